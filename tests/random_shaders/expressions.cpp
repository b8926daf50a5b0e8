// Random scalars of fixed point and conditions.
#include <algorithm>

#include "tests/random_shaders/context.h"
#include "tests/reference/limit.h"

namespace random_shaders {
namespace {

using namespace reference;
using pfman::ast::Operator;

constexpr int kStored = 64;    ///< bits that a node may have
constexpr int kBounded = 150;  ///< from the bottom up, where a demand limits it later

std::vector<Typed> leaves(Writer& writer, const Context& context, bool floating, bool uniform) {
  std::vector<Typed> found;
  for (const Name& name : context.names) {
    if (name.number.floating != floating || (uniform && !name.uniform) || context.busy.contains(name.text)) continue;
    if (name.rows == 0) {
      found.push_back({expression(name.text), name.number, 0, name.uniform});
    } else if (writer.random.one_in(2)) {
      found.push_back(
          {expression(name.text + "[$]", {index_below(writer, context, name.rows)}), name.number, 0, name.uniform});
    }
  }
  return found;
}

Typed leaf(Writer& writer, const Context& context, bool uniform) {
  const std::vector<Typed> found = leaves(writer, context, false, uniform);
  if (!found.empty() && !writer.random.one_in(10)) return writer.random.of(found);
  const Number number = random_fixed(writer.random);
  return {expression(spelled(number) + "(" + literal_for(writer.random, number) + ")"), number, 0, true};
}

struct Literal {
  std::string text;
  Number number;
};
Literal literal_beside(Random& random, const Number& other) {
  static const std::vector<std::int64_t> kIntegers = {0, 1, 2, 3, 5, 7, 10, 100, 255, 256, -1, -2, -7};
  static const std::vector<double> kReals = {0.5, 0.25, 0.1, 1.5, 2.75, 0.3333333, 100.125, -0.5, -1.3};
  if (random.one_in(2)) {
    const std::int64_t value = random.of(kIntegers);
    return {value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value), integer_literal(value).number};
  }
  const double value = random.of(kReals);
  std::string digits = std::to_string(value);
  return {value < 0 ? "(" + digits + ")" : digits, fixed_literal(value, std::max(16, other.exponent)).number};
}

Number type_of(const std::string& op, const Number& a, const Number& b) {
  if (op == "+") return sum_type(a, b);
  if (op == "-") return difference_type(a, b);
  if (op == "*") return product_type(a, b);
  if (op == "/") return quotient_type(a, b);
  return remainder_type(a, b);
}

bool aligns(const Number& a, const Number& b) {
  const int exponent = std::max(a.exponent, b.exponent);
  return a.size + exponent - a.exponent <= kStored && b.size + exponent - b.exponent <= kStored;
}

Number small_type(Random& random) {
  const int size = random.between(2, 12);
  return {false, random.one_in(2), size, random.between(0, size)};
}

Typed binary(Writer& writer, const Context& context, const Wish& wish) {
  static const std::vector<std::string> kOperators = {"+", "+", "-", "-", "*", "*", "/", "%"};
  const std::string op = writer.random.of(kOperators);
  const bool kept = op == "/" || op == "%";
  const Wish inner{0, wish.uniform, wish.depth - 1, wish.bounded && !kept};
  Typed a = fixed_value(writer, context, inner);
  const int room = wish.bounded ? kBounded : kStored;
  if (writer.random.one_in(4)) {
    const Literal literal = literal_beside(writer.random, a.number);
    const bool second = writer.random.one_in(2);
    const Number type = second ? type_of(op, literal.number, a.number) : type_of(op, a.number, literal.number);
    if (type.size > room || (op == "%" && !aligns(a.number, literal.number))) return a;
    return {second ? expression("(" + literal.text + " " + op + " $)", {a.piece})
                   : expression("($ " + op + " " + literal.text + ")", {a.piece}),
            type, 0, a.uniform};
  }
  Typed b = fixed_value(writer, context, inner);
  if (type_of(op, a.number, b.number).size > room || (op == "%" && !aligns(a.number, b.number))) {
    a = cast(writer, std::move(a), small_type(writer.random), writer.random.one_in(3));
    b = cast(writer, std::move(b), small_type(writer.random), writer.random.one_in(3));
  }
  const Number type = type_of(op, a.number, b.number);
  return {expression("($ " + op + " $)", {a.piece, b.piece}), type, 0, a.uniform && b.uniform};
}

Typed bits(Writer& writer, const Context& context, const Wish& wish) {
  static const std::vector<std::string> kOperators = {"&", "|", "^"};
  const std::string op = writer.random.of(kOperators);
  Typed a = fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, false});
  const Number number = a.number;
  const Operator kind = op == "&" ? Operator::BitAnd : op == "|" ? Operator::BitOr : Operator::BitXor;
  if (number.exponent == 0 && writer.random.one_in(2)) {
    const std::int64_t mask = static_cast<std::int64_t>(writer.random.bits() >> writer.random.between(48, 62));
    const Number type = bits_type(kind, number, integer_literal(mask).number);
    if (type.size <= kStored) {
      return {expression("($ " + op + " " + std::to_string(mask) + ")", {a.piece}), type, 0, a.uniform};
    }
  }
  if (number.exponent < -64 || number.exponent > 128 || number.size > kStored) return a;
  Number other{false, writer.random.one_in(2), writer.random.between(2, 24), number.exponent};
  Typed b = cast(writer, fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, false}), other, false);
  const Number type = bits_type(kind, number, other);
  if (type.size > kStored) return a;
  return {expression("($ " + op + " $)", {a.piece, b.piece}), type, 0, a.uniform && b.uniform};
}

Typed shift(Writer& writer, const Context& context, const Wish& wish) {
  const std::string op = writer.random.one_in(2) ? "<<" : ">>";
  Typed a = fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, wish.bounded});
  // A count that is made of constants would be one, so that it takes a variable.
  std::vector<std::string> counts;
  for (const Name& name : context.names) {
    const bool variable = name.uniform && !name.constant && name.rows == 0 && !context.busy.contains(name.text);
    if (variable && name.number == signed_fixed(32, 0)) counts.push_back(name.text);
  }
  if (counts.empty() || writer.random.one_in(2)) {
    const int count = writer.random.between(0, 9);
    a.number.exponent += op == "<<" ? -count : count;
    a.piece = expression("($ " + op + " " + std::to_string(count) + ")", {a.piece});
    return a;
  }
  if (a.number.size > kStored) return a;
  return {expression("($ " + op + " (" + writer.random.of(counts) + " & 7))", {a.piece}), a.number, 0, a.uniform};
}

Typed unary(Writer& writer, const Context& context, const Wish& wish) {
  Typed a = fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, wish.bounded});
  switch (writer.random.below(5)) {
    case 0:
      if (a.number.size >= (wish.bounded ? kBounded : kStored)) return a;
      return {expression("(-$)", {a.piece}), negation_type(a.number), 0, a.uniform};
    case 1:
      if (a.number.size > kStored) return a;
      return {expression("(~$)", {a.piece}), a.number, 0, a.uniform};
    case 2: return {expression("(+$)", {a.piece}), a.number, 0, a.uniform};
    default: return cast(writer, std::move(a), random_fixed(writer.random), writer.random.one_in(2));
  }
}

Typed choice(Writer& writer, const Context& context, const Wish& wish) {
  const Typed chosen = condition(writer, context, wish.uniform, wish.depth - 1);
  const Wish inner{0, wish.uniform, wish.depth - 1, wish.bounded};
  Typed a = fixed_value(writer, context, inner), b = fixed_value(writer, context, inner);
  const Number type = join(a.number, b.number);
  if (type.size > (wish.bounded ? kBounded : kStored)) return a;
  return {expression("($ ? $ : $)", {chosen.piece, a.piece, b.piece}), type, 0,
          chosen.uniform && a.uniform && b.uniform};
}

Typed from_library(Writer& writer, const Context& context, const Wish& wish) {
  const Wish inner{0, wish.uniform, wish.depth - 1, false};
  Typed a = fixed_value(writer, context, inner);
  if (a.number.size > kStored) a = cast(writer, std::move(a), small_type(writer.random), false);
  const auto one = [&](const std::string& name, const Number& type) {
    return Typed{expression(name + "($)", {a.piece}), type, 0, a.uniform};
  };
  const int kind = writer.random.below(10);
  if (kind == 0) return one("abs", unsigned_fixed(a.number.size, a.number.exponent));
  if (kind == 1 && aligns(a.number, kBool)) return one("sign", signed_fixed(2, 0));
  if (kind == 2 && a.number.exponent <= 32 && a.number.exponent >= -16 && a.number.integer_bits() < 32) {
    const int half = std::max(0, a.number.integer_bits() + 1) / 2;
    return one("sqrt", unsigned_fixed(std::max(1, half + a.number.exponent), a.number.exponent));
  }
  if (kind == 3) {
    return one("floor", a.number.exponent <= 0 ? a.number : fixed_of(a.number.is_signed, a.number.integer_bits(), 0));
  }
  if (kind == 4) {
    const Number up = a.number.exponent <= 0 ? a.number : fixed_of(a.number.is_signed, a.number.integer_bits() + 1, 0);
    return one(writer.random.one_in(2) ? "ceil" : "round", up);
  }
  if (kind == 5 && writer.settings.costly) {
    if (writer.random.one_in(3)) return one("cellnoise", unsigned_fixed(8, 8));
    return one("noise", unsigned_fixed(16, 16));
  }
  Typed b = fixed_value(writer, context, inner);
  if (b.number.size > kStored || !aligns(a.number, b.number)) {
    a = cast(writer, std::move(a), small_type(writer.random), false);
    b = cast(writer, std::move(b), small_type(writer.random), false);
  }
  const bool uniform = a.uniform && b.uniform;
  if (kind == 6) return {expression("step($, $)", {a.piece, b.piece}), kBool, 0, uniform};
  if (kind == 7) {
    const Typed c = cast(writer, fixed_value(writer, context, inner), small_type(writer.random), false);
    const Number all = join(join(a.number, b.number), c.number);
    if (all.size <= kStored && aligns(all, c.number) && aligns(all, a.number) && aligns(all, b.number)) {
      return {expression("clamp($, $, $)", {a.piece, b.piece, c.piece}), all, 0, uniform && c.uniform};
    }
  }
  const Number both = join(a.number, b.number);
  if (both.size > kStored) return a;
  return {expression((writer.random.one_in(2) ? "min" : "max") + std::string("($, $)"), {a.piece, b.piece}), both, 0,
          uniform};
}

/// dot, length or distance of fixed-point arrays.
Typed of_arrays(Writer& writer, const Context& context, const Wish& wish) {
  std::vector<Typed> found;
  for (const Name& name : context.names) {
    if (name.rows < 2 || name.number.floating || (wish.uniform && !name.uniform) || name.number.size > 14) continue;
    if (!context.busy.contains(name.text))
      found.push_back({expression(name.text), name.number, name.rows, name.uniform});
  }
  if (found.empty()) return leaf(writer, context, wish.uniform);
  const Typed a = writer.random.of(found);
  const Typed b = writer.random.of(found);
  if (a.rows != b.rows || !aligns(a.number, b.number)) return leaf(writer, context, wish.uniform);
  Number sum = product_type(a.number, b.number);
  for (int n = 1; n < a.rows; ++n) sum = sum_type(sum, product_type(a.number, b.number));
  const bool uniform = a.uniform && b.uniform;
  if (writer.random.one_in(2)) return {expression("dot($, $)", {a.piece, b.piece}), sum, 0, uniform};
  const bool length = writer.random.one_in(2);
  const Number side = length ? a.number : difference_type(a.number, b.number);
  Number square = product_type(side, side);
  for (int n = 1; n < a.rows; ++n) square = sum_type(square, product_type(side, side));
  if (square.size > kStored || square.exponent > 32 || square.exponent < -16)
    return a.rows > 0 ? leaf(writer, context, wish.uniform) : a;
  const int half = (std::max(0, square.integer_bits()) + 1) / 2;
  const Number root = unsigned_fixed(std::max(1, half + square.exponent), square.exponent);
  return length ? Typed{expression("length($)", {a.piece}), root, 0, a.uniform}
                : Typed{expression("distance($, $)", {a.piece, b.piece}), root, 0, uniform};
}

Typed mixed(Writer& writer, const Context& context, const Wish& wish) {
  std::vector<Piece> parts;
  std::vector<Number> types;
  bool uniform = true;
  for (int n = 0; n < 3; ++n) {
    const Typed one = cast(writer, fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, false}),
                           small_type(writer.random), false);
    uniform = uniform && one.uniform;
    parts.push_back(one.piece);
    types.push_back(one.number);
  }
  const Number rest = difference_type(unsigned_fixed(1, 0), types[2]);
  return {expression("mix($, $, $)", std::move(parts)),
          sum_type(product_type(types[0], rest), product_type(types[1], types[2])), 0, uniform};
}

}  // namespace

Typed fixed_array(Writer& writer, const Context& context, const Typed& array, const Wish& wish) {
  static const std::vector<std::string> kOperators = {"+", "-", "*", "/", "%", "-"};
  static const std::vector<std::string> kFunctions = {"abs", "floor", "round", "sign"};
  if (array.number.floating || array.number.size > 24) return array;
  if (writer.random.one_in(4)) {
    // Their types as for scalars; what the array is used for converts it.
    const std::string name = writer.random.of(kFunctions);
    if (name != "abs") return {expression("$ * 1.0f", {array.piece}), kFloat, array.rows, array.uniform};
    return {expression("abs($)", {array.piece}), unsigned_fixed(array.number.size, array.number.exponent), array.rows,
            array.uniform};
  }
  const std::string op = writer.random.of(kOperators);
  const Typed scalar = cast(writer, fixed_value(writer, context, {0, wish.uniform, wish.depth - 1, false}),
                            small_type(writer.random), false);
  const Number type = type_of(op, array.number, scalar.number);
  if (type.size > kStored || (op == "%" && !aligns(array.number, scalar.number))) return array;
  return {expression("($ " + op + " $)", {array.piece, scalar.piece}), type, array.rows,
          array.uniform && scalar.uniform};
}

Typed cast(Writer& writer, Typed value, const Number& to, bool saturate) {
  const bool sat = saturate && !to.floating && !to.is_bool();
  value.piece = expression(std::string(sat ? "sat " : "") + spelled(to) + "($)", {value.piece});
  value.number = to;
  (void)writer;
  return value;
}

Piece index_below(Writer& writer, const Context& context, int rows) {
  if (writer.random.one_in(2)) return expression(std::to_string(writer.random.below(rows)));
  std::vector<Piece> counters;
  for (const Name& name : context.names) {
    if (name.uniform && name.rows == 0 && name.number == reference::signed_fixed(32, 0) &&
        !context.busy.contains(name.text)) {
      counters.push_back(text(name.text));
    }
  }
  if (counters.empty()) return expression(std::to_string(writer.random.below(rows)));
  return expression("$ % " + std::to_string(rows), {writer.random.of(counters)});
}

Typed fixed_value(Writer& writer, const Context& context, const Wish& wish) {
  if (wish.depth <= 0) return leaf(writer, context, wish.uniform);
  switch (writer.random.below(16)) {
    case 0: return leaf(writer, context, wish.uniform);
    case 14: return of_arrays(writer, context, wish);
    case 15: return mixed(writer, context, wish);
    case 1:
    case 2: return unary(writer, context, wish);
    case 3: return bits(writer, context, wish);
    case 4: return shift(writer, context, wish);
    case 5: return choice(writer, context, wish);
    case 6:
    case 7: return from_library(writer, context, wish);
    case 8: return condition(writer, context, wish.uniform, wish.depth - 1);
    case 9: {
      Number to = random_fixed(writer.random);
      if (to.is_bool()) to = reference::signed_fixed(8, 4);
      return cast(writer, float_value(writer, context, {0, wish.uniform, wish.depth - 1, false}), to, false);
    }
    default: return binary(writer, context, wish);
  }
}

Typed condition(Writer& writer, const Context& context, bool uniform, int depth) {
  static const std::vector<std::string> kOperators = {"<", "<=", ">", ">=", "==", "!="};
  const Wish inner{0, uniform, depth - 1, false};
  const int kind = depth <= 0 ? writer.random.between(4, 6) : writer.random.below(9);
  if (kind == 0) {
    const Typed a = condition(writer, context, uniform, depth - 1);
    return {expression("(!$)", {a.piece}), kBool, 0, a.uniform};
  }
  if (kind <= 2) {
    const Typed a = condition(writer, context, uniform, depth - 1), b = condition(writer, context, uniform, depth - 1);
    return {expression(kind == 1 ? "($ && $)" : "($ || $)", {a.piece, b.piece}), kBool, 0, a.uniform && b.uniform};
  }
  const std::string op = writer.random.of(kOperators);
  if (kind == 3) {
    const Typed a = float_value(writer, context, inner);
    const Typed b = writer.random.one_in(3) ? fixed_value(writer, context, inner) : float_value(writer, context, inner);
    return {expression("($ " + op + " $)", {a.piece, b.piece}), kBool, 0, a.uniform && b.uniform};
  }
  Typed a = fixed_value(writer, context, inner);
  if (kind == 4) {
    const Literal literal = literal_beside(writer.random, a.number);
    if (aligns(a.number, literal.number)) {
      return {expression("($ " + op + " " + literal.text + ")", {a.piece}), kBool, 0, a.uniform};
    }
  }
  Typed b = fixed_value(writer, context, inner);
  if (!aligns(a.number, b.number)) {
    a = cast(writer, std::move(a), small_type(writer.random), false);
    b = cast(writer, std::move(b), small_type(writer.random), false);
  }
  return {expression("($ " + op + " $)", {a.piece, b.piece}), kBool, 0, a.uniform && b.uniform};
}

}  // namespace random_shaders
