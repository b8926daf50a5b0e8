// The library, written out.
#include <gtest/gtest.h>

#include "tests/pfman_check/checked.h"

namespace {

/// The value assigned to a float by the expression; a, b, c are floats, v, w vectors, p and q fixed<8,4> and vectors of
/// them.
std::string written(const std::string& expression) {
  const pfman_tests::Checked unit(
      pfman_tests::surface("float a = 1, b = 2, c = 3, v[3] = { 1, 2, 3 }, w[3] = { 4, 5, 6 }; fixed<8,4> p = 1, q[2] "
                           "= { 1, 2 };\nfloat r = " +
                           expression + ";"));
  const auto& body = unit.shader("s").body;
  return pfman_tests::formula(*body.back()->expression->operands.at(1));
}

TEST(pfman_check, library_orders) {
  EXPECT_EQ(written("min(a, b)"), "((b < a) ? b : a)");
  EXPECT_EQ(written("max(a, b)"), "((a < b) ? b : a)");
  EXPECT_EQ(written("min(a, b, c)"), "(v1 = ((b < a) ? b : a), ((c < v1) ? c : v1))");
  EXPECT_EQ(written("clamp(a * b, 0, 1)"), "(v1 = (a * b), v2 = ((v1 < 0) ? 0 : v1), ((1 < v2) ? 1 : v2))");
  EXPECT_EQ(written("step(a, b)"), "((b < a) ? 0 : 1)");
  EXPECT_EQ(written("sign(a)"), "((a < 0) ? -1 : ((0 < a) ? 1 : 0))");
  EXPECT_EQ(written("max(v, 0)[1]"), "((v[1] < 0) ? 0 : v[1])");
}

TEST(pfman_check, library_blends) {
  EXPECT_EQ(written("mix(a, b, c)"), "((a * (1 - c)) + (b * c))");
  EXPECT_EQ(written("smoothstep(a, b, c)"),
            "(v1 = ((c - a) / (b - a)), v2 = ((v1 < 0) ? 0 : v1), v3 = ((1 < v2) ? 1 : v2), ((v3 * v3) * (3 - (2 * "
            "v3))))");
  EXPECT_EQ(written("mod(a, b)"), "(a % b)");
  EXPECT_EQ(written("radians(a)"), "(a * 0.0174533)");
  EXPECT_EQ(written("degrees(a)"), "(a * 57.2958)");
}

TEST(pfman_check, library_vectors) {
  EXPECT_EQ(written("dot(v, w)"), "(((v[0] * w[0]) + (v[1] * w[1])) + (v[2] * w[2]))");
  EXPECT_EQ(written("cross(v, w)[1]"), "((v[2] * w[0]) - (v[0] * w[2]))");
  EXPECT_EQ(written("length(q)"), "float(sqrt(((q[0] * q[0]) + (q[1] * q[1]))))");
  EXPECT_EQ(written("distance(v, w)"), "(v1 = (v - w), sqrt((((v1[0] * v1[0]) + (v1[1] * v1[1])) + (v1[2] * v1[2]))))");
  EXPECT_EQ(written("faceforward(v, w)[0]"),
            "(((((w[0] * v[0]) + (w[1] * v[1])) + (w[2] * v[2])) < 0) ? v[0] : -v[0])");
  EXPECT_EQ(written("reflect(v, w)[0]"),
            "(v1 = (2 * (((v[0] * w[0]) + (v[1] * w[1])) + (v[2] * w[2]))), (v[0] - (v1 * w[0])))");
  EXPECT_EQ(written("bump(v, w, v, a, b)[2]"),
            "(v1 = ((v - (a * w)) - (b * v)), v2 = sqrt((((v1[0] * v1[0]) + (v1[1] * v1[1])) + (v1[2] * v1[2]))), "
            "((v2 != 0) ? (v1[2] / v2) : 0))");
}

TEST(pfman_check, library_noise) {
  EXPECT_EQ(written("noise(a, p)"), "noise(a, float(p))");
  EXPECT_EQ(written("noise(q)"), "float(noise(signed fixed<16,8>(q[0]), signed fixed<16,8>(q[1])))");
  EXPECT_EQ(written("snoise(v)"), "((2 * noise(v[0], v[1], v[2])) - 1)");
  EXPECT_EQ(written("snoise(p)"), "float(signed fixed<17,16>(((2 * noise(signed fixed<16,8>(p))) - 1)))");
  EXPECT_EQ(written("cellnoise(a, p)"), "float(cellnoise(a, p))");
  EXPECT_EQ(written("turbulence(v, 3)"), "turbulence(v, 3)");
  EXPECT_EQ(written("texture4(7, a, p)[3]"), "float((v1 = texture4(7, a, float(p)), v1[3]))");
}

TEST(pfman_check, library_takes_the_matrix_by_rows) {
  const pfman_tests::Checked unit(
      pfman_tests::surface("uniform float m[4][4]; float v[3] = { 1, 2, 3 }; float r = transform_point(m, v)[1] + "
                           "transform_vector(m, v)[2];"));
  EXPECT_EQ(pfman_tests::formula(*unit.shader("s").body.back()->expression->operands.at(1)),
            "(((((m[1][0] * v[0]) + (m[1][1] * v[1])) + (m[1][2] * v[2])) + m[1][3]) + (((m[2][0] * v[0]) + (m[2][1] * "
            "v[1])) + (m[2][2] * v[2])))");
}

}  // namespace
