// Noise, cells, turbulence and vectors.
#include <gtest/gtest.h>

#include "tests/pfman_lower/agreement.h"
#include "tests/pixelflow_model/seed.h"

namespace lower_tests {
namespace {

void try_library(const std::string& result, const std::vector<std::string>& expressions) {
  const std::uint64_t seed = pixelflow_tests::seed_or(1);
  const std::string parameters =
      "varying float p[3] = {0,0,0}, varying float q[3] = {0,0,0}, varying float f = 0, varying signed fixed<16,6> x = "
      "0, "
      "varying fixed<9,-3> y = 0, varying signed fixed<24,16> e[3] = {0,0,0}, uniform float c = 0, uniform int k_n = "
      "4, "
      "uniform fixed<10,3> d = 0";
  for (const std::string& expression : expressions) {
    for (std::uint64_t repeat = 0; repeat < 2; ++repeat) {
      EXPECT_TRUE(agrees(surface(result, parameters, {expression}), seed + repeat));
    }
  }
}

TEST(LowerLibrary, noise) {
  try_library("float", {"noise(f)", "noise(f, c)", "noise(p)", "noise({ f, p[1] })", "snoise(p)", "snoise(f)",
                        "noise(p * 4.0)", "noise({ f, 1, c })"});
  try_library("signed fixed<24,16>",
              {"noise(x)", "noise(x, y)", "noise(e)", "snoise(x)", "noise(x, d)", "noise(x + y)"});
}

TEST(LowerLibrary, cells) {
  try_library("fixed<8,8>",
              {"cellnoise(f)", "cellnoise(x)", "cellnoise(x, y)", "cellnoise(p)", "cellnoise(e)", "cellnoise(x, d)",
               "cellnoise(d, x)", "cellnoise(f, c)", "cellnoise(c, y)", "cellnoise({ f, c, 3 })"});
}

TEST(LowerLibrary, turbulence) {
  try_library("float", {"turbulence(p, 1)", "turbulence(p, k_n)", "turbulence(p * 3.0, 2)", "turbulence(p, k_n - 4)",
                        "turbulence({ f, c, 1 }, k_n - 2)", "turbulence(p, -3)"});
  EXPECT_EQ(
      compare(surface("float", "varying float p[3] = {0,0,0}, uniform int k_n = 17", {"turbulence(p, k_n)"}), 1).kind,
      Agreement::Kind::Refused);
}

TEST(LowerLibrary, vectors) {
  try_library("float",
              {"dot(p, q)", "length(p)", "distance(p, q)", "normalize(p)[1]", "cross(p, q)[2]", "reflect(p, q)[0]",
               "faceforward(p, q)[1]", "dot(normalize(p), q)", "bump(p, q, { 1, 0, c }, f, 0.5)[2]"});
  try_library("signed fixed<32,16>",
              {"dot(e, e)", "length(e)", "distance(e, { 0, x, 1 })", "cross(e, { x, 1, 2 })[0]"});
}

}  // namespace
}  // namespace lower_tests
