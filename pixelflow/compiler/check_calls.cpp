// Calls of functions of the unit.
#include "pixelflow/compiler/checker.h"

namespace pfman {

Value Checker::call(const ast::Expression& expression) {
  const auto found = functions_.find(expression.name);
  if (found == functions_.end()) return call_library(expression);
  if (found->second == nullptr) return {};  // its declaration was a mistake
  return call_function(*found->second, expression);
}

/// An argument of the parameter's type and rate. What is written back behind the call goes to `after`.
NodePtr Checker::argument(const ast::Expression& expression, Variable& parameter, Nodes& before, Nodes& after) {
  const Type& type = parameter.type;
  const auto check_shape = [&](const Type& given, const std::string& spelled) {
    if (!given.is_void && given.same_shape(type)) return true;
    error(132, expression.where,
          "argument for '" + parameter.name + "' is '" + spelled + "'; '" + spelling(type) + "' is needed");
    return false;
  };
  const auto check_rate = [&](const Type& given) {
    if (type.varying || !given.varying) return true;
    error(301, expression.where, "cannot pass a varying value to uniform parameter '" + parameter.name + "'");
    return false;
  };
  if (!parameter.output) {
    Value value = this->expression(expression);
    if (value.mistake() || !check_shape(value.type(), value.spelled()) || !check_rate(value.type())) return nullptr;
    return convert_to(std::move(value), type.scalar);
  }
  if (expression.kind != ast::Expression::Kind::Name && expression.kind != ast::Expression::Kind::Index) {
    error(132, expression.where, "argument for output parameter '" + parameter.name + "' is no variable");
    return nullptr;
  }
  NodePtr place = this->place(expression, before);
  if (!place || !check_shape(place->type, spelling(place->type)) || !check_rate(place->type)) return nullptr;
  if (!assignable(expression, type.varying, expression.where)) return nullptr;
  if (place->exact == type.scalar && place->type.varying == type.varying) return place;
  // Of another type: a variable of the parameter's own is passed and converted afterwards.
  Variable* passed = new_variable(parameter.name, type, Variable::Role::Hidden, expression.where);
  before.push_back(
      make_assign(make_read(passed, expression.where), make_convert(clone(*place), type.scalar), expression.where));
  const Scalar target = place->exact;
  if (target == Scalar::boolean() && type.scalar.is_float) {
    error(202, expression.where, "a float does not convert to bool; compare it with a number");
    return nullptr;
  }
  after.push_back(
      make_assign(std::move(place), make_convert(make_read(passed, expression.where), target), expression.where));
  return make_read(passed, expression.where);
}

Value Checker::call_function(const Function& function, const ast::Expression& expression) {
  if (function.parameters.size() != expression.operands.size()) {
    return mistake(132, expression.where,
                   "'" + function.name + "' takes " + counted(function.parameters.size(), "argument") + ", not " +
                       std::to_string(expression.operands.size()));
  }
  Nodes before, after, arguments;
  bool right = true, effects = function.is_external;
  for (std::size_t n = 0; n < function.parameters.size(); ++n) {
    Variable& parameter = *function.parameters[n];
    effects = effects || parameter.output;
    arguments.push_back(argument(*expression.operands[n], parameter, before, after));
    right = right && arguments.back();
  }
  if (effects) ++effects_;
  if (!right) return {};
  NodePtr node = make_node(Node::Op::Call, function.result.scalar, std::move(arguments), expression.where);
  node->type = function.result;
  node->function = &function;
  if (before.empty() && after.empty()) return Value::typed(std::move(node));
  if (after.empty()) return Value::typed(make_sequence(std::move(before), std::move(node), expression.where));
  if (function.result.is_void) {
    before.push_back(std::move(node));
    NodePtr last = std::move(after.back());
    after.pop_back();
    for (NodePtr& one : after) before.push_back(std::move(one));
    NodePtr sequence = make_sequence(std::move(before), std::move(last), expression.where);
    sequence->type = function.result;
    return Value::typed(std::move(sequence));
  }
  Variable* result = new_variable(function.name, function.result, Variable::Role::Hidden, expression.where);
  before.push_back(make_assign(make_read(result, expression.where), std::move(node), expression.where));
  for (NodePtr& one : after) before.push_back(std::move(one));
  return Value::typed(make_sequence(std::move(before), make_read(result, expression.where), expression.where));
}

}  // namespace pfman
