// The built-in library: published hash and noise values, and values by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/shaders.h"

namespace reference_tests {
namespace {

using namespace reference;

TEST(Library, cellnoise_is_the_hash_of_the_cell) {
  const auto cell = [](const std::string& arguments) { return value_of("fixed<8,8>", "cellnoise(" + arguments + ")"); };
  EXPECT_EQ(cell("{0.0, 0.0, 0.0}"), 0u);
  EXPECT_EQ(cell("1.5"), 17u);
  EXPECT_EQ(cell("0.2, 1.9"), 142u);
  EXPECT_EQ(cell("{0.0, 0.0, 1.0}"), 220u);
  EXPECT_EQ(cell("{1.0, 2.0, 3.0}"), 25u);
  EXPECT_EQ(cell("{-0.5, -1.0, -0.1}"), 5u);
  EXPECT_EQ(cell("{10, 20, 30}"), 100u);
  EXPECT_EQ(cell("{266, 276, -226}"), 100u);
}

TEST(Library, noise_has_the_published_values) {
  const auto noise = [](const std::string& point) { return float_result("result = noise(" + point + ");"); };
  EXPECT_FLOAT_EQ(noise("{0.5, 0.5, 0.5}"), 0.75f);
  EXPECT_NEAR(noise("{1.25, 2.5, 3.75}"), 0.5 + 0.094604492 / 2, 1e-6);
  EXPECT_NEAR(noise("{10.1, 20.2, 30.3}"), 0.5 + 0.191722086 / 2, 1e-6);
  EXPECT_NEAR(noise("{-0.3, 0.4, 7.9}"), 0.5 + 0.319813248 / 2, 1e-6);
  EXPECT_FLOAT_EQ(float_result("result = snoise({0.5, 0.5, 0.5});"), 0.5f);
  EXPECT_EQ(result_of("signed fixed<18,16>", "fixed<8,4> p[3] = {0.5, 0.5, 0.5}; result = snoise(p);"), 0x8000u);
  EXPECT_EQ(result_of("fixed<16,16>", "fixed<8,4> p[3] = {0.5, 0.5, 0.5}; result = noise(p);"), 0xC000u);
  EXPECT_EQ(float_result("result = turbulence({0.5, 0.5, 0.5}, 0);"), 0.0f);
  EXPECT_EQ(float_result("result = turbulence({0.5, 0.5, 0.5}, 1);"), 0.5f);
}

TEST(Library, integer_parts) {
  EXPECT_EQ(value_of("float", "floor(-0.0f)"), 0u);
  EXPECT_EQ(value_of("float", "ceil(-0.5f)"), 0u);
  EXPECT_EQ(float_result("result = ceil(1.25f) + 10*floor(-1.25f) + 100*round(2.5f);"), 2 - 20 + 300);
  EXPECT_EQ(result_of("signed fixed<8,0>", "signed fixed<8,4> x = -1.25; result = floor(x);"), static_cast<Raw>(-2));
  EXPECT_EQ(result_of("signed fixed<8,0>", "signed fixed<8,4> x = -1.25; result = ceil(x);"), static_cast<Raw>(-1));
  EXPECT_EQ(result_of("signed fixed<8,0>", "signed fixed<8,4> x = -1.5; result = round(x);"), static_cast<Raw>(-1));
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,8> x = 0.75; result = round(x);"), 1u);
}

TEST(Library, choices) {
  EXPECT_EQ(result_of("float", "float n = 0; n = n / n; result = min(1.0, n);"), float_bits(1));
  EXPECT_EQ(result_of("float", "float n = 0; n = n / n; result = min(n, 1.0);"), 0x7FC00000u);
  EXPECT_EQ(float_result("float x = 7; result = clamp(x, 0, 1) + max(x, 9, 8);"), 10.0f);
  EXPECT_EQ(result_of("fixed<8,4>", "fixed<8,4> x = 7.5; result = clamp(x, 0, 1.25);"), 20u);
  EXPECT_EQ(result_of("signed fixed<4,0>", "fixed<8,4> x = 7.5; signed fixed<4,0> y = -2; result = min(x, y);"),
            static_cast<Raw>(-2));
  EXPECT_EQ(float_result("float x = -0.0f; result = sign(x) + 10*sign(-2.5f);"), -10.0f);
  EXPECT_EQ(float_result("float x = 0.5; result = step(0.5, x) + 2*step(0.75, x);"), 1.0f);
  EXPECT_EQ(float_result("float x = 0.25; result = smoothstep(0, 1, x);"), 0.15625f);
  EXPECT_EQ(float_result("float x = 4; result = mix(x, 8, 0.25);"), 5.0f);
  EXPECT_EQ(result_of("fixed<8,4>", "fixed<8,4> x = 4, y = 8, t = 0.25; result = mix(x, y, t);"), 80u);
}

TEST(Library, geometry) {
  const std::string vectors = "float a[3] = {1, 2, 3}, b[3] = {3, -1, 2}; ";
  EXPECT_EQ(float_result(vectors + "result = dot(a, b);"), 7.0f);
  EXPECT_EQ(float_result(vectors + "float c[3] = cross(a, b); result = c[0] + 100*c[1] + 10000*c[2];"),
            7 + 700 - 70000);
  EXPECT_EQ(float_result("float a[2] = {3, 4}; result = length(a) + normalize(a)[0];"), 5 + 0.6f);
  EXPECT_EQ(float_result("float a[2] = {0, 0}; result = normalize(a)[0];"), 0.0f);
  EXPECT_EQ(result_of("fixed<8,0>", "signed fixed<8,0> a[2] = {3, -4}; result = length(a);"), 5u);
  EXPECT_EQ(result_of("fixed<8,0>", "fixed<8,0> a[2] = {3, 4}, b[2] = {6, 0}; result = distance(a, b);"), 5u);
  EXPECT_EQ(result_of("fixed<8,4>", "fixed<8,4> x = 2; result = sqrt(x);"), 22u);
  EXPECT_EQ(result_of("fixed<8,4>", "signed fixed<8,4> x = -2; result = sqrt(x);"), 0u);
  EXPECT_EQ(float_result(vectors + "float n[3] = {0, 0, 1}; result = faceforward(n, a)[2] + 10*reflect(a, n)[2];"),
            -1 - 30);
}

TEST(Library, functions_of_literals_take_floats) {
  EXPECT_EQ(float_result("result = cos(0);"), 1.0f);
  EXPECT_EQ(float_result("result = sqrt(2.25) + abs(-1);"), 2.5f);
  EXPECT_EQ(float_result("result = degrees(radians(180.0));"), 57.29578f * (180.0f * 0.017453292f));
}

}  // namespace
}  // namespace reference_tests
