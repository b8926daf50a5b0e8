// The built-in library: what each function's result is, and what it computes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/reference/node.h"

namespace reference {

class Textures;

/// How operands and result of a built-in function are typed.
enum class Typing {
  Float,    // operands and result float
  Generic,  // float if one operand is, else fixed point by type_builtin
  Noise,    // float unless all operands are fixed
  Cellnoise,
  Texture,
};

struct Builtin {
  std::string name;
  Typing typing;
  bool takes_literals;  ///< of literals alone it has its surroundings' type
  int result_rows;      ///< of the result; -1: as the operands, together
  /// `arguments` in the operands' types.
  std::function<Value(const Node& node, const std::vector<Value>& arguments)> evaluate;
};

/// Or null.
const Builtin* find_builtin(const std::string& name);

/// Elements and lanes of an operation on arguments: the most of each.
Value room_for(const Node& node, const std::vector<Value>& arguments);
/// result(element, lane) for each.
template <typename Function>
Value each(const Node& node, const std::vector<Value>& arguments, Function&& result) {
  Value value = room_for(node, arguments);
  for (int element = 0; element < value.elements(); ++element) {
    for (int lane = 0; lane < value.lanes; ++lane) value.to(element, lane) = result(element, lane);
  }
  return value;
}

// Float arithmetic, element by element, a scalar standing for every element. NaNs are the one.
Value float_difference(const Value& a, const Value& b);
Value float_product(const Value& a, const Value& b);
Value float_dot(const Value& a, const Value& b);
Value float_square_root(const Value& a);
Value normalized(const Value& a);  ///< a / |a|; 0 where |a| is 0
Value float_negated(const Value& a);
Value float_value(float value);
/// An operation of + - * / % on two floats.
Raw float_operation(pfman::ast::Operator op, Raw a, Raw b);
float float_floor(float x);
/// A function of the float library by its name.
Value library_function(const std::string& name, const std::vector<const Value*>& arguments);

}  // namespace reference
