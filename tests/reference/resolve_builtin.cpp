// Calls of the built-in library: types of operands and results.
#include <algorithm>

#include "tests/reference/builtin.h"
#include "tests/reference/limit.h"
#include "tests/reference/resolver.h"

namespace reference {
namespace {

using pfman::ast::Operator;

Number square_root_type(const Number& a, pfman::Location where) {
  if (a.exponent > 64) fail(210, where, "square root of more than 64 fraction bits");
  if (a.size > 64) fail(210, where, "square root of more than 64 bits");
  const int m = a.integer_bits();
  const int half = m >= 0 ? (m + 1) / 2 : -(-m / 2);  // rounded up
  return unsigned_fixed(std::max(1, half + a.exponent), a.exponent);
}

Number dot_type(const Number& a, const Number& b, int elements) {
  const Number product = product_type(a, b);
  Number sum = product;
  for (int n = 1; n < elements; ++n) sum = sum_type(sum, product);
  return sum;
}

Number mix_type(const Number& x, const Number& y, const Number& t) {
  return sum_type(product_type(x, difference_type(unsigned_fixed(1, 0), t)), product_type(y, t));
}

/// Of operands that are all fixed point.
Number fixed_result(const Node& node, const std::string& name) {
  std::vector<Number> types;
  for (const NodePtr& operand : node.operands) types.push_back(operand->number);
  const Number a = types[0];
  const int elements = node.operands[0]->shape.count();
  if (name == "abs") return unsigned_fixed(a.size, a.exponent);
  if (name == "sign") {
    require_alignment(a, unsigned_fixed(1, 0), node.where);  // it is compared with 0
    return signed_fixed(2, 0);
  }
  if (name == "floor") return a.exponent <= 0 ? a : fixed_of(a.is_signed, a.integer_bits(), 0);
  if (name == "ceil" || name == "round") {
    return a.exponent <= 0 ? a : fixed_of(a.is_signed, a.integer_bits() + 1, 0);
  }
  if (name == "sqrt") return square_root_type(a, node.where);
  if (name == "length") return square_root_type(dot_type(a, a, elements), node.where);
  if (name == "dot") return dot_type(a, types[1], elements);
  if (name == "cross") {
    const Number product = product_type(a, types[1]);
    return difference_type(product, product);
  }
  if (name == "distance") {
    const Number apart = difference_type(a, types[1]);
    if (apart.size > 64) fail(210, node.where, "difference of more than 64 bits");
    return square_root_type(dot_type(apart, apart, elements), node.where);
  }
  if (name == "mix") return mix_type(a, types[1], types[2]);
  if (name == "step") {
    require_alignment(a, types[1], node.where);
    return kBool;
  }
  // min, max, clamp
  Number all = a;
  for (const Number& type : types) {
    require_alignment(all, type, node.where);
    all = join(all, type);
  }
  return all;
}

Shape result_shape(const Node& node, pfman::Location where) {
  if (node.builtin->result_rows >= 0) return {node.builtin->result_rows, 0};
  Shape shape = node.operands[0]->shape;
  for (const NodePtr& operand : node.operands) shape = broadcast(shape, operand->shape, where);
  return shape;
}

}  // namespace

void type_builtin(Node& node) {
  const bool floating =
      std::any_of(node.operands.begin(), node.operands.end(), [](const NodePtr& n) { return n->number.floating; });
  node.number = floating ? kFloat : fixed_result(node, node.builtin->name);
}

NodePtr Resolver::builtin_node(const std::string& name, Nodes operands, pfman::Location where) {
  if (name == "mod" && operands.size() == 2) {
    return binary_node(Operator::Remainder, std::move(operands[0]), std::move(operands[1]), where);
  }
  const Builtin* builtin = find_builtin(name);
  if (builtin == nullptr) fail(110, where, "unknown function " + name);
  if (operands.empty()) fail(132, where, "function without arguments");
  NodePtr made = make_node(Node::Kind::Builtin, where);
  made->builtin = builtin;
  for (const NodePtr& operand : operands) {
    made->uniform = made->uniform && operand->uniform;
    made->real = made->real || operand->real;
  }
  const auto is_floating = [](const NodePtr& n) { return !n->untyped && n->number.floating; };
  switch (builtin->typing) {
    case Typing::Float:
      for (std::size_t n = 0; n < operands.size(); ++n) {
        const bool octaves = name == "turbulence" && n == 1;
        operands[n] = octaves ? whole(std::move(operands[n])) : root(std::move(operands[n]), kFloat);
      }
      made->number = kFloat;
      break;
    case Typing::Generic: {
      if (builtin->takes_literals && !meet(operands)) {
        made->untyped = true;
      } else {
        for (NodePtr& operand : operands) operand = whole(std::move(operand));
        if (std::any_of(operands.begin(), operands.end(), is_floating)) {
          for (NodePtr& operand : operands) operand = root(std::move(operand), kFloat);
        }
      }
      break;
    }
    case Typing::Noise:
      for (NodePtr& operand : operands) settle(*operand, std::nullopt);
      if (std::any_of(operands.begin(), operands.end(), is_floating)) {
        for (NodePtr& operand : operands) operand = root(std::move(operand), kFloat);
        made->number = kFloat;
      } else {
        for (NodePtr& operand : operands) operand = root(std::move(operand), signed_fixed(16, 8));
        made->number = name == "noise" ? unsigned_fixed(16, 16) : signed_fixed(17, 16);
      }
      break;
    case Typing::Cellnoise:
      for (NodePtr& operand : operands) operand = whole(std::move(operand));
      made->number = unsigned_fixed(8, 8);
      break;
    case Typing::Texture:
      operands[0] = whole(std::move(operands[0]));
      for (std::size_t n = 1; n < operands.size(); ++n) operands[n] = root(std::move(operands[n]), kFloat);
      made->number = unsigned_fixed(8, 8);
      break;
  }
  made->operands = std::move(operands);
  made->shape = result_shape(*made, where);
  if (builtin->typing == Typing::Generic && !made->untyped) type_builtin(*made);
  return made;
}

}  // namespace reference
