// Polygons of terrains: those of a fixed resolution, and those that a viewer's distance decides about.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "scanline/error.h"
#include "scanline/terrain/terrain_source.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/terrain/mesh_judge.h"
#include "tests/terrain/rasters.h"

namespace terrain_tests {
namespace {

using pixelflow_tests::replay;
using pixelflow_tests::seed_or;
using scanline::Elevation;
using scanline::Mesh;
using scanline::TerrainSource;
using scanline::TerrainSurface;
using scanline::Viewer;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TerrainSurface surface_of(Elevation elevation, double exaggeration = 1) {
  return {std::move(elevation), exaggeration, {}, {}};
}

Viewer eye(const glm::dvec3& position, double angle = 0.003) { return {true, position, angle, 0}; }

void cut_holes(Elevation& e, int count, std::mt19937_64& random) {
  for (int k = 0; k < count; ++k) {
    const int column = static_cast<int>(random() % static_cast<unsigned>(e.columns)),
              row = static_cast<int>(random() % static_cast<unsigned>(e.rows)), size = static_cast<int>(random() % 9);
    for (int j = row; j < std::min(row + size, e.rows); ++j) {
      for (int i = column; i < std::min(column + size, e.columns); ++i) {
        e.heights[static_cast<std::size_t>(j * e.columns + i)] = static_cast<float>(kNan);
      }
    }
  }
}

struct Size {
  int columns, rows;
};
class TerrainSizes : public testing::TestWithParam<Size> {};
INSTANTIATE_TEST_SUITE_P(Any, TerrainSizes,
                         testing::Values(Size{2, 2}, Size{2, 3}, Size{5, 2}, Size{9, 9}, Size{10, 9}, Size{33, 33},
                                         Size{34, 31}, Size{65, 64}, Size{100, 37}, Size{41, 150}, Size{200, 7},
                                         Size{129, 130}),
                         [](const auto& chosen) {
                           return std::to_string(chosen.param.columns) + "x" + std::to_string(chosen.param.rows);
                         });

TEST_P(TerrainSizes, NeitherCracksNorGaps) {
  const std::uint64_t seed = seed_or(2401);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto [columns, rows] = GetParam();
  for (int turn = 0; turn < 12; ++turn) {
    const TerrainSource source(
        surface_of(turn % 2 == 0 ? hills(columns, rows, random) : random_elevation(columns, rows, 200, random)),
        std::pow(10, unit(random)), "a");
    const Mesh mesh = source.mesh(eye({unit(random), 0.3 * unit(random), unit(random)}));
    const MeshJudge judge(mesh, source.surface());
    EXPECT_EQ(judge.fault(), "");
    EXPECT_EQ(judge.open_edges().size(), 0u);
    EXPECT_EQ(judge.area(), (columns - 1) * (rows - 1));
  }
}

TEST_P(TerrainSizes, DeviationsOnTheScreenStayWithinTheBound) {
  const std::uint64_t seed = seed_or(2402);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto [columns, rows] = GetParam();
  for (int turn = 0; turn < 8; ++turn) {
    const double detail = std::pow(10, unit(random));
    const TerrainSource source(surface_of(hills(columns, rows, random), 2), detail, "a");
    const Viewer viewer = eye({unit(random), 0.3 * unit(random), unit(random)});
    const Mesh mesh = source.mesh(viewer);
    const MeshJudge judge(mesh, source.surface());
    EXPECT_LE(judge.largest_deviation(viewer.position, viewer.pixel_angle), detail * (1 + 1e-9));

    const Viewer flat{false, {}, 0, 0.001};
    const Mesh seen = source.mesh(flat);
    EXPECT_LE(MeshJudge(seen, source.surface()).largest_deviation({}, 0), detail * 0.001 * (1 + 1e-9));
  }
}

TEST_P(TerrainSizes, HolesKeepTheirShape) {
  const std::uint64_t seed = seed_or(2403);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto [columns, rows] = GetParam();
  for (int turn = 0; turn < 8; ++turn) {
    Elevation elevation = hills(columns, rows, random);
    cut_holes(elevation, turn, random);
    elevation.heights.front() = 5;
    const TerrainSource source(surface_of(std::move(elevation)), 1 + unit(random), "a");
    const Mesh all = scanline::terrain_grid(source.surface(), 1, "a");
    const Mesh mesh = source.mesh(eye({unit(random), 0.3, unit(random)}));
    const MeshJudge full(all, source.surface()), judge(mesh, source.surface());
    EXPECT_EQ(judge.fault(), "");
    EXPECT_EQ(judge.area(), full.area());
    EXPECT_EQ(judge.open_edges(), full.open_edges());
  }
}

TEST(TerrainMesh, FullDetailIsTheFullGrid) {
  const std::uint64_t seed = seed_or(2404);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSource source(surface_of(random_elevation(37, 50, 300, random)), 1e-9, "a");
  const Mesh near = source.mesh(eye({0, 1, 0})), grid = scanline::terrain_grid(source.surface(), 1, "a");
  const auto triangles = [](const Mesh& mesh) {
    std::set<std::vector<std::array<double, 3>>> result;
    for (const auto& polygon : mesh.polygons) {
      std::vector<std::array<double, 3>> corners;
      for (const auto v : polygon) {
        const glm::dvec3& p = mesh.positions[v];
        corners.push_back({p.x, p.y, p.z});
      }
      std::sort(corners.begin(), corners.end());
      result.insert(corners);
    }
    return result;
  };
  EXPECT_EQ(grid.polygons.size(), 2u * 36 * 49);
  EXPECT_EQ(grid.positions.size(), 37u * 50);
  EXPECT_EQ(triangles(near), triangles(grid));
}

TEST(TerrainMesh, GridTakesEveryNthCellAndTheLast) {
  const std::uint64_t seed = seed_or(2405);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSurface surface = surface_of(random_elevation(12, 8, 300, random));
  const Mesh mesh = scanline::terrain_grid(surface, 5, "a");
  const MeshJudge judge(mesh, surface);
  EXPECT_EQ(judge.fault(), "");
  EXPECT_EQ(judge.open_edges().size(), 0u);
  std::set<int> columns, rows;
  for (const glm::ivec2& cell : judge.cells()) columns.insert(cell.x), rows.insert(cell.y);
  EXPECT_EQ(columns, (std::set<int>{0, 5, 10, 11}));
  EXPECT_EQ(rows, (std::set<int>{0, 5, 7}));
  EXPECT_EQ(scanline::terrain_grid(surface, 1000, "a").polygons.size(), 2u);
}

TEST(TerrainMesh, FinerNearTheViewerThanFarAway) {
  const std::uint64_t seed = seed_or(2406);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSource source(surface_of(hills(257, 257, random)), 1, "a");
  const Mesh mesh = source.mesh(eye({-0.5, 0.05, 0}, 0.02));
  int west = 0, east = 0;
  for (const auto& polygon : mesh.polygons) (mesh.positions[polygon[0]].x < 0 ? west : east) += 1;
  EXPECT_GT(west, 2 * east);
  // Twice as far, with pixels half as wide, and nearer: monotone.
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (double distance = 0.25; distance < 1000; distance *= 2) {
    const std::size_t polygons = source.mesh(eye({0, distance, 0})).polygons.size();
    EXPECT_LE(polygons, before);
    before = polygons;
  }
  EXPECT_EQ(before, 32u);
}

TEST(TerrainMesh, FlatGroundNeedsFewPolygons) {
  Elevation elevation{100, 60, {30, 30}, std::vector<float>(6000, 7)};
  const TerrainSource source(surface_of(std::move(elevation)), 0.01, "a");
  const Mesh mesh = source.mesh(eye({0, 0.01, 0}));
  // Squares of 8 cells: 13 to the east, 8 to the south.
  EXPECT_EQ(mesh.polygons.size(), 2u * 13 * 8);
  for (const glm::dvec3& p : mesh.positions) EXPECT_EQ(p.y, 0);
}

TEST(TerrainMesh, TheJudgeSeesACrack) {
  const std::uint64_t seed = seed_or(2407);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSource source(surface_of(hills(33, 33, random)), 1e-9, "a");
  Mesh mesh = source.mesh(eye({0, 1, 0}));
  // Two triangles with a common vertex and a straight side become one: their neighbours keep the vertex in the middle.
  const MeshJudge before(mesh, source.surface());
  ASSERT_EQ(before.open_edges().size(), 0u);
  const auto at = [&](int column, int row) {
    const auto found = std::find(before.cells().begin(), before.cells().end(), glm::ivec2(column, row));
    return static_cast<std::uint32_t>(found - before.cells().begin());
  };
  // Around (11, 10) the diagonals meet; the triangles below it are (10,10) (10,11)... by their own corners.
  std::vector<std::vector<std::uint32_t>> kept;
  const std::set<std::uint32_t> square{at(10, 10), at(11, 10), at(12, 10), at(11, 11)};
  for (const auto& polygon : mesh.polygons) {
    const bool within = std::all_of(polygon.begin(), polygon.end(), [&](auto v) { return square.contains(v); });
    if (!within) kept.push_back(polygon);
  }
  ASSERT_EQ(mesh.polygons.size() - kept.size(), 2u);
  kept.push_back({at(10, 10), at(11, 11), at(12, 10)});
  mesh.polygons = kept;
  const MeshJudge after(mesh, source.surface());
  EXPECT_EQ(after.fault(), "");
  EXPECT_EQ(after.area(), before.area());
  EXPECT_EQ(after.open_edges().size(), 3u);
}

TEST(TerrainMesh, StrangeViewersGetAMesh) {
  const std::uint64_t seed = seed_or(2408);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSource source(surface_of(hills(20, 30, random)), 1, "a");
  const double inf = std::numeric_limits<double>::infinity();
  for (const double x : {kNan, inf, -inf, 1e300, 0.0}) {
    for (const double angle : {kNan, inf, 0.0, -1.0, 1e-300}) {
      for (const bool perspective : {true, false}) {
        const Mesh mesh = source.mesh({perspective, {x, x, 0}, angle, angle});
        const MeshJudge judge(mesh, source.surface());
        EXPECT_EQ(judge.fault(), "");
        EXPECT_EQ(judge.open_edges().size(), 0u);
        EXPECT_EQ(judge.area(), 19 * 29);
      }
    }
  }
}

TEST(TerrainMesh, SameViewerSameMesh) {
  const std::uint64_t seed = seed_or(2409);
  SCOPED_TRACE(replay(seed));
  std::mt19937_64 random(seed);
  const TerrainSource source(surface_of(hills(100, 90, random)), 0.5, "a");
  const Mesh a = source.mesh(eye({0.1, 0.2, 0.3})), b = source.mesh(eye({0.1, 0.2, 0.3}));
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.polygons, b.polygons);
  for (std::size_t k = 0; k < a.attributes.size(); ++k) EXPECT_EQ(a.attributes[k].values, b.attributes[k].values);
}

TEST(TerrainMesh, TooManyPolygonsAreRefused) {
  Elevation elevation{1200, 900, {1, 1}, std::vector<float>(1'080'000, 1)};
  for (std::size_t k = 0; k < elevation.heights.size(); k += 2) elevation.heights[k] = 50;
  const TerrainSurface surface = surface_of(std::move(elevation));
  try {
    scanline::terrain_grid(surface, 1, "big.tif");
    FAIL();
  } catch (const scanline::UserError& e) {
    EXPECT_STREQ(e.what(), "big.tif: error: the terrain has more than 2097152 polygons at this resolution");
  }
  EXPECT_EQ(scanline::terrain_grid(surface, 2, "big.tif").polygons.size(), 2u * 600 * 450);
}

}  // namespace
}  // namespace terrain_tests
