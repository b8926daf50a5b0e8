// Fixed point: every operator on many pairs of types.
#include <gtest/gtest.h>

#include "tests/pfman_lower/agreement.h"
#include "tests/pixelflow_model/seed.h"

namespace lower_tests {
namespace {

/// Runs expressions of a, b (varying) and c (uniform) of random types, the results in a random type.
void try_expressions(const std::vector<std::string>& expressions, int programs, int most_bits, int least_agreed,
                     std::uint64_t own_seed) {
  const std::uint64_t seed = pixelflow_tests::seed_or(own_seed);
  int agreed = 0;
  for (int n = 0; n < programs && !::testing::Test::HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&] { return declared(random_fixed(random, most_bits)); };
    const std::string result = type();
    const std::string parameters =
        "varying " + type() + " a = 0, varying " + type() + " b = 0, uniform " + type() + " c = 0";
    const std::vector<std::string> results{one_of(random, expressions), one_of(random, expressions),
                                           one_of(random, expressions)};
    if (agrees(surface(result, parameters, results), seed + static_cast<std::uint64_t>(n))) ++agreed;
  }
  EXPECT_GE(agreed, least_agreed);
}

TEST(LowerFixed, sums) {
  try_expressions({"a + b", "a - b", "a + c", "c - a", "-a", "a + 3", "1.75 - a", "-(a - b)", "+a"}, 250, 64, 150, 1);
}

TEST(LowerFixed, products) {
  try_expressions({"a * b", "a * c", "c * b", "a * 3", "a * 0.5", "a * -0.375", "a * 1048576"}, 250, 64, 150, 2);
}

TEST(LowerFixed, quotients) {
  try_expressions({"a / b", "a / c", "c / b", "a / 3", "1.0 / a", "a / 0.01", "-100 / b"}, 300, 64, 100, 3);
}

TEST(LowerFixed, remainders) {
  try_expressions({"a % b", "a % c", "c % b", "a % 3", "a % 0.25", "a % -7"}, 250, 40, 100, 4);
}

TEST(LowerFixed, expressions_of_small_numbers) {
  try_expressions({"a * b + c", "(a + b) * c", "a * b - b * c", "(a - b) * (a + b)", "a * b + a / c", "-(a * b)",
                   "(a * b) * c", "a / b + b / a", "(a + b) % c", "a * a * a", "(a << 3) + (b >> 2)", "a * b << 2"},
                  400, 16, 200, 5);
}

TEST(LowerFixed, shifts) {
  try_expressions({"a << 1", "a >> 1", "a << 7", "a >> 9", "(a << 3) * b", "a << k_n", "a >> k_n", "a << (k_n - 5)",
                   "a >> 64 - k_n"},
                  0, 64, 0, 6);
  const std::uint64_t seed = pixelflow_tests::seed_or(7);
  for (int count : {0, 1, 5, 8, 13, 31, 32, 63, 64}) {
    for (int n = 0; n < 12; ++n) {
      Random random(seed + static_cast<std::uint64_t>(100 * count + n));
      const std::string type = declared(random_fixed(random)), result = declared(random_fixed(random));
      const std::string parameters = "varying " + type + " a = 0, uniform int k_n = " + std::to_string(count);
      agrees(surface(result, parameters, {"a << k_n", "a >> k_n", "(a >> k_n) + a"}), seed + 1);
      const std::string by_literal = std::to_string(count);
      agrees(surface(result, parameters, {"a << " + by_literal, "a >> " + by_literal, "(a << 3) >> 5"}), seed + 2);
    }
  }
  const std::string far = surface("int", "varying int a = 0, uniform int k_n = 65", {"a << k_n"});
  EXPECT_EQ(compare(far, 1).kind, Agreement::Kind::Refused);
}

TEST(LowerFixed, bits) {
  const std::uint64_t seed = pixelflow_tests::seed_or(8);
  int agreed = 0;
  for (int n = 0; n < 120; ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    reference::Number p = random_fixed(random), q = random_fixed(random), r = random_fixed(random);
    q.exponent = r.exponent = p.exponent = between(random, -4, 16);
    const std::string parameters =
        "varying " + declared(p) + " a = 0, varying " + declared(q) + " b = 0, uniform " + declared(r) + " c = 0";
    const std::vector<std::string> all{"a & b", "a | b",    "a ^ b",       "~a",       "a & c",      "c | b",
                                       "a ^ c", "~(a & b)", "(a | b) ^ c", "(~a) + b", "(a & b) * b"};
    agreed += agrees(surface(declared(random_fixed(random)), parameters,
                             {one_of(random, all), one_of(random, all), one_of(random, all)}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 60);
}

TEST(LowerFixed, comparisons_and_choices) {
  try_expressions({"a < b", "a <= c", "c > b", "a == b", "a != c", "a >= b ? a : b", "a < c ? a + b : c",
                   "a < b && b < c", "a == b || a < 3", "!(a < b)", "a ? b : c", "(a != b) + (a < c)", "!a ? c : 2",
                   "a < b == b < a", "a != b ? 1 : 0"},
                  300, 31, 200, 9);
}

TEST(LowerFixed, library) {
  try_expressions({"abs(a)", "abs(a - b)", "floor(a)", "ceil(a)", "round(a)", "sqrt(a)", "sqrt(abs(b))", "min(a, b)",
                   "max(a, c)", "min(a, b, c)", "clamp(a, b, c)", "sign(a)", "step(a, b)", "mod(a, b)",
                   "mix(a, b, 0.25)", "floor(a) + ceil(b)", "round(a + b)", "max(a, 0.5)"},
                  400, 24, 250, 10);
  try_expressions({"abs(a)", "floor(a)", "ceil(a)", "round(a)", "sqrt(a)", "min(a, c)", "max(b, c)"}, 200, 64, 100, 11);
}

TEST(LowerFixed, conversions) {
  const std::uint64_t seed = pixelflow_tests::seed_or(12);
  int agreed = 0;
  for (int n = 0; n < 300; ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&] { return declared(random_fixed(random)); };
    const std::string to = type();
    if (to == "fixed<1,0>") continue;  // bool: a float does not convert to it
    const std::vector<std::string> all{to + "(a)",       "sat " + to + "(a)", "sat " + to + "(a + b)",
                                       to + "(f)",       "sat " + to + "(f)", to + "(a * b) + b",
                                       "bool(a)",        "bool(a + b)",       "sat " + to + "(a) - " + to + "(b)",
                                       to + "(float(a))"};
    const std::string parameters = "varying " + type() + " a = 0, varying " + type() + " b = 0, varying float f = 0";
    agreed += agrees(surface(type(), parameters, {one_of(random, all), one_of(random, all), one_of(random, all)}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 150);
}

}  // namespace
}  // namespace lower_tests
