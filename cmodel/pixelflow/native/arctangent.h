// atan2(y, x), atan(x) = atan2(x, 1), and their fast versions. Paper: section 6.1.4.
//
// q = min / max of |y| and |x|, 32 bits of quotient; v = q B(q^2), B of degree 12, Q0.32; the result is v, pi/2 - v,
// pi/2 + v or pi - v (Q2.30), with the sign of y. The dividend is one unit of its 32 bits too small, so that q stays
// below 1. Infinities count as 1 beside each other, and make q = 0 beside anything else.
// The fast versions have a cubic for v that meets value and slope at q = 0 and 1.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_ARCTANGENT_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_ARCTANGENT_H_

#include "cmodel/pixelflow/native/arcsine.h"
#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/coefficients.h"

namespace pixelflow::native {

// atan(q) / q of q in Q0.32; Q0.32.
PIXELFLOW_INLINE uint32_t arctangent_polynomial(uint32_t q) {
  const uint32_t z = multiply_high(q, q);
  uint32_t p = horner_minus(kArctangent[11], z, kArctangent[12]);
  p = horner_minus(kArctangent[10], z, p);
  p = horner_minus(kArctangent[9], z, p);
  p = horner_minus(kArctangent[8], z, p);
  p = horner_minus(kArctangent[7], z, p);
  p = horner_minus(kArctangent[6], z, p);
  p = horner_minus(kArctangent[5], z, p);
  p = horner_minus(kArctangent[4], z, p);
  p = horner_minus(kArctangent[3], z, p);
  p = horner_minus(kArctangent[2], z, p);
  p = horner_minus(kArctangent[1], z, p);
  return horner_minus(kArctangent[0], z, p);
}

// 1 - q (b + c q), b = 5/2 - 3 pi/4, c = pi/2 - 3/2; Q0.32.
PIXELFLOW_INLINE uint32_t fast_arctangent_polynomial(uint32_t q) {
  return horner_minus(kFastArctangent[0], q, horner_plus(kFastArctangent[1], q, kFastArctangent[2]));
}

template <bool Fast>
PIXELFLOW_INLINE uint32_t arctangent(uint32_t y, uint32_t x) {
  const uint32_t ay = magnitude(y);
  const uint32_t ax = magnitude(x);
  const bool steep = ay > ax;
  const uint32_t small = steep ? ax : ay;
  const uint32_t large = steep ? ay : ax;
  const bool zero = (small == 0) | ((large == kInfinity) & (small != kInfinity));
  const Normal above = split(small);
  const Normal below = split(large);
  const uint32_t numerator = above.significand - 1;
  const uint32_t halve = numerator >= below.significand ? 1u : 0u;
  const uint32_t quotient = divide_fraction<32>(numerator >> halve, below.significand).quotient;
  const int32_t exponent = above.exponent - below.exponent - 1 + static_cast<int32_t>(halve);
  const uint32_t q = shift_right(quotient, -1 - exponent);
  const uint32_t p = Fast ? fast_arctangent_polynomial(q) : arctangent_polynomial(q);
  const Normal v = product(quotient, p, exponent - 1);

  const bool negative = sign_of(x) != 0;
  const uint32_t fixed = zero ? 0u : shift_right(v.significand, 1 - v.exponent);
  const uint32_t base = steep ? kHalfPiQ30 : kPiQ30;
  const uint32_t signed_v = (steep & negative) ? fixed : 0u - fixed;
  const Normal turned = normalise(base + signed_v, 1);
  const bool direct = !steep & !negative;
  const uint32_t rounded = round_any(sign_of(y), select(direct, v, turned));
  const uint32_t result = (direct & zero) ? sign_of(y) : rounded;
  return (ay > kInfinity || ax > kInfinity) ? kNan : result;
}

PIXELFLOW_INLINE uint32_t atan2(uint32_t y, uint32_t x) { return arctangent<false>(y, x); }
PIXELFLOW_INLINE uint32_t fast_atan2(uint32_t y, uint32_t x) { return arctangent<true>(y, x); }
PIXELFLOW_INLINE uint32_t atan(uint32_t x) { return arctangent<false>(x, kOne); }
PIXELFLOW_INLINE uint32_t fast_atan(uint32_t x) { return arctangent<true>(x, kOne); }

}  // namespace pixelflow::native

#endif
