#include "tests/reference/number.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace reference {

Number fixed_of(bool is_signed, int integer_bits, int exponent) {
  return {false, is_signed, std::max(1, integer_bits + exponent + (is_signed ? 1 : 0)), exponent};
}

Number join(const Number& a, const Number& b) {
  if (a.floating || b.floating) return kFloat;
  return fixed_of(a.is_signed || b.is_signed, std::max(a.integer_bits(), b.integer_bits()),
                  std::max(a.exponent, b.exponent));
}

std::string spelling(const Number& number) {
  if (number.floating) return "float";
  return (number.is_signed ? "S(" : "U(") + std::to_string(number.size) + "," + std::to_string(number.exponent) + ")";
}

Raw wrapped(Magnitude v, const Number& number) {
  const auto low = static_cast<Raw>(v);
  if (number.size >= 64) return low;
  const Raw field = low & ((Raw{1} << number.size) - 1);
  const bool negative = number.is_signed && (field >> (number.size - 1)) != 0;
  return negative ? field | ~Raw{0} << number.size : field;
}

Magnitude shifted_left(Magnitude v, int shift) { return shift >= 128 ? 0 : v << shift; }
Wide shifted_right(Wide v, int shift) { return v >> std::min(shift, 127); }

Raw fixed_to_fixed(Raw raw, const Number& from, const Number& to, bool saturate) {
  const Wide value = integer(raw, from);
  const int left = to.exponent - from.exponent;
  if (!saturate) {
    return wrapped(left >= 0 ? shifted_left(static_cast<Magnitude>(value), left)
                             : static_cast<Magnitude>(shifted_right(value, -left)),
                   to);
  }
  const int top = to.size - to.sign_bits();
  const Wide most = (Wide{1} << top) - 1;
  const Wide least = to.is_signed ? -most - 1 : 0;
  Wide result;
  if (left < 0) {
    result = shifted_right(value, -left);
  } else if (left < 64) {
    result = static_cast<Wide>(static_cast<Magnitude>(value) << left);
  } else {
    result = value == 0 ? 0 : value < 0 ? least : most;
  }
  return wrapped(static_cast<Magnitude>(std::clamp(result, least, most)), to);
}

Raw fixed_to_float(Raw raw, const Number& from) {
  const Wide value = integer(raw, from);
  const bool negative = value < 0;
  const auto magnitude = static_cast<Raw>(negative ? -value : value);
  if (magnitude == 0) return 0;
  // Significant bits beyond 24, or beyond the last place of subnormals, are rounded away; what stays is exact in a
  // double, and so is its scaling.
  const int drop = std::max(static_cast<int>(std::bit_width(magnitude)) - 24, from.exponent - 149);
  Magnitude kept = magnitude;
  if (drop > 70) {
    kept = 0;
  } else if (drop > 0) {
    const Magnitude half = Magnitude{1} << (drop - 1);
    const Magnitude rest = kept & (2 * half - 1);
    kept >>= drop;
    if (rest > half || (rest == half && kept % 2 == 1)) ++kept;
  }
  const double scaled = std::ldexp(static_cast<double>(kept), std::max(drop, 0) - from.exponent);
  const float result = scaled >= 0x1p128 ? INFINITY : static_cast<float>(scaled);
  return float_bits(negative ? -result : result);
}

Raw float_to_fixed(Raw bits, const Number& to) {
  const float value = as_float(bits);
  if (std::isnan(value) || value == 0) return 0;
  const Wide most = (Wide{1} << (to.size - to.sign_bits())) - 1;
  const Wide least = to.is_signed ? -most - 1 : 0;
  Wide result = value < 0 ? least : most;
  if (!std::isinf(value)) {
    // value = mantissa 2^(exponent - 24), exactly.
    int exponent = 0;
    const auto mantissa = static_cast<Wide>(std::ldexp(static_cast<double>(std::frexp(value, &exponent)), 24));
    const int shift = exponent - 24 + to.exponent;
    if (shift <= 70) result = shift >= 0 ? mantissa * (Wide{1} << shift) : shifted_right(mantissa, -shift);
  }
  return wrapped(static_cast<Magnitude>(std::clamp(result, least, most)), to);
}

Raw converted(Raw raw, const Number& from, const Number& to, bool saturate) {
  if (from == to) return raw;
  if (from.floating) {
    if (to.is_bool()) throw Error(202, "a float has no truth value");
    return float_to_fixed(raw, to);
  }
  if (to.floating) return fixed_to_float(raw, from);
  if (to.is_bool()) return raw != 0 ? 1 : 0;
  return fixed_to_fixed(raw, from, to, saturate);
}

float as_float(Raw bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); }
Raw float_bits(float value) { return std::isnan(value) ? 0x7FC00000u : std::bit_cast<std::uint32_t>(value); }

FixedLiteral fixed_literal(double value, int fraction_bits) {
  if (value == 0) return {unsigned_fixed(1, 0), 0};
  // |value| = mantissa 2^power, the mantissa of at most 53 bits.
  int power = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &power), 53));
  power -= 53;
  if (power < -fraction_bits) {
    const int drop = -fraction_bits - power;
    const Wide sum = Wide{mantissa} + (drop > 100 ? 0 : Wide{1} << (drop - 1));  // half of the last kept place
    mantissa = static_cast<std::int64_t>(drop > 100 ? 0 : shifted_right(sum, drop));
    power = -fraction_bits;
  }
  if (mantissa == 0) return {unsigned_fixed(1, 0), 0};
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++power;
  }
  FixedLiteral literal = integer_literal(mantissa);
  literal.number.exponent = -power;
  return literal;
}

FixedLiteral integer_literal(std::int64_t value) {
  if (value >= 0) {
    return {unsigned_fixed(std::max(1, static_cast<int>(std::bit_width(static_cast<Raw>(value)))), 0),
            static_cast<Raw>(value)};
  }
  return {signed_fixed(1 + static_cast<int>(std::bit_width(static_cast<Raw>(-(value + 1)))), 0),
          static_cast<Raw>(value)};
}

}  // namespace reference
