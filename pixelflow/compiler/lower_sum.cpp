// Sums of which fewer bits behind the point are wanted than they have. Where a summand has no more than those wanted,
// the other one can be floored before the addition, to the same result: floor(a + b) = a + floor(b) for an integer a.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {

/// A sum of which one side is a multiple of 2^-exponent; in a difference only what is subtracted can be it, since the
/// floor of the other sign goes the other way.
bool Lowering::has_coarse_summand(const Node& node, int exponent) const {
  if (is_uniform(node) || node.type.scalar.is_float || node.type.scalar.exponent <= exponent) return false;
  if (node.op != Op::Add && node.op != Op::Subtract) return false;
  const auto coarse = [&](const NodePtr& operand) { return operand->type.scalar.exponent <= exponent; };
  return coarse(node.operands[1]) || (node.op == Op::Add && coarse(node.operands[0]));
}

/// The node's value for one who drops all but `exponent` bits behind the point: of sums and products no more are made
/// than that.
Terms Lowering::lower_floored(const Node& node, int exponent) {
  const bool sum = has_coarse_summand(node, exponent);
  const bool product = !is_uniform(node) && node.op == Op::Multiply && !node.type.scalar.is_float &&
                       node.type.scalar.exponent > exponent;
  if (!sum && !product) return lower_node(node);
  const Location before = where_;
  where_ = node.where;
  const Scalar type = at_exponent(node.type.scalar, exponent);
  const auto side = [&](const Node& operand) { return sum ? lower_floored(operand, exponent) : lower_node(operand); };
  const Terms a = side(*node.operands[0]), b = side(*node.operands[1]);
  const auto floored = [&](const Term& value) {
    return value.type.exponent > exponent ? aligned(value, exponent, type.size) : value;
  };
  Terms result;
  for (std::size_t n = 0; n < std::max(a.size(), b.size()); ++n) {
    const Term &p = a[a.size() > 1 ? n : 0], &q = b[b.size() > 1 ? n : 0];
    result.push_back(sum ? fixed_add(floored(p), floored(q), node.op == Op::Subtract, type)
                         : fixed_multiply(p, q, type));
  }
  where_ = before;
  return result;
}

}  // namespace pfman
