// What is the same in all pixels stays a tree, for the host. Calls and choices that need control flow come before it,
// as instructions for the host that leave their result in a hidden variable.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
namespace {

bool has_inlined_call(const Node& node) {
  if (node.op == Node::Op::Call && !node.function->is_external) return true;
  return std::any_of(node.operands.begin(), node.operands.end(),
                     [](const NodePtr& operand) { return has_inlined_call(*operand); });
}

/// Without operands.
NodePtr copy_of(const Node& node) {
  NodePtr copy = make_node(node.op, node.type, node.where);
  copy->exact = node.exact;
  copy->raw = node.raw;
  copy->variable = node.variable;
  copy->math = node.math;
  copy->function = node.function;
  copy->under = node.under;
  return copy;
}

NodePtr deep_copy_of(const Node& node) {
  NodePtr copy = copy_of(node);
  for (const NodePtr& operand : node.operands) copy->operands.push_back(deep_copy_of(*operand));
  return copy;
}

}  // namespace

NodePtr make_node(Node::Op op, const Type& type, Location where) {
  auto node = std::make_unique<Node>();
  node->op = op;
  node->type = type;
  node->exact = type.scalar;
  node->where = where;
  return node;
}

NodePtr make_literal(std::uint64_t raw, const Scalar& type, Location where) {
  Type scalar;
  scalar.scalar = type;
  NodePtr node = make_node(Node::Op::Literal, scalar, where);
  node->raw = raw;
  return node;
}

NodePtr make_reference(Variable& variable, Location where) {
  NodePtr node = make_node(Node::Op::Variable, variable.type, where);
  node->variable = &variable;
  return node;
}

NodePtr make_unary(Node::Op op, const Scalar& type, NodePtr a) {
  Type scalar;
  scalar.scalar = type;
  NodePtr node = make_node(op, scalar, a->where);
  node->operands.push_back(std::move(a));
  return node;
}

NodePtr make_binary(Node::Op op, const Scalar& type, NodePtr a, NodePtr b) {
  NodePtr node = make_unary(op, type, std::move(a));
  node->operands.push_back(std::move(b));
  return node;
}

bool has_effects(const Node& node) {
  if (node.op == Node::Op::Assign || node.op == Node::Op::Postfix || node.op == Node::Op::Call) return true;
  return std::any_of(node.operands.begin(), node.operands.end(),
                     [](const NodePtr& operand) { return has_effects(*operand); });
}

bool is_uniform(const Node& node) {
  if (node.type.varying) return false;
  switch (node.op) {
    case Node::Op::Assign:
    case Node::Op::Postfix: return !node.operands[0]->type.varying;
    case Node::Op::Sequence:
      return std::all_of(node.operands.begin(), node.operands.end(),
                         [](const NodePtr& operand) { return is_uniform(*operand); });
    default: return true;
  }
}

int Lowering::add_uniform(NodePtr tree) {
  code_.uniforms.push_back(std::move(tree));
  return static_cast<int>(code_.uniforms.size()) - 1;
}

Value Lowering::uniform_value(NodePtr tree) {
  const Scalar type = tree->type.scalar;
  Value value;
  value.type = type;
  value.at.kind = ir::Operand::Kind::Uniform;
  value.at.is_signed = type.is_signed;
  value.at.bytes = type.bytes();
  value.at.uniform = add_uniform(std::move(tree));
  return value;
}

NodePtr Lowering::tree_of(const Value& value) const {
  return deep_copy_of(*code_.uniforms[static_cast<std::size_t>(value.at.uniform)]);
}

Values Lowering::uniform_values(const Node& node) {
  if (!node.type.is_array()) {
    NodePtr tree = uniform_tree(node);
    if (has_effects(*tree)) tree = make_reference(*hoist(std::move(tree)), node.where);
    return {uniform_value(std::move(tree))};
  }
  if (node.op == Op::Array) {
    Values all;
    for (const NodePtr& operand : node.operands) {
      const Values part = uniform_values(*operand);
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }
  NodePtr tree = uniform_tree(node);
  if (tree->op != Op::Variable || tree->type.scalar != tree->variable->type.scalar) {
    tree = make_reference(*hoist(std::move(tree)), node.where);
  }
  return elements_of(*tree->variable);
}

Values Lowering::elements_of(Variable& variable) {
  const Type& whole_type = variable.type;
  Type type;
  type.scalar = whole_type.scalar;
  if (!whole_type.is_array()) return {uniform_value(make_reference(variable, where_))};
  Type row_type = type;
  row_type.rank = 1;
  row_type.dimensions = {whole_type.dimensions[1], 1};
  const int columns = whole_type.dimensions[1];
  const auto index = [&](NodePtr array, const Type& element_type, int number) {
    NodePtr element = make_node(Op::Element, element_type, where_);
    element->operands.push_back(std::move(array));
    element->operands.push_back(make_literal(static_cast<std::uint64_t>(number), Scalar::fixed(false, 32, 0), where_));
    return element;
  };
  Values elements;
  for (int n = 0; n < whole_type.count(); ++n) {
    NodePtr element = make_reference(variable, where_);
    if (whole_type.rank == 2) element = index(std::move(element), row_type, n / columns);
    elements.push_back(uniform_value(index(std::move(element), type, whole_type.rank == 2 ? n % columns : n)));
  }
  return elements;
}

Variable* Lowering::hidden(const Type& type) {
  auto variable = std::make_unique<Variable>();
  variable->name = "u" + std::to_string(code_.uniform_variables.size() + 1);
  variable->type = type;
  variable->type.varying = false;
  variable->role = Variable::Role::Hidden;
  variable->where = where_;
  code_.uniform_variables.push_back(std::move(variable));
  return code_.uniform_variables.back().get();
}

void Lowering::evaluate(NodePtr tree) {
  ir::Instruction instruction;
  instruction.kind = Kind::Uniform;
  instruction.uniform = add_uniform(std::move(tree));
  append(std::move(instruction));
}

/// Evaluated here, once.
Variable* Lowering::hoist(NodePtr tree) {
  Variable* const variable = hidden(tree->type);
  const Location where = tree->where;
  NodePtr assign = make_node(Op::Assign, variable->type, where);
  assign->operands.push_back(make_reference(*variable, where));
  assign->operands.push_back(std::move(tree));
  evaluate(std::move(assign));
  return variable;
}

/// A variable of the shader is itself; of a function, each call has its own.
Variable* Lowering::uniform_of(const Variable& variable) {
  const auto found = bindings_.find(&variable);
  if (found != bindings_.end() && found->second.uniform) return found->second.uniform;
  if (depth_ == 0 || unit_constants_.contains(&variable)) return const_cast<Variable*>(&variable);
  Variable* const copy = hidden(variable.type);
  copy->name = variable.name;
  copy->where = variable.where;
  bindings_[&variable].uniform = copy;
  return copy;
}

NodePtr Lowering::uniform_tree(const Node& node) {
  if (has_inlined_call(node)) return hoisting_tree(node);
  NodePtr copy = copy_of(node);
  if (node.variable) copy->variable = uniform_of(*node.variable);
  for (const NodePtr& operand : node.operands) copy->operands.push_back(uniform_tree(*operand));
  return copy;
}

/// A tree with calls of functions in it: all that has effects is done before the tree, in the order of the text.
NodePtr Lowering::hoisting_tree(const Node& node) {
  switch (node.op) {
    case Op::Call: {
      if (node.function->is_external) break;
      const Values values = lower_call(node);
      if (!node.type.is_array()) return tree_of(values.at(0));
      NodePtr array = make_node(Op::Array, node.type, node.where);
      for (const Value& value : values) array->operands.push_back(tree_of(value));
      return array;
    }
    case Op::And:
    case Op::Or:
    case Op::Select: return conditional_tree(node);
    default: break;
  }
  NodePtr copy = copy_of(node);
  if (node.variable) copy->variable = uniform_of(*node.variable);
  for (const NodePtr& operand : node.operands) {
    NodePtr tree = uniform_tree(*operand);
    if (has_effects(*tree)) tree = make_reference(*hoist(std::move(tree)), operand->where);
    copy->operands.push_back(std::move(tree));
  }
  const bool acts = node.op == Op::Assign || node.op == Op::Postfix || node.op == Op::Call;
  return acts && !node.type.is_void ? make_reference(*hoist(std::move(copy)), node.where) : std::move(copy);
}

/// Calls in an operand that may not be evaluated at all.
NodePtr Lowering::conditional_tree(const Node& node) {
  Variable* const result = hidden(node.type);
  const auto assign = [&](const Node& value) {
    NodePtr assignment = make_node(Op::Assign, result->type, value.where);
    assignment->operands.push_back(make_reference(*result, value.where));
    assignment->operands.push_back(uniform_tree(value));
    evaluate(std::move(assignment));
  };
  if (node.op == Op::Select) {
    int opening = begin_if(uniform_tree(*node.operands[0]));
    assign(*node.operands[1]);
    opening = begin_else(opening);
    assign(*node.operands[2]);
    end_if(opening);
  } else {
    assign(*node.operands[0]);
    NodePtr go_on = make_reference(*result, node.where);
    if (node.op == Op::Or) go_on = make_unary(Op::Not, Scalar::boolean(), std::move(go_on));
    const int opening = begin_if(std::move(go_on));
    assign(*node.operands[1]);
    end_if(opening);
  }
  return make_reference(*result, node.where);
}

}  // namespace pfman
