// Functions of the library whose type follows from their arguments': float if one is float, else fixed with every bit.
// The arguments have met: all are float, or all are fixed.
#include "pixelflow/compiler/library_writer.h"

#include <algorithm>

namespace pfman {

using Op = Node::Op;

NodePtr LibraryWriter::keep(NodePtr node, Nodes& before) {
  const Location where = node->where;
  Type type = node->type;
  type.scalar = node->exact;
  Variable* variable = add_variable(tree_, "value", type, Variable::Role::Hidden, where);
  before.push_back(make_assign(make_read(variable, where), std::move(node), where));
  return make_read(variable, where);
}

NodePtr LibraryWriter::reuse(NodePtr node, Nodes& before) {
  if (is_plain(*node)) return node;
  return keep(std::move(node), before);
}

NodePtr LibraryWriter::by_elements(NodePtr node, Nodes& before) {
  const bool apart = node->type.is_array() && node->exact.is_float && is_pure(*node) &&
                     has_elements(*node, *make_integer(0, node->where));
  return apart ? std::move(node) : reuse(std::move(node), before);
}

/// The second one where it is less.
NodePtr LibraryWriter::lesser(NodePtr a, NodePtr b, Nodes& before) {
  const Location where = a->where;
  a = reuse(std::move(a), before);
  b = reuse(std::move(b), before);
  NodePtr less = make_operation(Op::Less, nodes(clone(*b), clone(*a)), where);
  return make_select(std::move(less), std::move(b), std::move(a), where);
}

/// The second one where the first is less.
NodePtr LibraryWriter::greater(NodePtr a, NodePtr b, Nodes& before) {
  const Location where = a->where;
  a = reuse(std::move(a), before);
  b = reuse(std::move(b), before);
  NodePtr less = make_operation(Op::Less, nodes(clone(*a), clone(*b)), where);
  return make_select(std::move(less), std::move(b), std::move(a), where);
}

namespace {

NodePtr sign(NodePtr x, Location where) {
  const bool real = x->exact.is_float;
  const auto number = [&](int value) {
    if (real) return make_float(value, where);
    return make_literal(Scalar::fixed(true, 2, 0), static_cast<std::uint64_t>(std::int64_t{value}), where);
  };
  const auto zero = [&] { return real ? make_float(0, where) : make_integer(0, where); };
  NodePtr positive = make_operation(Op::Less, nodes(zero(), clone(*x)), where);
  NodePtr rest = make_select(std::move(positive), number(1), number(0), where);
  NodePtr negative = make_operation(Op::Less, nodes(std::move(x), zero()), where);
  return make_select(std::move(negative), number(-1), std::move(rest), where);
}

bool is_unary(const std::string& name) {
  return name == "abs" || name == "floor" || name == "ceil" || name == "round" || name == "sqrt";
}

}  // namespace

NodePtr LibraryWriter::mix(Nodes arguments, Nodes& before, Location where) {
  const bool real = arguments[0]->exact.is_float;
  for (std::size_t n = 0; n < 3; ++n) {
    if (n == 2 || !real) arguments[n] = reuse(std::move(arguments[n]), before);
  }
  NodePtr one = real ? make_float(1, where) : make_integer(1, where);
  NodePtr rest = make_operation(Op::Subtract, nodes(std::move(one), clone(*arguments[2])), where);
  if (arguments[0]->type.is_array()) rest = keep(std::move(rest), before);
  NodePtr first = make_operation(Op::Multiply, nodes(std::move(arguments[0]), std::move(rest)), where);
  NodePtr second = make_operation(Op::Multiply, nodes(std::move(arguments[1]), std::move(arguments[2])), where);
  return make_operation(Op::Add, nodes(std::move(first), std::move(second)), where);
}

/// Of scalars.
NodePtr LibraryWriter::generic_scalar(const std::string& name, Nodes arguments, Location where) {
  Nodes before;
  NodePtr result;
  if (name == "min" || name == "max") {
    result = std::move(arguments[0]);
    for (std::size_t n = 1; n < arguments.size(); ++n) {
      result = name == "min" ? lesser(std::move(result), std::move(arguments[n]), before)
                             : greater(std::move(result), std::move(arguments[n]), before);
    }
  } else if (name == "clamp") {
    // Later arguments are evaluated before the first comparison.
    for (NodePtr& argument : arguments) argument = reuse(std::move(argument), before);
    NodePtr raised = greater(std::move(arguments[0]), std::move(arguments[1]), before);
    result = lesser(std::move(raised), std::move(arguments[2]), before);
  } else if (name == "step") {
    const bool real = arguments[0]->exact.is_float;
    const auto number = [&](int value) {
      return real ? make_float(value, where)
                  : make_literal(Scalar::boolean(), static_cast<std::uint64_t>(value), where);
    };
    NodePtr less = make_operation(Op::Less, nodes(std::move(arguments[1]), std::move(arguments[0])), where);
    result = make_select(std::move(less), number(0), number(1), where);
  } else {
    result = sign(reuse(std::move(arguments[0]), before), where);
  }
  result->precise = true;
  return make_sequence(std::move(before), std::move(result), where);
}

/// An array of the function's results for the elements of its arguments, scalars repeated.
NodePtr LibraryWriter::each_element(const std::string& name, const Nodes& arguments, Location where) {
  int length = 0;
  for (const NodePtr& argument : arguments) {
    if (argument->type.is_array()) length = argument->type.dimensions[0];
  }
  if (length == 0) {
    Nodes copies;
    for (const NodePtr& argument : arguments) copies.push_back(clone(*argument));
    return generic_scalar(name, std::move(copies), where);
  }
  Nodes results;
  for (int n = 0; n < length; ++n) {
    Nodes elements;
    for (const NodePtr& argument : arguments) {
      elements.push_back(argument->type.is_array() ? make_element(*argument, n) : clone(*argument));
    }
    results.push_back(each_element(name, elements, where));
  }
  NodePtr result = make_array(std::move(results), where);
  result->precise = true;
  return result;
}

NodePtr LibraryWriter::generic(const std::string& name, Nodes arguments, Location where) {
  const bool right =
      std::all_of(arguments.begin(), arguments.end(), [](const NodePtr& node) { return node != nullptr; });
  if (!right) return nullptr;
  const bool real =
      std::any_of(arguments.begin(), arguments.end(), [](const NodePtr& node) { return node->exact.is_float; });
  if (real) {
    for (NodePtr& argument : arguments) argument = to_float(std::move(argument));
  }
  if (is_unary(name)) {
    const Op op = name == "abs"     ? Op::Abs
                  : name == "floor" ? Op::Floor
                  : name == "ceil"  ? Op::Ceil
                  : name == "round" ? Op::Round
                                    : Op::SquareRoot;
    return make_operation(op, std::move(arguments), where);
  }
  Nodes before;
  if (name == "mix") {
    NodePtr result = mix(std::move(arguments), before, where);
    result->precise = true;
    return make_sequence(std::move(before), std::move(result), where);
  }
  const bool arrays =
      std::any_of(arguments.begin(), arguments.end(), [](const NodePtr& node) { return node->type.is_array(); });
  if (!arrays) return generic_scalar(name, std::move(arguments), where);
  for (NodePtr& argument : arguments) argument = by_elements(std::move(argument), before);
  return make_sequence(std::move(before), each_element(name, arguments, where), where);
}

NodePtr LibraryWriter::smoothstep(Nodes arguments, Location where) {
  Nodes before;
  NodePtr low = reuse(std::move(arguments[0]), before);
  NodePtr high = reuse(std::move(arguments[1]), before);
  NodePtr above = make_operation(Op::Subtract, nodes(std::move(arguments[2]), clone(*low)), where);
  NodePtr range = make_operation(Op::Subtract, nodes(std::move(high), std::move(low)), where);
  NodePtr part = make_operation(Op::Divide, nodes(std::move(above), std::move(range)), where);
  NodePtr t = greater(std::move(part), make_float(0, where), before);
  t = reuse(lesser(std::move(t), make_float(1, where), before), before);
  NodePtr square = make_operation(Op::Multiply, nodes(clone(*t), clone(*t)), where);
  NodePtr twice = make_operation(Op::Multiply, nodes(make_float(2, where), std::move(t)), where);
  NodePtr slope = make_operation(Op::Subtract, nodes(make_float(3, where), std::move(twice)), where);
  NodePtr result = make_operation(Op::Multiply, nodes(std::move(square), std::move(slope)), where);
  return make_sequence(std::move(before), std::move(result), where);
}

namespace {

NodePtr zeros(int count, Location where) {
  Nodes elements;
  for (int n = 0; n < count; ++n) elements.push_back(make_float(0, where));
  return make_array(std::move(elements), where);
}

}  // namespace

NodePtr LibraryWriter::normalized(NodePtr vector, Nodes& before) {
  const Location where = vector->where;
  const int count = vector->type.dimensions[0];
  vector = reuse(std::move(vector), before);
  NodePtr length = keep(make_operation(Op::SquareRoot, nodes(make_dot(*vector, *vector, where)), where), before);
  NodePtr different = make_operation(Op::NotEqual, nodes(clone(*length), make_float(0, where)), where);
  NodePtr quotient = make_operation(Op::Divide, nodes(std::move(vector), std::move(length)), where);
  return make_select(std::move(different), std::move(quotient), zeros(count, where), where);
}

NodePtr make_dot(const Node& a, const Node& b, Location where) {
  NodePtr sum;
  for (int n = 0; n < a.type.dimensions[0]; ++n) {
    NodePtr product = make_operation(Op::Multiply, nodes(make_element(a, n), make_element(b, n)), where);
    sum = sum ? make_operation(Op::Add, nodes(std::move(sum), std::move(product)), where) : std::move(product);
  }
  return sum;
}

Variable* add_variable(Tree& tree, std::string name, const Type& type, Variable::Role role, Location where) {
  auto variable = std::make_unique<Variable>();
  variable->name = std::move(name);
  variable->type = type;
  variable->role = role;
  variable->where = where;
  variable->id = static_cast<int>(tree.variables.size());
  tree.variables.push_back(std::move(variable));
  return tree.variables.back().get();
}

}  // namespace pfman
