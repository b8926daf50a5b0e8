// Arithmetic of literals: calculated in doubles, and a literal again.
#include <algorithm>
#include <cmath>

#include "pixelflow/compiler/checker.h"

namespace pfman {
namespace {

using ast::Operator;

Value number(double value, bool real, Location where) {
  if (real || value != std::floor(value) || std::fabs(value) >= 0x1p63) return Value::of(value, where);
  return Value::whole(static_cast<std::int64_t>(value), where);
}

/// -1 where the result has 63 bits or more.
std::int64_t bits(Operator op, std::int64_t x, std::int64_t y) {
  switch (op) {
    case Operator::ShiftLeft:
      if (x == 0) return 0;
      return y > 62 || (x << y) >> y != x || (x << y) < 0 ? -1 : x << y;
    case Operator::ShiftRight: return y > 63 ? 0 : x >> y;
    case Operator::BitAnd: return x & y;
    case Operator::BitOr: return x | y;
    default: return x ^ y;
  }
}

}  // namespace

Value Checker::fold(Operator op, const Value& a, const Value* b, Location where) {
  const double x = a.number;
  if (b == nullptr) {
    switch (op) {
      case Operator::Negate: return number(-x, a.real, where);
      case Operator::Plus: return number(x, a.real, where);
      case Operator::Not: return Value::whole(x == 0, where);
      default:
        if (a.real) return mistake(202, where, "'~' of a real number");
        return mistake(202, where, "'~' of a literal, which has no size of its own; give it a type");
    }
  }
  const double y = b->number;
  const bool real = a.real || b->real;
  switch (op) {
    case Operator::Add: return number(x + y, real, where);
    case Operator::Subtract: return number(x - y, real, where);
    case Operator::Multiply: return number(x * y, real, where);
    case Operator::Divide:
    case Operator::Remainder:
      if (y == 0) return mistake(202, where, "division of a literal by zero");
      return number(op == Operator::Divide ? x / y : x - y * std::floor(x / y), real, where);
    case Operator::Less: return Value::whole(x < y, where);
    case Operator::LessEqual: return Value::whole(x <= y, where);
    case Operator::Greater: return Value::whole(x > y, where);
    case Operator::GreaterEqual: return Value::whole(x >= y, where);
    case Operator::Equal: return Value::whole(x == y, where);
    case Operator::NotEqual: return Value::whole(x != y, where);
    case Operator::And: return Value::whole(x != 0 && y != 0, where);
    case Operator::Or: return Value::whole(x != 0 || y != 0, where);
    default: break;
  }
  const std::string spelled = std::string("'") + ast::spelling(op) + "'";
  if (real) return mistake(202, where, spelled + " of a real number");
  if (a.integer < 0 || b->integer < 0) return mistake(202, where, spelled + " of a negative literal");
  const std::int64_t result = bits(op, a.integer, b->integer);
  if (result < 0) return mistake(202, where, "the result of " + spelled + " has more than 63 bits");
  return Value::whole(result, where);
}

}  // namespace pfman
