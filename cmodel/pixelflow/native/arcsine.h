// asin, acos, their fast versions, and inversesqrt, which needs the same square root. Paper: section 6.1.4.
//
//   |x| <  1/2: s = |x|,                  v = s A(s^2),   asin = v,            acos = pi/2 -+ v
//   |x| >= 1/2: s = sqrt((1 - |x|) / 2),  v = 2 s A(s^2), asin = pi/2 - v,     acos = v or pi - v
// s is a Normal number as a factor (the root is worked out to 32 bits), Q0.32 in the polynomial; A has degree 7, Q1.31.
// Differences from pi/2 and pi are Q2.30. |x| < 2^-24 returns x (asin). The fast versions have a cubic for s A(s^2)
// that meets value and slope at s = 0 and 1/2: as asin(s) there, hence continuous at |x| = 1/2.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_ARCSINE_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_ARCSINE_H_

#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/coefficients.h"

namespace pixelflow::native {

// asin(s) / s of s in Q0.32, at most 1/2; Q1.31.
PIXELFLOW_INLINE uint32_t arcsine_polynomial(uint32_t s) {
  const uint32_t z = multiply_high(s, s);
  uint32_t p = horner_plus(kArcsine[6], z, kArcsine[7]);
  p = horner_plus(kArcsine[5], z, p);
  p = horner_plus(kArcsine[4], z, p);
  p = horner_plus(kArcsine[3], z, p);
  p = horner_plus(kArcsine[2], z, p);
  p = horner_plus(kArcsine[1], z, p);
  return horner_plus(kArcsine[0], z, p);
}

// 1 - b s + c s^2, b = 4 - 2 pi + 4/sqrt(3), c = 4 + 8/sqrt(3) - 8 pi/3; Q1.31.
PIXELFLOW_INLINE uint32_t fast_arcsine_polynomial(uint32_t s) {
  return horner_plus(horner_minus(kFastArcsine[0], s, kFastArcsine[1]), multiply_high(s, s), kFastArcsine[2]);
}

struct Arcsine {
  Normal value;    // v
  uint32_t fixed;  // v in Q2.30
};

// v of a magnitude that is at most 1.
template <bool Fast>
PIXELFLOW_INLINE Arcsine arcsine_of(uint32_t a) {
  const bool upper = a >= 0x3F000000u;
  const uint32_t scaled = ((a & 0x7FFFFFu) | 0x800000u) << (a == kOne ? 1 : 0);  // |x| * 2^24 in the upper half
  const Normal root = root_of(normalise((1u << 24) - scaled, 6));
  const Normal plain = split(a);
  const Normal s = select(upper, root, plain);
  const uint32_t s_fixed = shift_right(s.significand, -1 - s.exponent);
  const uint32_t p = Fast ? fast_arcsine_polynomial(s_fixed) : arcsine_polynomial(s_fixed);
  const Normal value = product(s.significand, p, upper ? s.exponent + 1 : s.exponent);
  return {value, shift_right(value.significand, 1 - value.exponent)};
}

template <bool Fast>
PIXELFLOW_INLINE uint32_t arcsine(uint32_t x) {
  const uint32_t a = magnitude(x);
  const Arcsine v = arcsine_of<Fast>(a > kOne ? kOne : a);
  const Normal upper = normalise(kHalfPiQ30 - v.fixed, 1);
  const bool is_upper = a >= 0x3F000000u;
  const uint32_t rounded = round_normal(sign_of(x), select(is_upper, upper, v.value));
  const uint32_t result = a < 0x33800000u ? x : rounded;
  return a > kOne ? kNan : result;
}

template <bool Fast>
PIXELFLOW_INLINE uint32_t arccosine(uint32_t x) {
  const uint32_t a = magnitude(x);
  const Arcsine v = arcsine_of<Fast>(a > kOne ? kOne : a);
  const bool negative = sign_of(x) != 0;
  const bool upper = a >= 0x3F000000u;
  const uint32_t base = upper ? kPiQ30 : kHalfPiQ30;
  const uint32_t signed_v = (negative != upper) ? v.fixed : 0u - v.fixed;
  const Normal fixed = normalise(base + signed_v, 1);
  const bool direct = upper & !negative;
  const uint32_t rounded = round_normal(0, select(direct, v.value, fixed));
  const uint32_t result = x == kOne ? 0u : rounded;
  return a > kOne ? kNan : result;
}

PIXELFLOW_INLINE uint32_t asin(uint32_t x) { return arcsine<false>(x); }
PIXELFLOW_INLINE uint32_t acos(uint32_t x) { return arccosine<false>(x); }
PIXELFLOW_INLINE uint32_t fast_asin(uint32_t x) { return arcsine<true>(x); }
PIXELFLOW_INLINE uint32_t fast_acos(uint32_t x) { return arccosine<true>(x); }

// 1 / sqrt(x), as rSqrt of IEEE 754: -0 gives minus infinity, other negative numbers NaN.
PIXELFLOW_INLINE uint32_t inversesqrt(uint32_t x) {
  const uint32_t a = magnitude(x);
  const Normal root = root_of(split(a));
  const uint32_t quotient = divide_fraction<32>(0x7FFFFFFFu, root.significand).quotient;
  const uint32_t rounded = round_normal(0, normalise(quotient, -1 - root.exponent));
  const uint32_t positive = x == kInfinity ? 0u : rounded;
  const uint32_t result = x > kInfinity ? kNan : positive;  // negative ones and NaN
  return a == 0 ? sign_of(x) | kInfinity : result;
}

}  // namespace pixelflow::native

#endif
