// Conditions: comparisons whose result goes from K straight to where it is used, or to a byte.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
bool Lowering::is_zero(const Term& value) const {
  if (value.at.kind != ir::Operand::Kind::Uniform || value.type.is_float) return false;
  const Node& tree = *code_.uniforms[static_cast<std::size_t>(value.at.uniform)];
  return tree.op == Op::Literal && tree.raw == 0;
}

Term Lowering::logical_not(const Term& value) {
  const Scalar boolean = Scalar::boolean();
  return {join(Kind::Xor, boolean, wrapped(value).at, constant(1, boolean)), boolean};
}

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

/// A number whose sign alone is wanted: its top byte.
Term Lowering::sign_of(const Term& value) {
  Term result = value;
  result.type = Scalar::fixed(true, 8, value.type.exponent);
  result.at.offset += value.at.bytes - 1;
  result.at.bytes = 1;
  return result;
}

/// To a byte of 0 or 1, or to K alone.
ir::Operand Lowering::compare_values(Op op, const Term& a, const Term& b, bool to_byte) {
  const bool keep = to_byte || !options_.fuse;
  Code code = op == Op::Less ? Code::Less : op == Op::LessEqual ? Code::LessEqual : Code::Equal;
  Term p = a, q = b;
  if (a.type.is_float) {
    code = op == Op::Less ? Code::FloatLess : op == Op::LessEqual ? Code::FloatLessEqual : Code::FloatEqual;
  } else {
    const int exponent = std::max(a.type.exponent, b.type.exponent);
    const bool with_zero = is_zero(a) || is_zero(b);
    for (Term* const value : {&p, &q}) {
      *value = wrapped(*value);
      if (with_zero) continue;
      const int size = value->type.size + exponent - value->type.exponent;
      if (size > kMostBits) {
        error("comparison needs " + std::to_string(size) + " bits; " + std::to_string(kMostBits) + " are possible");
        return keep ? temporary(Scalar::boolean()) : ir::Operand{};
      }
      *value = aligned(*value, exponent, kMostBits);
    }
    const auto has_sign = [](const Term& value) {
      return value.at.kind == ir::Operand::Kind::Pixel && value.type.is_signed;
    };
    if (options_.fuse && op == Op::Less && is_zero(q) && has_sign(p)) p = sign_of(p);
    if (options_.fuse && op == Op::LessEqual && is_zero(p) && has_sign(q)) q = sign_of(q);
  }
  ir::Operand d;
  if (keep) d = temporary(Scalar::boolean());
  operate_into(d, code, p.at, q.at);
  return d;
}

}  // namespace pfman
