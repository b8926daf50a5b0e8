// The built-in library: its table, and functions of floats alone.
#include "tests/reference/builtin.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/reference/builtin_tables.h"

namespace reference {
namespace {

using pfman::ast::Operator;
using Arguments = std::vector<Value>;

Value faceforward(const Value& normal, const Value& incident) {
  const Value along = float_dot(incident, normal);
  Value value(along.lanes, normal.elements());
  const Value back = float_negated(normal);
  for (int element = 0; element < value.elements(); ++element) {
    for (int lane = 0; lane < value.lanes; ++lane) {
      value.to(element, lane) = as_float(along.at(0, lane)) < 0 ? normal.at(element, lane) : back.at(element, lane);
    }
  }
  return value;
}

Value reflect(const Value& incident, const Value& normal) {
  const Value twice = float_product(float_value(2), float_dot(incident, normal));
  return float_difference(incident, float_product(twice, normal));
}

Value bump(const Arguments& a) {
  return normalized(float_difference(float_difference(a[0], float_product(a[3], a[1])), float_product(a[4], a[2])));
}

Value smoothstep(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) {
    const float from = as_float(a[0].at(element, lane)), to = as_float(a[1].at(element, lane));
    const float over = as_float(a[2].at(element, lane)) - from;
    float t = over / (to - from);
    t = t < 0 ? 0 : t;
    t = 1 < t ? 1 : t;
    const float square = t * t, twice = 2 * t;
    return float_bits(square * (3 - twice));
  });
}

Value transform(const Arguments& a, bool point) {
  Value value(std::max(a[0].lanes, a[1].lanes), 3);
  for (int row = 0; row < 3; ++row) {
    for (int lane = 0; lane < value.lanes; ++lane) {
      const auto product = [&](int n) {
        return float_operation(Operator::Multiply, a[0].at(4 * row + n, lane), a[1].at(n, lane));
      };
      Raw sum = float_operation(Operator::Add, product(0), product(1));
      sum = float_operation(Operator::Add, sum, product(2));
      if (point) sum = float_operation(Operator::Add, sum, a[0].at(4 * row + 3, lane));
      value.to(row, lane) = sum;
    }
  }
  return value;
}

void add_float_functions(std::map<std::string, Builtin>& table) {
  const auto add = [&](const std::string& name, int rows, auto evaluate) {
    table[name] = {name, Typing::Float, false, rows,
                   [evaluate](const Node& node, const Arguments& a) -> Value { return evaluate(node, a); }};
  };
  for (const auto& function : pixelflow::native::unary_functions()) {
    const std::string name(function.name);
    add(name, -1, [name](const Node&, const Arguments& a) { return library_function(name, {&a[0]}); });
  }
  for (const auto& function : pixelflow::native::binary_functions()) {
    const std::string name(function.name);
    add(name, -1, [name](const Node&, const Arguments& a) { return library_function(name, {&a[0], &a[1]}); });
  }
  add("radians", -1, [](const Node&, const Arguments& a) { return float_product(a[0], float_value(0.017453292f)); });
  add("degrees", -1, [](const Node&, const Arguments& a) { return float_product(a[0], float_value(57.29578f)); });
  add("smoothstep", -1, smoothstep);
  add("normalize", -1, [](const Node&, const Arguments& a) { return normalized(a[0]); });
  add("faceforward", -1, [](const Node&, const Arguments& a) { return faceforward(a[0], a[1]); });
  add("reflect", -1, [](const Node&, const Arguments& a) { return reflect(a[0], a[1]); });
  add("bump", -1, [](const Node&, const Arguments& a) { return bump(a); });
  add("transform_point", 3, [](const Node&, const Arguments& a) { return transform(a, true); });
  add("transform_vector", 3, [](const Node&, const Arguments& a) { return transform(a, false); });
}

std::map<std::string, Builtin> make_table() {
  std::map<std::string, Builtin> table;
  add_float_functions(table);
  add_generic_functions(table);
  add_noise_functions(table);
  for (const auto& [name, rows] : {std::pair{"texture", 3}, {"texture4", 4}, {"environment", 3}}) {
    table[name] = {name, Typing::Texture, false, rows, nullptr};
  }
  return table;
}

}  // namespace

const Builtin* find_builtin(const std::string& name) {
  static const std::map<std::string, Builtin> kTable = make_table();
  const auto found = kTable.find(name);
  return found == kTable.end() ? nullptr : &found->second;
}

Value room_for(const Node& node, const std::vector<Value>& arguments) {
  int lanes = 1;
  for (const Value& argument : arguments) lanes = std::max(lanes, argument.lanes);
  return Value(lanes, node.shape.count());
}

}  // namespace reference
