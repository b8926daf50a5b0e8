// Figure 4: with four bytes a number, fixed point goes deeper into the Mandelbrot set than floating point.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shaders/mandelbrot_counts.h"

namespace shader_tests {
namespace {

/// Near the middle of a spiral of three arms.
MandelbrotView view(int depth, int pixels, int iterations) {
  return {-1696117.0 / (1 << 24), 16043907.0 / (1 << 24), std::ldexp(1.0, -depth), pixels, iterations};
}

TEST(Mandelbrot, WholeSetDiffersFromExactCountsAtItsRimAlone) {
  const MandelbrotView whole{-0.625, 0, 2.75, 64, 40};
  const std::vector<int> exact = exact_counts(whole);
  EXPECT_LT(compare(counted("mandelbrot_float", whole), exact).wrong, 10);
  EXPECT_LT(compare(counted("mandelbrot_fixed", whole), exact).wrong, 10);
}

TEST(Mandelbrot, FixedPointErrsLessThanFloatAtDepth) {
  const MandelbrotView deep = view(16, 64, 90);
  const std::vector<int> exact = exact_counts(deep);
  const CountErrors floats = compare(counted("mandelbrot_float", deep), exact);
  const CountErrors fixed = compare(counted("mandelbrot_fixed", deep), exact);
  EXPECT_GT(floats.wrong, 2 * fixed.wrong);
  EXPECT_GT(floats.mean_error, 2 * fixed.mean_error);
}

}  // namespace
}  // namespace shader_tests
