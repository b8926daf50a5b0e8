// The two passes that size fixed-point numbers (Olano & Lastra 1998, section 6.3.2). They define what an expression's
// value is: bottom-up every operation gets a type that keeps all its bits, then a demand goes from the root to the
// leaves and limits them to the bits that are wanted.
#pragma once

#include "tests/reference/node.h"

namespace reference {

/// Bottom-up types of operations on fixed-point operands.
Number sum_type(const Number& a, const Number& b);
Number difference_type(const Number& a, const Number& b);
Number negation_type(const Number& a);
Number product_type(const Number& a, const Number& b);
Number quotient_type(const Number& a, const Number& b);
Number remainder_type(const Number& a, const Number& b);
Number bits_type(pfman::ast::Operator op, const Number& a, const Number& b);

/// Bits wanted of a node: integer bits (a sign included), fraction bits; `under` a sum or difference.
struct Demand {
  int integer_bits;
  int fraction_bits;
  bool under = false;
};
inline constexpr int kAll = 1 << 24;
inline constexpr Demand kEverything{kAll, kAll, false};

/// Limits a node and what its demand passes on to; each node once, from its root. Throws Error 210 for a node of more
/// than 64 bits.
void limit(Node& node, const Demand& demand);

}  // namespace reference
