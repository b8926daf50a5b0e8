// Names, elements, array literals, choices, casts.
#include <algorithm>

#include "pixelflow/compiler/checker.h"

namespace pfman {

using Op = Node::Op;
using Kind = ast::Expression::Kind;

Value Checker::expression(const ast::Expression& expression) {
  switch (expression.kind) {
    case Kind::Integer:
    case Kind::Boolean: return Value::whole(static_cast<std::int64_t>(expression.integer), expression.where);
    case Kind::Real:
      if (expression.float_suffix) return Value::typed(make_float(expression.real, expression.where));
      return Value::of(expression.real, expression.where);
    case Kind::Name: return name(expression);
    case Kind::Unary: return unary(expression.op, this->expression(*expression.operands[0]), expression.where);
    case Kind::Binary: {
      if (expression.op == ast::Operator::And || expression.op == ast::Operator::Or) return logic(expression);
      Value first = this->expression(*expression.operands[0]);
      return binary(expression.op, std::move(first), this->expression(*expression.operands[1]), expression.where);
    }
    case Kind::Conditional: return conditional(expression);
    case Kind::Assign: return assignment(expression);
    case Kind::PostIncrement:
    case Kind::PostDecrement: return postfix(expression);
    case Kind::Call: return call(expression);
    case Kind::Index: return index(expression);
    case Kind::Array: return array(expression);
    case Kind::Cast: return cast(expression);
  }
  return {};
}

Value Checker::name(const ast::Expression& expression) {
  if (expression.name.starts_with("px_light_")) return light_variable(expression);
  Symbol* symbol = find(expression.name);
  if (symbol == nullptr) {
    const bool function = functions_.contains(expression.name);
    return mistake(110, expression.where,
                   function ? "'" + expression.name + "' is a function; a variable is needed here"
                            : "undeclared identifier '" + expression.name + "'");
  }
  symbol->used = true;
  // A declaration that was a mistake leaves a name without a variable.
  if (symbol->variable == nullptr || symbol->variable->type.is_void) return {};
  return Value::typed(make_read(symbol->variable, expression.where));
}

/// An index: uniform, an integer, within the array where it is constant. Null for a mistake.
NodePtr Checker::index_of(const Type& array, const ast::Expression& expression) {
  NodePtr node = settle(this->expression(expression));
  if (!node) return nullptr;
  if (node->type.is_void || node->type.is_array() || node->exact.is_float || node->exact.exponent > 0) {
    error(202, node->where, "an index of type '" + spelling(node->type) + "' is no integer");
    return nullptr;
  }
  if (node->type.varying) {
    error(205, node->where, "an index that varies from pixel to pixel");
    return nullptr;
  }
  if (!is_constant(*node)) return node;
  const std::optional<std::int64_t> value = constant_integer(*node);
  if (!value) return nullptr;
  if (*value < 0 || *value >= array.dimensions[0]) {
    error(204, node->where, "index " + std::to_string(*value) + " is outside of '" + spelling(array) + "'");
    return nullptr;
  }
  return make_integer(*value, node->where);
}

Value Checker::index(const ast::Expression& expression) {
  NodePtr array = settle(this->expression(*expression.operands[0]));
  if (!array) return {};
  if (!array->type.is_array()) {
    return mistake(203, expression.operands[1]->where,
                   "an index of type '" + spelling(array->type) + "', which is no array");
  }
  NodePtr index = index_of(array->type, *expression.operands[1]);
  if (!index) return {};
  if (array->op == Op::Variable || array->op == Op::Element) return Value::typed(make_element(*array, *index));
  Nodes before;
  if (!is_plain(*index)) index = write_.reuse(std::move(index), before);
  if (!has_elements(*array, *index)) array = write_.keep(std::move(array), before);
  return Value::typed(make_sequence(std::move(before), make_element(*array, *index), expression.where));
}

Value Checker::array(const ast::Expression& expression) {
  Values parts;
  bool right = true;
  for (const auto& operand : expression.operands) {
    parts.push_back(this->expression(*operand));
    right = right && !parts.back().mistake();
  }
  if (!right || parts.empty()) return {};
  const Type row = parts[0].type();
  for (const Value& part : parts) {
    if (part.type().is_void) return mistake(202, part.where, "a call of a void function has no value");
    if (!part.type().same_shape(row)) return mistake(203, part.where, "elements of an array have different shapes");
  }
  if (row.rank == 2) return mistake(203, expression.where, "an array has at most two dimensions");
  const int length = static_cast<int>(parts.size());
  Nodes typed;
  if (meet(parts, typed)) {
    if (std::any_of(typed.begin(), typed.end(), [](const NodePtr& node) { return !node; })) return {};
    return Value::typed(make_array(std::move(typed), expression.where));
  }
  Value value = untyped(Value::Kind::Array, std::move(parts), expression.where);
  value.shape.rank = row.rank + 1;
  value.shape.dimensions = {length, row.dimensions[0]};
  return value;
}

Value Checker::conditional(const ast::Expression& expression) {
  NodePtr chosen = condition(this->expression(*expression.operands[0]));
  const int effects = effects_;
  Values branches;
  branches.push_back(this->expression(*expression.operands[1]));
  branches.push_back(this->expression(*expression.operands[2]));
  if (!chosen || branches[0].mistake() || branches[1].mistake()) return {};
  if (branches[0].type().is_void || branches[1].type().is_void) {
    return mistake(202, expression.where, "a call of a void function has no value");
  }
  if (!branches[0].type().same_shape(branches[1].type())) {
    return mistake(203, expression.where, "the branches of '?:' have different shapes");
  }
  const bool varying = chosen->type.varying || branches[0].type().varying || branches[1].type().varying;
  if (varying && effects_ != effects) {
    return mistake(305, expression.where, "assignment or call with effects in a branch of a varying '?:'");
  }
  Nodes typed;
  if (meet(branches, typed)) {
    if (!typed[0] || !typed[1]) return {};
    return Value::typed(make_select(std::move(chosen), std::move(typed[0]), std::move(typed[1]), expression.where));
  }
  Value value = untyped(Value::Kind::Choice, std::move(branches), expression.where);
  value.shape.varying = varying;
  value.node = std::move(chosen);
  return value;
}

Value Checker::cast(const ast::Expression& expression) {
  Value value = this->expression(*expression.operands[0]);
  const std::optional<Scalar> scalar = scalar_of(*expression.cast);
  if (!scalar || value.mistake()) return {};
  if (expression.saturate && scalar->is_float) return mistake(202, expression.where, "'sat' needs a fixed-point type");
  const bool saturate = expression.saturate && *scalar != Scalar::boolean();
  return Value::typed(convert_to(std::move(value), *scalar, saturate));
}

/// && and ||.
Value Checker::logic(const ast::Expression& expression) {
  const int effects = effects_;
  Value first = this->expression(*expression.operands[0]);
  Value second = this->expression(*expression.operands[1]);
  const bool varying = first.type().varying || second.type().varying;
  if (first.mistake() || second.mistake()) return {};
  if (varying && effects_ != effects) {
    return mistake(305, expression.where,
                   std::string("assignment or call with effects in an operand of a varying '") +
                       ast::spelling(expression.op) + "'");
  }
  return binary(expression.op, std::move(first), std::move(second), expression.where);
}

}  // namespace pfman
