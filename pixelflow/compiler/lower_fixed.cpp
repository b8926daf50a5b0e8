// Fixed point: sizes and exponents of numbers, sums, shifts, bits. Terms are what the sizing passes define; a
// reduction to sizes that are no whole bytes is put off until somebody can see the difference.
#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {
namespace {

bool is_uniform_value(const Term& value) { return value.at.kind == ir::Operand::Kind::Uniform; }

Scalar resized(const Scalar& type, int size) { return Scalar::fixed(type.is_signed, size, type.exponent); }

/// A uniform number in another type: exact, floored or reduced, on the host. A conversion to one bit would be to a
/// bool, and mean something else.
NodePtr converted_tree(NodePtr tree, const Scalar& type) {
  const Location where = tree->where;
  if (type != Scalar::boolean()) return make_node(Node::Op::Convert, type, nodes(std::move(tree)), where);
  NodePtr two = make_node(Node::Op::Convert, Scalar::fixed(false, 2, 0), nodes(std::move(tree)), where);
  return make_node(Node::Op::BitAnd, type, nodes(std::move(two), make_literal(type, 1, where)), where);
}

}  // namespace

Scalar at_exponent(const Scalar& type, int exponent) {
  return Scalar::fixed(type.is_signed, std::max(type.size + exponent - type.exponent, 1), exponent);
}

bool fits(const Scalar& type, const Scalar& into) {
  if (type.is_signed && !into.is_signed) return false;
  return type.size + (into.is_signed && !type.is_signed ? 1 : 0) <= into.size;
}

Scalar contents_of(const Term& value) {
  if (value.type.is_float) return value.type;
  return Scalar::fixed(value.at.is_signed, kBitsOfByte * value.at.bytes, value.type.exponent);
}

/// The bytes at `value.at` are known in their low type.size bits. Exact if it has no others: where type.size is in
/// whole bytes, fewer are read.
Term Arithmetic::with_type(const Term& value, const Scalar& type) {
  Term result = value;
  result.type = type;
  result.exact = false;
  if (type.size % kBitsOfByte == 0 && kBitsOfByte * value.at.bytes >= type.size) {
    result.at.bytes = type.size / kBitsOfByte;
    result.at.is_signed = type.is_signed;
    result.exact = true;
  }
  return result;
}

Term Arithmetic::wrapped(const Term& value) {
  if (value.exact || value.type.is_float) return value;
  const Scalar& type = value.type;
  const bool whole_bytes = type.size % kBitsOfByte == 0;
  const ir::Operand at =
      whole_bytes ? operate(Code::Copy, type, value.at) : operate(Code::Wrap, type, value.at, {}, type.size);
  return {at, type};
}

Term Arithmetic::needed(const Term& value, int bits) {
  return value.exact || value.type.size >= bits ? value : wrapped(value);
}

/// To the same exponent's type, modulo its size.
Term Arithmetic::reduced(const Term& value, const Scalar& type) {
  if (value.exact && fits(value.type, type)) return value;
  if (is_uniform_value(value)) return uniform_value(converted_tree(tree_of(value), type));
  const Term known = needed(value, type.size);
  if (known.exact && fits(known.type, type)) return known;
  return with_type(known, type);
}

/// What an operator has computed becomes the node's number: floored to its exponent, reduced to its size.
Term Arithmetic::finished(const Term& value, const Scalar& type) {
  Term result = value;
  if (value.type.exponent > type.exponent) {
    result = shifted_right(value, value.type.exponent - type.exponent, type.size);
  } else if (type.size + value.type.exponent - type.exponent < 1) {
    result = shifted_left(value, type.exponent - value.type.exponent, type.size);
  }
  return reduced(result, at_exponent(type, result.type.exponent));
}

/// value 2^places, of which the low `bits` are wanted, at an exponent that leaves its meaning.
Term Arithmetic::shifted_left(const Term& value, int places, int bits) {
  if (places == 0) return value;
  const Scalar full = Scalar::fixed(value.type.is_signed, value.type.size + places, value.type.exponent + places);
  if (is_uniform_value(value)) {
    Term result = uniform_value(converted_tree(tree_of(value), resized(full, std::min(full.size, kMostBits))));
    return result;
  }
  const Term known = needed(value, std::max(bits - places, 1));
  const int bytes = bytes_of(std::min(full.size, bits));
  const Scalar held = resized(full, std::min(full.size, kBitsOfByte * bytes));
  Term result{{}, held, known.exact};
  if (places > kMostBits) {  // nothing is left of it
    result.at = operate(Code::Copy, resized(full, kBitsOfByte * bytes), constant(0, held));
    return {result.at, resized(full, kBitsOfByte * bytes)};
  }
  result.at = operate(Code::ShiftLeft, resized(full, kBitsOfByte * bytes), known.at, {}, places);
  if (known.exact) return result;
  return with_type(result, resized(full, std::min({known.type.size + places, held.size})));
}

/// floor(value / 2^places), of which the low `bits` are wanted.
Term Arithmetic::shifted_right(const Term& value, int places, int bits) {
  if (places == 0) return value;
  const int exponent = value.type.exponent - places;
  if (is_uniform_value(value)) {
    const Scalar full = Scalar::fixed(value.type.is_signed, std::max(value.type.size - places, 1), exponent);
    return uniform_value(converted_tree(tree_of(value), full));
  }
  const Term known = needed(value, bits + places);
  const Scalar full = Scalar::fixed(known.type.is_signed, std::max(known.type.size - places, 1), exponent);
  ir::Operand at = known.at;
  int rest = places;
  if (options_.fuse) {  // whole bytes are left out by reading further up
    const int whole_bytes = std::min(places / kBitsOfByte, at.bytes - 1);
    at.offset += whole_bytes;
    at.bytes -= whole_bytes;
    rest -= kBitsOfByte * whole_bytes;
  }
  Term result{at, full, known.exact};
  if (rest > 0) {
    const int bytes = bytes_of(std::min(full.size, bits));
    const Scalar held = resized(full, kBitsOfByte * bytes);
    result.at = operate(Code::ShiftRight, held, at, {}, std::min(rest, kMostBits));
    result.type.size = std::min(full.size, held.size);
  }
  return known.exact ? result : with_type(result, result.type);
}

Term Arithmetic::aligned(const Term& value, int exponent, int bits) {
  const int places = exponent - value.type.exponent;
  return places >= 0 ? shifted_left(value, places, bits) : shifted_right(value, -places, bits);
}

/// With all the bits behind the point that it should have: a product by a power of two moves the point, not the bits.
Term Arithmetic::at_least(const Term& value, int exponent) {
  return value.type.exponent < exponent ? aligned(value, exponent, kMostBits) : value;
}

/// In a number of so many bytes, for operations byte by byte.
Term Arithmetic::extended(const Term& value, int bytes) {
  Term result = value;
  if (value.at.bytes < bytes && !is_uniform_value(value)) {
    const Scalar type = Scalar::fixed(value.at.is_signed, kBitsOfByte * bytes, value.type.exponent);
    result.at = operate(Code::Copy, type, value.at);
  }
  result.at.bytes = bytes;
  return result;
}

Term Arithmetic::fixed_convert(const Term& value, const Scalar& to) {
  if (to == Scalar::boolean()) return nonzero(value);
  return reduced(aligned(value, to.exponent, to.size), to);
}

Term Arithmetic::nonzero(const Term& value) {
  const Term known = wrapped(value);
  const Scalar boolean = Scalar::boolean();
  if (!known.type.is_signed && known.type.size == 1) return {known.at, boolean};
  const ir::Operand zero = constant(0, Scalar::fixed(known.type.is_signed, 2, 0));
  if (!known.type.is_signed) {
    const ir::Operand d = temporary(boolean);
    operate_into(d, Code::Less, zero, known.at);
    return {d, boolean};
  }
  const ir::Operand d = temporary(boolean);
  operate_into(d, Code::Equal, known.at, zero);
  return logical_not({d, boolean});
}

Term Arithmetic::fixed_saturate(const Term& value, const Scalar& to) {
  Term known = wrapped(value);
  const int places = to.exponent - known.type.exponent;
  if (places <= 0 || known.type.size + places <= kMostBits) {
    known = aligned(known, to.exponent, kMostBits);
    if (fits(known.type, to)) return known;
    return {operate(Code::Saturate, to, known.at, {}, to.size), to};
  }
  // The shifted number has more than 64 bits: what is too great shows before the shift.
  const std::uint64_t all = ~std::uint64_t{0} >> (kMostBits - to.size);
  const std::uint64_t most = to.is_signed ? all >> 1 : all;
  const std::uint64_t least = to.is_signed ? ~most : 0;
  const std::uint64_t above = places < kMostBits ? most >> places : 0;
  const auto lowest = static_cast<std::int64_t>(least);
  const std::uint64_t below = places < to.size ? static_cast<std::uint64_t>(lowest >> std::min(places, 63)) : 0;
  const Scalar wide = Scalar::fixed(to.is_signed, kMostBits, 0);
  ir::Operand at = shifted_left(known, places, to.size).at;
  at = operate(Code::Wrap, to, at, {}, to.size);
  const Term plain{known.at, Scalar::fixed(known.type.is_signed, known.type.size, 0)};
  const Term upper{constant(above, wide), wide}, lower{constant(below, wide), wide};
  ir::Operand test = compare_values(Op::Less, upper, plain, false);
  at = select(test, to, constant(most, to), at);
  if (known.type.is_signed) {
    test = compare_values(Op::Less, plain, lower, false);
    at = select(test, to, constant(least, to), at);
  }
  return {at, to};
}

Term Arithmetic::fixed_add(const Term& a, const Term& b, bool subtract, const Scalar& type) {
  const int exponent = std::max(a.type.exponent, b.type.exponent);
  const Scalar p = at_exponent(a.type, exponent), q = at_exponent(b.type, exponent);
  const bool any_sign = p.is_signed || q.is_signed, sign = subtract || any_sign;
  const int magnitude = std::max(p.size - p.sign_bits(), q.size - q.sign_bits());
  const Scalar exact = Scalar::fixed(sign, magnitude + (subtract ? (any_sign ? 1 : 0) : 1) + (sign ? 1 : 0), exponent);
  const Scalar most = at_exponent(type, exponent);
  const bool whole = a.exact && b.exact && fits(exact, most);
  const Scalar held = whole ? exact : most;
  const Term x = needed(aligned(a, exponent, held.size), held.size);
  const Term y = needed(aligned(b, exponent, held.size), held.size);
  const Term sum{operate(subtract ? Code::Sub : Code::Add, held, x.at, y.at), held, whole};
  return finished(whole ? sum : with_type(sum, held), type);
}

Term Arithmetic::fixed_bitwise(Op op, const Term& a, const Term& b, const Scalar& type) {
  const int exponent = std::max(a.type.exponent, b.type.exponent);
  const Scalar most = at_exponent(type, exponent);
  const Scalar p = at_exponent(a.type, exponent), q = at_exponent(b.type, exponent);
  Scalar exact = pfman::join(p, q);
  if (op == Op::BitAnd && !p.is_signed && !q.is_signed) exact.size = std::min(p.size, q.size);
  const bool whole = a.exact && b.exact && fits(exact, most);
  const Scalar held = whole ? exact : most;
  const auto prepared = [&](const Term& value) {
    return extended(needed(aligned(value, exponent, held.size), held.size), held.bytes());
  };
  const Kind kind = op == Op::BitAnd ? Kind::And : op == Op::BitOr ? Kind::Or : Kind::Xor;
  const Term x = prepared(a), y = prepared(b);
  const Term value{join(kind, held, x.at, y.at), held, whole};
  return finished(whole ? value : with_type(value, held), type);
}

/// Of an unsigned number only its own bits change.
Term Arithmetic::fixed_complement(const Term& value, const Scalar& type) {
  if (value.type.exponent < type.exponent) return fixed_complement(at_least(value, type.exponent), type);
  const Scalar held = at_exponent(type, value.type.exponent);
  const Term known = extended(needed(value, held.size), held.bytes());
  const std::uint64_t bits = ~std::uint64_t{0} >> (kMostBits - held.size);
  const bool whole = value.exact && fits(value.type, held);
  const ir::Operand ones = constant(held.is_signed ? ~std::uint64_t{0} : bits, held);
  const Term result{join(Kind::Xor, held, known.at, ones), held, whole};
  return finished(whole ? result : with_type(result, held), type);
}

}  // namespace pfman
