// Expressions other than operators.
#include <algorithm>

#include "tests/reference/builtin.h"
#include "tests/reference/limit.h"
#include "tests/reference/resolver.h"

namespace reference {

using pfman::ast::Operator;

NodePtr Resolver::node(const Expression& expression) {
  using Kind = Expression::Kind;
  switch (expression.kind) {
    case Kind::Integer:
    case Kind::Real:
    case Kind::Boolean: return literal_node(expression);
    case Kind::Name: {
      NodePtr made = make_node(Node::Kind::Read, expression.where);
      made->variable = find(expression.name, expression.where);
      made->number = made->variable->number;
      made->shape = made->variable->shape;
      made->uniform = made->variable->uniform;
      return made;
    }
    case Kind::Unary: return unary_node(expression.op, node(*expression.operands[0]), expression.where);
    case Kind::Binary: {
      NodePtr first = node(*expression.operands[0]);
      return binary_node(expression.op, std::move(first), node(*expression.operands[1]), expression.where);
    }
    case Kind::Conditional: return conditional_node(expression);
    case Kind::Assign: return assignment_node(expression);
    case Kind::PostIncrement:
    case Kind::PostDecrement: return increment_node(expression);
    case Kind::Call: return call_node(expression);
    case Kind::Index: {
      NodePtr made = make_node(Node::Kind::Index, expression.where);
      made->operands.push_back(node(*expression.operands[0]));
      settle(*made->operands[0], std::nullopt);
      made->operands.push_back(whole(node(*expression.operands[1])));
      const Node& array = *made->operands[0];
      if (array.shape.scalar()) fail(203, expression.where, "index of a scalar");
      if (made->operands[1]->number.floating || made->operands[1]->number.exponent > 0) {
        fail(202, expression.where, "index that is no integer");
      }
      if (!made->operands[1]->uniform) fail(205, expression.where, "varying index");
      made->number = array.number;
      made->shape = array.shape.element();
      made->uniform = array.uniform;
      return made;
    }
    case Kind::Array: return array_node(expression);
    case Kind::Cast: {
      NodePtr operand = node(*expression.operands[0]);
      // An expression of the very type stays a root of its own.
      NodePtr value = root(std::move(operand), number_of(*expression.cast), expression.saturate);
      NodePtr made = make_node(Node::Kind::Convert, expression.where);
      made->number = value->number;
      made->target = value->number;
      made->shape = value->shape;
      made->uniform = value->uniform;
      made->operands.push_back(std::move(value));
      return made;
    }
  }
  fail(0, expression.where, "unknown expression");
}

NodePtr Resolver::literal_node(const Expression& expression) {
  NodePtr made = make_node(Node::Kind::Literal, expression.where);
  if (expression.kind == Expression::Kind::Real && expression.float_suffix) {
    made->number = kFloat;
    made->raw = float_bits(static_cast<float>(expression.real));
    return made;
  }
  made->untyped = true;
  made->real = expression.kind == Expression::Kind::Real;
  made->literal = made->real ? expression.real : static_cast<double>(expression.integer);
  made->raw = expression.integer;
  return made;
}

NodePtr Resolver::array_node(const Expression& expression) {
  NodePtr made = make_node(Node::Kind::Array, expression.where);
  for (const auto& operand : expression.operands) made->operands.push_back(node(*operand));
  for (const NodePtr& operand : made->operands) {
    made->uniform = made->uniform && operand->uniform;
    made->real = made->real || operand->real;
    if (operand->shape != made->operands[0]->shape) fail(203, expression.where, "elements of different shapes");
  }
  made->shape = {static_cast<int>(made->operands.size()), made->operands[0]->shape.rows};
  if (!meet(made->operands)) {
    made->untyped = true;
    return made;
  }
  made->number = made->operands[0]->number;
  for (const NodePtr& operand : made->operands) made->number = join(made->number, operand->number);
  return made;
}

NodePtr Resolver::conditional_node(const Expression& expression) {
  NodePtr chosen = condition(node(*expression.operands[0]));
  Nodes branches;
  branches.push_back(node(*expression.operands[1]));
  branches.push_back(node(*expression.operands[2]));
  const bool typed = meet(branches);
  NodePtr made = make_node(Node::Kind::Conditional, expression.where);
  made->uniform = chosen->uniform && branches[0]->uniform && branches[1]->uniform;
  made->untyped = !typed;
  made->real = branches[0]->real || branches[1]->real;
  made->shape = branches[0]->shape;
  if (branches[0]->shape != branches[1]->shape) fail(203, expression.where, "branches of different shapes");
  if (typed) made->number = join(branches[0]->number, branches[1]->number);
  made->operands.push_back(std::move(chosen));
  for (NodePtr& branch : branches) made->operands.push_back(std::move(branch));
  return made;
}

NodePtr Resolver::assignment_node(const Expression& expression) {
  NodePtr target = node(*expression.operands[0]);
  NodePtr value = node(*expression.operands[1]);
  if (expression.op != Operator::None) {
    value = binary_node(expression.op, node(*expression.operands[0]), std::move(value), expression.where);
  }
  if (value->shape != target->shape) fail(203, expression.where, "assignment between different shapes");
  if (target->uniform && !value->uniform) fail(301, expression.where, "varying value for a uniform variable");
  note_color(*target);
  NodePtr made = make_node(Node::Kind::Assign, expression.where);
  made->number = target->number;
  made->shape = target->shape;
  made->uniform = target->uniform;
  value = root(std::move(value), target->number);
  made->operands.push_back(std::move(target));
  made->operands.push_back(std::move(value));
  return made;
}

/// Which of the light's colours something assigns.
void Resolver::note_color(const Node& target) {
  const Variable* base = (target.kind == Node::Kind::Read ? &target : target.operands[0].get())->variable;
  for (int n = 0; base != nullptr && n < 3; ++n) {
    const char* const names[] = {"px_light_color", "px_light_ambient", "px_light_specular"};
    if (base == scopes_.front().at(names[n])) three_colors_[n] = true;
  }
}

NodePtr Resolver::increment_node(const Expression& expression) {
  NodePtr one = make_node(Node::Kind::Literal, expression.where);
  one->untyped = true;
  one->literal = 1;
  one->raw = 1;
  const Operator op = expression.kind == Expression::Kind::PostIncrement ? Operator::Add : Operator::Subtract;
  NodePtr made = make_node(Node::Kind::Increment, expression.where);
  made->operands.push_back(node(*expression.operands[0]));
  const Node& target = *made->operands[0];
  note_color(target);
  made->number = target.number;
  made->shape = target.shape;
  made->uniform = target.uniform;
  NodePtr sum = binary_node(op, node(*expression.operands[0]), std::move(one), expression.where);
  made->operands.push_back(root(std::move(sum), made->number));
  return made;
}

NodePtr Resolver::call_node(const Expression& expression) {
  bool defined = false;
  for (const auto& definition : unit_.definitions) {
    defined =
        defined || (definition.name == expression.name && definition.kind == pfman::ast::Definition::Kind::Function);
  }
  if (!defined) {
    Nodes operands;
    for (const auto& operand : expression.operands) operands.push_back(node(*operand));
    return builtin_node(expression.name, std::move(operands), expression.where);
  }
  Function& called = function(expression.name);
  if (called.parameters.size() != expression.operands.size()) fail(132, expression.where, "wrong number of arguments");
  NodePtr made = make_node(Node::Kind::Call, expression.where);
  made->function = &called;
  for (std::size_t n = 0; n < called.parameters.size(); ++n) {
    const Variable& parameter = *called.parameters[n];
    NodePtr argument = node(*expression.operands[n]);
    if (argument->shape != parameter.shape) fail(132, argument->where, "argument of another shape");
    if (parameter.uniform && !argument->uniform) fail(301, argument->where, "varying argument for a uniform parameter");
    made->operands.push_back(root(std::move(argument), parameter.number));
    const bool output = called.definition->parameters[n].specifiers->output;
    made->results.push_back(output ? node(*expression.operands[n]) : nullptr);
    if (output) note_color(*made->results.back());
  }
  if (called.result != nullptr) {
    made->number = called.result->number;
    made->shape = called.result->shape;
    made->uniform = called.result->uniform;
  }
  return made;
}

}  // namespace reference
