// Values of expressions, computed by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/reference/shaders.h"

namespace reference_tests {
namespace {

using namespace reference;

TEST(Conversions, fixed_to_fixed_floors_and_wraps) {
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<16,4> x = 300.75; result = x;"), 300u % 256);
  EXPECT_EQ(result_of("signed fixed<8,0>", "signed fixed<16,4> x = -1.25; result = x;"), static_cast<Raw>(-2));
  EXPECT_EQ(result_of("fixed<8,0>", "signed fixed<16,4> x = -1.25; result = x;"), 254u);
  EXPECT_EQ(result_of("fixed<8,4>", "fixed<4,0> x = 9; result = x;"), 144u);
}

TEST(Conversions, sat_limits) {
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<16,4> x = 300.75; result = sat fixed<8,0>(x);"), 255u);
  EXPECT_EQ(result_of("fixed<8,8>", "fixed<8,8> f = 0; result = sat fixed<8,8>(1.0 - f);"), 255u);
  EXPECT_EQ(result_of("fixed<8,8>", "fixed<8,8> f = 0; result = 1.0 - f;"), 0u);
  EXPECT_EQ(result_of("fixed<8,0>", "signed fixed<16,4> x = -1.25; result = sat fixed<8,0>(x);"), 0u);
  EXPECT_EQ(result_of("signed fixed<4,0>", "signed fixed<16,0> x = -100; result = sat signed fixed<4,0>(x);"),
            static_cast<Raw>(-8));
}

TEST(Conversions, float_to_fixed_floors_and_saturates_to_the_size) {
  EXPECT_EQ(value_of("fixed<8,8>", "1.0f"), 255u);
  EXPECT_EQ(value_of("fixed<8,8>", "0.999f"), 255u);
  EXPECT_EQ(value_of("fixed<8,8>", "0.5f"), 128u);
  EXPECT_EQ(value_of("fixed<8,8>", "-0.5f"), 0u);
  EXPECT_EQ(value_of("signed fixed<5,0>", "-1.5f"), static_cast<Raw>(-2));
  EXPECT_EQ(value_of("signed fixed<5,0>", "100.0f"), 15u);
  EXPECT_EQ(value_of("signed fixed<5,0>", "-100.0f"), static_cast<Raw>(-16));
  EXPECT_EQ(result_of("int", "float zero = 0; result = zero / zero;"), 0u);
  EXPECT_EQ(result_of("int", "float zero = 0; result = 1 / zero;"), 0x7FFFFFFFu);
  EXPECT_EQ(value_of("fixed<64,64>", "0.5f"), Raw{1} << 63);
  EXPECT_EQ(value_of("fixed<64,0>", "1e30f"), ~Raw{0});
}

TEST(Conversions, fixed_to_float_rounds_once_to_nearest_even) {
  EXPECT_EQ(float_result("fixed<25,0> x = 16777217; result = x;"), 16777216.0f);
  EXPECT_EQ(float_result("fixed<25,0> x = 16777219; result = x;"), 16777220.0f);
  EXPECT_EQ(float_result("signed fixed<25,24> x = -0.75; result = x;"), -0.75f);
  EXPECT_EQ(fixed_to_float(1, unsigned_fixed(1, 149)), 1u);
  EXPECT_EQ(fixed_to_float(1, unsigned_fixed(1, 150)), 0u);
  EXPECT_EQ(fixed_to_float(3, unsigned_fixed(2, 150)), 2u);
  EXPECT_EQ(fixed_to_float(~Raw{0}, unsigned_fixed(64, -64)), 0x7F800000u);
  EXPECT_EQ(as_float(fixed_to_float(~Raw{0}, signed_fixed(64, 0))), -1.0f);
}

TEST(Conversions, to_bool_compares_with_zero) {
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,4> x = 0.25; bool b = x; result = b;"), 1u);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> x = 2; bool b = x; result = b;"), 1u);
  EXPECT_THROW(value_of("bool", "1.5f"), Error);
}

TEST(FixedArithmetic, quotients_floor_and_zero_divisors_give_zero) {
  const std::string signed_pair = "signed fixed<8,0> a = -7, b = 2; ";
  EXPECT_EQ(result_of("signed fixed<8,0>", signed_pair + "result = a / b;"), static_cast<Raw>(-4));
  EXPECT_EQ(result_of("signed fixed<8,0>", signed_pair + "result = a % b;"), 1u);
  EXPECT_EQ(result_of("signed fixed<8,0>", signed_pair + "result = b / a;"), static_cast<Raw>(-1));
  EXPECT_EQ(result_of("signed fixed<8,0>", signed_pair + "result = b % a;"), static_cast<Raw>(-5));
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> z = 0, a = 5; result = a / z;"), 0u);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> z = 0, a = 5; result = a % z;"), 0u);
  EXPECT_EQ(result_of("fixed<8,8>", "fixed<8,0> a = 1, b = 3; result = a / b;"), 85u);
}

TEST(FixedArithmetic, comparison_is_exact_between_signs_and_exponents) {
  EXPECT_EQ(result_of("bool", "signed fixed<8,0> a = -1; fixed<8,0> b = 255; result = a < b;"), 1u);
  EXPECT_EQ(result_of("bool", "fixed<8,8> a = 0.5; fixed<8,1> b = 0.5; result = a == b;"), 1u);
  EXPECT_EQ(result_of("bool", "fixed<8,8> a = 0.5; fixed<8,0> b = 0; result = a <= b;"), 0u);
}

TEST(FixedArithmetic, shifts_by_constants_are_exact_and_by_variables_keep_the_size) {
  EXPECT_EQ(result_of("fixed<16,0>", "fixed<8,0> a = 200; result = a << 3;"), 1600u);
  EXPECT_EQ(result_of("fixed<16,8>", "fixed<8,0> a = 3; result = a >> 1;"), 384u);
  EXPECT_EQ(result_of("fixed<16,0>", "fixed<8,0> a = 200; uniform int n = 3; result = a << n;"), 1600u % 256);
  EXPECT_EQ(result_of("fixed<16,8>", "fixed<8,0> a = 3; uniform int n = 1; result = a >> n;"), 256u);
  EXPECT_EQ(result_of("signed fixed<8,0>", "signed fixed<8,0> a = -3; uniform int n = 64; result = a >> n;"),
            static_cast<Raw>(-1));
  EXPECT_THROW(result_of("fixed<8,0>", "fixed<8,0> a = 3; uniform int n = 65; result = a << n;"), Error);
}

TEST(FixedArithmetic, bits) {
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> a = 0xF0, b = 0x3C; result = a & b;"), 0x30u);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> a = 0xF0, b = 0x3C; result = a ^ b;"), 0xCCu);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> a = 0xF0; result = ~a;"), 0x0Fu);
  EXPECT_EQ(result_of("signed fixed<16,0>", "signed fixed<8,0> a = -1; fixed<8,0> b = 0x3C; result = a & b;"), 0x3Cu);
}

TEST(FloatArithmetic, single_precision_to_nearest_even) {
  EXPECT_EQ(float_result("float a = 16777216; result = a + 1;"), 16777216.0f);
  EXPECT_EQ(value_of("float", "1e-45"), 1u);
  EXPECT_EQ(result_of("float", "float a = 1e-45; result = a / 2;"), 0u);
  EXPECT_EQ(result_of("float", "float a = 0; result = a / a;"), 0x7FC00000u);
  EXPECT_EQ(result_of("float", "float a = 0; result = -a;"), 0x80000000u);
  EXPECT_EQ(result_of("float", "float a = 0; result = -(a / a);"), 0x7FC00000u);
}

TEST(FloatArithmetic, remainder_is_floored) {
  EXPECT_EQ(float_result("float a = -0.25; result = a % 1.0;"), 0.75f);
  EXPECT_EQ(float_result("float a = 5.5; result = a % -2.0;"), -0.5f);
  EXPECT_EQ(result_of("float", "float a = 5.5; float z = 0; result = a % z;"), 0x7FC00000u);
}

TEST(Literals, fold_in_doubles) {
  EXPECT_EQ(value_of("float", "1/3"), float_bits(1.0f / 3));
  EXPECT_EQ(value_of("float", "0.1 + 0.2"), float_bits(static_cast<float>(0.1 + 0.2)));
  EXPECT_EQ(value_of("fixed<8,0>", "7 % 4 + (1 << 3)"), 11u);
  EXPECT_EQ(value_of("fixed<8,0>", "-7 % 4"), 1u);
  EXPECT_EQ(value_of("fixed<8,4>", "7 / 2"), 56u);
  EXPECT_EQ(value_of("bool", "1 < 2 && !(3 == 4)"), 1u);
  EXPECT_THROW(value_of("float", "1 / 0"), Error);
}

TEST(Literals, take_the_type_of_their_surroundings) {
  EXPECT_EQ(result_of("float", "fixed<8,8> a = 0.5; result = a + 0.25;"), float_bits(0.75f));
  EXPECT_EQ(result_of("float", "fixed<8,8> a = 0.5; result = a + 0.25f;"), float_bits(0.75f));
  // A third is a fraction of 16 bits beside a fixed-point number, and a float beside a float.
  EXPECT_EQ(result_of("bool", "fixed<16,16> a = 0.33331298828125; result = 1.0/3 < a + 0.1f;"), 1u);
  EXPECT_EQ(result_of("fixed<20,20>", "fixed<8,8> a = 0; result = a + 1.0/3;"), 21845u * 16);
  EXPECT_EQ(result_of("fixed<20,20>", "result = 1.0/3;"), 349525u);
  EXPECT_EQ(result_of("fixed<8,8>", "bool b = true; result = b ? 0.25 : 0.5;"), 64u);
}

TEST(Assignments, compound_and_increments) {
  EXPECT_EQ(result_of("fixed<8,0>", "result = 250; result += 10;"), 4u);
  EXPECT_EQ(result_of("fixed<8,0>", "result = 5; result *= 0.5;"), 2u);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> x = 5; result = x++; result = result * 16 + x;"), 86u);
  EXPECT_EQ(float_result("float x = 0.5; x--; result = x;"), -0.5f);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<4,0> x; result = (x = 20) + 1;"), 5u);
}

TEST(Arrays, element_by_element_with_scalars_for_all) {
  const std::string arrays = "float a[3] = {1, 2, 3}; float b[3] = {0.5, 0.25, 2}; ";
  EXPECT_EQ(float_result(arrays + "float c[3] = a * b - 1; result = c[0] + 10*c[1] + 100*c[2];"), 494.5f);
  EXPECT_EQ(result_of("bool", arrays + "result = a == b;"), 0u);
  EXPECT_EQ(result_of("bool", arrays + "result = a != b;"), 1u);
  EXPECT_EQ(float_result("float m[2][2] = {{1, 2}, {3, 4}}; float row[2] = m[1]; result = row[0] + 10*m[0][1];"),
            23.0f);
  EXPECT_THROW(float_result(arrays + "uniform int i = 3; result = a[i];"), Error);
}

}  // namespace
}  // namespace reference_tests
