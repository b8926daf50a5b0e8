// Fixed point: absolute values, rounding to integers, roots.
#include <algorithm>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {

Term Arithmetic::fixed_abs(const Term& value, const Scalar& type) {
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
Term Arithmetic::fixed_round(Op op, const Term& value, const Scalar& type) {
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
Term Arithmetic::fixed_square_root(const Term& value, const Scalar& type) {
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
