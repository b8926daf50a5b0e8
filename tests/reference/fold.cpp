// Arithmetic of literals: in doubles, and itself a literal.
#include <cmath>

#include "tests/reference/resolver.h"

namespace reference {
namespace {

using pfman::ast::Operator;

NodePtr real_literal(double value, pfman::Location where) {
  NodePtr made = make_node(Node::Kind::Literal, where);
  made->untyped = true;
  made->real = true;
  made->literal = value;
  return made;
}

NodePtr whole_literal(std::int64_t value, pfman::Location where) {
  NodePtr made = make_node(Node::Kind::Literal, where);
  made->untyped = true;
  made->literal = static_cast<double>(value);
  made->raw = static_cast<Raw>(value);
  return made;
}

NodePtr arithmetic(double value, bool real, pfman::Location where) {
  if (real || value != std::floor(value) || std::fabs(value) >= 0x1p63) return real_literal(value, where);
  return whole_literal(static_cast<std::int64_t>(value), where);
}

NodePtr bits(Operator op, const Node& a, const Node& b, pfman::Location where) {
  const auto x = static_cast<std::int64_t>(a.raw), y = static_cast<std::int64_t>(b.raw);
  if (a.real || b.real || x < 0 || y < 0) fail(202, where, "bits of a literal that is no integer");
  Wide result = 0;
  switch (op) {
    case Operator::ShiftLeft: result = y > 63 && x > 0 ? -1 : Wide{x} << std::min<std::int64_t>(y, 63); break;
    case Operator::ShiftRight: result = y > 63 ? 0 : x >> y; break;
    case Operator::BitAnd: result = x & y; break;
    case Operator::BitOr: result = x | y; break;
    default: result = x ^ y; break;
  }
  if (result < 0 || result >= Wide{1} << 63) fail(202, where, "literal too large");
  return whole_literal(static_cast<std::int64_t>(result), where);
}

}  // namespace

NodePtr fold(Operator op, const Node& a, const Node* b, pfman::Location where) {
  const double x = a.literal;
  if (b == nullptr) {
    switch (op) {
      case Operator::Negate: return arithmetic(-x, a.real, where);
      case Operator::Plus: return arithmetic(x, a.real, where);
      case Operator::Not: return whole_literal(x == 0, where);
      default:
        if (a.real || x < 0) fail(202, where, "~ of a literal that is no integer");
        fail(202, where, "literal too large");
    }
  }
  const double y = b->literal;
  const bool real = a.real || b->real;
  switch (op) {
    case Operator::Add: return arithmetic(x + y, real, where);
    case Operator::Subtract: return arithmetic(x - y, real, where);
    case Operator::Multiply: return arithmetic(x * y, real, where);
    case Operator::Divide:
    case Operator::Remainder:
      if (y == 0) fail(202, where, "division of a literal by zero");
      return arithmetic(op == Operator::Divide ? x / y : x - y * std::floor(x / y), real, where);
    case Operator::Less: return whole_literal(x < y, where);
    case Operator::LessEqual: return whole_literal(x <= y, where);
    case Operator::Greater: return whole_literal(x > y, where);
    case Operator::GreaterEqual: return whole_literal(x >= y, where);
    case Operator::Equal: return whole_literal(x == y, where);
    case Operator::NotEqual: return whole_literal(x != y, where);
    case Operator::And: return whole_literal(x != 0 && y != 0, where);
    case Operator::Or: return whole_literal(x != 0 || y != 0, where);
    default: return bits(op, a, *b, where);
  }
}

}  // namespace reference
