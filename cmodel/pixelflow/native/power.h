// pow(x, y) = 2^(y log2 |x|), with the special cases of C99 (F.9.4.4). Paper: section 6.1.4.
//
// log2 |x| to 5 bytes times the 3 bytes of y is an exact 8-byte product; it is shifted to Q8.32 for 2^f. The error
// before rounding is below 2^-28 of the result. An odd integer y passes on the sign of x.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_POWER_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_POWER_H_

#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/exponential.h"
#include "cmodel/pixelflow/native/logarithm.h"

namespace pixelflow::native {

struct Parity {
  uint32_t integer;  // 0 or 1
  uint32_t odd;
};

PIXELFLOW_INLINE Parity parity_of(uint32_t a) {
  const int32_t field = static_cast<int32_t>(a >> 23);
  const uint32_t m = (a & 0x7FFFFFu) | 0x800000u;
  const int32_t fraction_bits = 150 - field;
  const uint32_t mask = (1u << (fraction_bits & 31)) - 1u;
  const uint32_t whole = ((field >= 127) & (field <= 150) & ((m & mask) == 0)) ? 1u : 0u;
  const uint32_t integer = ((field > 150) | (a == 0)) ? 1u : whole;
  return {integer, whole & (m >> (fraction_bits & 31))};
}

PIXELFLOW_INLINE uint32_t pow(uint32_t x, uint32_t y) {
  const uint32_t ax = magnitude(x);
  const uint32_t ay = magnitude(y);
  const uint32_t y_negative = y >> 31;
  const Parity parity = parity_of(ay);
  const uint32_t sign = sign_of(x) & (0u - parity.odd);

  const Logarithm log = logarithm_of(ax);
  const Normal factor = split(ay);
  const uint64_t exact = (log.significand >> 8) * uint64_t{factor.significand >> 8};
  const int32_t exponent = log.exponent + factor.exponent;  // of units of 2^-62
  const uint64_t fixed = shift_right_wide(exact, 30 - (exponent > 7 ? 7 : exponent));
  const bool large = ((exponent > 7) | (fixed > kLargestQ32)) & (exact != 0);
  const uint32_t value = power_of_two<false>(sign, log.negative ^ y_negative, large ? kLargestQ32 : fixed);

  const bool extreme = (ax == 0) | (ax == kInfinity) | ((ay == kInfinity) & (ax != kOne));
  const uint32_t infinite = (ax > kOne ? 1u : 0u) ^ y_negative;
  const uint32_t limit = sign | (kInfinity & (0u - infinite));
  const uint32_t invalid = (x >> 31) & (parity.integer ^ 1u);
  const uint32_t finite = select(invalid, kNan, value);
  const uint32_t number = extreme ? limit : finite;
  const uint32_t result = ((ax > kInfinity) | (ay > kInfinity)) ? kNan : number;
  return ((ay == 0) | (x == kOne)) ? kOne : result;
}

}  // namespace pixelflow::native

#endif
