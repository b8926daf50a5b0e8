// sin, cos, tan and their fast versions. Paper: Olano & Lastra 1998, section 6.1.4.
//
// Reduction (Payne-Hanek, exact for every float32): |x| = m * 2^(8q - 48), m a 4-byte integer. 13 bytes of 2/pi, chosen
// by q, times m give |x| * 2/pi modulo 256 as 1 integer byte and 12 fraction bytes; the integer's low two bits are the
// quadrant, the top 8 fraction bytes F are kept (error below 2^-64; the least F of all float32 is about 2^-33).
// In the quadrant, t = F or 1 - F (taken as ~F) in [0, 1), and
//   sin(pi/2 t) = t S(t^2), S of degree 5, Q1.31
//   tan(pi/2 t) = t R(t^2) / (1 - t^2), R of degree 4, Q1.31, t folded to [0, 1/2]; the cotangent is the inverse
// t is normalised to 4 bytes as a factor, t^2 comes from its top 4 bytes (Q0.32). |x| < 2^-24 returns x.
// The fast versions have cubics instead that meet value and slope at t = 0 and 1 (tan: 0 and 1/2). The one of sin is
// worked out from the nearer end, so that it is monotone where it is flat.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_TRIGONOMETRY_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_TRIGONOMETRY_H_

#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/coefficients.h"

namespace pixelflow::native {

// The bytes of 2/pi * 2^(8q + 48) modulo 2^104, in words of 4 bytes, least significant first, the last of 1 byte.
inline constexpr uint32_t kTwoOverPi[4][20] = {
    {0x836E4E44u, 0x6E4E4415u, 0x4E441529u, 0x441529FCu, 0x1529FC27u, 0x29FC2757u, 0xFC2757D1u,
     0x2757D1F5u, 0x57D1F534u, 0xD1F534DDu, 0xF534DDC0u, 0x34DDC0DBu, 0xDDC0DB62u, 0xC0DB6295u,
     0xDB629599u, 0x6295993Cu, 0x95993C43u, 0x993C4390u, 0x3C439041u, 0x439041FEu},
    {0x0000A2F9u, 0x00A2F983u, 0xA2F9836Eu, 0xF9836E4Eu, 0x836E4E44u, 0x6E4E4415u, 0x4E441529u,
     0x441529FCu, 0x1529FC27u, 0x29FC2757u, 0xFC2757D1u, 0x2757D1F5u, 0x57D1F534u, 0xD1F534DDu,
     0xF534DDC0u, 0x34DDC0DBu, 0xDDC0DB62u, 0xC0DB6295u, 0xDB629599u, 0x6295993Cu},
    {0x00000000u, 0x00000000u, 0x00000000u, 0x000000A2u, 0x0000A2F9u, 0x00A2F983u, 0xA2F9836Eu,
     0xF9836E4Eu, 0x836E4E44u, 0x6E4E4415u, 0x4E441529u, 0x441529FCu, 0x1529FC27u, 0x29FC2757u,
     0xFC2757D1u, 0x2757D1F5u, 0x57D1F534u, 0xD1F534DDu, 0xF534DDC0u, 0x34DDC0DBu},
    {0x00u, 0x00u, 0x00u, 0x00u, 0x00u, 0x00u, 0x00u, 0xA2u, 0xF9u, 0x83u,
     0x6Eu, 0x4Eu, 0x44u, 0x15u, 0x29u, 0xFCu, 0x27u, 0x57u, 0xD1u, 0xF5u},
};

struct Quadrant {
  uint64_t fraction;  // Q0.64
  uint32_t number;    // modulo 4
};

PIXELFLOW_INLINE Quadrant reduce_angle(uint32_t finite_magnitude) {
  const uint32_t field = finite_magnitude >> 23;
  const uint32_t distance = field < 103 ? 1 : field - 102;  // smaller ones are not reduced
  const uint32_t q = (distance >> 3) < 20 ? distance >> 3 : 19;
  const uint64_t m = uint64_t{(finite_magnitude & 0x7FFFFFu) | 0x800000u} << (distance & 7u);  // 31 bits
  const uint64_t low = ((m * kTwoOverPi[0][q]) >> 32) + m * kTwoOverPi[1][q];
  const uint64_t high = m * kTwoOverPi[2][q] + (low >> 32);
  const uint64_t integer = m * kTwoOverPi[3][q] + (high >> 32);
  return {(high << 32) | (low & 0xFFFFFFFFu), static_cast<uint32_t>(integer) & 3u};
}

// sin(pi/2 t), t in Q0.64, not zero.
PIXELFLOW_INLINE Normal sine_of_quarter(uint64_t t) {
  const uint32_t t_high = static_cast<uint32_t>(t >> 32);
  const uint32_t z = multiply_high(t_high, t_high);
  uint32_t p = horner_minus(kSine[4], z, kSine[5]);
  p = horner_minus(kSine[3], z, p);
  p = horner_minus(kSine[2], z, p);
  p = horner_minus(kSine[1], z, p);
  p = horner_minus(kSine[0], z, p);
  const WideNormal factor = normalise_wide(t, -1);
  return product(static_cast<uint32_t>(factor.significand >> 32), p, factor.exponent);
}

// The cubic that meets value and slope at t = 0 and 1, from the nearer end: y = t or 1 - t,
//   t <= 1/2: y (a - y (b + c y))      t > 1/2: 1 - y^2 (d - c y)
// with y as a factor normalised in both: seen from 1 the rest has few bits wrong in its own last places, so that
// rounding keeps the order even where the cubic is flat.
PIXELFLOW_INLINE Normal fast_sine_of_quarter(uint64_t t) {
  const uint32_t fold = static_cast<uint32_t>(t >> 63);
  const uint64_t y = select_wide(fold, ~t, t);
  const WideNormal wide = normalise_wide(y, 0);
  const uint32_t factor = static_cast<uint32_t>(wide.significand >> 32);  // y = factor * 2^(exponent - 32)
  const uint32_t bent = multiply_high(static_cast<uint32_t>(y >> 32), kFastSine[2]);
  const uint32_t slope = select(fold, kFastSine[3] - bent, kFastSine[1] + bent);
  const uint32_t part = multiply_high(factor, slope);
  const uint32_t p = select(fold, part, kFastSine[0] - shift_right(part, -wide.exponent));
  const uint32_t value = multiply_high(factor, p);
  const uint32_t below_one = kSignBit - shift_right(value, -2 * wide.exponent);  // Q1.31
  const Normal near_zero = {value, wide.exponent};
  const Normal near_one = {below_one, 0};
  const Normal chosen = select(fold, near_one, near_zero);
  return normalise(chosen.significand, chosen.exponent);
}

struct Ratio {
  Normal numerator;
  uint32_t denominator;  // Q0.32, at least 3/4
};

// tan(pi/2 t), t in Q0.64, in (0, 1/2).
PIXELFLOW_INLINE Ratio tangent_of_eighth(uint64_t t) {
  const uint32_t t_high = static_cast<uint32_t>(t >> 32);
  const uint32_t z = multiply_high(t_high, t_high);
  uint32_t p = horner_plus(kTangent[3], z, kTangent[4]);
  p = horner_plus(kTangent[2], z, p);
  p = horner_plus(kTangent[1], z, p);
  p = horner_minus(kTangent[0], z, p);
  const WideNormal factor = normalise_wide(t, -1);
  return {product(static_cast<uint32_t>(factor.significand >> 32), p, factor.exponent), ~z};
}

// w (a - b w + c w^2), w = 2 t, a = pi/4, b = pi - 3, c = 3 pi/4 - 2, Q0.32; a - b + c = 1 - 2^-32.
PIXELFLOW_INLINE Ratio fast_tangent_of_eighth(uint64_t t) {
  const uint32_t w = static_cast<uint32_t>(t >> 31);
  const uint32_t p =
      horner_plus(horner_minus(kFastTangent[0], w, kFastTangent[1]), multiply_high(w, w), kFastTangent[2]);
  const WideNormal factor = normalise_wide(t, -1);
  return {product(static_cast<uint32_t>(factor.significand >> 32), p, factor.exponent), 0xFFFFFFFFu};
}

// Numerator / denominator, or its inverse: both are normalised, so that the quotient has 32 bits.
PIXELFLOW_INLINE Normal divide_ratio(Ratio ratio, uint32_t invert) {
  const Normal bottom = {ratio.denominator, -1};
  const Normal above = select(invert, bottom, ratio.numerator);
  const Normal below = select(invert, ratio.numerator, bottom);
  const uint32_t halve = above.significand >= below.significand ? 1u : 0u;
  const uint32_t quotient = divide_fraction<32>(above.significand >> halve, below.significand).quotient;
  return {quotient, above.exponent - below.exponent - 1 + static_cast<int32_t>(halve)};
}

template <bool Fast>
PIXELFLOW_INLINE uint32_t sine_from(uint32_t x, uint32_t first_quadrant) {
  const uint32_t a = magnitude(x);
  const Quadrant angle = reduce_angle(a);
  const uint32_t quadrant = angle.number + first_quadrant;
  const uint64_t t = (quadrant & 1u) != 0 ? ~angle.fraction : angle.fraction;
  const Normal value = Fast ? fast_sine_of_quarter(t) : sine_of_quarter(t);
  const uint32_t sign = (first_quadrant == 0 ? sign_of(x) : 0u) ^ ((quadrant & 2u) << 30);
  const uint32_t reduced = round_normal(sign, value);
  const uint32_t tiny = first_quadrant == 0 ? x : kOne;
  const uint32_t finite = a < 0x33800000u ? tiny : reduced;
  return a >= kInfinity ? kNan : finite;
}

PIXELFLOW_INLINE uint32_t sin(uint32_t x) { return sine_from<false>(x, 0); }
PIXELFLOW_INLINE uint32_t cos(uint32_t x) { return sine_from<false>(x, 1); }
PIXELFLOW_INLINE uint32_t fast_sin(uint32_t x) { return sine_from<true>(x, 0); }
PIXELFLOW_INLINE uint32_t fast_cos(uint32_t x) { return sine_from<true>(x, 1); }

template <bool Fast>
PIXELFLOW_INLINE uint32_t tangent(uint32_t x) {
  const uint32_t a = magnitude(x);
  const Quadrant angle = reduce_angle(a);
  const uint32_t fold = static_cast<uint32_t>(angle.fraction >> 63);
  const uint64_t t = select_wide(fold, ~angle.fraction, angle.fraction);
  const Ratio ratio = Fast ? fast_tangent_of_eighth(t) : tangent_of_eighth(t);
  const uint32_t sign = sign_of(x) ^ (angle.number << 31);
  const uint32_t reduced = round_normal(sign, divide_ratio(ratio, fold ^ (angle.number & 1u)));
  const uint32_t finite = a < 0x33800000u ? x : reduced;
  return a >= kInfinity ? kNan : finite;
}

PIXELFLOW_INLINE uint32_t tan(uint32_t x) { return tangent<false>(x); }
PIXELFLOW_INLINE uint32_t fast_tan(uint32_t x) { return tangent<true>(x); }

}  // namespace pixelflow::native

#endif
