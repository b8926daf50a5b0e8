// Operators: operands meet, shapes and rates are checked, the result's type found from the bottom up.
#include <cmath>

#include "pixelflow/compiler/checker.h"

namespace pfman {
namespace {

using ast::Operator;
using Op = Node::Op;

Op arithmetic_op(Operator op) {
  switch (op) {
    case Operator::Add: return Op::Add;
    case Operator::Subtract: return Op::Subtract;
    case Operator::Multiply: return Op::Multiply;
    case Operator::Divide: return Op::Divide;
    case Operator::Remainder: return Op::Remainder;
    case Operator::BitAnd: return Op::BitAnd;
    case Operator::BitOr: return Op::BitOr;
    default: return Op::BitXor;
  }
}

bool is_bitwise(Operator op) { return op == Operator::BitAnd || op == Operator::BitOr || op == Operator::BitXor; }

std::string quoted(Operator op) { return std::string("'") + ast::spelling(op) + "'"; }

Values pair_of(Value a, Value b) {
  Values both;
  both.push_back(std::move(a));
  both.push_back(std::move(b));
  return both;
}

bool is_void(const Value& value) { return value.kind == Value::Kind::Typed && value.node->type.is_void; }

}  // namespace

bool Checker::same_shapes(const Type& a, const Type& b, Location where) {
  if (!a.is_array() || !b.is_array() || a.same_shape(b)) return true;
  error(203, where, "arrays of different shapes");
  return false;
}

Value Checker::unary(Operator op, Value operand, Location where) {
  if (operand.mistake()) return {};
  if (operand.kind == Value::Kind::Literal) return fold(op, operand, nullptr, where);
  if (op == Operator::Not) {
    NodePtr node = condition(std::move(operand));
    if (!node) return {};
    return Value::typed(make_operation(Op::Not, nodes(std::move(node)), where));
  }
  NodePtr node = settle(std::move(operand));
  if (!node) return {};
  if (node->type.is_void) return mistake(202, where, "a call of a void function has no value");
  if (op == Operator::Plus) return Value::typed(std::move(node));
  if (op == Operator::Complement) {
    if (node->exact.is_float || node->type.is_array()) {
      return mistake(202, where, "'~' of type '" + spelling(node->type) + "'; it takes a fixed-point number");
    }
    return Value::typed(make_operation(Op::Complement, nodes(std::move(node)), where));
  }
  return Value::typed(make_operation(Op::Negate, nodes(std::move(node)), where));
}

Value Checker::binary(Operator op, Value a, Value b, Location where) {
  if (a.mistake() || b.mistake()) return {};
  if (is_void(a) || is_void(b)) return mistake(202, where, "a call of a void function has no value");
  if (a.kind == Value::Kind::Literal && b.kind == Value::Kind::Literal) return fold(op, a, &b, where);
  switch (op) {
    case Operator::And:
    case Operator::Or: {
      NodePtr first = condition(std::move(a)), second = condition(std::move(b));
      if (!first || !second) return {};
      return Value::typed(
          make_operation(op == Operator::And ? Op::And : Op::Or, nodes(std::move(first), std::move(second)), where));
    }
    case Operator::ShiftLeft:
    case Operator::ShiftRight: return shift(op, std::move(a), std::move(b), where);
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Greater:
    case Operator::GreaterEqual:
    case Operator::Equal:
    case Operator::NotEqual: return comparison(op, std::move(a), std::move(b), where);
    default: return arithmetic(op, std::move(a), std::move(b), where);
  }
}

Value Checker::arithmetic(Operator op, Value a, Value b, Location where) {
  if (!same_shapes(a.type(), b.type(), where)) return {};
  Nodes operands;
  settle_together(pair_of(std::move(a), std::move(b)), operands);
  if (!operands[0] || !operands[1]) return {};
  const Node &x = *operands[0], &y = *operands[1];
  if (is_bitwise(op)) {
    if (x.exact.is_float || x.type.is_array() || y.type.is_array()) {
      return mistake(202, where,
                     quoted(op) + " of types '" + spelling(x.type) + "' and '" + spelling(y.type) +
                         "'; it takes fixed-point numbers");
    }
    if (x.exact.exponent != y.exact.exponent) {
      return mistake(202, where,
                     quoted(op) + " of numbers with different exponents, " + std::to_string(x.exact.exponent) +
                         " and " + std::to_string(y.exact.exponent));
    }
  }
  return Value::typed(make_operation(arithmetic_op(op), std::move(operands), where));
}

Value Checker::comparison(Operator op, Value a, Value b, Location where) {
  const bool equality = op == Operator::Equal || op == Operator::NotEqual;
  const Type first = a.type(), second = b.type();
  if (equality ? !first.same_shape(second) : first.is_array() || second.is_array()) {
    if (!equality) return mistake(202, where, quoted(op) + " of arrays");
    return mistake(203, where, "comparison of different shapes");
  }
  Nodes operands;
  settle_together(pair_of(std::move(a), std::move(b)), operands);
  if (!operands[0] || !operands[1]) return {};
  const bool swapped = op == Operator::Greater || op == Operator::GreaterEqual;
  Nodes before;
  if (swapped) {
    // Calls keep their order.
    if (!is_pure(*operands[0]) && !is_pure(*operands[1])) operands[0] = write_.reuse(std::move(operands[0]), before);
    std::swap(operands[0], operands[1]);
  }
  const Op kind = op == Operator::Equal                             ? Op::Equal
                  : op == Operator::NotEqual                        ? Op::NotEqual
                  : op == Operator::Less || op == Operator::Greater ? Op::Less
                                                                    : Op::LessEqual;
  return Value::typed(make_sequence(std::move(before), make_operation(kind, std::move(operands), where), where));
}

Value Checker::shift(Operator op, Value a, Value b, Location where) {
  NodePtr number = settle(std::move(a)), count = settle(std::move(b));
  if (!number || !count) return {};
  if (number->exact.is_float || number->type.is_array() || count->exact.is_float || count->type.is_array()) {
    return mistake(202, where,
                   quoted(op) + " of types '" + spelling(number->type) + "' and '" + spelling(count->type) +
                       "'; it takes fixed-point numbers");
  }
  if (count->type.varying) return mistake(206, count->where, "the count of a shift varies from pixel to pixel");
  const bool left = op == Operator::ShiftLeft;
  Scalar scalar = number->exact;
  if (is_constant(*count)) {
    const std::optional<std::int64_t> places = constant_integer(*count);
    if (!places) return {};
    if (*places < 0 || *places > 64) {
      return mistake(202, count->where, "a shift by " + std::to_string(*places) + "; 0 to 64 places are possible");
    }
    scalar.exponent += left ? -static_cast<int>(*places) : static_cast<int>(*places);
    count = make_integer(*places, count->where);
  }
  return Value::typed(
      make_node(left ? Op::ShiftLeft : Op::ShiftRight, scalar, nodes(std::move(number), std::move(count)), where));
}

}  // namespace pfman
