// Built-in shapes and Bezier patches: closed, facing outwards, with the polygons they promise.
#include "scanline/shapes.h"

#include <cmath>
#include <map>
#include <numbers>

#include "scanline/patches.h"
#include "scanline/polygon.h"
#include "scanline/text_reader.h"
#include "tests/scanline/checks.h"

namespace scanline_tests {
namespace {

using scanline::Mesh;
using Sizes = std::map<std::size_t, int>;

struct Case {
  std::string name;
  Mesh mesh;
  Sizes polygons;
  double volume, tolerance;
};

std::vector<Case> solids() {
  using std::numbers::pi;
  const std::vector<scanline::Box> two{{{0, 0, 0}, {1, 2, 3}, {1, 1}}, {{0, 1.5, 0}, {1, 1, 1}, {0.5, 0.5}}};
  const std::vector<glm::dvec2> arrow{{0, 0}, {2, -1}, {1, 0}, {2, 1}};
  std::vector<glm::dvec2> turned(arrow.rbegin(), arrow.rend());
  return {
      {"box", scanline::make_boxes(std::vector<scanline::Box>{{{5, 6, 7}, {1, 2, 3}, {1, 1}}}), {{4, 6}}, 6, 1e-12},
      {"two boxes", scanline::make_boxes(two), {{4, 12}}, 6 + (1 + 0.25 + 0.5) / 3, 1e-12},
      {"sphere", scanline::make_sphere(2, 64, 32), {{3, 128}, {4, 64 * 30}}, 4.0 / 3 * pi * 8, 0.2},
      {"cylinder", scanline::make_cone(1, 1, 2, 64), {{4, 64}, {64, 2}}, 2 * pi, 0.02},
      {"cone", scanline::make_cone(1, 0, 3, 64), {{3, 64}, {64, 1}}, pi, 0.02},
      {"cone upside down", scanline::make_cone(0, 1, 3, 64), {{3, 64}, {64, 1}}, pi, 0.02},
      {"tube", scanline::make_tube(1, 0.5, 2, 64), {{4, 256}}, 1.5 * pi, 0.02},
      {"torus", scanline::make_torus(2, 0.5, 64, 32), {{4, 64 * 32}}, pi * pi, 0.1},
      {"prism", scanline::make_prism(arrow, 2), {{4, 6}}, 2, 1e-12},
      {"prism given clockwise", scanline::make_prism(turned, 2), {{4, 6}}, 2, 1e-12},
  };
}

TEST(Shapes, SolidsAreClosedAndFaceOutwards) {
  for (const Case& c : solids()) {
    SCOPED_TRACE(c.name);
    EXPECT_TRUE(open_edges(c.mesh.polygons).empty());
    EXPECT_EQ(sizes(c.mesh.polygons), c.polygons);
    EXPECT_NEAR(volume(c.mesh), c.volume, c.tolerance);
  }
}

TEST(Shapes, PolygonsArePlanarAndSimple) {
  for (const Case& c : solids()) {
    SCOPED_TRACE(c.name);
    for (const auto& polygon : c.mesh.polygons) {
      std::vector<glm::dvec3> points;
      for (const std::uint32_t v : polygon) points.push_back(c.mesh.positions[v]);
      EXPECT_LT(scanline::unevenness(points), 1e-12);
      EXPECT_FALSE(scanline::crosses_itself(points));
    }
  }
}

TEST(Shapes, NormalsAtCornersAgreeWithThePolygon) {
  for (const Case& c : solids()) {
    SCOPED_TRACE(c.name);
    if (c.mesh.attributes.empty()) continue;
    ASSERT_EQ(c.mesh.attributes[0].name, "normal");
    const auto first = scanline::first_corners(c.mesh.polygons);
    ASSERT_EQ(c.mesh.attributes[0].values.size(), 3 * std::size_t{first.back()});
    for (std::size_t p = 0; p < c.mesh.polygons.size(); ++p) {
      std::vector<glm::dvec3> points;
      for (const std::uint32_t v : c.mesh.polygons[p]) points.push_back(c.mesh.positions[v]);
      const glm::dvec3 face = glm::normalize(scanline::newell_vector(points));
      for (std::uint32_t k = first[p]; k < first[p + 1]; ++k) {
        const double* n = &c.mesh.attributes[0].values[3 * std::size_t{k}];
        EXPECT_GT(glm::dot(face, glm::dvec3(n[0], n[1], n[2])), 0.9);
      }
    }
  }
}

TEST(Shapes, RoundShapesAreSymmetricToTheBit) {
  for (const int segments : {3, 4, 6, 8, 12, 20, 64, 100}) {
    for (const glm::dvec3& p : scanline::make_cone(1.7, 1.7, 1, segments).positions) {
      if (segments % 4 == 0) {
        EXPECT_TRUE(p.x == 0 || p.z == 0 || std::abs(p.x) > 1e-3);
      }
      EXPECT_NEAR(std::hypot(p.x, p.z), 1.7, 1e-15 * 4);
    }
  }
}

TEST(Shapes, PlaneFacesUp) {
  const Mesh mesh = scanline::make_plane({4, 2}, {3, 5});
  EXPECT_EQ(sizes(mesh.polygons), (Sizes{{4, 15}}));
  EXPECT_EQ(mesh.positions.size(), 24u);
  EXPECT_EQ(open_edges(mesh.polygons).size(), 16u);
  for (const auto& polygon : mesh.polygons) {
    std::vector<glm::dvec3> points;
    for (const std::uint32_t v : polygon) points.push_back(mesh.positions[v]);
    EXPECT_GT(scanline::newell_vector(points).y, 0);
  }
}

scanline::PatchSet teapot() {
  const auto path = scenes_folder() / "teapot" / "teapot.patches";
  return scanline::read_patches(scanline::read_text_file(path), path.string());
}

TEST(Patches, TeapotHasTheRightCountsAtEveryLevel) {
  const scanline::PatchSet set = teapot();
  ASSERT_EQ(set.patches.size(), 32u);
  for (int level = 2; level <= 12; ++level) {
    SCOPED_TRACE(level);
    const Mesh mesh = scanline::tessellate(set, level);
    Sizes count = sizes(mesh.polygons);
    // Eight patches end in a pole (knob and bottom); a quad out of its plane counts as its two triangles.
    const int cells = count[4] + (count[3] - 8 * level) / 2 + 8 * level;
    EXPECT_EQ(cells, 32 * level * level);
    EXPECT_EQ(count.size(), 2u) << "triangles and quads only";
    if (level >= 8) {
      EXPECT_EQ(count[3], 8 * level);
    }
  }
}

TEST(Patches, TeapotIsOpenOnlyWhereItIs) {
  // Borders that no other patch shares: the rim's inner edge (4 curves), the lid's edge (4), the two ends of the handle
  // (2 each), of the spout (2 each). Everywhere else neighbours have the same vertices to the bit.
  for (const int level : {2, 3, 5, 8, 13}) {
    const Mesh mesh = scanline::tessellate(teapot(), level);
    EXPECT_EQ(open_edges(mesh.polygons).size(), 16u * level) << "level " << level;
  }
}

TEST(Patches, NormalsPointOutOfTheSurface) {
  const Mesh mesh = scanline::tessellate(teapot(), 6);
  const auto first = scanline::first_corners(mesh.polygons);
  ASSERT_EQ(mesh.attributes[0].name, "normal");
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    std::vector<glm::dvec3> points;
    for (const std::uint32_t v : mesh.polygons[p]) points.push_back(mesh.positions[v]);
    const glm::dvec3 face = glm::normalize(scanline::newell_vector(points));
    for (std::uint32_t k = first[p]; k < first[p + 1]; ++k) {
      const double* n = &mesh.attributes[0].values[3 * std::size_t{k}];
      EXPECT_NEAR(glm::length(glm::dvec3(n[0], n[1], n[2])), 1, 1e-9);
      EXPECT_GT(glm::dot(face, glm::dvec3(n[0], n[1], n[2])), 0.2) << "polygon " << p;
    }
  }
}

TEST(Patches, MistakesNameFileAndLine) {
  const auto read = [](const std::string& text) { return mistake([&] { scanline::read_patches(text, "a.patches"); }); };
  const std::string patch = "b 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n";
  EXPECT_EQ(read(""), "a.patches:1: error: a patch file begins with 'vsgpatches 1'");
  EXPECT_EQ(read("vsgpatches 2\n"), "a.patches:1: error: '2' is not a whole number from 1 to 1");
  EXPECT_EQ(read("vsgpatches 1\n"), "a.patches: error: no patch in this file");
  EXPECT_EQ(read("vsgpatches 1\nv 1 2\n"), "a.patches:2: error: a control point has three coordinates");
  EXPECT_EQ(read("vsgpatches 1\n\nv 1 2 nan\n"), "a.patches:3: error: 'nan' is not a finite number");
  EXPECT_EQ(read("vsgpatches 1\n" + patch), "a.patches:2: error: a patch stands before the first control point");
  EXPECT_EQ(read("vsgpatches 1\nv 1 2 3\nb 1 2\n"), "a.patches:3: error: a patch has sixteen control points");
  EXPECT_EQ(read("vsgpatches 1\nv 1 2 3\nb 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 2\n"),
            "a.patches:3: error: '2' is not a whole number from 1 to 1");
  EXPECT_EQ(read("vsgpatches 1\nq\n"), "a.patches:2: error: unknown record 'q' (known: v, b)");
  EXPECT_EQ(read("vsgpatches 1\nv 1 2 3\n" + patch), "");
}

TEST(Polygon, CrossingEdgesAreFound) {
  using Points = std::vector<glm::dvec3>;
  EXPECT_TRUE(scanline::crosses_itself(Points{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {2, 1, 0}}));
  EXPECT_FALSE(scanline::crosses_itself(Points{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
  EXPECT_FALSE(scanline::crosses_itself(Points{{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}})) << "not convex";
  Points pentagram;
  for (int k = 0; k < 5; ++k) {
    const double angle = 4 * std::numbers::pi * k / 5;
    pentagram.emplace_back(1, std::cos(angle), std::sin(angle));
  }
  EXPECT_TRUE(scanline::crosses_itself(pentagram)) << "always turns left, but twice around";
  // A square with a square hole, joined by a bridge that is passed twice.
  const Points bridged{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                       {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_FALSE(scanline::crosses_itself(bridged));
}

TEST(Polygon, BowTiesCrossThoughTheirHalvesCancel) {
  using Points = std::vector<glm::dvec3>;
  EXPECT_TRUE(scanline::crosses_itself(Points{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0.3}}));
  // The flat one, in planes of all directions: among them some in which its box is thin along the wrong axis.
  const Points flat{{-9, -1, 0}, {9, 1, 0}, {9, -1, 0}, {-9, 1, 0}};
  for (int turn = 0; turn < 360; turn += 15) {
    for (int tilt = 0; tilt < 360; tilt += 15) {
      const double a = turn * std::numbers::pi / 180, b = tilt * std::numbers::pi / 180;
      const glm::dvec3 across(std::cos(a), 0, std::sin(a));
      const glm::dvec3 up(-std::sin(a) * std::sin(b), std::cos(b), std::cos(a) * std::sin(b));
      Points bow_tie, line;
      for (const glm::dvec3& p : flat) {
        bow_tie.push_back(across * p.x + up * p.y);
        line.push_back(across * p.x * 0.1 + up * p.x * 0.7);
      }
      EXPECT_TRUE(scanline::crosses_itself(bow_tie)) << turn << ' ' << tilt;
      EXPECT_EQ(scanline::unevenness(bow_tie), 0) << turn << ' ' << tilt;
      EXPECT_FALSE(scanline::crosses_itself(line)) << turn << ' ' << tilt;
    }
  }
}

TEST(Polygon, BowTiesStayInAMesh) {
  const std::vector<std::vector<glm::dvec3>> polygons{{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}},
                                                      {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}};
  scanline::MeshBuilder builder;
  for (const auto& points : polygons) {
    std::vector<std::uint32_t> polygon;
    for (const glm::dvec3& p : points) polygon.push_back(builder.vertex(p));
    builder.polygon(polygon);
  }
  EXPECT_EQ(builder.take().polygons, (scanline::PolygonList{{0, 1, 2, 3}})) << "the line is dropped";
}

TEST(Polygon, AreaAndUnevenness) {
  using Points = std::vector<glm::dvec3>;
  const glm::dvec3 n = scanline::newell_vector(Points{{1, 1, 5}, {3, 1, 5}, {3, 4, 5}, {1, 4, 5}});
  EXPECT_EQ(n, glm::dvec3(0, 0, 12));
  EXPECT_FALSE(scanline::has_area(Points{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}));
  EXPECT_FALSE(scanline::has_area(Points{{0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}, {0.7, 1.4, 2.1}})) << "up to rounding";
  EXPECT_TRUE(scanline::has_area(Points{{0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}}));
  EXPECT_NEAR(scanline::unevenness(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}}), 0.05 / std::sqrt(2), 0.01);
  EXPECT_EQ(scanline::unevenness(Points{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}), 0);
}

}  // namespace
}  // namespace scanline_tests
