// The library of the language: which functions there are, and what they take.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "pixelflow/compiler/checker.h"

namespace pfman {
namespace {

using Op = Node::Op;
using pixelflow::Code;

enum class Family : std::uint8_t {
  Floats,     // of float scalars, by the library of floats
  Generic,    // generic()
  Choosing,   // generic(), literals alone wait for a type
  Remainder,  // mod
  Smooth,     // smoothstep
  Noise,
  Turbulence,
  Lookup,
  Vectors,
  Transforms,
};

struct Entry {
  std::string_view name;
  Family family;
  std::size_t least, most;  ///< arguments
  Code code = Code::Count;
};

constexpr std::size_t kMany = 256;
/// Functions are written out for each element of an array; pixel memory holds no more.
constexpr int kMostElements = 256;
constexpr std::array kEntries = {
    Entry{"sin", Family::Floats, 1, 1, Code::Sin},
    Entry{"cos", Family::Floats, 1, 1, Code::Cos},
    Entry{"tan", Family::Floats, 1, 1, Code::Tan},
    Entry{"asin", Family::Floats, 1, 1, Code::Asin},
    Entry{"acos", Family::Floats, 1, 1, Code::Acos},
    Entry{"atan", Family::Floats, 1, 1, Code::Atan},
    Entry{"atan2", Family::Floats, 2, 2, Code::Atan2},
    Entry{"exp", Family::Floats, 1, 1, Code::Exp},
    Entry{"exp2", Family::Floats, 1, 1, Code::Exp2},
    Entry{"log", Family::Floats, 1, 1, Code::Log},
    Entry{"log2", Family::Floats, 1, 1, Code::Log2},
    Entry{"pow", Family::Floats, 2, 2, Code::Pow},
    Entry{"inversesqrt", Family::Floats, 1, 1, Code::InverseSquareRoot},
    Entry{"fast_sin", Family::Floats, 1, 1, Code::FastSin},
    Entry{"fast_cos", Family::Floats, 1, 1, Code::FastCos},
    Entry{"fast_tan", Family::Floats, 1, 1, Code::FastTan},
    Entry{"fast_asin", Family::Floats, 1, 1, Code::FastAsin},
    Entry{"fast_acos", Family::Floats, 1, 1, Code::FastAcos},
    Entry{"fast_atan", Family::Floats, 1, 1, Code::FastAtan},
    Entry{"fast_atan2", Family::Floats, 2, 2, Code::FastAtan2},
    Entry{"fast_exp", Family::Floats, 1, 1, Code::FastExp},
    Entry{"fast_exp2", Family::Floats, 1, 1, Code::FastExp2},
    Entry{"fast_log", Family::Floats, 1, 1, Code::FastLog},
    Entry{"fast_log2", Family::Floats, 1, 1, Code::FastLog2},
    Entry{"radians", Family::Floats, 1, 1},
    Entry{"degrees", Family::Floats, 1, 1},
    Entry{"sqrt", Family::Generic, 1, 1},
    Entry{"abs", Family::Generic, 1, 1},
    Entry{"sign", Family::Generic, 1, 1},
    Entry{"floor", Family::Generic, 1, 1},
    Entry{"ceil", Family::Generic, 1, 1},
    Entry{"round", Family::Generic, 1, 1},
    Entry{"step", Family::Generic, 2, 2},
    Entry{"min", Family::Choosing, 2, kMany},
    Entry{"max", Family::Choosing, 2, kMany},
    Entry{"clamp", Family::Choosing, 3, 3},
    Entry{"mix", Family::Choosing, 3, 3},
    Entry{"mod", Family::Remainder, 2, 2},
    Entry{"smoothstep", Family::Smooth, 3, 3},
    Entry{"noise", Family::Noise, 1, 3},
    Entry{"snoise", Family::Noise, 1, 3},
    Entry{"cellnoise", Family::Noise, 1, 3},
    Entry{"turbulence", Family::Turbulence, 2, 2},
    Entry{"texture", Family::Lookup, 3, 3},
    Entry{"texture4", Family::Lookup, 3, 3},
    Entry{"environment", Family::Lookup, 2, 2},
    Entry{"dot", Family::Vectors, 2, 2},
    Entry{"cross", Family::Vectors, 2, 2},
    Entry{"length", Family::Vectors, 1, 1},
    Entry{"distance", Family::Vectors, 2, 2},
    Entry{"normalize", Family::Vectors, 1, 1},
    Entry{"faceforward", Family::Vectors, 2, 2},
    Entry{"reflect", Family::Vectors, 2, 2},
    Entry{"bump", Family::Vectors, 5, 5},
    Entry{"transform_point", Family::Transforms, 2, 2},
    Entry{"transform_vector", Family::Transforms, 2, 2},
};

const Entry* find_entry(const std::string& name) {
  const auto found =
      std::find_if(kEntries.begin(), kEntries.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == kEntries.end() ? nullptr : &*found;
}

/// Functions that take arrays element by element.
bool takes_arrays(const std::string& name) {
  constexpr std::array kNames = {"abs", "sign", "floor", "ceil", "round", "min", "max", "clamp", "mix", "mod"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

bool is_library_function(const std::string& name) { return find_entry(name) != nullptr; }

/// Shapes of functions of scalars and of arrays element by element.
bool Checker::arguments_fit(const std::string& name, const Values& arguments, Location where) {
  const Type* array = nullptr;
  for (const Value& argument : arguments) {
    const Type& type = argument.type();
    if (!type.is_array()) continue;
    if (!takes_arrays(name)) {
      error(132, argument.where, "'" + name + "' takes numbers, not '" + argument.spelled() + "'");
      return false;
    }
    if (type.count() > kMostElements) {
      error(132, argument.where,
            "'" + name + "' takes arrays of up to " + std::to_string(kMostElements) + " elements, not " +
                std::to_string(type.count()));
      return false;
    }
    if (array != nullptr && !array->same_shape(type)) {
      error(132, where, "arguments of '" + name + "' have different shapes");
      return false;
    }
    array = &type;
  }
  const bool scalar_weight = name == "mix" && arguments[2].type().is_array();
  const bool unlike = name == "mix" && arguments[0].type().rank != arguments[1].type().rank;
  if (scalar_weight || unlike) {
    error(132, where, "'mix' takes two values of one shape and a number");
    return false;
  }
  return true;
}

Value Checker::call_library(const ast::Expression& expression) {
  Values arguments;
  bool right = true;
  for (const auto& operand : expression.operands) {
    arguments.push_back(this->expression(*operand));
    const Value& value = arguments.back();
    right = right && !value.mistake();
    if (!value.mistake() && value.type().is_void) {
      error(202, value.where, "a call of a void function has no value");
      right = false;
    }
  }
  const Entry* entry = find_entry(expression.name);
  if (entry == nullptr) {
    return mistake(110, expression.where,
                   find(expression.name) != nullptr
                       ? "'" + expression.name + "' is a variable; a function is needed here"
                       : "undeclared function '" + expression.name + "'");
  }
  if (arguments.size() < entry->least || arguments.size() > entry->most) {
    std::string range = counted(entry->least, "argument");
    const bool open = entry->most == kMany && arguments.size() < kMany;
    if (open) range = std::to_string(entry->least) + " arguments or more";
    if (!open && entry->most != entry->least) {
      range = std::to_string(entry->least) + " to " + counted(entry->most, "argument");
    }
    return mistake(132, expression.where,
                   "'" + expression.name + "' takes " + range + ", not " + std::to_string(arguments.size()));
  }
  if (!right) return {};
  return library(expression.name, std::move(arguments), expression.where);
}

Value Checker::library(const std::string& name, Values arguments, Location where) {
  const Family family = find_entry(name)->family;
  switch (family) {
    case Family::Noise: return noise(name, std::move(arguments), where);
    case Family::Turbulence: return turbulence(std::move(arguments), where);
    case Family::Lookup: return lookup(name, std::move(arguments), where);
    case Family::Vectors: return vectors(name, std::move(arguments), where);
    case Family::Transforms: return transformed(name, std::move(arguments), where);
    default: break;
  }
  if (!arguments_fit(name, arguments, where)) return {};
  if (family == Family::Remainder) {
    return binary(ast::Operator::Remainder, std::move(arguments[0]), std::move(arguments[1]), where);
  }
  if (family == Family::Floats || family == Family::Smooth)
    return functions_of_floats(name, std::move(arguments), where);
  Nodes typed;
  if (family == Family::Choosing) {
    if (!meet(arguments, typed)) {
      Value value = untyped(Value::Kind::Library, std::move(arguments), where);
      value.name = name;
      return value;
    }
  } else {
    settle_together(std::move(arguments), typed);
  }
  return Value::typed(write_.generic(name, std::move(typed), where));
}

Value Checker::functions_of_floats(const std::string& name, Values arguments, Location where) {
  Nodes floats;
  for (Value& argument : arguments) {
    floats.push_back(convert_to(std::move(argument), Scalar::floating()));
    if (!floats.back()) return {};
  }
  const Entry& entry = *find_entry(name);
  if (entry.family == Family::Smooth) return Value::typed(write_.smoothstep(std::move(floats), where));
  if (entry.code != Code::Count) return Value::typed(make_math(entry.code, std::move(floats), where));
  const double factor = name == "radians" ? 0.017453292519943295 : 57.29577951308232;
  return Value::typed(make_operation(Op::Multiply, nodes(std::move(floats[0]), make_float(factor, where)), where));
}

}  // namespace pfman
