// The two passes over fixed-point sizes: examples worked by hand.
#include <gtest/gtest.h>

#include "tests/reference/limit.h"
#include "tests/reference/resolver.h"
#include "tests/reference/shaders.h"

namespace reference_tests {
namespace {

using namespace reference;

/// The types of the nodes of a declaration's initial value, from the last statement of function f: a node, then its
/// operands.
std::vector<std::string> sizes(const std::string& body) {
  static std::vector<std::unique_ptr<pfman::ast::Unit>> units;  // a Resolver refers to its unit
  units.push_back(std::make_unique<pfman::ast::Unit>(parse("void f() { " + body + " }")));
  Resolver resolver(*units.back());
  const Step* last = resolver.function("f").body->body.back().get();
  last = last->body.back().get();
  std::vector<std::string> found;
  const auto visit = [&](const Node& node, const auto& self) -> void {
    if (node.kind != Node::Kind::Convert) found.push_back(spelling(node.number));
    for (const NodePtr& operand : node.operands) self(*operand, self);
  };
  visit(*last->nodes[0], visit);
  return found;
}

using Sizes = std::vector<std::string>;

TEST(Sizing, sum_of_fourteen_bits_has_fifteen) {
  EXPECT_EQ(sizes("fixed<14,0> a = 1, b = 2; fixed<16,0> c = a + b;"), (Sizes{"U(15,0)", "U(14,0)", "U(14,0)"}));
}

TEST(Sizing, sum_is_cut_to_what_is_assigned) {
  EXPECT_EQ(sizes("fixed<16,0> a = 1, b = 2; fixed<24,0> c = a + b;").front(), "U(17,0)");
  EXPECT_EQ(sizes("fixed<16,0> a = 1, b = 2; fixed<16,0> c = a + b;").front(), "U(16,0)");
}

TEST(Sizing, color_keeps_guard_bits_under_a_sum) {
  EXPECT_EQ(sizes("fixed<8,8> col = 0, tex = 0, amb = 0; fixed<8,8> c = col*tex + amb*0.25;"),
            (Sizes{"U(12,12)", "U(12,12)", "U(8,8)", "U(8,8)", "U(9,10)", "U(8,8)", "U(1,2)"}));
}

TEST(Sizing, mandelbrot_step_needs_five_bytes) {
  const Sizes found = sizes("signed fixed<32,28> zr = 0, zi = 0, cr = 0; signed fixed<32,28> t = zr*zr - zi*zi + cr;");
  EXPECT_EQ(found, (Sizes{"S(36,32)", "S(36,32)", "S(36,32)", "S(32,28)", "S(32,28)", "S(36,32)", "S(32,28)",
                          "S(32,28)", "S(32,28)"}));
}

TEST(Sizing, quotient_is_cut_to_the_row_and_remainder_to_the_divisor) {
  EXPECT_EQ(sizes("fixed<16,12> tt = 1; fixed<16,16> h = 0.5; fixed<8,0> row = tt / h;").front(), "U(8,0)");
  EXPECT_EQ(sizes("fixed<8,0> row = 3; fixed<16,0> r = row % 2;").front(), "U(2,0)");
}

TEST(Sizing, bottom_up_types) {
  EXPECT_EQ(quotient_type(unsigned_fixed(16, 12), unsigned_fixed(16, 16)), unsigned_fixed(32, 12));
  EXPECT_EQ(product_type(unsigned_fixed(8, 8), unsigned_fixed(8, 8)), unsigned_fixed(16, 16));
  EXPECT_EQ(difference_type(unsigned_fixed(8, 0), unsigned_fixed(8, 0)), signed_fixed(9, 0));
  EXPECT_EQ(difference_type(signed_fixed(64, 56), signed_fixed(64, 56)), signed_fixed(65, 56));
  EXPECT_EQ(sum_type(unsigned_fixed(8, 0), signed_fixed(8, 4)), signed_fixed(14, 4));
  EXPECT_EQ(remainder_type(signed_fixed(8, 4), unsigned_fixed(8, 0)), unsigned_fixed(12, 4));
  EXPECT_EQ(remainder_type(unsigned_fixed(8, 4), unsigned_fixed(8, 0)), unsigned_fixed(8, 4));
  EXPECT_EQ(remainder_type(unsigned_fixed(8, 0), signed_fixed(5, 0)), signed_fixed(5, 0));
  EXPECT_EQ(negation_type(signed_fixed(8, 0)), signed_fixed(9, 0));
}

TEST(Sizing, more_than_sixty_four_bits_is_an_error) {
  const std::string wide = "signed fixed<64,32> a = 1; ";
  EXPECT_NO_THROW(sizes(wide + "signed fixed<64,32> b = a * a;"));  // cut to what is assigned
  try {
    sizes(wide + "bool b = a * a == 1;");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code, 210);
  }
}

TEST(Sizing, literals) {
  const auto literal = [](double value, int bits) { return spelling(fixed_literal(value, bits).number); };
  EXPECT_EQ(literal(0.25, 16), "U(1,2)");
  EXPECT_EQ(literal(0.75, 16), "U(2,2)");
  EXPECT_EQ(literal(-0.5, 16), "S(1,1)");
  EXPECT_EQ(fixed_literal(1.0 / 3, 16).raw, 21845u);
  EXPECT_EQ(literal(1.0 / 3, 16), "U(15,16)");
  EXPECT_EQ(fixed_literal(0x1.8p-17, 16).raw, 1u);  // a half and more
  EXPECT_EQ(fixed_literal(0x1p-17, 16).raw, 1u);    // a half goes up
  EXPECT_EQ(fixed_literal(0x1p-18, 16).raw, 0u);
  EXPECT_EQ(fixed_literal(-0x1p-17, 16).raw, 0u);
  EXPECT_EQ(spelling(integer_literal(0).number), "U(1,0)");
  EXPECT_EQ(spelling(integer_literal(255).number), "U(8,0)");
  EXPECT_EQ(spelling(integer_literal(-5).number), "S(4,0)");
}

}  // namespace
}  // namespace reference_tests
