// Built-in functions of floats or of fixed-point numbers.
#include <algorithm>
#include <cmath>

#include "tests/reference/builtin_tables.h"
#include "tests/reference/limit.h"

namespace reference {
namespace {

using pfman::ast::Operator;
using Arguments = std::vector<Value>;

const Number& type_of(const Node& node, std::size_t n) { return node.operands[n]->number; }
bool floating(const Node& node) { return node.operands[0]->number.floating; }

/// Of a fixed-point operand, without a loss: raw 2^(exponent - own exponent), modulo 2^128.
Magnitude aligned(Raw raw, const Number& number, int exponent) {
  return shifted_left(static_cast<Magnitude>(integer(raw, number)), exponent - number.exponent);
}

bool less(Raw x, const Number& a, Raw y, const Number& b) {
  if (a.floating) return as_float(x) < as_float(y);
  const int exponent = std::max(a.exponent, b.exponent);
  return static_cast<Wide>(aligned(x, a, exponent)) < static_cast<Wide>(aligned(y, b, exponent));
}

/// A number with its type, as min and max hand it on.
struct Typed {
  Raw raw;
  Number number;
};
Typed least(const Typed& a, const Typed& b) { return less(b.raw, b.number, a.raw, a.number) ? b : a; }
Typed most(const Typed& a, const Typed& b) { return less(a.raw, a.number, b.raw, b.number) ? b : a; }
Raw held(const Typed& typed, const Node& node) {
  return node.number.floating ? typed.raw : fixed_to_fixed(typed.raw, typed.number, node.number, false);
}

Value extreme(const Node& node, const Arguments& a, bool greatest) {
  return each(node, a, [&](int element, int lane) {
    Typed best{a[0].at(element, lane), type_of(node, 0)};
    for (std::size_t n = 1; n < a.size(); ++n) {
      const Typed other{a[n].at(element, lane), type_of(node, n)};
      best = greatest ? most(best, other) : least(best, other);
    }
    return held(best, node);
  });
}

Value clamp(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) {
    const Typed x{a[0].at(element, lane), type_of(node, 0)};
    const Typed raised = most(x, {a[1].at(element, lane), type_of(node, 1)});
    return held(least(raised, {a[2].at(element, lane), type_of(node, 2)}), node);
  });
}

Value step(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) -> Raw {
    const bool below = less(a[1].at(element, lane), type_of(node, 1), a[0].at(element, lane), type_of(node, 0));
    return floating(node) ? float_bits(below ? 0.0f : 1.0f) : below ? 0 : 1;
  });
}

Value absolute(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) {
    const Raw raw = a[0].at(element, lane);
    if (floating(node)) return float_bits(std::fabs(as_float(raw)));
    const Wide value = integer(raw, type_of(node, 0));
    return wrapped(static_cast<Magnitude>(value < 0 ? -value : value), node.number);
  });
}

Value sign(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) {
    const Raw raw = a[0].at(element, lane);
    if (floating(node)) return float_bits(as_float(raw) < 0 ? -1.0f : 0 < as_float(raw) ? 1.0f : 0.0f);
    const Wide value = integer(raw, type_of(node, 0));
    return wrapped(static_cast<Magnitude>(value < 0 ? Wide{-1} : Wide{value > 0}), node.number);
  });
}

/// floor, ceil, round. `add` has the fixed-point number's fraction bits in: 0, all ones, a half.
Value integer_part(const Node& node, const Arguments& a, float (*of_float)(float), Wide (*add)(int)) {
  return each(node, a, [&](int element, int lane) {
    const Raw raw = a[0].at(element, lane);
    if (floating(node)) return float_bits(of_float(as_float(raw)));
    const Number& from = type_of(node, 0);
    Wide value = integer(raw, from);
    // Beyond 64 fraction bits the number is less than one; 65 of them tell as much as all do.
    int exponent = from.exponent;
    if (exponent > 100) {
      value = value < 0 ? -1 : Wide{value > 0};
      exponent = 100;
    }
    if (exponent > 0) value = shifted_right(value + add(exponent), exponent);
    return wrapped(static_cast<Magnitude>(value), node.number);
  });
}

Raw square_root(const Magnitude value) {
  // The greatest root whose square is not above the value, bit by bit.
  Magnitude root = 0;
  for (Magnitude bit = Magnitude{1} << 63; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return static_cast<Raw>(root);
}

/// floor(sqrt(raw 2^-e) 2^e) = floor(sqrt(floor(raw 2^e))).
Raw fixed_square_root(Wide raw, int exponent, const Node& node) {
  if (raw <= 0) return 0;
  const Wide scaled = exponent >= 0 ? static_cast<Wide>(shifted_left(static_cast<Magnitude>(raw), exponent))
                                    : shifted_right(raw, -exponent);
  return wrapped(square_root(static_cast<Magnitude>(scaled)), node.number);
}

Value root(const Node& node, const Arguments& a) {
  if (floating(node)) return float_square_root(a[0]);
  return each(node, a, [&](int element, int lane) {
    return fixed_square_root(integer(a[0].at(element, lane), type_of(node, 0)), type_of(node, 0).exponent, node);
  });
}

/// A sum of products modulo 2^128, of elements of arrays of fixed-point numbers.
Magnitude fixed_dot(const Value& a, const Number& p, const Value& b, const Number& q, int lane) {
  Magnitude sum = 0;
  for (int n = 0; n < std::max(a.elements(), b.elements()); ++n) {
    sum += static_cast<Magnitude>(integer(a.at(n, lane), p)) * static_cast<Magnitude>(integer(b.at(n, lane), q));
  }
  return sum;
}

Value dot(const Node& node, const Arguments& a) {
  if (floating(node)) return float_dot(a[0], a[1]);
  return each(node, a, [&](int, int lane) {
    return wrapped(fixed_dot(a[0], type_of(node, 0), a[1], type_of(node, 1), lane), node.number);
  });
}

Value length(const Node& node, const Arguments& a) {
  if (floating(node)) return float_square_root(float_dot(a[0], a[0]));
  const Number& from = type_of(node, 0);
  return each(node, a, [&](int, int lane) {
    const auto square = static_cast<Wide>(fixed_dot(a[0], from, a[0], from, lane));
    return fixed_square_root(square, 2 * from.exponent, node);
  });
}

Value distance(const Node& node, const Arguments& a) {
  if (floating(node)) {
    const Value apart = float_difference(a[0], a[1]);
    return float_square_root(float_dot(apart, apart));
  }
  const Number &p = type_of(node, 0), &q = type_of(node, 1);
  const int exponent = std::max(p.exponent, q.exponent);
  return each(node, a, [&](int, int lane) {
    Magnitude sum = 0;
    for (int n = 0; n < a[0].elements(); ++n) {
      const Magnitude apart = aligned(a[0].at(n, lane), p, exponent) - aligned(a[1].at(n, lane), q, exponent);
      sum += apart * apart;
    }
    return fixed_square_root(static_cast<Wide>(sum), 2 * exponent, node);
  });
}

Value cross(const Node& node, const Arguments& a) {
  constexpr int kAxes[3][2] = {{1, 2}, {2, 0}, {0, 1}};
  return each(node, a, [&](int element, int lane) {
    const int i = kAxes[element][0], j = kAxes[element][1];
    const Raw p = a[0].at(i, lane), q = a[1].at(j, lane), r = a[0].at(j, lane), s = a[1].at(i, lane);
    if (floating(node)) {
      return float_operation(Operator::Subtract, float_operation(Operator::Multiply, p, q),
                             float_operation(Operator::Multiply, r, s));
    }
    const Number &first = type_of(node, 0), &second = type_of(node, 1);
    const auto product = [&](Raw x, Raw y) {
      return static_cast<Magnitude>(integer(x, first)) * static_cast<Magnitude>(integer(y, second));
    };
    return wrapped(product(p, q) - product(r, s), node.number);
  });
}

Value mix(const Node& node, const Arguments& a) {
  return each(node, a, [&](int element, int lane) {
    const Raw x = a[0].at(element, lane), y = a[1].at(element, lane), t = a[2].at(element, lane);
    if (floating(node)) {
      const Raw rest = float_operation(Operator::Subtract, float_bits(1), t);
      return float_operation(Operator::Add, float_operation(Operator::Multiply, x, rest),
                             float_operation(Operator::Multiply, y, t));
    }
    const Number &p = type_of(node, 0), &q = type_of(node, 1), &r = type_of(node, 2);
    const int fraction = std::max(0, r.exponent);  // of 1 - t
    const Magnitude part = aligned(t, r, fraction);
    const Magnitude rest = shifted_left(1, fraction) - part;
    const int exponent = node.number.exponent;
    const Magnitude first = static_cast<Magnitude>(integer(x, p)) * rest;
    const Magnitude second = static_cast<Magnitude>(integer(y, q)) * static_cast<Magnitude>(integer(t, r));
    return wrapped(shifted_left(first, exponent - p.exponent - fraction) +
                       shifted_left(second, exponent - q.exponent - r.exponent),
                   node.number);
  });
}

float rounded_up(float x) {
  const float below = float_floor(-x);
  return below == 0 ? 0.0f : -below;
}
float to_nearest(float x) { return float_floor(x + 0.5f); }

}  // namespace

void add_generic_functions(std::map<std::string, Builtin>& table) {
  const auto add = [&](const std::string& name, bool takes_literals, int rows, auto evaluate) {
    table[name] = {name, Typing::Generic, takes_literals, rows,
                   [evaluate](const Node& node, const Arguments& a) -> Value { return evaluate(node, a); }};
  };
  add("min", true, -1, [](const Node& node, const Arguments& a) { return extreme(node, a, false); });
  add("max", true, -1, [](const Node& node, const Arguments& a) { return extreme(node, a, true); });
  add("clamp", true, -1, clamp);
  add("mix", true, -1, mix);
  add("step", false, -1, step);
  add("abs", false, -1, absolute);
  add("sign", false, -1, sign);
  add("floor", false, -1, [](const Node& node, const Arguments& a) {
    return integer_part(node, a, float_floor, [](int) -> Wide { return 0; });
  });
  add("ceil", false, -1, [](const Node& node, const Arguments& a) {
    return integer_part(node, a, rounded_up, [](int e) -> Wide { return (Wide{1} << e) - 1; });
  });
  add("round", false, -1, [](const Node& node, const Arguments& a) {
    return integer_part(node, a, to_nearest, [](int e) -> Wide { return Wide{1} << (e - 1); });
  });
  add("sqrt", false, -1, root);
  add("dot", false, 0, dot);
  add("length", false, 0, length);
  add("distance", false, 0, distance);
  add("cross", false, 3, cross);
}

}  // namespace reference
