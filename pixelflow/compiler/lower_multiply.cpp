// Products of fixed-point numbers: as much of them as is wanted, shifted right on the way by whole bytes.
#include <algorithm>
#include <bit>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {
namespace {

constexpr int kMostScale = 8;

}  // namespace

/// The power of two that a literal's raw number is, or -1.
int Arithmetic::power_of_two(const Term& value) const {
  if (value.at.kind != ir::Operand::Kind::Uniform) return -1;
  const Node& tree = *code_.uniforms[static_cast<std::size_t>(value.at.uniform)];
  const bool negative = value.type.is_signed && tree.raw >> (kMostBits - 1);
  return tree.op == Op::Literal && !negative && std::has_single_bit(tree.raw) ? std::countr_zero(tree.raw) : -1;
}

Term Arithmetic::fixed_multiply(const Term& a, const Term& b, const Scalar& type) {
  const bool both_uniform = a.at.kind == ir::Operand::Kind::Uniform && b.at.kind == ir::Operand::Kind::Uniform;
  if (power_of_two(a) >= 0 && !both_uniform) return fixed_multiply(b, a, type);
  const int power = power_of_two(b);
  if (power >= 0 && !both_uniform) {  // only the point moves
    Term moved = a;
    moved.type.exponent += b.type.exponent - power;
    return finished(moved, type);
  }
  const int exponent = a.type.exponent + b.type.exponent;
  const int places = std::max(exponent - type.exponent, 0);
  const Scalar full = Scalar::fixed(a.type.is_signed || b.type.is_signed, a.type.size + b.type.size, exponent);
  const Scalar exact = Scalar::fixed(full.is_signed, std::max(full.size - places, 1), exponent - places);
  const Scalar most = at_exponent(type, exponent - places);
  const bool whole = a.exact && b.exact && fits(exact, most);
  const int bits = whole ? exact.size : most.size;
  const Term x = needed(a, bits + places), y = needed(b, bits + places);
  return finished(product(x, y, places, full, bits), type);
}

/// floor(a b / 2^places), of which the low `bits` are wanted. `full` is the product's type.
Term Arithmetic::product(const Term& a, const Term& b, int places, const Scalar& full, int bits) {
  const bool exact = a.exact && b.exact;
  const bool by_bytes = options_.fuse || full.size > kMostBits;
  const int scale = by_bytes ? std::min(places / kBitsOfByte, kMostScale) : 0;
  const int rest = places - kBitsOfByte * scale;
  const int available = std::max(full.size - kBitsOfByte * scale, 1);
  const int wanted = std::min(bits + rest, available);
  const int exponent = full.exponent - kBitsOfByte * scale;
  const auto multiply = [&](int size, int by) {
    return operate(Code::Multiply, Scalar::fixed(full.is_signed, size, exponent), a.at, b.at, by);
  };
  if (wanted <= kMostBits) {
    const int bytes = bytes_of(wanted);
    const Scalar held = Scalar::fixed(full.is_signed, std::min(available, kBitsOfByte * bytes), exponent);
    Term value{multiply(kBitsOfByte * bytes, scale), held, exact};
    // Operands that are known in their low places + bits bits give a product known in as many.
    if (!exact) value = with_type(value, Scalar::fixed(full.is_signed, std::min(bits + rest, held.size), exponent));
    return shifted_right(value, rest, bits);
  }
  // More than 64 bits before the rest of the shift: the upper ones by a greater scale, and the low ones again.
  const Scalar type = Scalar::fixed(full.is_signed, kMostBits, exponent - rest);
  const ir::Operand upper = multiply(kMostBits, scale + 1);
  ir::Operand lower = temporary(Scalar::fixed(false, kBitsOfByte, 0));
  operate_into(lower, Code::Multiply, a.at, b.at, scale);
  return joined(upper, lower, rest, type);
}

/// upper 2^(8 - places) + lower / 2^places: the shift right by `places` of a number of 9 bytes, of which `upper` are
/// all but the last.
Term Arithmetic::joined(const ir::Operand& upper, const ir::Operand& lower, int places, const Scalar& type) {
  const Scalar low = Scalar::fixed(false, kBitsOfByte - places, 0);
  const ir::Operand high = operate(Code::ShiftLeft, type, upper, {}, kBitsOfByte - places);
  const ir::Operand rest = operate(Code::ShiftRight, low, lower, {}, places);
  return {operate(Code::Add, type, high, rest), type};
}

}  // namespace pfman
