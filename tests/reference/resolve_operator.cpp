// Operators: their operands' types met, their results' types from the bottom up.
#include <algorithm>

#include "tests/reference/limit.h"
#include "tests/reference/machine.h"
#include "tests/reference/resolver.h"

namespace reference {
namespace {

using pfman::ast::Operator;

bool is_literal(const Node& node) { return node.kind == Node::Kind::Literal && node.untyped; }

/// Operands that are all literals without surroundings: one type for them.
void settle_together(std::vector<NodePtr>& nodes) {
  if (meet(nodes)) return;
  const bool real = std::any_of(nodes.begin(), nodes.end(), [](const NodePtr& n) { return n->real; });
  for (NodePtr& node : nodes) settle(*node, real ? kFloat : unsigned_fixed(1, 0));
}

NodePtr with_operands(Node::Kind kind, Operator op, std::vector<NodePtr> operands, pfman::Location where) {
  NodePtr made = make_node(kind, where);
  made->op = op;
  made->uniform = std::all_of(operands.begin(), operands.end(), [](const NodePtr& n) { return n->uniform; });
  made->operands = std::move(operands);
  return made;
}

std::vector<NodePtr> pair_of(NodePtr a, NodePtr b) {
  std::vector<NodePtr> both;
  both.push_back(std::move(a));
  both.push_back(std::move(b));
  return both;
}

}  // namespace

NodePtr Resolver::unary_node(Operator op, NodePtr operand, pfman::Location where) {
  if (is_literal(*operand)) return fold(op, *operand, nullptr, where);
  if (op == Operator::Not) operand = condition(std::move(operand));
  settle(*operand, std::nullopt);
  if (op == Operator::Plus) return operand;
  std::vector<NodePtr> operands;
  operands.push_back(std::move(operand));
  const Number number = operands[0]->number;
  const Shape shape = operands[0]->shape;
  NodePtr made =
      with_operands(op == Operator::Not ? Node::Kind::Logic : Node::Kind::Unary, op, std::move(operands), where);
  made->shape = shape;
  if (op == Operator::Not) {
    made->number = kBool;
  } else if (op == Operator::Complement) {
    if (number.floating) fail(202, where, "~ of a float");
    made->number = number;
  } else {
    made->number = number.floating ? kFloat : negation_type(number);
  }
  return made;
}

NodePtr Resolver::binary_node(Operator op, NodePtr a, NodePtr b, pfman::Location where) {
  if (is_literal(*a) && is_literal(*b)) return fold(op, *a, b.get(), where);
  switch (op) {
    case Operator::And:
    case Operator::Or: {
      NodePtr first = condition(std::move(a)), second = condition(std::move(b));
      NodePtr made = with_operands(Node::Kind::Logic, op, pair_of(std::move(first), std::move(second)), where);
      made->number = kBool;
      return made;
    }
    case Operator::ShiftLeft:
    case Operator::ShiftRight: return shift_node(op, std::move(a), std::move(b), where);
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Greater:
    case Operator::GreaterEqual:
    case Operator::Equal:
    case Operator::NotEqual: return comparison_node(op, std::move(a), std::move(b), where);
    default: return arithmetic_node(op, std::move(a), std::move(b), where);
  }
}

NodePtr Resolver::arithmetic_node(Operator op, NodePtr a, NodePtr b, pfman::Location where) {
  std::vector<NodePtr> operands = pair_of(std::move(a), std::move(b));
  settle_together(operands);
  const Shape shape = broadcast(operands[0]->shape, operands[1]->shape, where);
  if (op == Operator::Divide || op == Operator::Remainder) {
    for (NodePtr& operand : operands) operand = whole(std::move(operand));
  }
  const Number x = operands[0]->number, y = operands[1]->number;
  NodePtr made = with_operands(Node::Kind::Binary, op, std::move(operands), where);
  made->shape = shape;
  if (x.floating) {
    made->number = kFloat;
    return made;
  }
  switch (op) {
    case Operator::Add: made->number = sum_type(x, y); break;
    case Operator::Subtract: made->number = difference_type(x, y); break;
    case Operator::Multiply: made->number = product_type(x, y); break;
    case Operator::Divide: made->number = quotient_type(x, y); break;
    case Operator::Remainder:
      require_alignment(x, y, where);
      made->number = remainder_type(x, y);
      break;
    default: made->number = bits_type(op, x, y); break;
  }
  return made;
}

NodePtr Resolver::comparison_node(Operator op, NodePtr a, NodePtr b, pfman::Location where) {
  std::vector<NodePtr> operands = pair_of(std::move(a), std::move(b));
  settle_together(operands);
  for (NodePtr& operand : operands) operand = whole(std::move(operand));
  if (!operands[0]->number.floating) require_alignment(operands[0]->number, operands[1]->number, where);
  broadcast(operands[0]->shape, operands[1]->shape, where);
  NodePtr made = with_operands(Node::Kind::Compare, op, std::move(operands), where);
  made->number = kBool;
  return made;
}

NodePtr Resolver::shift_node(Operator op, NodePtr a, NodePtr b, pfman::Location where) {
  settle(*a, std::nullopt);
  NodePtr count = whole(std::move(b));
  if (a->number.floating || count->number.floating || !count->uniform) fail(206, where, "shift that is not possible");
  if (!is_constant(*count)) {
    const Number number = a->number;
    NodePtr shifted = whole(std::move(a));
    NodePtr made = with_operands(Node::Kind::Shift, op, pair_of(std::move(shifted), std::move(count)), where);
    made->number = number;
    return made;
  }
  Machine machine(1);
  const Wide shift = machine.integer_of(*count);
  if (shift < 0 || shift > 64) fail(202, where, "shift out of range");
  std::vector<NodePtr> operands;
  operands.push_back(std::move(a));
  Number number = operands[0]->number;
  NodePtr made = with_operands(Node::Kind::Scale, op, std::move(operands), where);
  made->shift = static_cast<int>(op == Operator::ShiftLeft ? shift : -shift);
  number.exponent -= made->shift;
  made->number = number;
  return made;
}

}  // namespace reference
