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

}  // namespace

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

Terms Lowering::uniform_values(const Node& node) {
  if (!node.type.is_array()) {
    return {uniform_value(once(uniform_tree(node)))};
  }
  if (node.op == Op::Array) {
    Terms all;
    for (const NodePtr& operand : node.operands) {
      const Terms part = uniform_values(*operand);
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }
  NodePtr tree = uniform_tree(node);
  if (tree->op != Op::Variable || tree->type.scalar != tree->variable->type.scalar) {
    return elements_of(hoist(std::move(tree)));
  }
  return elements_of(tree->variable);
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
  NodePtr copy = clone_alone(node);
  if (node.variable) copy->variable = uniform_of(*node.variable);
  for (const NodePtr& operand : node.operands) copy->operands.push_back(uniform_tree(*operand));
  return copy;
}

/// A tree with calls of functions in it: all that has effects is done before the tree, in the order of the text.
NodePtr Lowering::hoisting_tree(const Node& node) {
  switch (node.op) {
    case Op::Call: {
      if (node.function->is_external) break;
      const Terms values = lower_call(node);
      if (!node.type.is_array()) return tree_of(values.at(0));
      NodePtr array = make_node(Op::Array, node.type.scalar, {}, node.where);
      array->type = node.type;
      for (const Term& value : values) array->operands.push_back(tree_of(value));
      return array;
    }
    case Op::And:
    case Op::Or:
    case Op::Select: return conditional_tree(node);
    default: break;
  }
  NodePtr copy = clone_alone(node);
  if (node.variable) copy->variable = uniform_of(*node.variable);
  for (const NodePtr& operand : node.operands) copy->operands.push_back(once(uniform_tree(*operand)));
  return node.type.is_void ? std::move(copy) : once(std::move(copy));
}

/// Calls in an operand that may not be evaluated at all.
NodePtr Lowering::conditional_tree(const Node& node) {
  Variable* const result = hidden(node.type);
  const auto take = [&](const Node& value) { assign(result, uniform_tree(value)); };
  if (node.op == Op::Select) {
    int opening = begin_if(uniform_tree(*node.operands[0]));
    take(*node.operands[1]);
    opening = begin_else(opening);
    take(*node.operands[2]);
    end_if(opening);
  } else {
    take(*node.operands[0]);
    NodePtr go_on = make_read(result, node.where);
    if (node.op == Op::Or) go_on = make_node(Op::Not, Scalar::boolean(), nodes(std::move(go_on)), node.where);
    const int opening = begin_if(std::move(go_on));
    take(*node.operands[1]);
    end_if(opening);
  }
  return make_read(result, node.where);
}

}  // namespace pfman
