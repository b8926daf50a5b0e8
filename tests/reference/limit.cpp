#include "tests/reference/limit.h"

#include <algorithm>

namespace reference {
namespace {

using pfman::ast::Operator;

constexpr int kGuard = 4;

std::string place(pfman::Location where) {
  return std::to_string(where.line) + ":" + std::to_string(where.column) + ": ";
}

}  // namespace

Number sum_type(const Number& a, const Number& b) {
  return fixed_of(a.is_signed || b.is_signed, std::max(a.integer_bits(), b.integer_bits()) + 1,
                  std::max(a.exponent, b.exponent));
}

Number difference_type(const Number& a, const Number& b) {
  return fixed_of(true, std::max(a.integer_bits(), b.integer_bits()) + (a.is_signed || b.is_signed ? 1 : 0),
                  std::max(a.exponent, b.exponent));
}

Number negation_type(const Number& a) { return signed_fixed(a.size + 1, a.exponent); }

Number product_type(const Number& a, const Number& b) {
  return {false, a.is_signed || b.is_signed, a.size + b.size, a.exponent + b.exponent};
}

Number quotient_type(const Number& a, const Number& b) {
  return {false, a.is_signed || b.is_signed, a.size + b.size, a.exponent + b.integer_bits()};
}

Number remainder_type(const Number& a, const Number& b) {
  const int m = b.is_signed || a.is_signed ? b.integer_bits() : std::min(a.integer_bits(), b.integer_bits());
  return fixed_of(b.is_signed, m, std::max(a.exponent, b.exponent));
}

Number bits_type(Operator op, const Number& a, const Number& b) {
  if (a.exponent != b.exponent) throw Error(202, "bits of numbers with different exponents");
  if (op == Operator::BitAnd && !a.is_signed && !b.is_signed) {
    return unsigned_fixed(std::min(a.size, b.size), a.exponent);
  }
  return join(a, b);
}

void limit(Node& node, const Demand& demand) {
  if (node.number.floating) return;
  const auto [M, E, under] = demand;
  const Number up = node.number;
  const int extra = under ? kGuard : 0;
  int exponent = up.exponent;
  int size = up.size;
  // Of a node whose operands pass their own fraction bits on.
  const auto carried = [&] {
    exponent = node.operands.back()->number.exponent;
    for (const NodePtr& operand : node.operands) {
      if (!(node.kind == Node::Kind::Conditional && operand == node.operands.front())) {
        exponent = std::max(exponent, operand->number.exponent);
      }
    }
    size = up.integer_bits() + exponent + up.sign_bits();
  };
  switch (node.kind) {
    case Node::Kind::Index:
      if (node.operands[0]->kind != Node::Kind::Read && node.operands[0]->kind != Node::Kind::Index) {
        limit(*node.operands[0], kEverything);
      }
      break;
    case Node::Kind::Array:
      for (const NodePtr& operand : node.operands) limit(*operand, demand);
      carried();
      break;
    case Node::Kind::Conditional:
      limit(*node.operands[1], demand);
      limit(*node.operands[2], demand);
      carried();
      break;
    case Node::Kind::Scale:
      limit(*node.operands[0], {M - node.shift, E + node.shift, under});
      exponent = node.operands[0]->number.exponent - node.shift;
      size = node.operands[0]->number.size;
      break;
    case Node::Kind::Unary:
      if (node.op == Operator::Complement) {
        limit(*node.operands[0], {M, kAll, under});
      } else {
        limit(*node.operands[0], demand);
        carried();
      }
      break;
    case Node::Kind::Binary: {
      const Number a = node.operands[0]->number, b = node.operands[1]->number;
      if (node.op == Operator::Add || node.op == Operator::Subtract) {
        for (const NodePtr& operand : node.operands) limit(*operand, {M, E, true});
        carried();
      } else if (node.op == Operator::Multiply) {
        limit(*node.operands[0], {M + b.exponent, E + b.integer_bits() + kGuard, false});
        limit(*node.operands[1], {M + a.exponent, E + a.integer_bits() + kGuard, false});
        exponent = std::min(node.operands[0]->number.exponent + node.operands[1]->number.exponent, E + extra);
        size = up.size - (up.exponent - exponent);
      } else if (node.op == Operator::Divide) {
        exponent = std::min(up.exponent, E + extra);
        size = up.size - (up.exponent - exponent);
      } else if (node.op != Operator::Remainder) {
        for (const NodePtr& operand : node.operands) limit(*operand, {M, kAll, false});
      }
      break;
    }
    default: break;  // it has no operands that wait for a demand
  }
  node.number.exponent = exponent;
  node.number.size = std::max(1, std::min(size, M + exponent));
  if (node.number.size > 64) throw Error(210, place(node.where) + "more than 64 bits: " + spelling(node.number));
}

}  // namespace reference
