// Heights as a surface: places, gradients, what corners carry; missing cells.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scanline/terrain/terrain_surface.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/terrain/rasters.h"

namespace terrain_tests {
namespace {

using scanline::Elevation;
using scanline::TerrainSurface;

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// h = 100 + 3 a cell to the east + 2 a cell to the south.
Elevation plane(int columns, int rows) {
  Elevation e{columns, rows, {30, 20}, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      e.heights.push_back(static_cast<float>(100 + 3 * column + 2 * row));
  }
  return e;
}

TEST(TerrainSurface, LongerSideIsOneAndTheLowestCellAtZero) {
  const TerrainSurface surface(plane(11, 7), 2, {}, {});
  EXPECT_EQ(surface.position({0, 0}), glm::dvec3(-0.5, 0, -0.2));
  EXPECT_EQ(surface.position({10, 0}).x, 0.5);
  EXPECT_NEAR(surface.position({10, 6}).y, 42 * 2 / 300.0, 1e-15);
  EXPECT_NEAR(surface.position({10, 6}).z, 0.2, 1e-15);
}

TEST(TerrainSurface, UnitAndBaseAsAsked) {
  const TerrainSurface surface(plane(11, 7), -1, 0.5, 100);
  EXPECT_EQ(surface.position({10, 0}), glm::dvec3(75, -15, -30));
  EXPECT_EQ(surface.height_scale(), -0.5);
}

TEST(TerrainSurface, CornersCarryNormalPlaceSlopesAndHeight) {
  const TerrainSurface surface(plane(11, 7), 2, {}, {});
  for (const scanline::TerrainCell cell : {scanline::TerrainCell{0, 0}, {5, 3}, {10, 6}, {0, 6}, {4, 0}}) {
    const auto v = surface.values(cell);
    // East 0.1, north -0.1, twice exaggerated.
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.2, 1, -0.2));
    EXPECT_NEAR(glm::length(glm::dvec3(v[0], v[1], v[2]) - normal), 0, 1e-12);
    EXPECT_NEAR(v[3], (cell.column + 0.5) / 11, 1e-15);
    EXPECT_NEAR(v[4], (6.5 - cell.row) / 7, 1e-15);
    EXPECT_NEAR(v[5], 0.2, 1e-12);
    EXPECT_NEAR(v[6], -0.2, 1e-12);
    EXPECT_EQ(v[7], 100 + 3 * cell.column + 2 * cell.row);
  }
}

TEST(TerrainSurface, NormalIsThatOfTheSurface) {
  const std::uint64_t seed = pixelflow_tests::seed_or(2411);
  SCOPED_TRACE(pixelflow_tests::replay(seed));
  std::mt19937_64 random(seed);
  // On a plane of any slope the triangles' own normals are those that the corners carry.
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int turn = 0; turn < 50; ++turn) {
    const double east = 100 * unit(random), south = 100 * unit(random);
    Elevation e{3, 3, {30, 20}, {}};
    for (int k = 0; k < 9; ++k) e.heights.push_back(static_cast<float>(east * (k % 3) + south * (k / 3)));
    const TerrainSurface surface(std::move(e), 1 + unit(random), {}, {});
    const glm::dvec3 a = surface.position({0, 0}), b = surface.position({0, 2}), c = surface.position({2, 0});
    const auto v = surface.values({1, 1});
    EXPECT_NEAR(glm::dot(glm::normalize(glm::cross(b - a, c - a)), glm::dvec3(v[0], v[1], v[2])), 1, 1e-9);
  }
}

TEST(TerrainSurface, SteepSlopesKeepAFiniteNormal) {
  Elevation e{2, 2, {1e-6, 1e-6}, {-3e38f, 3e38f, 3e38f, -3e38f}};
  const TerrainSurface surface(std::move(e), 1e6, {}, {});
  for (const int column : {0, 1}) {
    const auto v = surface.values({column, 0});
    EXPECT_NEAR(glm::length(glm::dvec3(v[0], v[1], v[2])), 1, 1e-12);
  }
}

TEST(TerrainGradient, HornsWeights) {
  Elevation e{3, 3, {10, 5}, {1, 2, 4, 8, 16, 32, 64, 128, 256}};
  const glm::dvec2 slope = scanline::gradient(e, 1, 1);
  EXPECT_DOUBLE_EQ(slope.x, ((4 + 2 * 32 + 256) - (1 + 2 * 8 + 64)) / 80.0);
  EXPECT_DOUBLE_EQ(slope.y, ((1 + 2 * 2 + 4) - (64 + 2 * 128 + 256)) / 40.0);
}

TEST(TerrainGradient, PlanesAreExactAtBordersAndBesideHoles) {
  Elevation e = plane(6, 5);
  for (const int hole : {14, 15, 21}) e.heights[static_cast<std::size_t>(hole)] = kMissing;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 6; ++column) {
      if (!e.known(column, row)) continue;
      const glm::dvec2 slope = scanline::gradient(e, column, row);
      EXPECT_NEAR(slope.x, 0.1, 1e-9) << column << ", " << row;
      EXPECT_NEAR(slope.y, -0.1, 1e-9) << column << ", " << row;
    }
  }
}

TEST(TerrainGradient, ALonelyCellIsLevel) {
  Elevation e{3, 3, {10, 10}, std::vector<float>(9, kMissing)};
  e.heights[4] = 77;
  EXPECT_EQ(scanline::gradient(e, 1, 1), glm::dvec2(0, 0));
}

TEST(TerrainFill, RingsTakeTheMeanOfWhatIsKnown) {
  Elevation e{5, 3, {10, 10}, {1, 2, 3, 4, 5, 6, 7, kMissing, kMissing, kMissing, 9, 8, 7, kMissing, kMissing}};
  scanline::fill_missing(e);
  EXPECT_FLOAT_EQ(e.at(2, 1), (2 + 3 + 4 + 7 + 8 + 7) / 6.0f);
  EXPECT_FLOAT_EQ(e.at(3, 1), (3 + 4 + 5 + 7) / 4.0f);
  EXPECT_FLOAT_EQ(e.at(4, 1), (4 + 5) / 2.0f);
  EXPECT_FLOAT_EQ(e.at(3, 2), 7);
  // The last ring: all of its neighbours were found before it.
  EXPECT_FLOAT_EQ(e.at(4, 2), (e.at(3, 1) + e.at(4, 1) + e.at(3, 2)) / 3);
}

TEST(TerrainFill, KnownCellsStayAndAllBecomeKnown) {
  const std::uint64_t seed = pixelflow_tests::seed_or(2412);
  SCOPED_TRACE(pixelflow_tests::replay(seed));
  std::mt19937_64 random(seed);
  Elevation e = random_elevation(40, 30, 100, random);
  for (float& height : e.heights) {
    if (random() % 4 != 0) height = kMissing;
  }
  const Elevation before = e;
  scanline::fill_missing(e);
  for (std::size_t k = 0; k < e.heights.size(); ++k) {
    if (std::isnan(before.heights[k])) {
      EXPECT_GE(e.heights[k], 0);
      EXPECT_LE(e.heights[k], 100);
    } else {
      EXPECT_EQ(e.heights[k], before.heights[k]);
    }
  }
  Elevation nothing{2, 2, {1, 1}, std::vector<float>(4, kMissing)};
  scanline::fill_missing(nothing);
  EXPECT_FALSE(nothing.known(0, 0));
}

}  // namespace
}  // namespace terrain_tests
