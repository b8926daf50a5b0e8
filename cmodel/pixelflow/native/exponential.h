// exp2, exp and their fast versions. Paper: section 6.1.4.
//
// The exponent of 2 is brought to Q8.32 (5 bytes) with its sign apart: |x| shifted, or |x| log2(e) from an exact
// product of 3 by 5 bytes. Negated where x is negative, its integer byte is the exponent of the result, and with its
// fraction f 2^f = 1 + f F(f), F of degree 6, Q1.31. What cannot be held counts as 256 - 2^-32: infinity or zero either
// way. The fast versions have a cubic for 2^f that meets value and slope at f = 0 and 1.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_EXPONENTIAL_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_EXPONENTIAL_H_

#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/coefficients.h"

namespace pixelflow::native {

inline constexpr uint64_t kLargestQ32 = 0xFFFFFFFFFFu;
inline constexpr uint64_t kOneQ39 = uint64_t{1} << 39;

// 2^f of f in Q0.32; Q1.31.
PIXELFLOW_INLINE uint32_t power_of_fraction(uint32_t f) {
  uint32_t p = horner_plus(kExponential[6], f, kExponential[7]);
  p = horner_plus(kExponential[5], f, p);
  p = horner_plus(kExponential[4], f, p);
  p = horner_plus(kExponential[3], f, p);
  p = horner_plus(kExponential[2], f, p);
  p = horner_plus(kExponential[1], f, p);
  return horner_plus(kExponential[0], f, p);
}

// 1 + f (a + f (b + c f)), a = ln 2, b = 3 - 4 ln 2, c = 3 ln 2 - 2, Q1.31; a + b + c = 1 exactly.
PIXELFLOW_INLINE uint32_t fast_power_of_fraction(uint32_t f) {
  const uint32_t p = horner_plus(kFastExponential[1], f, horner_plus(kFastExponential[2], f, kFastExponential[3]));
  return horner_plus(kFastExponential[0], f, p);
}

// 2^exponent, or 2^-exponent where negative is 1, rounded; exponent in Q8.32.
template <bool Fast>
PIXELFLOW_INLINE uint32_t power_of_two(uint32_t sign, uint32_t negative, uint64_t exponent) {
  const int64_t power = static_cast<int64_t>(select_wide(negative, uint64_t{0} - exponent, exponent));
  const uint32_t f = static_cast<uint32_t>(power);
  const uint32_t significand = Fast ? fast_power_of_fraction(f) : power_of_fraction(f);
  return round_any(sign, {significand, static_cast<int32_t>(power >> 32)});
}

// 2^(x * factor), factor in Q1.39, for magnitudes below 2^limit; larger ones overflow.
template <bool Fast>
PIXELFLOW_INLINE uint32_t exponential(uint32_t x, uint64_t factor, int32_t limit) {
  const uint32_t a = magnitude(x);
  const int32_t exponent = static_cast<int32_t>(a >> 23) - 127;
  const uint64_t exact = uint64_t{(a & 0x7FFFFFu) | 0x800000u} * factor;  // 8 bytes, units of 2^(exponent - 62)
  const bool large = exponent >= limit;
  const uint64_t fixed = shift_right_wide(exact, 30 - (large ? 0 : exponent));
  const uint32_t result = power_of_two<Fast>(0, x >> 31, large ? kLargestQ32 : fixed);
  return is_nan(x) ? kNan : result;
}

PIXELFLOW_INLINE uint32_t exp2(uint32_t x) { return exponential<false>(x, kOneQ39, 8); }
PIXELFLOW_INLINE uint32_t exp(uint32_t x) { return exponential<false>(x, kLog2EQ39, 7); }
PIXELFLOW_INLINE uint32_t fast_exp2(uint32_t x) { return exponential<true>(x, kOneQ39, 8); }
PIXELFLOW_INLINE uint32_t fast_exp(uint32_t x) { return exponential<true>(x, kLog2EQ39, 7); }

}  // namespace pixelflow::native

#endif
