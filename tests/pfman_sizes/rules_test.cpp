// Types of single operations from the bottom up, and literals.
#include <gtest/gtest.h>

#include "pixelflow/compiler/fixed_types.h"
#include "tests/pfman_sizes/checked.h"

namespace {

using Op = pfman::Node::Op;
using pfman::binary_type;
using pfman::fixed_literal;
using pfman::integer_literal;
using pfman::Scalar;
using pfman::unary_type;
using pfman_tests::text;

Scalar u(int size, int exponent) { return Scalar::fixed(false, size, exponent); }
Scalar s(int size, int exponent) { return Scalar::fixed(true, size, exponent); }

TEST(pfman_sizes, rules_of_sums) {
  EXPECT_EQ(binary_type(Op::Add, u(8, 8), u(8, 0)), u(17, 8));
  EXPECT_EQ(binary_type(Op::Add, s(8, 4), u(8, 4)), s(10, 4));
  EXPECT_EQ(binary_type(Op::Subtract, u(8, 0), u(8, 0)), s(9, 0));
  EXPECT_EQ(binary_type(Op::Subtract, s(8, 0), u(4, 2)), s(11, 2));
  EXPECT_EQ(unary_type(Op::Negate, u(8, 3)), s(9, 3));
  EXPECT_EQ(unary_type(Op::Negate, s(8, 3)), s(9, 3));
}

TEST(pfman_sizes, rules_of_products_and_quotients) {
  EXPECT_EQ(binary_type(Op::Multiply, s(8, 4), u(10, 12)), s(18, 16));
  EXPECT_EQ(binary_type(Op::Divide, u(16, 12), u(16, 16)), u(32, 12));
  EXPECT_EQ(binary_type(Op::Divide, s(8, 0), s(8, 2)), s(16, 5));
  EXPECT_EQ(binary_type(Op::Remainder, u(8, 0), u(2, 0)), u(2, 0));
  EXPECT_EQ(binary_type(Op::Remainder, u(2, 0), u(8, 4)), u(6, 4));
  EXPECT_EQ(binary_type(Op::Remainder, s(8, 0), u(4, 0)), u(4, 0));
  EXPECT_EQ(binary_type(Op::Remainder, u(8, 4), s(4, 0)), s(8, 4));
}

TEST(pfman_sizes, rules_of_bits_and_roundings) {
  EXPECT_EQ(binary_type(Op::BitAnd, u(8, 4), u(5, 4)), u(5, 4));
  EXPECT_EQ(binary_type(Op::BitAnd, s(8, 4), u(5, 4)), s(8, 4));
  EXPECT_EQ(binary_type(Op::BitXor, s(8, 4), u(8, 4)), s(9, 4));
  EXPECT_EQ(unary_type(Op::Complement, s(8, 4)), s(8, 4));
  EXPECT_EQ(unary_type(Op::Abs, s(8, 4)), u(8, 4));
  EXPECT_EQ(unary_type(Op::Floor, s(12, 8)), s(4, 0));
  EXPECT_EQ(unary_type(Op::Round, u(12, 8)), u(5, 0));
  EXPECT_EQ(unary_type(Op::Ceil, u(8, -2)), u(8, -2));
  EXPECT_EQ(unary_type(Op::Floor, u(8, 16)), u(1, 0));
  EXPECT_EQ(unary_type(Op::SquareRoot, u(16, 0)), u(8, 0));
  EXPECT_EQ(unary_type(Op::SquareRoot, s(32, 28)), u(30, 28));
  EXPECT_EQ(unary_type(Op::SquareRoot, u(8, 16)), u(12, 16));
}

TEST(pfman_sizes, literals_have_the_smallest_type) {
  EXPECT_EQ(integer_literal(0).scalar, u(1, 0));
  EXPECT_EQ(integer_literal(255).scalar, u(8, 0));
  EXPECT_EQ(integer_literal(-128).scalar, s(8, 0));
  EXPECT_EQ(integer_literal(-129).scalar, s(9, 0));
  EXPECT_EQ(integer_literal(INT64_MIN).scalar, s(64, 0));
  EXPECT_EQ(fixed_literal(0.25, 16).scalar, u(1, 2));
  EXPECT_EQ(fixed_literal(6.0, 16).scalar, u(2, -1));
  EXPECT_EQ(fixed_literal(-0.75, 16).scalar, s(3, 2));
  EXPECT_EQ(fixed_literal(0.1, 16).scalar, u(12, 15));  // 6554 / 65536
  EXPECT_EQ(fixed_literal(0.1, 16).raw, 3277u);
  EXPECT_EQ(fixed_literal(0x1.8p-17, 16).raw, 1u);  // a half up
  EXPECT_EQ(fixed_literal(-0x1p-17, 16).raw, 0u);
  EXPECT_EQ(fixed_literal(0x1p-18, 16).raw, 0u);
}

TEST(pfman_sizes, literals_take_the_type_of_what_they_meet) {
  const auto type_of = [](const std::string& statements) {
    const auto checked = pfman_tests::check_body(statements);
    EXPECT_FALSE(checked->diagnostics.has_errors()) << checked->diagnostics.text();
    const pfman::Node* node = pfman_tests::last_expression(*checked).operands.at(1).get();
    while (node->op == Op::Convert) node = node->operands[0].get();
    return text(node->exact);
  };
  EXPECT_EQ(type_of("fixed<8,8> a = 0; fixed<8,8> b = a * 0.5;"), "U(9,9)");
  EXPECT_EQ(type_of("float a = 0; float b = a * 2;"), "float");
  EXPECT_EQ(type_of("fixed<8,8> a = 0; float b = a * 0.5f;"), "float");
  EXPECT_EQ(type_of("fixed<20,18> a = 0; fixed<20,18> b = a + 1.0 / 3;"), "U(21,18)");
  EXPECT_EQ(type_of("fixed<8,4> a = 0; fixed<8,4> b = a > 1 ? a : 0.5;"), "U(8,4)");
  EXPECT_EQ(type_of("bool c = true; fixed<8,4> b = c ? 0.5 : 3;"), "U(3,1)");
  EXPECT_EQ(type_of("bool c = true; float b = 1 + (c ? 0.5 : 3);"), "float");
  EXPECT_EQ(type_of("fixed<8,4> b = min(0.5, 2);"), "U(3,1)");
  EXPECT_EQ(type_of("float b = abs(-3);"), "U(3,0)");
}

}  // namespace
