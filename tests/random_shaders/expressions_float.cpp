// Random floats, arrays, calls, and what is assigned.
#include <algorithm>

#include "tests/random_shaders/context.h"

namespace random_shaders {
namespace {

using reference::kFloat;

Typed leaf(Writer& writer, const Context& context, bool uniform) {
  std::vector<Typed> found;
  for (const Name& name : context.names) {
    if (!name.number.floating || (uniform && !name.uniform) || context.busy.contains(name.text)) continue;
    if (name.rows == 0) {
      found.push_back({expression(name.text), kFloat, 0, name.uniform});
    } else {
      found.push_back(
          {expression(name.text + "[$]", {index_below(writer, context, name.rows)}), kFloat, 0, name.uniform});
    }
  }
  if (!found.empty() && !writer.random.one_in(8)) return writer.random.of(found);
  static const std::vector<std::string> kLiterals = {"0.5f", "1.0f",   "-2.0f",  "0.1f",
                                                     "3.7f", "1e-30f", "255.0f", "0.0f"};
  return {expression("(" + writer.random.of(kLiterals) + ")"), kFloat, 0, true};
}

Typed unary_function(Writer& writer, const Context& context, const Wish& wish) {
  static const std::vector<std::string> kCheap = {"sqrt", "floor", "ceil",    "round",
                                                  "abs",  "sign",  "radians", "degrees"};
  static const std::vector<std::string> kCostly = {
      "sin",      "cos",       "tan",      "asin",      "acos",        "atan",      "exp",       "exp2",
      "log",      "log2",      "fast_sin", "fast_cos",  "fast_tan",    "fast_asin", "fast_acos", "fast_atan",
      "fast_exp", "fast_exp2", "fast_log", "fast_log2", "inversesqrt", "noise",     "snoise"};
  const bool costly = writer.settings.costly && writer.random.one_in(3);
  const Typed a = float_value(writer, context, {0, wish.uniform, wish.depth - 1, false});
  return {expression(writer.random.of(costly ? kCostly : kCheap) + "($)", {a.piece}), kFloat, 0, a.uniform};
}

Typed several(Writer& writer, const Context& context, const Wish& wish) {
  static const std::vector<std::string> kTwo = {"min", "max",   "mod",        "step", "min",
                                                "max", "atan2", "fast_atan2", "pow",  "noise"};
  static const std::vector<std::string> kThree = {"clamp", "mix", "smoothstep", "max", "min"};
  const bool three = writer.random.one_in(2);
  const int two = writer.random.below(writer.settings.costly && writer.random.one_in(3) ? 10 : 6);
  std::vector<Piece> arguments;
  bool uniform = true;
  for (int n = 0; n < (three ? 3 : 2); ++n) {
    const Typed one = n > 0 && writer.random.one_in(3)
                          ? fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, false})
                          : float_value(writer, context, {0, wish.uniform, wish.depth - 1, false});
    uniform = uniform && one.uniform;
    arguments.push_back(one.piece);
  }
  const std::string name = three ? writer.random.of(kThree) : kTwo[static_cast<std::size_t>(two)];
  return {expression(name + (three ? "($, $, $)" : "($, $)"), std::move(arguments)), kFloat, 0, uniform};
}

Typed of_arrays(Writer& writer, const Context& context, const Wish& wish) {
  const int rows = writer.random.between(2, 4);
  const Wish inner{rows, wish.uniform, wish.depth - 1, false};
  Typed a = array_value(writer, context, inner);
  const bool length = writer.random.one_in(3);
  // Fixed-point operands would make it fixed; with a float it is float.
  if (!a.number.floating) a.piece = expression("($ * 1.0f)", {a.piece});
  if (length) return {expression("length($)", {a.piece}), kFloat, 0, a.uniform};
  const Typed b = array_value(writer, context, inner);
  const std::string name = writer.random.one_in(4) ? "distance" : "dot";
  return {expression(name + "($, $)", {a.piece, b.piece}), kFloat, 0, a.uniform && b.uniform};
}

std::string matrix(Random& random) {
  static const std::vector<std::string> kNumbers = {"0", "1", "0.5f", "-2.0", "3", "0.25", "-1e-3f"};
  std::string made = "{";
  for (int row = 0; row < 4; ++row) {
    made += row == 0 ? "{" : ", {";
    for (int column = 0; column < 4; ++column) made += (column == 0 ? "" : ", ") + random.of(kNumbers);
    made += "}";
  }
  return made + "}";
}

/// A texture is looked up at pixels only: a coordinate has to vary.
Typed looked_up(Writer& writer, const Context& context, const Wish& wish) {
  std::vector<Piece> varying;
  for (const Name& name : context.names) {
    if (name.number.floating && !name.uniform && name.rows == 0 && !context.busy.contains(name.text)) {
      varying.push_back(text(name.text));
    }
  }
  const Typed b = float_value(writer, context, {0, false, wish.depth - 1, false});
  if (varying.empty()) return b;
  const int kind = writer.random.below(3);
  const std::string form = kind == 0   ? "texture($, $, $)"
                           : kind == 1 ? "texture4($, $, $)"
                                       : "environment($, {$, $, 1})";
  const Piece number = text(std::to_string(writer.random.below(3)));
  return {expression(form + "[" + std::to_string(writer.random.below(3)) + "]",
                     {number, writer.random.of(varying), b.piece}),
          reference::unsigned_fixed(8, 8), 0, false};
}

/// A scalar of an array's noise, or an element of a vector of the geometry's functions.
Typed of_points(Writer& writer, const Context& context, const Wish& wish) {
  const Wish inner{3, wish.uniform, wish.depth - 1, false};
  const Typed p = array_value(writer, context, inner);
  const std::string index = "[" + std::to_string(writer.random.below(3)) + "]";
  const int kind = writer.random.below(writer.settings.costly ? 6 : 2);
  if (kind <= 1) {
    const std::string name = kind == 0 ? "transform_point(" : "transform_vector(";
    return {expression(name + matrix(writer.random) + ", $)" + index, {p.piece}), kFloat, 0, p.uniform};
  }
  if (kind == 2) {
    const std::string octaves = std::to_string(writer.random.between(0, 3));
    return {expression("turbulence($, " + octaves + ")", {p.piece}), kFloat, 0, p.uniform};
  }
  if (kind == 3) {
    const Typed q = array_value(writer, context, inner);
    const Typed s = float_value(writer, context, {0, wish.uniform, wish.depth - 1, false});
    return {expression("bump($, $, {1, 0, 0}, $, 0.5)" + index, {p.piece, q.piece, s.piece}), kFloat, 0,
            p.uniform && q.uniform && s.uniform};
  }
  const std::string name = kind == 4 ? "noise" : "snoise";
  return {expression(name + "(1.0f * $)", {p.piece}), kFloat, 0, p.uniform};
}

Typed element_of_array(Writer& writer, const Context& context, const Wish& wish) {
  const int rows = wish.rows;
  std::vector<Piece> elements;
  bool uniform = true;
  std::string form = "{";
  for (int n = 0; n < rows; ++n) {
    const Typed one = float_value(writer, context, {0, wish.uniform, wish.depth - 1, false});
    uniform = uniform && one.uniform;
    form += n == 0 ? "$" : ", $";
    elements.push_back(one.piece);
  }
  return {expression(form + "}", std::move(elements)), kFloat, rows, uniform};
}

}  // namespace

Typed call(Writer& writer, const Context& context, const FunctionName& function) {
  std::vector<Piece> arguments;
  std::string form = function.text + "(";
  for (std::size_t n = 0; n < function.parameters.size(); ++n) {
    const Name& parameter = function.parameters[n];
    Context inner = context;
    inner.functions.clear();  // calls in arguments would multiply
    arguments.push_back(value_for(writer, inner, parameter.number, parameter.rows, parameter.uniform));
    form += n == 0 ? "$" : ", $";
  }
  return {expression(form + ")", std::move(arguments)), function.result, 0, function.uniform};
}

Typed float_value(Writer& writer, const Context& context, const Wish& wish) {
  if (wish.depth <= 0) return leaf(writer, context, wish.uniform);
  static const std::vector<std::string> kOperators = {"+", "-", "*", "/", "%", "+", "-", "*"};
  const Wish inner{0, wish.uniform, wish.depth - 1, false};
  switch (writer.random.below(14)) {
    case 0: return leaf(writer, context, wish.uniform);
    case 12: return of_points(writer, context, wish);
    case 13:
      if (!writer.textures || wish.uniform || !writer.random.one_in(4)) return leaf(writer, context, wish.uniform);
      return cast(writer, looked_up(writer, context, wish), kFloat, false);
    case 1: {
      const Typed a = float_value(writer, context, inner);
      return {expression("(-$)", {a.piece}), kFloat, 0, a.uniform};
    }
    case 2: return cast(writer, fixed_value(writer, context, inner), kFloat, false);
    case 3:
    case 4: return unary_function(writer, context, wish);
    case 5: return several(writer, context, wish);
    case 6: return of_arrays(writer, context, wish);
    case 7: {
      const Typed chosen = condition(writer, context, wish.uniform, wish.depth - 1);
      const Typed a = float_value(writer, context, inner);
      const Typed b =
          writer.random.one_in(3) ? fixed_value(writer, context, inner) : float_value(writer, context, inner);
      return {expression("($ ? $ : $)", {chosen.piece, a.piece, b.piece}), kFloat, 0,
              chosen.uniform && a.uniform && b.uniform};
    }
    default: {
      const std::string op = writer.random.of(kOperators);
      const Typed a = float_value(writer, context, inner);
      if (writer.random.one_in(4)) {
        static const std::vector<std::string> kLiterals = {"2", "0.5", "1.0", "0.1", "3"};
        return {expression("($ " + op + " " + writer.random.of(kLiterals) + ")", {a.piece}), kFloat, 0, a.uniform};
      }
      const Typed b =
          writer.random.one_in(4) ? fixed_value(writer, context, inner) : float_value(writer, context, inner);
      const bool swapped = writer.random.one_in(2);
      return {expression("($ " + op + " $)",
                         swapped ? std::vector<Piece>{b.piece, a.piece} : std::vector<Piece>{a.piece, b.piece}),
              kFloat, 0, a.uniform && b.uniform};
    }
  }
}

Typed array_value(Writer& writer, const Context& context, const Wish& wish) {
  std::vector<Typed> found;
  for (const Name& name : context.names) {
    if (name.rows == wish.rows && (!wish.uniform || name.uniform) && !context.busy.contains(name.text)) {
      found.push_back({expression(name.text), name.number, name.rows, name.uniform});
    }
  }
  const bool leaf_only = wish.depth <= 0;
  if (!found.empty() && (leaf_only || writer.random.one_in(2))) return writer.random.of(found);
  const Wish inner{wish.rows, wish.uniform, wish.depth - 1, false};
  const int kind = leaf_only ? 0 : writer.random.below(8);
  if (kind == 7 && !found.empty()) return fixed_array(writer, context, writer.random.of(found), inner);
  if (kind == 1) {
    const Typed a = array_value(writer, context, inner);
    return {expression("normalize($)", {a.piece}), kFloat, wish.rows, a.uniform};
  }
  if (kind == 2 && wish.rows == 3) {
    static const std::vector<std::string> kVectors = {"cross", "faceforward", "reflect"};
    const Typed a = array_value(writer, context, inner);
    const Typed b = element_of_array(writer, context, inner);
    return {expression(writer.random.of(kVectors) + "($, $)", {a.piece, b.piece}), kFloat, 3, a.uniform && b.uniform};
  }
  if (kind >= 3) {
    // With a float on one side the whole is float.
    static const std::vector<std::string> kOperators = {"+", "-", "*", "/", "%"};
    const Typed a = array_value(writer, context, inner);
    const bool scalar = writer.random.one_in(2);
    const Typed b = scalar ? float_value(writer, context, {0, wish.uniform, wish.depth - 1, false})
                           : element_of_array(writer, context, inner);
    const bool swapped = writer.random.one_in(2);
    return {expression("($ " + writer.random.of(kOperators) + " $)",
                       swapped ? std::vector<Piece>{b.piece, a.piece} : std::vector<Piece>{a.piece, b.piece}),
            kFloat, wish.rows, a.uniform && b.uniform};
  }
  return element_of_array(writer, context, wish);
}

Typed any_value(Writer& writer, const Context& context, const Wish& wish) {
  std::vector<const FunctionName*> pure;
  for (const FunctionName& function : context.functions) {
    if (!function.has_output() && !function.is_void && (function.uniform || !wish.uniform)) pure.push_back(&function);
  }
  if (!pure.empty() && wish.depth > 0 && writer.random.one_in(5)) {
    return call(writer, context, *writer.random.of(pure));
  }
  return writer.random.one_in(3) ? float_value(writer, context, wish) : fixed_value(writer, context, wish);
}

Piece value_for(Writer& writer, const Context& context, const Number& number, int rows, bool uniform) {
  const int depth = writer.random.between(0, writer.settings.depth);
  if (rows > 0) {
    if (writer.random.one_in(2)) return array_value(writer, context, {rows, uniform, depth, false}).piece;
    std::vector<Piece> elements;
    std::string form = "{";
    for (int n = 0; n < rows; ++n) {
      elements.push_back(writer.random.one_in(3) ? expression(literal_for(writer.random, number))
                                                 : any_value(writer, context, {0, uniform, depth - 1, false}).piece);
      form += n == 0 ? "$" : ", $";
    }
    return expression(form + "}", std::move(elements));
  }
  if (writer.random.one_in(8)) return expression(literal_for(writer.random, number));
  if (writer.random.one_in(12)) {
    const Typed chosen = condition(writer, context, uniform, depth);
    const std::string a = literal_for(writer.random, number), b = literal_for(writer.random, number);
    return expression("($ ? " + a + " : " + b + ")", {chosen.piece});
  }
  if (number.is_bool()) {
    const Typed value = writer.random.one_in(2) ? condition(writer, context, uniform, depth)
                                                : fixed_value(writer, context, {0, uniform, depth, false});
    return value.piece;
  }
  return any_value(writer, context, {0, uniform, depth, !number.floating}).piece;
}

}  // namespace random_shaders
