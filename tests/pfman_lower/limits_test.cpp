// Fixed point where 64 bits are just enough: products, quotients and conversions of long numbers, far exponents.
#include <gtest/gtest.h>

#include "tests/pfman_lower/agreement.h"
#include "tests/pixelflow_model/seed.h"

namespace lower_tests {
namespace {

reference::Number long_fixed(Random& random, int first_exponent, int last_exponent) {
  const bool is_signed = between(random, 0, 1) == 1;
  return {false, is_signed, between(random, 0, 2) ? between(random, 57, 64) : between(random, 2, 64),
          between(random, first_exponent, last_exponent)};
}

void try_long(const std::vector<std::string>& expressions, int programs, int first_exponent, int last_exponent,
              int least_agreed, std::uint64_t own_seed) {
  const std::uint64_t seed = pixelflow_tests::seed_or(own_seed);
  int agreed = 0;
  for (int n = 0; n < programs && !::testing::Test::HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&] { return declared(long_fixed(random, first_exponent, last_exponent)); };
    const std::string result = type();
    const std::string parameters =
        "varying " + type() + " a = 0, varying " + type() + " b = 0, uniform " + type() + " c = 0";
    agreed += agrees(surface(result, parameters,
                             {one_of(random, expressions), one_of(random, expressions), one_of(random, expressions)}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, least_agreed);
}

TEST(LowerLimits, long_products) {
  try_long({"a * b", "a * a", "a * c", "a * b + c", "c - a * b"}, 500, 0, 70, 250, 1);
}

TEST(LowerLimits, long_quotients) { try_long({"a / b", "c / a", "b / c", "b / a"}, 700, 0, 70, 250, 2); }

TEST(LowerLimits, quotients_with_few_bits) {
  // Exponents so far apart that the quotient of the raw numbers is shifted right.
  const std::uint64_t seed = pixelflow_tests::seed_or(3);
  int agreed = 0;
  for (int n = 0; n < 500 && !HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&](int exponent) {
      reference::Number number = long_fixed(random, exponent, exponent);
      return declared(number);
    };
    const int high = between(random, 20, 64), low = between(random, 0, 8);
    const std::string parameters = "varying " + type(high) + " a = 0, varying " + type(low) + " b = 0";
    agreed += agrees(surface(type(between(random, 0, high - low)), parameters, {"a / b", "a / b", "a / a"}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 150);
}

TEST(LowerLimits, exponents_beyond_the_number) {
  try_long({"a + b", "a * b", "a / b", "-a", "abs(a)", "floor(a)", "ceil(a)", "round(b)", "a * c", "a - c", "a < b"},
           700, -64, 128, 150, 4);
  try_long({"a * b", "floor(a * b)", "a * c", "round(a)", "a"}, 300, -10, 10, 100, 5);
}

TEST(LowerLimits, conversions_of_long_numbers) {
  const std::uint64_t seed = pixelflow_tests::seed_or(6);
  int agreed = 0;
  for (int n = 0; n < 600 && !HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&] { return declared(long_fixed(random, -64, 128)); };
    const std::string to = type();
    if (to == "fixed<1,0>") continue;  // bool: a float does not convert to it
    const std::string parameters = "varying " + type() + " a = 0, varying float f = 0, uniform " + type() + " c = 0";
    const std::vector<std::string> all{to + "(a)", "sat " + to + "(a)", to + "(f)", "sat " + to + "(f)", to + "(c)"};
    agreed += agrees(surface(to, parameters, {one_of(random, all), one_of(random, all), one_of(random, all)}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 500);
}

TEST(LowerLimits, long_numbers_become_floats) {
  const std::uint64_t seed = pixelflow_tests::seed_or(7);
  int agreed = 0;
  for (int n = 0; n < 300 && !HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&] { return declared(long_fixed(random, -64, 128)); };
    const std::string parameters = "varying " + type() + " a = 0, varying " + declared(random_fixed(random, 32)) +
                                   " b = 0, varying " + declared(random_fixed(random, 32)) + " d = 0";
    agreed += agrees(surface("float", parameters, {"float(a)", "float(b * d)", "float(a) + b"}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 250);
}

TEST(LowerLimits, far_products_become_floats) {
  // Exponents that no single conversion has: overflow, subnormal results, and less than those.
  const std::uint64_t seed = pixelflow_tests::seed_or(8);
  int agreed = 0;
  for (int n = 0; n < 300 && !HasFailure(); ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    const auto type = [&](int first, int last) {
      const bool is_signed = between(random, 0, 1) == 1;
      return declared({false, is_signed, between(random, 2, 32), between(random, first, last)});
    };
    const bool small = between(random, 0, 1) == 1;
    const auto operand = [&] { return small ? type(60, between(random, 0, 1) ? 90 : 128) : type(-64, -20); };
    const std::string first = operand(), second = operand();
    const std::string parameters = "varying " + first + " a = 0, varying " + second + " b = 0";
    agreed += agrees(surface("float", parameters, {"float(a * b)", "-float(a * b)", "float(a)"}),
                     seed + static_cast<std::uint64_t>(n));
  }
  EXPECT_GE(agreed, 250);
}

}  // namespace
}  // namespace lower_tests
