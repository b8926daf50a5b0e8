// The Lambertian reflectance map on the pixel processors against the formula in double precision and gdaldem.
#include "tests/terrain/hillshade.h"

#include <gtest/gtest.h>

#include "scanline/terrain/elevation_file.h"

namespace terrain_tests {
namespace {

constexpr Sun kSuns[] = {{315, 45}, {135, 20}, {0, 90}, {200, 3}};

std::vector<glm::dvec2> project_gradients() {
  return interior_gradients(
      scanline::read_elevation_file(std::filesystem::path(VSG_SOURCE_DIR) / "scenes/terrain/jacksboro.tif"));
}

TEST(Hillshade, TheFormulaIsGdaldems) {
  const Heights heights = project_heights();
  for (const Sun& sun : kSuns) {
    const auto gdal = gdaldem_greys(heights, sun);
    if (!gdal) GTEST_SKIP() << "gdaldem is not installed";
    const GreyDifferences d = compare_greys(*gdal, expected_greys(heights, sun));
    EXPECT_EQ(d.compared, 401 * 342);
    // gdaldem computes in single precision: a value beside a rounding border may fall to either side.
    EXPECT_LE(d.by_one, d.compared / 10'000) << sun.azimuth;
    EXPECT_EQ(d.more, 0) << sun.azimuth;
  }
}

TEST(Hillshade, FloatShaderGivesItsGreyLevels) {
  const Heights heights = project_heights();
  const auto gradients = project_gradients();
  for (const Sun& sun : kSuns) {
    const GreyDifferences d =
        compare_greys(shader_greys("terrain_lambert_float", 0, gradients, sun).greys, expected_greys(heights, sun));
    EXPECT_EQ(d.compared, 401 * 342);
    EXPECT_LE(d.by_one, d.compared / 10'000) << sun.azimuth;
    EXPECT_EQ(d.more, 0) << sun.azimuth;
  }
}

TEST(Hillshade, FixedShaderIsWithinOneLevel) {
  const Heights heights = project_heights();
  const auto gradients = project_gradients();
  for (const Sun& sun : kSuns) {
    const GreyDifferences d =
        compare_greys(shader_greys("terrain_lambert", 0, gradients, sun).greys, expected_greys(heights, sun));
    EXPECT_LE(d.by_one, d.compared / 20) << sun.azimuth;
    EXPECT_EQ(d.more, 0) << sun.azimuth;
  }
}

TEST(Hillshade, MoreBitsComeCloser) {
  const Heights heights = project_heights();
  const auto gradients = project_gradients();
  const std::vector<int> expected = expected_greys(heights, {});
  int before = static_cast<int>(expected.size());
  for (const int fraction : {8, 12, 16, 20}) {
    const GreyDifferences d = compare_greys(shader_greys("terrain_lambert", fraction, gradients, {}).greys, expected);
    EXPECT_LT(d.by_one + d.more, before) << fraction;
    before = d.by_one + d.more;
  }
}

TEST(Hillshade, AWrongSlopeIsSeen) {
  const Heights heights = project_heights();
  std::vector<glm::dvec2> gradients = project_gradients();
  for (glm::dvec2& slope : gradients) slope.y = -slope.y;
  const GreyDifferences d =
      compare_greys(shader_greys("terrain_lambert_float", 0, gradients, {}).greys, expected_greys(heights, {}));
  EXPECT_GT(d.more, d.compared / 2);
}

}  // namespace
}  // namespace terrain_tests
