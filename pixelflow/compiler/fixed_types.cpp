#include "pixelflow/compiler/fixed_types.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace pfman {

using Op = Node::Op;

Scalar fixed_of(bool is_signed, int magnitude, int exponent) {
  return Scalar::fixed(is_signed, std::max(1, magnitude + exponent + (is_signed ? 1 : 0)), exponent);
}

Scalar binary_type(Op op, const Scalar& a, const Scalar& b) {
  const bool either_signed = a.is_signed || b.is_signed;
  const int larger = std::max(a.magnitude(), b.magnitude());
  const int exponent = std::max(a.exponent, b.exponent);
  switch (op) {
    case Op::Add: return fixed_of(either_signed, larger + 1, exponent);
    case Op::Subtract: return fixed_of(true, larger + (either_signed ? 1 : 0), exponent);
    case Op::Multiply: return Scalar::fixed(either_signed, a.size + b.size, a.exponent + b.exponent);
    case Op::Divide: return Scalar::fixed(either_signed, a.size + b.size, a.exponent + b.magnitude());
    case Op::Remainder: {
      const bool by_divisor = either_signed;
      return fixed_of(b.is_signed, by_divisor ? b.magnitude() : std::min(a.magnitude(), b.magnitude()), exponent);
    }
    case Op::BitAnd:
      if (!either_signed) return Scalar::fixed(false, std::min(a.size, b.size), a.exponent);
      return join(a, b);
    case Op::BitOr:
    case Op::BitXor: return join(a, b);
    default: throw std::logic_error("no operation of two fixed-point numbers");
  }
}

Scalar unary_type(Op op, const Scalar& a) {
  switch (op) {
    case Op::Negate: return Scalar::fixed(true, a.size + 1, a.exponent);
    case Op::Complement: return a;
    case Op::Abs: return Scalar::fixed(false, a.size, a.exponent);
    case Op::Floor: return a.exponent <= 0 ? a : fixed_of(a.is_signed, a.magnitude(), 0);
    case Op::Ceil:
    case Op::Round: return a.exponent <= 0 ? a : fixed_of(a.is_signed, a.magnitude() + 1, 0);
    case Op::SquareRoot: {
      const int m = a.magnitude();
      const int half = m >= 0 ? (m + 1) / 2 : -(-m / 2);  // rounded up
      return Scalar::fixed(false, std::max(1, half + a.exponent), a.exponent);
    }
    default: throw std::logic_error("no operation of one fixed-point number");
  }
}

FixedLiteral integer_literal(std::int64_t value) {
  const auto raw = static_cast<std::uint64_t>(value);
  if (value >= 0) return {Scalar::fixed(false, std::max(1, static_cast<int>(std::bit_width(raw))), 0), raw};
  return {Scalar::fixed(true, 1 + static_cast<int>(std::bit_width(~raw)), 0), raw};
}

FixedLiteral fixed_literal(double value, int fraction_bits) {
  if (value == 0 || !std::isfinite(value)) return integer_literal(0);
  int exponent = 0;
  // value = mantissa 2^exponent; 53 bits hold every mantissa.
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const int drop = -fraction_bits - exponent;
  if (drop > 54) return integer_literal(0);
  if (drop > 0) {
    mantissa = (mantissa + (std::int64_t{1} << (drop - 1))) >> drop;
    exponent += drop;
  }
  if (mantissa == 0) return integer_literal(0);
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  FixedLiteral literal = integer_literal(mantissa);
  literal.scalar.exponent = -exponent;
  return literal;
}

}  // namespace pfman
