#include "pixelflow/compiler/build.h"

#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/fixed_types.h"
#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/host_numbers.h"

namespace pfman {

using Op = Node::Op;

NodePtr make_node(Op op, const Scalar& scalar, Nodes operands, Location where) {
  auto node = std::make_unique<Node>();
  node->op = op;
  node->where = where;
  node->exact = scalar;
  node->type.scalar = scalar;
  for (const NodePtr& operand : operands) {
    const Type& type = operand->type;
    node->type.varying = node->type.varying || type.varying;
    if (type.rank > node->type.rank) {
      node->type.rank = type.rank;
      node->type.dimensions = type.dimensions;
    }
  }
  node->operands = std::move(operands);
  return node;
}

NodePtr make_literal(const Scalar& scalar, std::uint64_t raw, Location where) {
  NodePtr node = make_node(Op::Literal, scalar, {}, where);
  node->raw = raw;
  return node;
}

NodePtr make_float(double value, Location where) {
  return make_literal(Scalar::floating(), from_float(static_cast<float>(value)), where);
}

NodePtr make_integer(std::int64_t value, Location where) {
  const FixedLiteral literal = integer_literal(value);
  return make_literal(literal.scalar, literal.raw, where);
}

NodePtr make_read(Variable* variable, Location where) {
  NodePtr node = make_node(Op::Variable, variable->type.scalar, {}, where);
  node->type = variable->type;
  node->variable = variable;
  return node;
}

NodePtr make_operation(Op op, Nodes operands, Location where) {
  const Scalar a = operands[0]->exact;
  Scalar result = a;
  switch (op) {
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::NotEqual: {
      NodePtr node = make_node(op, Scalar::boolean(), std::move(operands), where);
      node->type.rank = 0;
      node->type.dimensions = {1, 1};
      return node;
    }
    case Op::And:
    case Op::Or:
    case Op::Not: result = Scalar::boolean(); break;
    default:
      if (!a.is_float) result = operands.size() == 1 ? unary_type(op, a) : binary_type(op, a, operands[1]->exact);
  }
  return make_node(op, result, std::move(operands), where);
}

NodePtr make_math(pixelflow::Code code, Nodes operands, Location where) {
  NodePtr node = make_node(Op::Math, Scalar::floating(), std::move(operands), where);
  node->math = code;
  return node;
}

NodePtr make_array(Nodes elements, Location where) {
  Scalar scalar = elements[0]->exact;
  for (const NodePtr& element : elements) scalar = join(scalar, element->exact);
  if (scalar.is_float) {
    for (NodePtr& element : elements) element = to_float(std::move(element));
  }
  const Type row = elements[0]->type;
  const int length = static_cast<int>(elements.size());
  NodePtr node = make_node(Op::Array, scalar, std::move(elements), where);
  node->type.rank = row.rank + 1;
  node->type.dimensions = {length, row.dimensions[0]};
  return node;
}

NodePtr make_select(NodePtr condition, NodePtr first, NodePtr second, Location where) {
  const Scalar scalar = join(first->exact, second->exact);
  if (scalar.is_float) {
    first = to_float(std::move(first));
    second = to_float(std::move(second));
  }
  return make_node(Op::Select, scalar, nodes(std::move(condition), std::move(first), std::move(second)), where);
}

NodePtr make_assign(NodePtr target, NodePtr value, Location where) {
  const Type type = target->type;
  const Scalar scalar = target->exact;
  NodePtr node = make_node(Op::Assign, scalar, nodes(std::move(target), std::move(value)), where);
  node->type = type;
  return node;
}

NodePtr make_sequence(Nodes before, NodePtr value, Location where) {
  if (before.empty()) return value;
  const Type type = value->type;
  const Scalar exact = value->exact;
  before.push_back(std::move(value));
  NodePtr node = make_node(Op::Sequence, exact, std::move(before), where);
  node->type = type;
  return node;
}

NodePtr make_convert(NodePtr node, const Scalar& to) {
  const Scalar from = node->exact;
  if (node->op == Op::Literal) {
    if (from == to) return node;
    const bool truth = to == Scalar::boolean() && !from.is_float;
    return make_literal(to, truth ? std::uint64_t{node->raw != 0} : convert(node->raw, from, to), node->where);
  }
  const bool leaf = to.is_float || to == Scalar::boolean() || node->op == Op::Variable || node->op == Op::Element;
  if (leaf && from == to) return node;
  const Location where = node->where;
  return make_node(Op::Convert, to, nodes(std::move(node)), where);
}

NodePtr to_float(NodePtr node) { return make_convert(std::move(node), Scalar::floating()); }

namespace {

NodePtr element_of_variable(const Node& array, const Node& index) {
  NodePtr node = make_node(Op::Element, array.exact, nodes(clone(array), clone(index)), array.where);
  node->type = array.type;
  node->type.varying = array.type.varying;
  --node->type.rank;
  node->type.dimensions = {array.type.dimensions[1], 1};
  return node;
}

bool is_elementwise(Op op) {
  switch (op) {
    case Op::Negate:
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Remainder:
    case Op::Select:
    case Op::Convert:
    case Op::Saturate:
    case Op::Abs:
    case Op::Floor:
    case Op::Ceil:
    case Op::Round: return true;
    default: return false;
  }
}

bool elements_follow(const Node& node, const Node& index) {
  switch (node.op) {
    case Op::Variable:
    case Op::Element: return true;
    case Op::Array: return index.op == Op::Literal;
    case Op::Sequence: return elements_follow(*node.operands.back(), index);
    default:
      return is_elementwise(node.op) &&
             std::all_of(node.operands.begin(), node.operands.end(), [&](const NodePtr& operand) {
               return !operand->type.is_array() || elements_follow(*operand, index);
             });
  }
}

/// Assigns hidden variables at most.
bool has_no_effects(const Node& node) {
  if (node.op == Op::Postfix || node.op == Op::Call) return false;
  if (node.op == Op::Assign &&
      (node.operands[0]->op != Op::Variable || node.operands[0]->variable->role != Variable::Role::Hidden)) {
    return false;
  }
  return std::all_of(node.operands.begin(), node.operands.end(),
                     [](const NodePtr& part) { return has_no_effects(*part); });
}

}  // namespace

bool has_elements(const Node& array, const Node& index) {
  return has_no_effects(array) && elements_follow(array, index);
}

NodePtr make_element(const Node& array, const Node& index) {
  switch (array.op) {
    case Op::Variable:
    case Op::Element: return element_of_variable(array, index);
    case Op::Array:
      if (index.op == Op::Literal) return clone(*array.operands.at(static_cast<std::size_t>(index.raw)));
      break;
    case Op::Sequence: {
      Nodes before;
      for (std::size_t n = 0; n + 1 < array.operands.size(); ++n) before.push_back(clone(*array.operands[n]));
      return make_sequence(std::move(before), make_element(*array.operands.back(), index), array.where);
    }
    default: {
      if (!is_elementwise(array.op)) break;
      Nodes operands;
      for (const NodePtr& operand : array.operands) {
        operands.push_back(operand->type.is_array() ? make_element(*operand, index) : clone(*operand));
      }
      NodePtr node = make_node(array.op, array.exact, std::move(operands), array.where);
      node->precise = array.precise;
      return node;
    }
  }
  throw std::logic_error("an element of what has none of its own");
}

NodePtr make_element(const Node& array, int index) { return make_element(array, *make_integer(index, array.where)); }

bool is_plain(const Node& node) {
  switch (node.op) {
    case Op::Literal:
    case Op::Variable: return true;
    case Op::Element: return node.operands[1]->op == Op::Literal && is_plain(*node.operands[0]);
    case Op::Array:
      return std::all_of(node.operands.begin(), node.operands.end(),
                         [](const NodePtr& part) { return is_plain(*part); });
    default: return false;
  }
}

bool is_pure(const Node& node) {
  if (node.op == Op::Assign || node.op == Op::Postfix || node.op == Op::Call) return false;
  return std::all_of(node.operands.begin(), node.operands.end(), [](const NodePtr& part) { return is_pure(*part); });
}

StatementPtr make_statement(Statement::Kind kind, Location where) {
  auto statement = std::make_unique<Statement>();
  statement->kind = kind;
  statement->where = where;
  return statement;
}

StatementPtr make_evaluate(NodePtr expression) {
  StatementPtr statement = make_statement(Statement::Kind::Evaluate, expression->where);
  statement->expression = std::move(expression);
  return statement;
}

}  // namespace pfman
