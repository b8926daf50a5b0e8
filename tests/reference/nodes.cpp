// Literals that take their type from their surroundings, and roots.
#include <algorithm>

#include "tests/reference/builtin.h"
#include "tests/reference/limit.h"
#include "tests/reference/resolver.h"

namespace reference {

void fail(int code, pfman::Location where, const std::string& text) {
  throw Error(code, std::to_string(where.line) + ":" + std::to_string(where.column) + ": " + text);
}

NodePtr make_node(Node::Kind kind, pfman::Location where) {
  auto made = std::make_unique<Node>();
  made->kind = kind;
  made->where = where;
  return made;
}

void settle(Node& node, const std::optional<Number>& surroundings) {
  if (!node.untyped) return;
  node.untyped = false;
  const Number target = surroundings ? *surroundings : node.real ? kFloat : unsigned_fixed(1, 0);
  if (node.kind == Node::Kind::Literal) {
    if (target.floating) {
      node.number = kFloat;
      node.raw =
          node.real ? float_bits(static_cast<float>(node.literal)) : fixed_to_float(node.raw, {false, true, 64, 0});
    } else {
      const FixedLiteral literal = node.real ? fixed_literal(node.literal, std::max(16, target.exponent))
                                             : integer_literal(static_cast<std::int64_t>(node.raw));
      node.number = literal.number;
      node.raw = literal.raw;
    }
    return;
  }
  const std::size_t first = node.kind == Node::Kind::Conditional ? 1 : 0;
  for (std::size_t n = first; n < node.operands.size(); ++n) settle(*node.operands[n], target);
  if (node.kind == Node::Kind::Builtin) {
    for (NodePtr& operand : node.operands) operand = whole(std::move(operand));
    type_builtin(node);
    return;
  }
  node.number = node.operands[first]->number;
  for (std::size_t n = first; n < node.operands.size(); ++n) node.number = join(node.number, node.operands[n]->number);
}

bool meet(std::vector<NodePtr>& nodes) {
  std::optional<Number> typed;
  for (const NodePtr& node : nodes) {
    if (!node->untyped) typed = typed ? join(*typed, node->number) : node->number;
  }
  if (!typed) return false;
  for (NodePtr& node : nodes) {
    settle(*node, typed);
    if (typed->floating) node = root(std::move(node), kFloat);
  }
  return true;
}

NodePtr root(NodePtr node, const Number& target, bool saturate) {
  if (node->untyped && node->kind == Node::Kind::Array) {
    // Literals alone: each of them goes to the target.
    for (NodePtr& operand : node->operands) operand = root(std::move(operand), target, saturate);
    node->untyped = false;
    node->number = target;
    return node;
  }
  settle(*node, target);
  if (!node->number.floating) {
    if (target.floating || target.is_bool()) {
      limit(*node, kEverything);
    } else {
      limit(*node, {saturate ? kAll : target.size - target.exponent, target.exponent, false});
    }
  }
  if (node->number == target) return node;
  if (node->number.floating && target.is_bool()) fail(202, node->where, "a float has no truth value");
  NodePtr made = make_node(Node::Kind::Convert, node->where);
  made->number = target;
  made->target = target;
  made->shape = node->shape;
  made->uniform = node->uniform;
  made->saturate = saturate;
  made->operands.push_back(std::move(node));
  return made;
}

NodePtr whole(NodePtr node) {
  settle(*node, std::nullopt);
  limit(*node, kEverything);
  return node;
}

NodePtr condition(NodePtr node) {
  NodePtr made = whole(std::move(node));
  if (made->number.floating) fail(202, made->where, "a float is no condition");
  return made;
}

void require_alignment(const Number& a, const Number& b, pfman::Location where) {
  const int exponent = std::max(a.exponent, b.exponent);
  if (a.size + exponent - a.exponent > 64 || b.size + exponent - b.exponent > 64) {
    fail(210, where, "more than 64 bits to align " + spelling(a) + " and " + spelling(b));
  }
}

bool is_constant(const Node& node) {
  switch (node.kind) {
    case Node::Kind::Literal: return true;
    case Node::Kind::Read: return node.variable->constant;
    case Node::Kind::Assign:
    case Node::Kind::Increment:
    case Node::Kind::Call: return false;
    default:
      return std::all_of(node.operands.begin(), node.operands.end(), [](const NodePtr& n) { return is_constant(*n); });
  }
}

Shape broadcast(const Shape& a, const Shape& b, pfman::Location where) {
  if (a.scalar() || a == b) return b.scalar() ? a : b;
  if (b.scalar()) return a;
  fail(203, where, "arrays of different shapes");
}

}  // namespace reference
