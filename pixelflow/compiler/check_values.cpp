// Literals get the type of what they meet; every typed expression that has to become another type is converted.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "pixelflow/compiler/checker.h"
#include "pixelflow/compiler/fixed_types.h"

namespace pfman {

Value Value::typed(NodePtr node) {
  Value value;
  if (!node) return value;
  value.kind = Kind::Typed;
  value.where = node->where;
  value.node = std::move(node);
  return value;
}

std::string Value::spelled() const {
  if (!untyped()) return spelling(type());
  std::string text = "number";
  for (int n = 0; n < shape.rank; ++n)
    text += "[" + std::to_string(shape.dimensions[static_cast<std::size_t>(n)]) + "]";
  return text;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

Value Value::whole(std::int64_t integer, Location where) {
  Value value;
  value.kind = Kind::Literal;
  value.where = where;
  value.integer = integer;
  value.number = static_cast<double>(integer);
  return value;
}

Value Value::of(double number, Location where) {
  Value value;
  value.kind = Kind::Literal;
  value.where = where;
  value.real = true;
  value.number = number;
  return value;
}

Value Checker::untyped(Value::Kind kind, Values parts, Location where) {
  Value value;
  value.kind = kind;
  value.where = where;
  for (const Value& part : parts) {
    value.real = value.real || part.real;
    value.shape.varying = value.shape.varying || part.shape.varying;
    if (part.shape.rank > value.shape.rank) {
      value.shape.rank = part.shape.rank;
      value.shape.dimensions = part.shape.dimensions;
    }
  }
  value.parts = std::move(parts);
  return value;
}

/// Null for a mistake.
NodePtr Checker::settle(Value value, const std::optional<Scalar>& surroundings) {
  if (value.mistake()) return nullptr;
  if (value.kind == Value::Kind::Typed) return std::move(value.node);
  const Scalar target = surroundings ? *surroundings : value.real ? Scalar::floating() : Scalar::fixed(false, 1, 0);
  if (value.kind == Value::Kind::Literal) {
    if (target.is_float) {
      if (value.real) return make_float(value.number, value.where);
      const FixedLiteral literal = integer_literal(value.integer);
      return to_float(make_literal(literal.scalar, literal.raw, value.where));
    }
    const FixedLiteral literal =
        value.real ? fixed_literal(value.number, std::max(16, target.exponent)) : integer_literal(value.integer);
    return make_literal(literal.scalar, literal.raw, value.where);
  }
  Nodes parts;
  for (Value& part : value.parts) {
    parts.push_back(settle(std::move(part), target));
    if (!parts.back()) return nullptr;
  }
  switch (value.kind) {
    case Value::Kind::Choice:
      return make_select(std::move(value.node), std::move(parts[0]), std::move(parts[1]), value.where);
    case Value::Kind::Array: return make_array(std::move(parts), value.where);
    default: return write_.generic(value.name, std::move(parts), value.where);
  }
}

/// Literals among the values take the type of the others; if one of these is float, all are made floats. False where
/// all are literals, and nothing is done then.
bool Checker::meet(Values& values, Nodes& typed) {
  std::optional<Scalar> common;
  for (const Value& value : values) {
    if (value.kind != Value::Kind::Typed) continue;
    common = common ? join(*common, value.node->exact) : value.node->exact;
  }
  if (!common) return false;
  for (Value& value : values) {
    NodePtr node = settle(std::move(value), common);
    if (node && common->is_float) node = to_float(std::move(node));
    typed.push_back(std::move(node));
  }
  return true;
}

/// As meet(); literals alone are floats if one is real, else fixed.
void Checker::settle_together(Values values, Nodes& typed) {
  if (meet(values, typed)) return;
  const bool real = std::any_of(values.begin(), values.end(), [](const Value& value) { return value.real; });
  for (Value& value : values) typed.push_back(settle(std::move(value), real ? Scalar::floating() : Scalar::boolean()));
}

namespace {

std::string written(double value) {
  std::ostringstream out;
  out.precision(10);
  out << value;
  return out.str();
}

}  // namespace

/// A literal as the target holds it, and a warning where it cannot.
NodePtr Checker::fit(const Value& value, NodePtr literal, const Scalar& target, bool saturate) {
  const Scalar from = literal->exact;
  if (target == Scalar::boolean()) return make_convert(std::move(literal), target);
  const std::uint64_t raw = convert(literal->raw, from, target, saturate);
  if (!saturate) {
    // The same number in the widest type of the target's exponent shows whether anything was lost.
    const double scaled = std::floor(std::ldexp(to_double(literal->raw, from), target.exponent));
    const double kept = std::ldexp(to_double(raw, target), target.exponent);
    if (scaled != kept) {
      error(601, value.where,
            "constant " + written(value.number) + " is out of the range of '" + spelling(target) + "' and becomes " +
                written(to_double(raw, target)));
    }
  }
  return make_literal(target, raw, literal->where);
}

/// The value in the target's type: a root of the sizing passes.
NodePtr Checker::convert_to(Value value, const Scalar& target, bool saturate) {
  if (value.mistake()) return nullptr;
  const bool truth = target == Scalar::boolean();
  if (value.kind == Value::Kind::Literal && !target.is_float && !(truth && value.real)) {
    const FixedLiteral fixed =
        value.real ? fixed_literal(value.number, std::max(16, target.exponent)) : integer_literal(value.integer);
    NodePtr literal = make_literal(fixed.scalar, fixed.raw, value.where);
    return fit(value, std::move(literal), target, saturate);
  }
  if (value.kind == Value::Kind::Array && !target.is_float) {
    const Location where = value.where;
    Nodes parts;
    for (Value& part : value.parts) {
      parts.push_back(convert_to(std::move(part), target, saturate));
      if (!parts.back()) return nullptr;
    }
    return make_array(std::move(parts), where);
  }
  NodePtr node = settle(std::move(value), truth ? std::nullopt : std::optional<Scalar>(target));
  if (!node) return nullptr;
  if (node->type.is_void) {
    error(202, node->where, "a call of a void function has no value");
    return nullptr;
  }
  const Location where = node->where;
  if (truth && node->exact.is_float) {
    error(202, where, "a float does not convert to bool; compare it with a number");
    return nullptr;
  }
  if (!target.is_float && node->exact.is_float) warn_mixed(*node);
  if (saturate) return make_node(Node::Op::Saturate, target, nodes(std::move(node)), where);
  return make_convert(std::move(node), target);
}

NodePtr Checker::condition(Value value) {
  NodePtr node = settle(std::move(value));
  if (!node) return nullptr;
  if (node->type.is_void || node->type.is_array() || node->exact.is_float) {
    error(202, node->where,
          "a condition of type '" + spelling(node->type) + "' is neither true nor false; compare it with a number");
    return nullptr;
  }
  if (node->exact == Scalar::boolean()) return node;
  return make_convert(std::move(node), Scalar::boolean());
}

namespace {

bool is_arithmetic(const Node& node) {
  switch (node.op) {
    case Node::Op::Add:
    case Node::Op::Subtract:
    case Node::Op::Multiply:
    case Node::Op::Divide:
    case Node::Op::Remainder: return true;
    default: return false;
  }
}

/// A varying fixed-point number that was converted to meet a float.
bool is_converted(const Node& node) {
  return node.op == Node::Op::Convert && node.type.varying && !node.operands[0]->exact.is_float;
}

}  // namespace

/// `node` is float and becomes fixed: does it calculate with fixed numbers only because of a float operand?
void Checker::warn_mixed(const Node& node) {
  if (!is_arithmetic(node) || !node.type.varying || !node.exact.is_float) {
    if (node.op == Node::Op::Negate) warn_mixed(*node.operands[0]);
    return;
  }
  for (std::size_t n = 0; n < 2 && node.operands.size() == 2; ++n) {
    const Node &fixed = *node.operands[n], &other = *node.operands[1 - n];
    if (is_converted(fixed) && !is_converted(other) && other.exact.is_float) {
      const Node* base = &other;
      while (base->op == Node::Op::Element) base = base->operands[0].get();
      const std::string named = base->op == Node::Op::Variable ? "'" + base->variable->name + "'" : "an operand";
      error(602, other.where,
            named + " is float and makes this fixed-point arithmetic float; its result becomes fixed again");
      return;
    }
  }
  for (const NodePtr& operand : node.operands) warn_mixed(*operand);
}

}  // namespace pfman
