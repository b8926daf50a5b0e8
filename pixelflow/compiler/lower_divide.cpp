// Quotients and remainders of fixed-point numbers.
#include <algorithm>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {
Term Arithmetic::fixed_divide(const Term& a, const Term& b, const Scalar& type) {
  const Term x = wrapped(a), y = wrapped(b);
  const int places = type.exponent + y.type.exponent - x.type.exponent;
  const Scalar exact = Scalar::fixed(x.type.is_signed || y.type.is_signed,
                                     std::max(x.type.size + y.type.sign_bits() + places, 1), type.exponent);
  const Scalar held = fits(exact, type) ? exact : type;
  Term value = places >= 0 ? scaled_quotient(x, y, places, held.size) : shifted_quotient(x, y, -places, held.size);
  value.type.is_signed = exact.is_signed;
  value.type.exponent = type.exponent;
  // What was computed has the quotient's low bits; all of them where it is no longer than that.
  value = fits(exact, type) ? Term{value.at, exact, true}
                            : with_type(value, Scalar::fixed(exact.is_signed, held.size, type.exponent));
  return finished(value, type);
}

/// floor(a 2^places / b), of which the low `bits` are wanted.
Term Arithmetic::scaled_quotient(const Term& a, const Term& b, int places, int bits) {
  const int scale = places / kBitsOfByte, rest = places % kBitsOfByte;
  const bool sign = a.type.is_signed || b.type.is_signed;
  const auto divide = [&](const Term& dividend, int by, int size) {
    return operate(Code::Divide, Scalar::fixed(sign, kBitsOfByte * bytes_of(size), 0), dividend.at, b.at, by);
  };
  const Scalar type = Scalar::fixed(sign, bits, 0);
  if (rest == 0) return {divide(a, scale, bits), type};
  if (a.type.size + rest <= kMostBits) return {divide(shifted_left(a, rest, kMostBits), scale, bits), type};
  const int back = kBitsOfByte - rest;
  if (bits + back <= kMostBits) {
    const Term quotient{divide(a, scale + 1, bits + back), Scalar::fixed(sign, kBitsOfByte * bytes_of(bits + back), 0)};
    return shifted_right(quotient, back, bits);
  }
  // Dividend and quotient are both full: its low byte by the greater scale, the others by the smaller one.
  const ir::Operand upper = divide(a, scale, kMostBits);
  ir::Operand lower = temporary(Scalar::fixed(false, kBitsOfByte, 0));
  operate_into(lower, Code::Divide, a.at, b.at, scale + 1);
  return joined(upper, lower, back, Scalar::fixed(sign, kMostBits, 0));
}

/// floor(a / (b 2^places)), of which the low `bits` are wanted: a floor of a floor.
Term Arithmetic::shifted_quotient(const Term& a, const Term& b, int places, int bits) {
  const bool sign = a.type.is_signed || b.type.is_signed;
  const Scalar type = Scalar::fixed(sign, bits, 0);
  const int full = a.type.size + b.type.sign_bits();
  const int wanted = std::min(bits + places, full);
  if (wanted <= kMostBits) {
    const int bytes = bytes_of(wanted);
    const Scalar held = Scalar::fixed(sign, std::min(full, kBitsOfByte * bytes), 0);
    const Term quotient{operate(Code::Divide, Scalar::fixed(sign, kBitsOfByte * bytes, 0), a.at, b.at), held};
    return shifted_right(quotient, places, bits);
  }
  if (b.type.size + places <= kMostBits) {
    const Term divisor = shifted_left(b, places, kMostBits);
    return {operate(Code::Divide, Scalar::fixed(sign, kBitsOfByte * bytes_of(bits), 0), a.at, divisor.at), type};
  }
  // The quotient has 65 bits. Its sign is that of a b, unless it is zero; without it, the rest is unsigned.
  const Scalar wide = Scalar::fixed(false, kMostBits, 0);
  const ir::Operand quotient = operate(Code::Divide, wide, a.at, b.at);
  const Term shifted = shifted_right({quotient, wide}, places, kMostBits);
  const auto is_negative = [&](const Term& value) {
    const Term plain{value.at, Scalar::fixed(value.type.is_signed, value.type.size, 0)};
    const Scalar zero = Scalar::fixed(value.type.is_signed, 2, 0);
    return compare_values(Op::Less, plain, {constant(0, zero), zero}, true);
  };
  const Scalar boolean = Scalar::boolean();
  ir::Operand negative = is_negative(b);
  if (a.type.is_signed) negative = join(Kind::Xor, boolean, negative, is_negative(a));
  negative = join(Kind::And, boolean, negative, nonzero({quotient, wide}).at);
  const ir::Operand ones = operate(Code::ShiftLeft, wide, negative, {}, std::max(kMostBits - places, 0));
  return {operate(Code::Sub, Scalar::fixed(true, kMostBits, 0), shifted.at, ones), Scalar::fixed(true, kMostBits, 0)};
}

Term Arithmetic::fixed_remainder(const Term& a, const Term& b, const Scalar& type) {
  const int exponent = std::max(a.type.exponent, b.type.exponent);
  Term p = wrapped(a), q = wrapped(b);
  for (Term* const value : {&p, &q}) {
    const int size = value->type.size + exponent - value->type.exponent;
    if (size > kMostBits) {
      error("remainder needs " + std::to_string(size) + " bits; " + std::to_string(kMostBits) + " are possible");
      return {temporary(type), type};
    }
    *value = aligned(*value, exponent, kMostBits);
  }
  // It has the divisor's sign, and is less.
  const bool sign = q.type.is_signed;
  int size = q.type.size;
  if (!sign && !p.type.is_signed) size = std::min(p.type.size, q.type.size);
  const Scalar exact = Scalar::fixed(sign, size, exponent);
  const Scalar most = at_exponent(type, exponent);
  const bool whole = fits(exact, most);
  const Scalar held = whole ? exact : most;
  const Term rest{operate(Code::Remainder, held, p.at, q.at), held, whole};
  return finished(whole ? rest : with_type(rest, held), type);
}

}  // namespace pfman
