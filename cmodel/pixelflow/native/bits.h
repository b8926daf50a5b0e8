// Float32 bit patterns taken apart and put together with integers: the steps that all functions of this folder share.
//
// Formats. "Normal" is a positive number significand * 2^(exponent - 31) whose bit 31 is set (4 bytes and an exponent
// of 2 bytes). "Qi.f" is an unsigned fixed-point number of i integer and f fraction bits. Products are exact and then
// lose whole low bytes. Everything is free of branches, as the elements have none; loops over it become vector code.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_BITS_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_BITS_H_

#include <cstdint>

#define PIXELFLOW_INLINE [[gnu::always_inline]] inline

namespace pixelflow::native {

inline constexpr uint32_t kSignBit = 0x80000000u;
inline constexpr uint32_t kInfinity = 0x7F800000u;
inline constexpr uint32_t kNan = 0x7FC00000u;  // the only one that a function returns
inline constexpr uint32_t kOne = 0x3F800000u;
inline constexpr uint32_t kHalfPi = 0x3FC90FDBu;  // rounded to nearest

struct Normal {
  uint32_t significand;
  int32_t exponent;
};

struct Quotient {
  uint32_t quotient;
  uint32_t remainder;
};

PIXELFLOW_INLINE uint32_t magnitude(uint32_t x) { return x & 0x7FFFFFFFu; }
PIXELFLOW_INLINE uint32_t sign_of(uint32_t x) { return x & kSignBit; }
PIXELFLOW_INLINE bool is_nan(uint32_t x) { return magnitude(x) > kInfinity; }

PIXELFLOW_INLINE uint32_t multiply_high(uint32_t a, uint32_t b) {
  return static_cast<uint32_t>((uint64_t{a} * b) >> 32);
}

// Bytes 4 to 9 of the product of two 5-byte numbers.
PIXELFLOW_INLINE uint64_t multiply_40(uint64_t a, uint64_t b) {
  const uint64_t a_low = a & 0xFFFFFFFFu;
  const uint64_t b_low = b & 0xFFFFFFFFu;
  const uint64_t a_high = a >> 32;
  const uint64_t b_high = b >> 32;
  return ((a_low * b_low) >> 32) + a_high * b_low + a_low * b_high + ((a_high * b_high) << 32);
}

// condition ? a : b, condition 0 or 1, without a branch: the compiler makes one out of several choices by one
// condition.
PIXELFLOW_INLINE uint32_t select(uint32_t condition, uint32_t a, uint32_t b) {
  return b ^ ((a ^ b) & (0u - condition));
}
PIXELFLOW_INLINE uint64_t select_wide(uint32_t condition, uint64_t a, uint64_t b) {
  return b ^ ((a ^ b) & (uint64_t{0} - condition));
}
PIXELFLOW_INLINE Normal select(uint32_t condition, Normal a, Normal b) {
  const uint32_t exponent = select(condition, static_cast<uint32_t>(a.exponent), static_cast<uint32_t>(b.exponent));
  return {select(condition, a.significand, b.significand), static_cast<int32_t>(exponent)};
}

// Shifts by a count of the element; zero when nothing is left.
PIXELFLOW_INLINE uint32_t shift_right(uint32_t value, int32_t count) { return count > 31 ? 0u : value >> (count & 31); }
PIXELFLOW_INLINE uint64_t shift_right_wide(uint64_t value, int32_t count) {
  return select_wide(count > 63 ? 1u : 0u, 0u, value >> (count & 63));
}

// As shift_right, but bit 0 of the result is set where a bit is lost. count >= 0.
PIXELFLOW_INLINE uint32_t shift_right_sticky(uint32_t value, int32_t count) {
  const uint32_t kept = shift_right(value, count);
  const uint32_t back = count > 31 ? 0u : kept << (count & 31);
  return kept | (back != value ? 1u : 0u);
}

// Shifts left until bit 31 is set, by 16, 8, 4, 2, 1; exponent falls by the count. Zero stays zero. By recursion, here
// and below: the compiler unrolls few loops before it looks for vectors.
template <int Step = 16>
PIXELFLOW_INLINE Normal normalise(uint32_t value, int32_t exponent) {
  const bool clear = (value >> (32 - Step)) == 0;
  const Normal next = {clear ? value << Step : value, clear ? exponent - Step : exponent};
  if constexpr (Step == 1) {
    return next;
  } else {
    return normalise<Step / 2>(next.significand, next.exponent);
  }
}

// The same of 8 bytes, down to bit 63; the value is significand * 2^(exponent - 63) then.
struct WideNormal {
  uint64_t significand;
  int32_t exponent;
};
template <int Step = 32>
PIXELFLOW_INLINE WideNormal normalise_wide(uint64_t value, int32_t exponent) {
  const bool clear = (value >> (64 - Step)) == 0;
  const WideNormal next = {clear ? value << Step : value, clear ? exponent - Step : exponent};
  if constexpr (Step == 1) {
    return next;
  } else {
    return normalise_wide<Step / 2>(next.significand, next.exponent);
  }
}

// A finite magnitude as a Normal number; subnormals are normalised. Zero gives significand 0.
PIXELFLOW_INLINE Normal split(uint32_t finite_magnitude) {
  const uint32_t field = finite_magnitude >> 23;
  const uint32_t fraction = (finite_magnitude << 8) & 0x7FFFFFFFu;
  const uint32_t value = field != 0 ? fraction | kSignBit : fraction;
  return normalise(value, field != 0 ? static_cast<int32_t>(field) - 127 : -126);
}

// Rounds to nearest even. The exponent is that of a normal float32.
PIXELFLOW_INLINE uint32_t round_normal(uint32_t sign, Normal value) {
  const uint32_t kept = value.significand >> 8;
  const uint32_t up = ((value.significand & 0xFFu) + (kept & 1u) + 127u) >> 8;
  return sign | ((static_cast<uint32_t>(value.exponent + 126) << 23) + kept + up);
}

// Rounds once to nearest even, to subnormal numbers, zero and infinity too.
PIXELFLOW_INLINE uint32_t round_any(uint32_t sign, Normal value) {
  const int32_t field = value.exponent + 126;  // one less than the exponent field: the top bit of `kept` adds one
  const uint32_t significand = shift_right_sticky(value.significand, field < 0 ? -field : 0);
  const uint32_t kept = significand >> 8;
  const uint32_t up = ((significand & 0xFFu) + (kept & 1u) + 127u) >> 8;
  const uint32_t finite = (static_cast<uint32_t>(field < 0 ? 0 : field) << 23) + kept + up;
  return sign | (field > 253 ? kInfinity : finite);
}

// One bit of a restoring division.
PIXELFLOW_INLINE Quotient divide_bit(Quotient state, uint32_t divisor) {
  const uint32_t carry = state.remainder >> 31;
  const uint32_t doubled = state.remainder << 1;
  const uint32_t take = carry | (doubled >= divisor ? 1u : 0u);
  return {(state.quotient << 1) | take, doubled - (take != 0 ? divisor : 0u)};
}

// Bits of numerator / divisor below the point; numerator < divisor.
template <int Bits>
PIXELFLOW_INLINE Quotient divide_more(Quotient state, uint32_t divisor) {
  if constexpr (Bits == 0) {
    return state;
  } else {
    return divide_more<Bits - 1>(divide_bit(state, divisor), divisor);
  }
}
template <int Bits>
PIXELFLOW_INLINE Quotient divide_fraction(uint32_t numerator, uint32_t divisor) {
  return divide_more<Bits>({0, numerator}, divisor);
}

// Two bits of the radicand leave it at the top and give one bit of the root.
struct Root {
  uint64_t radicand;
  uint64_t remainder;
  uint64_t root;
};
template <int Bits>
PIXELFLOW_INLINE Root root_more(Root state) {
  if constexpr (Bits == 0) {
    return state;
  } else {
    const uint64_t next = (state.remainder << 2) | (state.radicand >> 62);
    const uint64_t trial = (state.root << 2) | 1u;
    const bool take = next >= trial;
    return root_more<Bits - 1>({state.radicand << 2, next - (take ? trial : 0u), (state.root << 1) | (take ? 1u : 0u)});
  }
}

// floor(2^32 sqrt(radicand / 2^33)), radicand Q0.33 in [1/4, 1): 32 bits, the top one set.
PIXELFLOW_INLINE uint32_t square_root(uint64_t radicand) {
  return static_cast<uint32_t>(root_more<32>({radicand << 31, 0, 0}).root);
}

// p := c - z p and p := c + z p, Horner steps of 4-byte numbers with z in Q0.32.
PIXELFLOW_INLINE uint32_t horner_minus(uint32_t c, uint32_t z, uint32_t p) { return c - multiply_high(z, p); }
PIXELFLOW_INLINE uint32_t horner_plus(uint32_t c, uint32_t z, uint32_t p) { return c + multiply_high(z, p); }

// The top 4 bytes of a significand times a Q1.31 number, normalised.
PIXELFLOW_INLINE Normal product(uint32_t significand, uint32_t factor, int32_t exponent) {
  return normalise(multiply_high(significand, factor), exponent + 1);
}

// Square root of a Normal number: 32 bits, floored.
PIXELFLOW_INLINE Normal root_of(Normal value) {
  const uint64_t radicand = (value.exponent & 1) != 0 ? uint64_t{value.significand} << 1 : value.significand;
  return {square_root(radicand), value.exponent >> 1};
}

}  // namespace pixelflow::native

#endif
