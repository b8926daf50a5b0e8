// The bottom-up pass over fixed-point expressions (Olano and Lastra 1998, section 6.3.2): types that keep every bit of
// an operation's result. Sizes may exceed 64 bits here.
#pragma once

#include "pixelflow/compiler/tree.h"
#include "pixelflow/compiler/types.h"

namespace pfman {

/// Of `magnitude` integer bits besides the sign, and `exponent` fraction bits; one bit at least.
Scalar fixed_of(bool is_signed, int magnitude, int exponent);

/// Add, Subtract, Multiply, Divide, Remainder, BitAnd, BitOr, BitXor. A quotient keeps as many fraction bits as the
/// divisor has integer bits beyond the dividend's; bitwise operands have one exponent.
Scalar binary_type(Node::Op op, const Scalar& a, const Scalar& b);
/// Negate, Complement, Abs, Floor, Ceil, Round, SquareRoot.
Scalar unary_type(Node::Op op, const Scalar& a);

/// The literal `value` at up to `fraction_bits`, rounded to nearest, a half up, without trailing zero bits: the
/// smallest type that holds it, signed if it is negative.
struct FixedLiteral {
  Scalar scalar;
  std::uint64_t raw = 0;
};
FixedLiteral fixed_literal(double value, int fraction_bits);
FixedLiteral integer_literal(std::int64_t value);

}  // namespace pfman
