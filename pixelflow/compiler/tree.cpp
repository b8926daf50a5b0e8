#include "pixelflow/compiler/tree.h"

namespace pfman {

NodePtr clone_alone(const Node& node) {
  auto copy = std::make_unique<Node>();
  copy->op = node.op;
  copy->type = node.type;
  copy->exact = node.exact;
  copy->where = node.where;
  copy->raw = node.raw;
  copy->variable = node.variable;
  copy->math = node.math;
  copy->function = node.function;
  copy->precise = node.precise;
  copy->shared = node.shared;
  copy->under = node.under;
  return copy;
}

NodePtr clone(const Node& node) {
  NodePtr copy = clone_alone(node);
  copy->operands.reserve(node.operands.size());
  for (const NodePtr& operand : node.operands) copy->operands.push_back(clone(*operand));
  return copy;
}

}  // namespace pfman
