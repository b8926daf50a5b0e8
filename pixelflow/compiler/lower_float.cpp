// Floats: conversions, signs, rounding to integers, remainders. The one NaN is 0x7FC00000 and stays it.
#include <algorithm>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {
namespace {

constexpr int kLeastScale = -64, kMostScale = 128;  ///< of conversions
constexpr int kBias = 127, kFractionBits = 23;
constexpr int kNormalPower = -126, kLeastPower = 149;  ///< 2^-126 is the least normal float, 2^-149 the least of all
constexpr std::uint64_t kSign = 0x80000000, kHalf = 0x3F000000;
constexpr std::uint64_t kTopOfNan = 0x7FC0;         ///< upper two bytes of NaN, and of no other number
constexpr std::uint64_t kTopOfWholeNumbers = 0x4B;  ///< top byte of 2^23, from which on all floats are whole numbers

}  // namespace

Term Arithmetic::to_float(const Term& value) {
  if (value.type.is_float) return value;
  const Scalar type = Scalar::floating();
  Term known = wrapped(value);
  const int exponent = known.type.exponent, scale = std::clamp(exponent, kLeastScale, kMostScale);
  if (exponent == scale) return {operate(Code::FixedToFloat, type, known.at, {}, scale), type};
  const auto times = [&](int power, int by) {
    const auto factor = static_cast<std::uint64_t>(kBias + power) << kFractionBits;
    return float_binary(Code::FloatMultiply, {operate(Code::FixedToFloat, type, known.at, {}, by), type},
                        {constant(factor, type), type});
  };
  if (exponent < scale) return times(std::min(scale - exponent, kBias), scale);
  // Subnormal results are rounded by the multiplication, after the conversion has rounded: that does no harm as long as
  // the number has two bits more than they keep, the last of which tells whether there is anything below.
  known.type.exponent = 0;
  const int dropped = std::max(exponent - kLeastPower - 2, 0);
  if (dropped > 0) {
    const Scalar rest = Scalar::fixed(false, std::min(dropped, 64), 0);
    const Term any = nonzero({operate(Code::Wrap, rest, known.at, {}, rest.size), rest});
    Term kept = shifted_right(known, dropped, 64);
    kept.type.exponent = 0;
    known = fixed_bitwise(Op::BitOr, kept, any, Scalar::fixed(known.type.is_signed, 64, 0));
  }
  return times(kNormalPower, exponent - dropped + kNormalPower);
}

Term Arithmetic::to_fixed(const Term& value, const Scalar& to) {
  const ir::Operand d = operate(Code::FloatToFixed, to, value.at, {}, to.exponent);
  if (to.size == 8 * to.bytes()) return {d, to};
  return {operate(Code::Saturate, to, d, {}, to.size), to};
}

Term Arithmetic::float_binary(Code code, const Term& a, const Term& b) {
  return {operate(code, Scalar::floating(), a.at, b.at), Scalar::floating()};
}

/// Another sign bit, but for NaN, which the upper two bytes tell.
Term Arithmetic::float_negate(const Term& value) {
  const Scalar type = Scalar::floating();
  const ir::Operand own = pixel(value.at);
  const ir::Operand other = join(Kind::Xor, type, own, constant(kSign, type));
  ir::Operand top = own;
  top.offset += 2;
  top.bytes = 2;
  top.is_signed = false;
  const Scalar two = Scalar::fixed(false, 16, 0);
  const ir::Operand test = compare_values(Op::Equal, {top, two}, {constant(kTopOfNan, two), two}, false);
  return {select(test, type, own, other), type};
}

Term Arithmetic::float_abs(const Term& value) {
  const Scalar type = Scalar::floating();
  return {join(Kind::And, type, pixel(value.at), constant(kSign - 1, type)), type};
}

/// By way of an integer of 24 bits; numbers from 2^23 on, infinities and NaN are what they are.
Term Arithmetic::float_round(Op op, const Term& value) {
  const Scalar type = Scalar::floating(), integer = Scalar::fixed(true, 24, 0), wide = Scalar::fixed(true, 25, 0);
  Term x{pixel(value.at), type};
  if (op == Op::Round) x = float_binary(Code::FloatAdd, x, {constant(kHalf, type), type});
  ir::Operand whole_number;
  if (op == Op::Ceil) {
    const ir::Operand opposite = join(Kind::Xor, type, x.at, constant(kSign, type));
    const ir::Operand floor = operate(Code::FloatToFixed, integer, opposite);
    whole_number = operate(Code::Sub, wide, constant(0, integer), floor);
  } else {
    whole_number = operate(Code::FloatToFixed, integer, x.at);
  }
  const ir::Operand rounded = operate(Code::FixedToFloat, type, whole_number);
  ir::Operand top = x.at;
  top.offset += 3;
  top.bytes = 1;
  const Scalar byte = Scalar::fixed(false, 8, 0);
  const ir::Operand magnitude = join(Kind::And, byte, top, constant(0x7F, byte));
  const Term limit{constant(kTopOfWholeNumbers, byte), byte};
  const ir::Operand test = compare_values(Op::LessEqual, limit, {magnitude, byte}, false);
  return {select(test, type, x.at, rounded), type};
}

/// a - b floor(a / b), each step rounded.
Term Arithmetic::float_remainder(const Term& a, const Term& b) {
  const Term quotient = float_round(Op::Floor, float_binary(Code::FloatDivide, a, b));
  return float_binary(Code::FloatSub, a, float_binary(Code::FloatMultiply, b, quotient));
}

}  // namespace pfman
