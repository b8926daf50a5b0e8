// Coefficients of the mathematical functions, lowest degree first, in units of 2^-31 or 2^-32 unless said. Native
// versions and microcode share them. polynomials.sollya makes the minimax ones; subtracted ones are stored without
// their sign.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_COEFFICIENTS_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_COEFFICIENTS_H_

#include <array>
#include <cstdint>

namespace pixelflow::native {

template <int Count>
using Coefficients = std::array<uint32_t, Count>;

// S: sin(pi/2 t) = t S(t^2), signs alternate. Q1.31.
inline constexpr Coefficients<6> kSine = {3373259426u, 1387197331u, 171138555u, 10053764u, 344124u, 7362u};
// R: tan(pi/2 t) = t R(t^2) / (1 - t^2), all but the first subtracted. Q1.31.
inline constexpr Coefficients<5> kTangent = {3373259426u, 598864733u, 36177473u, 3526108u, 405292u};
// A: asin(s) = s A(s^2). Q1.31.
inline constexpr Coefficients<8> kArcsine = {2147483648u, 357913953u, 161060135u, 95907509u,
                                             64655733u,   52897335u,  15959242u,  74589132u};
// B: atan(q) = q B(q^2), signs alternate. Q0.32.
inline constexpr Coefficients<13> kArctangent = {0xFFFFFFFFu, 1431655752u, 858992694u, 613548826u, 476998511u,
                                                 388824217u,  322509851u,  260045475u, 189656670u, 113980899u,
                                                 50591114u,   14297305u,   1895764u};
// 2^f = sum of the terms. Q1.31.
inline constexpr Coefficients<8> kExponential = {2147483648u, 1488522236u, 515882458u, 119194842u,
                                                 20650591u,   2875317u,    313619u,    44585u};
// G: log2((1+s)/(1-s)) = s (kTwoOverLn2 + w G(w)/16), w = 16 s^2. Q0.32.
inline constexpr Coefficients<5> kLogarithm = {4130885346u, 154908184u, 6915750u, 335285u, 18739u};
inline constexpr uint64_t kTwoOverLn2 = 198282496599u;  // Q4.36

// Cubics of the fast versions, which meet value and slope at both ends of the reduced range.
// t (a - t (b + c t)) = 1 - u^2 (d - c u), u = 1 - t: a = pi/2, b = pi - 3, c = 2 - pi/2, d = 3 - pi/2. Q1.31.
inline constexpr Coefficients<4> kFastSine = {3373259426u, 304067908u, 921707870u, 3069191518u};
// w (a - b w + c w^2): a = pi/4, b = pi - 3, c = 3 pi/4 - 2, Q0.32; a - b + c = 1 - 2^-32.
inline constexpr Coefficients<3> kFastTangent = {3373259426u, 608135817u, 1529843686u};
// s (1 - b s + c s^2): b = 4 - 2 pi + 4/sqrt(3), c = 4 + 8/sqrt(3) - 8 pi/3, Q1.31.
inline constexpr Coefficients<3> kFastArcsine = {2147483648u, 56297936u, 518019751u};
// q (1 - q (b + c q)): b = 5/2 - 3 pi/4, c = pi/2 - 3/2, Q0.32.
inline constexpr Coefficients<3> kFastArctangent = {0xFFFFFFFFu, 617639962u, 304067908u};
// 1 + f (a + f (b + c f)): a = ln 2, b = 3 - 4 ln 2, c = 3 ln 2 - 2, Q1.31; a + b + c = 1 exactly.
inline constexpr Coefficients<4> kFastExponential = {2147483648u, 1488522236u, 488362000u, 170599412u};
// u (a - u (b - c u)): a = 1/ln 2, b = 5/(2 ln 2) - 3, c = 3/(2 ln 2) - 2, Q1.39; a - b + c = 1 exactly.
inline constexpr std::array<uint64_t, 3> kFastLogarithm = {793129986396u, 333557524326u, 90183351818u};

// Other constants.
inline constexpr uint32_t kPiQ30 = 3373259426u;
inline constexpr uint32_t kHalfPiQ30 = 1686629713u;
inline constexpr uint32_t kLn2Q32 = 2977044472u;
inline constexpr uint64_t kLog2EQ39 = 793129986396u;
// Fraction bytes of 2/pi, most significant first.
inline constexpr std::array<uint8_t, 25> kTwoOverPiBytes = {0xA2, 0xF9, 0x83, 0x6E, 0x4E, 0x44, 0x15, 0x29, 0xFC,
                                                            0x27, 0x57, 0xD1, 0xF5, 0x34, 0xDD, 0xC0, 0xDB, 0x62,
                                                            0x95, 0x99, 0x3C, 0x43, 0x90, 0x41, 0xFE};

}  // namespace pixelflow::native

#endif
