// The worked examples of the language manual, node by node: the bottom-up type, then the final one.
#include <gtest/gtest.h>

#include "tests/pfman_sizes/checked.h"

namespace {

using pfman::Node;
using pfman_tests::check_body;
using pfman_tests::text;

/// "bottom-up -> final" of the value assigned by the last statement, a node before its operands; conversions at the
/// root and what lies below elements are left out.
std::vector<std::string> sizes(const std::string& statements) {
  const auto checked = check_body(statements);
  EXPECT_EQ(checked->diagnostics.text(), "");
  if (checked->diagnostics.has_errors()) return {};
  std::vector<std::string> found;
  const auto visit = [&](const Node& node, const auto& self) -> void {
    found.push_back(text(node.exact) + " -> " + text(node.type.scalar));
    if (node.op == Node::Op::Element) return;
    for (const auto& operand : node.operands) self(*operand, self);
  };
  const Node* root = pfman_tests::last_expression(*checked).operands.at(1).get();
  if (root->op == Node::Op::Convert) root = root->operands[0].get();
  visit(*root, visit);
  return found;
}

using Sizes = std::vector<std::string>;

TEST(pfman_sizes, example_sum_of_fourteen_bits_has_two_bytes) {
  EXPECT_EQ(sizes("fixed<14,0> a = 1, b = 2; fixed<16,0> c = a + b;"),
            (Sizes{"U(15,0) -> U(15,0)", "U(14,0) -> U(14,0)", "U(14,0) -> U(14,0)"}));
}

TEST(pfman_sizes, example_sum_of_sixteen_bits_is_cut_to_its_target) {
  EXPECT_EQ(sizes("fixed<16,0> a = 1, b = 2; fixed<24,0> c = a + b;")[0], "U(17,0) -> U(17,0)");
  EXPECT_EQ(sizes("fixed<16,0> a = 1, b = 2; fixed<16,0> c = a + b;")[0], "U(17,0) -> U(16,0)");
}

TEST(pfman_sizes, example_colour) {
  EXPECT_EQ(sizes("fixed<8,8> col = 0, tex = 0, amb = 0; fixed<8,8> c = col*tex + amb*0.25;"),
            (Sizes{"U(17,16) -> U(12,12)", "U(16,16) -> U(12,12)", "U(8,8) -> U(8,8)", "U(8,8) -> U(8,8)",
                   "U(9,10) -> U(9,10)", "U(8,8) -> U(8,8)", "U(1,2) -> U(1,2)"}));
}

TEST(pfman_sizes, example_mandelbrot_step) {
  EXPECT_EQ(sizes("signed fixed<32,28> zr = 0, zi = 0, cr = 0; signed fixed<32,28> t = zr*zr - zi*zi + cr;"),
            (Sizes{"S(66,56) -> S(36,32)", "S(65,56) -> S(36,32)", "S(64,56) -> S(36,32)", "S(32,28) -> S(32,28)",
                   "S(32,28) -> S(32,28)", "S(64,56) -> S(36,32)", "S(32,28) -> S(32,28)", "S(32,28) -> S(32,28)",
                   "S(32,28) -> S(32,28)"}));
}

TEST(pfman_sizes, example_row_of_bricks) {
  EXPECT_EQ(sizes("fixed<16,12> tt = 1; fixed<16,16> h = 0.5; fixed<8,0> row = tt / h;"),
            (Sizes{"U(32,12) -> U(8,0)", "U(16,12) -> U(16,12)", "U(16,16) -> U(16,16)"}));
  EXPECT_EQ(sizes("fixed<8,0> row = 3; fixed<16,0> odd = row % 2;"),
            (Sizes{"U(2,0) -> U(2,0)", "U(8,0) -> U(8,0)", "U(2,0) -> U(2,0)"}));
}

TEST(pfman_sizes, products_under_a_difference_and_a_negation_keep_guard_bits) {
  const auto checked = check_body("fixed<8,8> a = 0, b = 0; signed fixed<9,8> c = -(a * b);");
  const Node& negated = *pfman_tests::last_expression(*checked).operands.at(1)->operands.at(0);
  EXPECT_FALSE(negated.operands[0]->under);
  EXPECT_EQ(text(negated.operands[0]->type.scalar), "U(8,8)");
  EXPECT_EQ(sizes("fixed<8,8> a = 0, b = 0; signed fixed<9,8> c = b - -(a * b);")[3], "U(16,16) -> U(12,12)");
}

TEST(pfman_sizes, constant_shifts_move_the_demand) {
  EXPECT_EQ(sizes("fixed<16,8> a = 0; fixed<8,0> b = a << 4;"),
            (Sizes{"U(16,4) -> U(12,4)", "U(16,8) -> U(12,8)", "U(3,0) -> U(3,0)"}));
  EXPECT_EQ(sizes("fixed<16,8> a = 0; fixed<8,4> b = (a * a) >> 4;"),
            (Sizes{"U(32,20) -> U(8,4)", "U(32,16) -> U(8,0)", "U(16,8) -> U(16,8)", "U(16,8) -> U(16,8)",
                   "U(3,0) -> U(3,0)"}));
}

TEST(pfman_sizes, branches_have_one_type) {
  EXPECT_EQ(sizes("fixed<8,8> a = 0; signed fixed<12,4> b = 0; bool c = true; fixed<8,4> d = c ? a : b;"),
            (Sizes{"S(16,8) -> S(12,8)", "U(1,0) -> U(1,0)", "S(12,8) -> S(12,8)", "U(8,8) -> U(8,8)",
                   "S(12,8) -> S(12,8)", "S(12,4) -> S(8,4)"}));
}

TEST(pfman_sizes, library_results_keep_their_fraction_bits) {
  EXPECT_EQ(sizes("fixed<8,8> a[2] = { 0, 0 }; fixed<8,4> d = dot(a, a);")[0], "U(17,16) -> U(17,16)");
  EXPECT_EQ(sizes("signed fixed<16,14> a = 0, b = 0; signed fixed<8,4> d = max(a, b);")[0], "S(16,14) -> S(16,14)");
}

TEST(pfman_sizes, wide_intermediate_values_are_refused) {
  const auto checked = check_body("fixed<40,0> a = 1; fixed<64,0> b = a * a; float f = a * a;");
  EXPECT_EQ(checked->diagnostics.text(),
            "s.pfman:2:55: error: the result of '*' needs 80 bits; 64 are possible [E210]\n");
}

}  // namespace
