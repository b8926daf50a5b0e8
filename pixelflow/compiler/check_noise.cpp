// Noise of a point given as scalars or as an array, and lookups in textures.
#include <algorithm>

#include "pixelflow/compiler/checker.h"
#include "pixelflow/compiler/host_numbers.h"

namespace pfman {

using Op = Node::Op;

Value Checker::noise(const std::string& name, Values arguments, Location where) {
  const Type first = arguments[0].type();
  const bool point = first.rank == 1 && (first.dimensions[0] == 2 || first.dimensions[0] == 3);
  for (const Value& argument : arguments) {
    if (argument.type().is_array() && !(point && arguments.size() == 1)) {
      return mistake(132, argument.where, "'" + name + "' takes one to three numbers, or an array of two or three");
    }
  }
  Nodes given;
  if (name == "cellnoise") {
    // Cells are found by integers: each argument keeps its own type.
    for (Value& argument : arguments) given.push_back(settle(std::move(argument)));
  } else {
    settle_together(std::move(arguments), given);
  }
  if (std::any_of(given.begin(), given.end(), [](const NodePtr& node) { return !node; })) return {};
  Nodes before, coordinates;
  if (point) {
    const NodePtr whole = write_.reuse(std::move(given[0]), before);
    for (int n = 0; n < first.dimensions[0]; ++n) coordinates.push_back(make_element(*whole, n));
  } else {
    coordinates = std::move(given);
  }
  if (name == "cellnoise") {
    NodePtr node = make_node(Op::CellNoise, Scalar::fixed(false, 8, 8), std::move(coordinates), where);
    return Value::typed(make_sequence(std::move(before), std::move(node), where));
  }
  const bool real = coordinates[0]->exact.is_float;
  if (!real) {
    for (NodePtr& coordinate : coordinates)
      coordinate = make_convert(std::move(coordinate), Scalar::fixed(true, 16, 8));
  }
  const Scalar scalar = real ? Scalar::floating() : Scalar::fixed(false, 16, 16);
  NodePtr node = make_node(Op::Noise, scalar, std::move(coordinates), where);
  if (name == "snoise") {
    NodePtr two = real ? make_float(2, where) : make_integer(2, where);
    NodePtr one = real ? make_float(1, where) : make_integer(1, where);
    node = make_operation(Op::Multiply, nodes(std::move(two), std::move(node)), where);
    node = make_operation(Op::Subtract, nodes(std::move(node), std::move(one)), where);
    if (!real) node = make_convert(std::move(node), Scalar::fixed(true, 17, 16));
  }
  return Value::typed(make_sequence(std::move(before), std::move(node), where));
}

/// A uniform integer of the type int. Null for a mistake.
NodePtr Checker::uniform_integer(Value value, const char* what) {
  NodePtr node = settle(std::move(value));
  if (!node) return nullptr;
  if (node->type.is_array() || node->exact.is_float) {
    error(132, node->where, std::string(what) + " of type '" + spelling(node->type) + "' is no integer");
    return nullptr;
  }
  if (node->type.varying) {
    error(301, node->where, std::string(what) + " varies from pixel to pixel");
    return nullptr;
  }
  return make_convert(std::move(node), Scalar::integer());
}

Value Checker::turbulence(Values arguments, Location where) {
  const Type type = arguments[0].type();
  if (type.rank != 1 || type.dimensions[0] != 3) {
    return mistake(132, arguments[0].where,
                   "'turbulence' takes a point float[3], not '" + arguments[0].spelled() + "'");
  }
  NodePtr point = convert_to(std::move(arguments[0]), Scalar::floating());
  NodePtr octaves = uniform_integer(std::move(arguments[1]), "the number of octaves");
  if (!point || !octaves) return {};
  if (is_constant(*octaves)) {
    const std::optional<std::int64_t> count = constant_integer(*octaves);
    if (!count) return {};
    if (*count > kMostOctaves) {
      return mistake(
          132, octaves->where,
          "'turbulence' adds " + std::to_string(kMostOctaves) + " octaves at most, not " + std::to_string(*count));
    }
  }
  NodePtr node = make_node(Op::Turbulence, Scalar::floating(), nodes(std::move(point), std::move(octaves)), where);
  node->type.rank = 0;
  node->type.dimensions = {1, 1};
  return Value::typed(std::move(node));
}

/// texture, texture4 and environment: at the pixels, also where the coordinates are uniform.
Value Checker::lookup(const std::string& name, Values arguments, Location where) {
  const bool environment = name == "environment";
  Nodes operands;
  bool right = true;
  for (std::size_t n = 1; n < arguments.size(); ++n) {
    const Type type = arguments[n].type();
    const bool fits = environment ? type.rank == 1 && type.dimensions[0] == 3 : !type.is_array();
    if (!fits) {
      return mistake(
          132, arguments[n].where,
          "argument " + std::to_string(n + 1) + " of '" + name + "' cannot be '" + arguments[n].spelled() + "'");
    }
  }
  operands.push_back(uniform_integer(std::move(arguments[0]), "the number of a texture"));
  for (std::size_t n = 1; n < arguments.size(); ++n) {
    operands.push_back(convert_to(std::move(arguments[n]), Scalar::floating()));
  }
  for (const NodePtr& operand : operands) right = right && operand;
  if (!right) return {};
  NodePtr node =
      make_node(environment ? Op::Environment : Op::Texture, Scalar::fixed(false, 8, 8), std::move(operands), where);
  node->type.varying = true;
  node->type.rank = 1;
  node->type.dimensions = {name == "texture4" ? 4 : 3, 1};
  node->shared = in_common_code_;
  return Value::typed(std::move(node));
}

}  // namespace pfman
