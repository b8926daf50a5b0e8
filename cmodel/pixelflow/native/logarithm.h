// log2, log and their fast versions. Paper: section 6.1.4.
//
// |x| = 2^E m, m in [3/4, 3/2); s = (m - 1) / (m + 1), 40 bits of quotient; with w = 16 s^2 (Q0.32)
//   log2 m = s (2/ln 2 + w G(w)/16), G of degree 4, Q0.32; the sum is Q4.36 in 5 bytes
// and log2 x = E + log2 m, in Q8.40 where E is not 0, otherwise the product itself, normalised: 6 bytes, relative error
// below 2^-36, as pow needs. log = log2 * ln 2.
// The fast versions have a cubic for log2 of [1, 2) that meets value and slope at both ends, in Q1.39.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_LOGARITHM_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_LOGARITHM_H_

#include "cmodel/pixelflow/native/bits.h"
#include "cmodel/pixelflow/native/coefficients.h"

namespace pixelflow::native {

struct Logarithm {
  uint64_t significand;  // 6 bytes, bit 47 set, or 0; the value is significand * 2^(exponent - 47)
  int32_t exponent;
  uint32_t negative;  // 0 or 1
};

// Of a positive finite magnitude.
PIXELFLOW_INLINE Logarithm logarithm_of(uint32_t a) {
  const Normal x = split(a);
  const uint32_t m = x.significand >> 8;  // 24 bits
  const uint32_t below_one = m >= 0xC00000u ? 1u : 0u;
  const int32_t whole = x.exponent + static_cast<int32_t>(below_one);
  const uint32_t one = 0x800000u << below_one;
  const uint32_t difference = select(below_one, one - m, m - one);
  const uint32_t sum = m + one;  // 25 bits, the top one set
  const uint32_t divisor = sum << 7;
  const Normal above = normalise(difference, 7);
  const uint32_t halve = above.significand >= divisor ? 1u : 0u;
  const Quotient first = divide_fraction<32>(above.significand >> halve, divisor);
  const Quotient second = divide_fraction<8>(first.remainder, divisor);
  const uint64_t s = (uint64_t{first.quotient} << 8) | second.quotient;  // s * 2^(exponent - 40), exponent <= -2
  const int32_t exponent = above.exponent + static_cast<int32_t>(halve);

  const uint32_t s4 = shift_right(first.quotient, -2 - exponent);  // 4 s in Q0.32
  const uint32_t w = multiply_high(s4, s4);
  uint32_t g = horner_plus(kLogarithm[3], w, kLogarithm[4]);
  g = horner_plus(kLogarithm[2], w, g);
  g = horner_plus(kLogarithm[1], w, g);
  g = horner_plus(kLogarithm[0], w, g);
  const uint64_t p = kTwoOverLn2 + multiply_high(w, g);  // Q4.36
  const uint64_t log_m = multiply_40(s, p);              // below 2^46, units of 2^(exponent - 44)

  const uint32_t has_integer = whole != 0 ? 1u : 0u;
  const uint32_t negative = select(has_integer, static_cast<uint32_t>(whole) >> 31, below_one);
  const uint64_t part = shift_right_wide(log_m, 4 - exponent);
  const uint64_t integer = uint64_t{static_cast<uint32_t>(whole < 0 ? -whole : whole)} << 40;
  const uint64_t fixed = select_wide(below_one ^ negative, integer - part, integer + part);
  const int32_t unit = static_cast<int32_t>(select(has_integer, 7u, static_cast<uint32_t>(exponent + 1)));
  const WideNormal value = normalise_wide(select_wide(has_integer, fixed, log_m << 2) << 16, unit);
  return {value.significand >> 16, value.exponent, negative};
}

// E + u (a - u (b - c u)), u = m - 1, a = 1/ln 2, b = 5/(2 ln 2) - 3, c = 3/(2 ln 2) - 2, Q8.39; a - b + c = 1 exactly.
PIXELFLOW_INLINE Logarithm fast_logarithm_of(uint32_t a) {
  const Normal x = split(a);
  const uint64_t u = (x.significand >> 7) & 0xFFFFFFu;  // Q0.24
  uint64_t p = kFastLogarithm[1] - ((u * kFastLogarithm[2]) >> 24);
  p = kFastLogarithm[0] - ((u * p) >> 24);
  const uint64_t fraction = (u * p) >> 24;
  const uint64_t sum = (static_cast<uint64_t>(static_cast<int64_t>(x.exponent)) << 39) + fraction;
  const uint32_t negative = static_cast<uint32_t>(sum >> 63);
  const WideNormal value = normalise_wide(select_wide(negative, uint64_t{0} - sum, sum) << 16, 8);
  return {value.significand >> 16, value.exponent, negative};
}

template <bool Fast>
PIXELFLOW_INLINE uint32_t logarithm(uint32_t x, bool natural) {
  const uint32_t a = magnitude(x);
  const Logarithm log = Fast ? fast_logarithm_of(a) : logarithm_of(a);
  const uint32_t significand = static_cast<uint32_t>(log.significand >> 16);
  const Normal scaled = product(significand, kLn2Q32, log.exponent - 1);
  const Normal value = natural ? scaled : Normal{significand, log.exponent};
  const uint32_t rounded = round_normal(log.negative << 31, value);
  const uint32_t finite = x == kOne ? 0u : rounded;
  const uint32_t positive = x == kInfinity ? kInfinity : finite;
  const uint32_t result = x > kInfinity ? kNan : positive;  // negative ones and NaN
  return a == 0 ? kSignBit | kInfinity : result;
}

PIXELFLOW_INLINE uint32_t log2(uint32_t x) { return logarithm<false>(x, false); }
PIXELFLOW_INLINE uint32_t log(uint32_t x) { return logarithm<false>(x, true); }
PIXELFLOW_INLINE uint32_t fast_log2(uint32_t x) { return logarithm<true>(x, false); }
PIXELFLOW_INLINE uint32_t fast_log(uint32_t x) { return logarithm<true>(x, true); }

}  // namespace pixelflow::native

#endif
