// Conditions: comparisons whose result goes from K straight to where it is used, or to a byte.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {

/// The comparison that a condition is, its operands lowered; none where it is something else, and then nothing is
/// emitted.
std::optional<Lowering::Comparison> Lowering::comparison_of(const Node& node) {
  if (is_uniform(node)) return std::nullopt;
  Comparison result;
  switch (node.op) {
    case Op::Not: {
      const std::optional<Comparison> opposite = comparison_of(*node.operands[0]);
      if (!opposite) return std::nullopt;
      result = *opposite;
      result.negated = !result.negated;
      break;
    }
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::NotEqual:
      if (node.operands[0]->type.is_array() || node.operands[1]->type.is_array()) return std::nullopt;
      result.op = node.op == Op::NotEqual ? Op::Equal : node.op;
      result.a = lower_scalar(*node.operands[0]);
      result.b = lower_scalar(*node.operands[1]);
      result.negated = node.op == Op::NotEqual;
      break;
    case Op::Convert: {
      const Node& source = *node.operands[0];
      if (node.exact != Scalar::boolean() || source.type.scalar.is_float || source.exact.size == 1) return std::nullopt;
      result.op = Op::Equal;
      result.a = wrapped(lower_scalar(source));
      const Scalar type = Scalar::fixed(result.a.type.is_signed, 2, result.a.type.exponent);
      result.b = {constant(0, type), type};
      result.negated = true;
      break;
    }
    default: return std::nullopt;
  }
  if (!result.negated || result.a.type.is_float) return result;
  // Of fixed-point numbers there is always one of which the opposite is true, or it is that 0 is less.
  if (result.op != Op::Equal) {
    return Comparison{result.op == Op::Less ? Op::LessEqual : Op::Less, result.b, result.a, false};
  }
  if (is_zero(result.b) && result.a.exact && !result.a.type.is_signed) {
    return Comparison{Op::Less, result.b, result.a, false};
  }
  return result;
}

ir::Operand Lowering::condition(const Node& node) {
  const std::optional<Comparison> comparison = options_.fuse ? comparison_of(node) : std::nullopt;
  if (!comparison) return pixel(wrapped(lower_scalar(node)).at);
  const ir::Operand result = compare_values(comparison->op, comparison->a, comparison->b, comparison->negated);
  return comparison->negated ? logical_not({result, Scalar::boolean()}).at : result;
}

ir::Operand Lowering::compare(const Node& node) {
  const Terms a = lower_node(*node.operands[0]), b = lower_node(*node.operands[1]);
  const Scalar boolean = Scalar::boolean();
  const bool equality = node.op == Op::Equal || node.op == Op::NotEqual;
  const Op op = equality ? Op::Equal : node.op;
  ir::Operand all;
  for (std::size_t n = 0; n < std::max(a.size(), b.size()); ++n) {
    const ir::Operand one = compare_values(op, a[a.size() > 1 ? n : 0], b[b.size() > 1 ? n : 0], true);
    all = n == 0 ? one : join(Kind::And, boolean, all, one);
  }
  return node.op == Op::NotEqual ? logical_not({all, boolean}).at : all;
}

}  // namespace pfman
