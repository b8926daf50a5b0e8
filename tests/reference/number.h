// Numbers of the shading language as the reference interpreter holds them: a type, and raw bits in 64.
//
// A fixed-point number's raw bits are extended to 64 by its sign; its value is the raw integer times 2^-exponent. A
// float's are its 32 bits, NaN always 0x7FC00000. Integers of 128 bits carry what lies between.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace reference {

__extension__ using Wide = __int128;
__extension__ using Magnitude = unsigned __int128;
using Raw = std::uint64_t;

/// What a program does that it may not, with its place as "line:column: "; `code` is the compiler's for it, or 0.
struct Error : std::runtime_error {
  Error(int number, const std::string& text) : std::runtime_error(text), code(number) {}
  int code;
};

struct Number {
  bool floating = false;
  bool is_signed = false;
  int size = 1;
  int exponent = 0;

  int sign_bits() const { return is_signed ? 1 : 0; }
  int integer_bits() const { return size - exponent - sign_bits(); }
  /// A truth value: conversions to it compare with zero.
  bool is_bool() const { return !floating && !is_signed && size == 1 && exponent == 0; }
  friend bool operator==(const Number&, const Number&) = default;
};

inline constexpr Number kFloat{true, true, 32, 0};
inline constexpr Number kBool{};
constexpr Number unsigned_fixed(int size, int exponent) { return {false, false, size, exponent}; }
constexpr Number signed_fixed(int size, int exponent) { return {false, true, size, exponent}; }
/// Of sign bits g, integer bits m and exponent e; at least one bit.
Number fixed_of(bool is_signed, int integer_bits, int exponent);
Number join(const Number& a, const Number& b);
std::string spelling(const Number& number);  ///< "U(8,8)", "S(36,32)", "float"

/// The low `number.size` bits of v, extended.
Raw wrapped(Magnitude v, const Number& number);
inline Wide integer(Raw raw, const Number& number) {
  return number.is_signed ? Wide{static_cast<std::int64_t>(raw)} : Wide{raw};
}
/// v 2^shift, the upper bits lost; floor(v 2^-shift) of v with its sign extended.
Magnitude shifted_left(Magnitude v, int shift);
Wide shifted_right(Wide v, int shift);

Raw fixed_to_fixed(Raw raw, const Number& from, const Number& to, bool saturate);
Raw fixed_to_float(Raw raw, const Number& from);
Raw float_to_fixed(Raw bits, const Number& to);
/// Any to any. A conversion to a truth value compares with zero.
Raw converted(Raw raw, const Number& from, const Number& to, bool saturate);

float as_float(Raw bits);
Raw float_bits(float value);  ///< a NaN made the one

/// A literal as fixed point: to nearest, a half up, at `fraction_bits`, without trailing zero bits; the smallest type
/// that holds it, signed for a negative one.
struct FixedLiteral {
  Number number;
  Raw raw = 0;
};
FixedLiteral fixed_literal(double value, int fraction_bits);
FixedLiteral integer_literal(std::int64_t value);

}  // namespace reference
