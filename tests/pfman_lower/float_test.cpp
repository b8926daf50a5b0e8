// Floats: every operator on hard values, and mixed with fixed point.
#include <gtest/gtest.h>

#include "tests/pfman_lower/agreement.h"
#include "tests/pixelflow_model/seed.h"

namespace lower_tests {
namespace {

void try_floats(const std::vector<std::string>& expressions, std::uint64_t own_seed) {
  const std::uint64_t seed = pixelflow_tests::seed_or(own_seed);
  const std::string parameters =
      "varying float a = 0, varying float b = 0, uniform float c = 0, varying fixed<8,8> x = 0";
  for (std::size_t n = 0; n < expressions.size(); ++n) {
    for (std::uint64_t repeat = 0; repeat < 3; ++repeat) {
      EXPECT_TRUE(agrees(surface("float", parameters, {expressions[n], "a", expressions[n] + " + b"}), seed + repeat));
    }
  }
}

TEST(LowerFloat, arithmetic) {
  try_floats({"a + b", "a - b", "a * b", "a / b", "a + c", "c - a", "c * b", "c / a", "a * 2.0", "3 * a", "a * x",
              "a + x", "x / a", "a - 0.1"},
             1);
}

TEST(LowerFloat, signs) {
  try_floats({"-a", "-(a * b)", "abs(a)", "abs(-a)", "-abs(a)", "sign(a)", "-a + c", "+a"}, 2);
}

TEST(LowerFloat, whole_numbers) {
  try_floats({"floor(a)", "ceil(a)", "round(a)", "floor(a * 100.0)", "ceil(-a)", "round(a - b)", "a % b", "a % 1.0",
              "a % c", "c % a", "mod(a, 0.25)"},
             3);
}

TEST(LowerFloat, comparisons_and_choices) {
  try_floats({"float(a < b)", "float(a <= c)", "float(a == b)", "float(a != b)", "a < b ? a : b", "a != b ? a : c",
              "a >= c ? a : 1.0", "min(a, b)", "max(a, b)", "min(a, b, c)", "max(c, a)", "clamp(a, b, c)",
              "clamp(a, 0, 1)", "step(a, b)", "!(a < b) ? 1.0f : b", "a < b && b < c ? a : c", "a == a ? 1.0f : 2.0f"},
             4);
}

TEST(LowerFloat, library) {
  try_floats({"sqrt(a)", "inversesqrt(a)", "mix(a, b, c)", "mix(a, b, x)", "smoothstep(0.0, 1.0, a)",
              "smoothstep(a, b, c)", "radians(a)", "sin(a)", "fast_cos(b)", "pow(a, b)", "pow(2.0, a)", "atan2(a, b)",
              "exp(a)", "log2(a)", "sqrt(x)", "sin(x)"},
             5);
}

TEST(LowerFloat, conversions) {
  try_floats({"float(fixed<8,8>(a))", "float(int(a))", "float(signed fixed<5,2>(a))", "float(sat fixed<12,4>(a))",
              "float(fixed<64,64>(a))", "float(signed fixed<64,0>(a))", "float(fixed<7,-3>(a))", "float(bool(x))",
              "float(fixed<1,0>(x))", "x", "x * x", "float(fixed<3,70>(a))"},
             6);
}

}  // namespace
}  // namespace lower_tests
