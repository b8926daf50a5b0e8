// Expressions that vary: arrays taken apart, assignments, choices, conditions.
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "pixelflow/compiler/lowering.h"

namespace pfman {

Terms Lowering::lower_node(const Node& node) {
  const Location before = where_;
  where_ = node.where;
  Terms values = is_uniform(node) && !node.type.is_void ? uniform_values(node) : lower_varying(node);
  where_ = before;
  return values;
}

Terms Lowering::lower_varying(const Node& node) {
  const auto as_node = [&](Terms values) {
    if (!node.type.scalar.is_float) {
      for (Term& value : values) value = finished(value, node.type.scalar);
    }
    return values;
  };
  switch (node.op) {
    case Op::Variable:
    case Op::Element: return as_node(place_of(node));
    case Op::Array: {
      Terms all;
      for (const NodePtr& operand : node.operands) {
        const Terms part = lower_node(*operand);
        all.insert(all.end(), part.begin(), part.end());
      }
      return as_node(std::move(all));
    }
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::NotEqual: return {{compare(node), Scalar::boolean()}};
    case Op::Select: return lower_select(node);
    case Op::Assign: return lower_assign(node);
    case Op::Sequence: {
      Terms last;
      for (const NodePtr& operand : node.operands) last = lower_node(*operand);
      return as_node(std::move(last));
    }
    case Op::Postfix: {
      Terms old = place_of(*node.operands[0]);
      for (Term& value : old) value.at = operate(Code::Copy, value.type, value.at);
      store(*node.operands[0], lower_node(*node.operands[1]));
      return as_node(std::move(old));
    }
    case Op::Call: return as_node(lower_call(node));
    case Op::Noise: return as_node({lower_noise(node)});
    case Op::CellNoise: return as_node({lower_cell_noise(node)});
    case Op::Turbulence: return {lower_turbulence(node)};
    case Op::Texture:
    case Op::Environment: return as_node(lower_lookup(node));
    case Op::Literal: throw std::logic_error("a literal that varies");
    default: return lower_elementwise(node);
  }
}

Terms Lowering::lower_elementwise(const Node& node) {
  // A conversion that drops bits of a sum; saturation sees all of the sum's upper bits, which the floor leaves alone.
  const bool to_fixed = (node.op == Op::Convert && node.exact != Scalar::boolean()) || node.op == Op::Saturate;
  const bool floors = to_fixed && options_.fuse && !node.type.scalar.is_float;
  const Terms a = floors ? lower_floored(*node.operands[0], node.exact.exponent) : lower_node(*node.operands[0]);
  const bool shifts = node.op == Op::ShiftLeft || node.op == Op::ShiftRight;
  Terms result;
  if (shifts) {
    for (const Term& value : a) result.push_back(fixed_shift(node, value));
    return result;
  }
  if (node.operands.size() == 1) {
    for (const Term& value : a) result.push_back(lower_unary(node, value));
    return result;
  }
  const Terms b = lower_node(*node.operands[1]);
  for (std::size_t n = 0; n < std::max(a.size(), b.size()); ++n) {
    result.push_back(lower_binary(node, a[a.size() > 1 ? n : 0], b[b.size() > 1 ? n : 0]));
  }
  return result;
}

Term Lowering::lower_unary(const Node& node, const Term& a) {
  const Scalar& type = node.type.scalar;
  const bool is_float = a.type.is_float;
  switch (node.op) {
    case Op::Convert: {
      if (type.is_float) return to_float(a);
      // What it converts to; of that, only as much as is wanted may remain.
      return finished(convert(a, node.exact, false), type);
    }
    case Op::Saturate: return finished(convert(a, node.exact, true), type);
    case Op::Negate: {
      if (is_float) return float_negate(a);
      const Term zero{constant(0, Scalar::fixed(false, 1, a.type.exponent)), Scalar::fixed(false, 1, a.type.exponent)};
      return fixed_add(zero, a, true, type);
    }
    case Op::Complement: return fixed_complement(a, type);
    case Op::Not: return logical_not(a);
    case Op::Abs: return is_float ? float_abs(a) : fixed_abs(a, type);
    case Op::Floor:
    case Op::Ceil:
    case Op::Round: return is_float ? float_round(node.op, a) : fixed_round(node.op, a, type);
    case Op::SquareRoot:
      if (!is_float) return fixed_square_root(a, type);
      return {operate(Code::FloatSquareRoot, type, a.at), type};
    case Op::Math: return {operate(node.math, type, a.at), type};
    default: throw std::logic_error("an operator of one operand that is none");
  }
}

Term Lowering::lower_binary(const Node& node, const Term& a, const Term& b) {
  const Scalar& type = node.type.scalar;
  if (a.type.is_float) {
    switch (node.op) {
      case Op::Add: return float_binary(Code::FloatAdd, a, b);
      case Op::Subtract: return float_binary(Code::FloatSub, a, b);
      case Op::Multiply: return float_binary(Code::FloatMultiply, a, b);
      case Op::Divide: return float_binary(Code::FloatDivide, a, b);
      case Op::Remainder: return float_remainder(a, b);
      case Op::Math: return float_binary(node.math, a, b);
      default: throw std::logic_error("an operator that floats do not have");
    }
  }
  switch (node.op) {
    case Op::Add: return fixed_add(a, b, false, type);
    case Op::Subtract: return fixed_add(a, b, true, type);
    case Op::Multiply: return fixed_multiply(a, b, type);
    case Op::Divide: return fixed_divide(a, b, type);
    case Op::Remainder: return fixed_remainder(a, b, type);
    case Op::BitAnd:
    case Op::BitOr:
    case Op::BitXor: return fixed_bitwise(node.op, a, b, type);
    case Op::And:
    case Op::Or: {
      const Kind kind = node.op == Op::And ? Kind::And : Kind::Or;
      return {join(kind, Scalar::boolean(), wrapped(a).at, wrapped(b).at), Scalar::boolean()};
    }
    default: throw std::logic_error("an operator of two operands that is none");
  }
}

/// Both ways are computed; a uniform condition chooses on the host.
Terms Lowering::lower_select(const Node& node) {
  const Node& test = *node.operands[0];
  const Scalar& type = node.type.scalar;
  if (is_uniform(test)) {
    Terms result;
    for (int n = 0; n < node.type.count(); ++n) result.push_back({temporary(type), type});
    int opening = begin_if(uniform_tree(test));
    for (const std::size_t way : {1u, 2u}) {
      if (way == 2) opening = begin_else(opening);
      const Terms values = lower_node(*node.operands[way]);
      for (std::size_t n = 0; n < result.size(); ++n) store(result[n], values[values.size() > 1 ? n : 0]);
    }
    end_if(opening);
    return result;
  }

  // A comparison comes last, so that its result need not leave K; its operands come first, as in the text.
  const std::optional<Comparison> comparison = options_.fuse ? comparison_of(test) : std::nullopt;
  const bool in_flag = comparison && node.type.count() == 1;
  const bool swapped = comparison && comparison->negated;
  ir::Operand chosen;
  if (!comparison) chosen = pixel(wrapped(lower_scalar(test)).at);
  if (comparison && !in_flag) chosen = compare_values(comparison->op, comparison->a, comparison->b, true);
  Terms a = lower_node(*node.operands[1]), b = lower_node(*node.operands[2]);
  Terms result;
  for (std::size_t n = 0; n < static_cast<std::size_t>(node.type.count()); ++n) {
    Term x = a[a.size() > 1 ? n : 0], y = b[b.size() > 1 ? n : 0];
    Scalar held = type;
    bool exact = true;
    if (!type.is_float) {
      x = finished(x, type);
      y = finished(y, type);
      const int exponent = std::max(x.type.exponent, y.type.exponent);
      const Scalar most = at_exponent(type, exponent);
      const Scalar both = pfman::join(at_exponent(x.type, exponent), at_exponent(y.type, exponent));
      exact = x.exact && y.exact && fits(both, most);
      held = exact ? both : most;
      const auto prepared = [&](const Term& way) {
        return extended(needed(aligned(way, exponent, held.size), held.size), held.bytes());
      };
      x = prepared(x);
      y = prepared(y);
    }
    if (in_flag) chosen = compare_values(comparison->op, comparison->a, comparison->b, false);
    Term value{select(chosen, held, swapped ? y.at : x.at, swapped ? x.at : y.at), held, exact};
    result.push_back(exact ? value : with_type(value, held));
  }
  return result;
}

Terms Lowering::lower_assign(const Node& node) {
  const Node& target = *node.operands[0];
  Terms values = lower_node(*node.operands[1]);
  Terms places = place_of(target);
  // No element may change before all of the right side has been read.
  for (std::size_t n = 0; n < values.size() && values.size() > 1; ++n) {
    const ir::Operand& from = values[n].at;
    const bool touched = from.kind == ir::Operand::Kind::Pixel &&
                         std::any_of(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n),
                                     [&](const Term& place) { return place.at.variable == from.variable; });
    if (touched) values[n].at = operate(Code::Copy, contents_of(values[n]), from);
  }
  for (std::size_t n = 0; n < places.size(); ++n) store(places[n], values[values.size() > 1 ? n : 0]);
  return places;
}

void Lowering::store(const Node& target, const Terms& values) {
  const Terms places = place_of(target);
  for (std::size_t n = 0; n < places.size(); ++n) store(places[n], values[values.size() > 1 ? n : 0]);
}

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

}  // namespace pfman
