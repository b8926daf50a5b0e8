// Comparisons of numbers, and what is stored in variables.
#include <algorithm>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {

bool Arithmetic::is_zero(const Term& value) const {
  if (value.at.kind != ir::Operand::Kind::Uniform || value.type.is_float) return false;
  const Node& tree = *code_.uniforms[static_cast<std::size_t>(value.at.uniform)];
  return tree.op == Op::Literal && tree.raw == 0;
}

Term Arithmetic::logical_not(const Term& value) {
  const Scalar boolean = Scalar::boolean();
  return {join(Kind::Xor, boolean, wrapped(value).at, constant(1, boolean)), boolean};
}

/// A number whose sign alone is wanted: its top byte.
Term Arithmetic::sign_of(const Term& value) {
  Term result = value;
  result.type = Scalar::fixed(true, 8, value.type.exponent);
  result.at.offset += value.at.bytes - 1;
  result.at.bytes = 1;
  return result;
}

/// To a byte of 0 or 1, or to K alone.
ir::Operand Arithmetic::compare_values(Op op, const Term& a, const Term& b, bool to_byte) {
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

Term Arithmetic::convert(const Term& value, const Scalar& to, bool saturate) {
  if (value.type.is_float) return to_fixed(value, to);
  return saturate ? fixed_saturate(value, to) : fixed_convert(value, to);
}

void Arithmetic::store(const Term& target, const Term& value) {
  if (target.type.is_float) return operate_into(target.at, Code::Copy, value.at);
  const Term ready = reduced(aligned(value, target.type.exponent, target.type.size), target.type);
  if (ready.exact) return operate_into(target.at, Code::Copy, ready.at);
  operate_into(target.at, Code::Wrap, ready.at, {}, target.type.size);
}

int Arithmetic::gathered(const Terms& values, const Scalar& type, int count) {
  const int most = std::max(static_cast<int>(values.size()), count);
  const int variable = add_variable({}, type, most, true);
  for (int n = 0; n < most; ++n) {
    store({whole(variable, n), type}, values[values.size() > 1 ? static_cast<std::size_t>(n) : 0]);
  }
  return variable;
}

}  // namespace pfman
