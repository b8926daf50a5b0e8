// Fixed point: shifts by counts, absolute values, rounding to integers, roots.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
/// A literal count moves the point and no bit. Any other is known when the stream is made.
Term Lowering::fixed_shift(const Node& node, const Term& value) {
  const bool left = node.op == Op::ShiftLeft;
  const Node& places = *node.operands[1];
  const Scalar& type = node.type.scalar;
  if (places.op == Op::Literal) {
    const int exponent = places.type.scalar.exponent;
    const auto count = static_cast<int>(exponent >= 0 ? places.raw >> exponent : places.raw << -exponent);
    Term moved = value;
    if (value.at.kind == ir::Operand::Kind::Uniform) moved.at = pixel(value.at);
    moved.type.exponent += left ? -count : count;
    return finished(moved, type);
  }
  Term known = wrapped(at_least(value, type.exponent));
  const Scalar held = Scalar::fixed(known.type.is_signed, type.size, known.type.exponent);
  // The factor's evaluation is what refuses counts that are not between 0 and 64.
  const Scalar wide = Scalar::fixed(false, kMostBits, 0);
  Variable* const count = hoist(index_tree(places));
  NodePtr factor =
      make_node(Op::ShiftLeft, wide, nodes(make_literal(wide, 1, where_), make_read(count, places.where)), where_);
  if (left) {
    const Term multiplier = uniform_value(std::move(factor));
    const Term shifted{operate(Code::Multiply, held, known.at, multiplier.at), held};
    return finished(with_type(shifted, held), type);
  }
  hoist(std::move(factor));
  // Binary digit by digit of the count: only the shifts that it has are in the stream.
  const ir::Operand at = operate(Code::Copy, known.type, known.at);
  for (int digit = 0; digit <= 6; ++digit) {
    const auto literal = [&](std::uint64_t raw) { return make_literal(count->type.scalar, raw, places.where); };
    NodePtr bit = make_node(Op::BitAnd, count->type.scalar,
                            nodes(make_read(count, places.where), literal(std::uint64_t{1} << digit)), places.where);
    const int opening =
        begin_if(make_node(Op::NotEqual, Scalar::boolean(), nodes(std::move(bit), literal(0)), places.where));
    operate_into(at, Code::ShiftRight, at, {}, 1 << digit);
    end_if(opening);
  }
  return finished({at, known.type}, type);
}

Term Lowering::fixed_abs(const Term& value, const Scalar& type) {
  Term known = wrapped(value);
  if (!known.type.is_signed) return finished(known, type);
  known.at = pixel(known.at);
  const Scalar held = Scalar::fixed(false, known.type.size, known.type.exponent);
  const ir::Operand own = extended(known, held.bytes()).at;
  const ir::Operand negated = operate(Code::Sub, held, constant(0, known.type), known.at);
  // The sign is in the top byte.
  ir::Operand top = known.at;
  top.offset += top.bytes - 1;
  top.bytes = 1;
  const Scalar byte = Scalar::fixed(true, 8, 0);
  const ir::Operand test = compare_values(Op::Less, {top, byte}, {constant(0, byte), byte}, false);
  return finished({select(test, held, negated, own), held}, type);
}

/// floor(x), floor(x + 1/2), or the least integer that is not less than x.
Term Lowering::fixed_round(Op op, const Term& value, const Scalar& type) {
  const int places = value.type.exponent;
  if (places <= 0) return finished(value, type);
  Term known = wrapped(value);
  if (op == Op::Floor) return finished(shifted_right(known, places, kMostBits), type);
  const int sign = known.type.sign_bits();
  if (std::max(known.type.size - sign, places) + 1 + sign <= kMostBits) {
    const Scalar one = Scalar::fixed(false, places, places);
    const std::uint64_t raw = op == Op::Round ? std::uint64_t{1} << (places - 1) : (std::uint64_t{1} << places) - 1;
    const Term sum =
        fixed_add(known, {constant(raw, one), one}, false, Scalar::fixed(known.type.is_signed, kMostBits, places));
    return finished(shifted_right(sum, places, kMostBits), type);
  }
  // The sum would not fit: the integer part, and one more by what is behind the point.
  const Term integer = shifted_right(known, places, kMostBits);
  Term more;
  if (op == Op::Round) {
    const Term half = shifted_right(known, places - 1, kMostBits);
    more = {operate(Code::Wrap, Scalar::boolean(), half.at, {}, 1), Scalar::boolean()};
  } else {
    const Scalar fraction = Scalar::fixed(false, std::min(places, kMostBits), 0);
    more = nonzero({operate(Code::Wrap, fraction, known.at, {}, fraction.size), fraction});
  }
  return finished(fixed_add(integer, more, false, Scalar::fixed(known.type.is_signed, kMostBits, 0)), type);
}

/// The root has as many bits behind the point as its operand: floor(sqrt(raw 2^exponent)).
Term Lowering::fixed_square_root(const Term& value, const Scalar& type) {
  constexpr int kMostExponent = 64;
  Term known = wrapped(at_least(value, type.exponent));
  const int exponent = known.type.exponent;
  if (exponent > kMostExponent) {
    error("square root of a number with " + std::to_string(exponent) + " bits behind the point; " +
          std::to_string(kMostExponent) + " are possible");
    return {temporary(type), type};
  }
  const int scale = std::max(exponent, 0);
  if (exponent < 0) {
    // The root counts in 2^-exponent as well: of raw 2^-exponent it is sqrt(raw 2^exponent).
    known = {known.at, Scalar::fixed(known.type.is_signed, known.type.size, 0)};
    known = shifted_right(known, -exponent, kMostBits);
    known.type.exponent = 0;
  }
  const int magnitude = std::max(known.type.size - known.type.sign_bits() + scale, 0);
  const Scalar held = Scalar::fixed(false, std::max((magnitude + 1) / 2, 1), exponent);
  return finished({operate(Code::SquareRoot, held, known.at, {}, scale), held}, type);
}

}  // namespace pfman
