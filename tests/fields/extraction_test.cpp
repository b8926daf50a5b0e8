// Polygons of fields: closed, outside in front, where the solid is, and as far from it as is said.
#include "scanline/fields/extraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "scanline/error.h"
#include "scanline/fields/field_error.h"
#include "scanline/fields/mesh_field.h"
#include "scanline/fields/operations.h"
#include "scanline/polygon.h"
#include "scanline/shapes.h"
#include "tests/fields/random_field.h"

namespace fields_tests {
namespace {

namespace fields = scanline::fields;
using scanline::Field;
using scanline::FieldPointer;
using scanline::Mesh;

constexpr double kPi = std::numbers::pi;

std::vector<glm::dvec3> points_of(const Mesh& mesh, std::size_t polygon) {
  std::vector<glm::dvec3> points;
  for (const std::uint32_t v : mesh.polygons[polygon]) points.push_back(mesh.positions[v]);
  return points;
}

/// What keeps a mesh from being a closed surface of planar polygons; empty when nothing does.
std::string fault(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> used;
  std::size_t corners = 0;
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    const auto& polygon = mesh.polygons[p];
    const std::string name = "polygon " + std::to_string(p);
    if (std::set<std::uint32_t>(polygon.begin(), polygon.end()).size() != polygon.size()) return name + " meets itself";
    for (std::size_t k = 0; k < polygon.size(); ++k) ++edges[{polygon[k], polygon[(k + 1) % polygon.size()]}];
    used.insert(polygon.begin(), polygon.end());
    corners += polygon.size();
    const auto points = points_of(mesh, p);
    if (!scanline::has_area(points)) return name + " has no area";
    if (scanline::crosses_itself(points)) return name + " crosses itself";
    if (scanline::unevenness(points) > scanline::kPlanarTolerance) return name + " is not planar";
  }
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (count != 1 || other == edges.end() || other->second != 1) return "an edge has not two polygons";
  }
  if (used.size() != mesh.positions.size()) return "a vertex belongs to no polygon";
  if (mesh.attributes.size() != 1 || mesh.attributes[0].name != "normal") return "no normals";
  if (mesh.attributes[0].values.size() != 3 * corners) return "not a normal for each corner";
  return {};
}

long euler(const Mesh& mesh) {
  std::size_t corners = 0;
  for (const auto& polygon : mesh.polygons) corners += polygon.size();
  return static_cast<long>(mesh.positions.size() + mesh.polygons.size()) - static_cast<long>(corners / 2);
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    const auto points = points_of(mesh, p);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      sum += glm::dot(points[0], glm::cross(points[k], points[k + 1])) / 6;
    }
  }
  return sum;
}

FieldPointer drilled_cube() {
  const FieldPointer hole = fields::frustum(0.3, 0.3, 2);
  return fields::subtract({fields::box(glm::dvec3(1)), hole, fields::place(hole, {{}, {90, 0, 0}, 1})});
}

struct Known {
  const char* name;
  FieldPointer field;
  long euler;
  double volume;
};

std::vector<Known> known_solids() {
  const FieldPointer ball = fields::sphere(1), post = fields::frustum(1, 1, 3);
  return {{"sphere", ball, 2, 4 * kPi / 3},
          {"torus", fields::torus(1, 0.3), 0, 2 * kPi * kPi * 0.09},
          {"cylinder", fields::frustum(1, 1, 2), 2, 2 * kPi},
          {"cone", fields::frustum(1, 0, 2), 2, 2 * kPi / 3},
          {"ellipsoid", fields::ellipsoid({1, 0.5, 0.25}), 2, kPi / 6},
          {"rounded rod", fields::triangle({glm::dvec3(0), {0.5, 0, 0}, {1, 0, 0}}, 0.2), 2,
           kPi * 0.04 + 4 * kPi / 3 * 0.008},
          {"two cylinders in common", fields::intersect({post, fields::place(post, {{}, {90, 0, 0}, 1})}), 2, 16.0 / 3},
          {"half a ball", fields::intersect({fields::plane({1, 2, 3}), ball}), 2, 2 * kPi / 3},
          {"spheres in rows", fields::repeat(fields::sphere(0.4), {1, 0, 1}, {3, 0, 2}), 12, 6 * 4 * kPi / 3 * 0.064},
          {"two holes", drilled_cube(), -4, 1 - 2 * kPi * 0.09 + 16 * 0.027 / 3}};
}

TEST(FieldsExtraction, KnownSolids) {
  for (const Known& solid : known_solids()) {
    for (const int cells : {31, 64}) {
      const Mesh mesh = scanline::extract_surface(*solid.field, cells);
      EXPECT_EQ(fault(mesh), "") << solid.name << " of " << cells;
      EXPECT_EQ(euler(mesh), solid.euler) << solid.name << " of " << cells;
      EXPECT_NEAR(volume(mesh) / solid.volume, 1, cells == 64 ? 0.005 : 0.02) << solid.name << " of " << cells;
    }
  }
}

TEST(FieldsExtraction, FlatSolidsHaveTheirOwnPolygons) {
  const glm::dvec3 size(2, 1, 0.5);
  for (const int cells : {2, 7, 16, 32}) {
    const Mesh mesh = scanline::extract_surface(*fields::box(size), cells);
    EXPECT_EQ(fault(mesh), "");
    EXPECT_EQ(mesh.polygons.size(), 6u);
    ASSERT_EQ(mesh.positions.size(), 8u);
    for (const glm::dvec3& p : mesh.positions) {
      EXPECT_LT(glm::length(glm::abs(p) - size / 2.0), 1e-12);
    }
  }
  const Mesh turned = scanline::extract_surface(*fields::place(fields::box(size), {{1, 2, 3}, {10, 20, 30}, 1}), 32);
  EXPECT_EQ(fault(turned), "");
  EXPECT_EQ(turned.polygons.size(), 6u);
  EXPECT_EQ(turned.positions.size(), 8u);
  // Two boxes that overlap in a corner: twelve faces, three of each cut to an L.
  const FieldPointer box = fields::box(glm::dvec3(1));
  const Mesh both = scanline::extract_surface(*fields::join({box, fields::place(box, {{0.5, 0.5, 0.5}, {}, 1})}), 32);
  EXPECT_EQ(fault(both), "");
  EXPECT_EQ(both.polygons.size(), 12u);
  EXPECT_NEAR(volume(both), 1.875, 1e-9);
}

TEST(FieldsExtraction, CapsOfACylinderAreOnePolygonEach) {
  const Mesh mesh = scanline::extract_surface(*fields::frustum(1, 1, 2), 32);
  int caps = 0;
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    const auto points = points_of(mesh, p);
    if (points.size() < 30) continue;
    ++caps;
    for (const glm::dvec3& q : points) EXPECT_NEAR(std::abs(q.y), 1, 1e-12);
  }
  EXPECT_EQ(caps, 2);
}

TEST(FieldsExtraction, NormalsAreTheFieldsOnEachSideOfAnEdge) {
  const Mesh box = scanline::extract_surface(*fields::box({2, 1, 0.5}), 16);
  std::size_t corner = 0;
  for (std::size_t p = 0; p < box.polygons.size(); ++p) {
    const glm::dvec3 normal = glm::normalize(scanline::newell_vector(points_of(box, p)));
    for (std::size_t k = 0; k < box.polygons[p].size(); ++k, ++corner) {
      const double* n = &box.attributes[0].values[3 * corner];
      EXPECT_GT(glm::dot(normal, glm::dvec3(n[0], n[1], n[2])), 1 - 1e-12);
    }
  }
  const Mesh ball = scanline::extract_surface(*fields::sphere(1), 16);
  corner = 0;
  for (const auto& polygon : ball.polygons) {
    for (const std::uint32_t v : polygon) {
      const double* n = &ball.attributes[0].values[3 * corner++];
      EXPECT_GT(glm::dot(glm::normalize(ball.positions[v]), glm::dvec3(n[0], n[1], n[2])), 1 - 1e-12);
    }
  }
}

TEST(FieldsExtraction, ErrorFallsWithTheSquareOfTheCells) {
  for (const FieldPointer& field : {fields::sphere(1), fields::torus(1, 0.4), fields::ellipsoid({1, 0.7, 0.5})}) {
    double before = 0;
    for (const int cells : {16, 32, 64}) {
      const scanline::FieldError error = scanline::measure(*field, scanline::extract_surface(*field, cells));
      EXPECT_GT(error.largest, error.mean);
      if (before > 0) {
        EXPECT_LT(error.worst(), 0.4 * before) << cells;
      }
      before = error.worst();
    }
  }
}

TEST(FieldsExtraction, RandomFieldsGiveClosedSurfaces) {
  const std::uint64_t seed = seed_or(31);
  int found = 0;
  for (std::uint64_t k = 0; k < 80; ++k) {
    Random random(seed + k);
    const RandomField f = random_field(random, static_cast<int>(k % 4), false);
    const int cells = 3 + static_cast<int>(random() % 22);
    const Mesh mesh = scanline::extract_surface(*f.field, cells);
    if (mesh.polygons.empty()) continue;
    ++found;
    EXPECT_EQ(fault(mesh), "") << f.text << " of " << cells << ", " << replay(seed + k);
    EXPECT_EQ(euler(mesh) % 2, 0) << f.text << ", " << replay(seed + k);
  }
  EXPECT_GT(found, 50);
}

/// Noise at the corners of the lattice: all ways in which a cell can be crossed.
class Noise final : public Field {
 public:
  explicit Noise(std::uint64_t seed) : seed_(seed) {}
  double distance(const glm::dvec3& p) const override {
    std::uint64_t h = seed_;
    for (int k = 0; k < 3; ++k) {
      h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[k] * 1e7)))) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return (h & 1) != 0 ? 1e-12 : -1e-12;
  }
  scanline::Bounds bounds() const override { return {glm::dvec3(-1e-4), glm::dvec3(1e-4)}; }

 private:
  std::uint64_t seed_;
};

TEST(FieldsExtraction, AnyPatternOfCornersIsClosed) {
  const std::uint64_t seed = seed_or(32);
  std::size_t polygons = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Mesh mesh = scanline::extract_surface(Noise(seed + k), 8);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& polygon : mesh.polygons) {
      for (std::size_t n = 0; n < polygon.size(); ++n) ++edges[{polygon[n], polygon[(n + 1) % polygon.size()]}];
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << replay(seed + k);
      ASSERT_TRUE(edges.contains({edge.second, edge.first})) << replay(seed + k);
    }
    polygons += mesh.polygons.size();
  }
  EXPECT_GT(polygons, 10000u);
}

TEST(FieldsExtraction, IsTheSameTwice) {
  const Mesh a = scanline::extract_surface(*drilled_cube(), 20), b = scanline::extract_surface(*drilled_cube(), 20);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.polygons, b.polygons);
  EXPECT_EQ(a.attributes[0].values, b.attributes[0].values);
}

TEST(FieldsExtraction, BoundsCloseWhatIsInfinite) {
  const FieldPointer slab = fields::intersect({fields::plane({0, 1, 0}), fields::box(glm::dvec3(2))});
  const Mesh mesh = scanline::extract_surface(*slab, 16);
  EXPECT_EQ(fault(mesh), "");
  EXPECT_EQ(mesh.polygons.size(), 6u);
  EXPECT_NEAR(volume(mesh), 4, 1e-9);
  EXPECT_TRUE(scanline::extract_surface(*fields::plane({0, 1, 0}), 16).polygons.empty());
}

TEST(FieldsExtraction, NothingGivesNothing) {
  const FieldPointer ball = fields::sphere(0.5);
  const FieldPointer nothing = fields::intersect({ball, fields::place(ball, {{3, 0, 0}, {}, 1})});
  EXPECT_TRUE(scanline::extract_surface(*nothing, 16).polygons.empty());
  EXPECT_TRUE(scanline::extract_surface(*fields::subtract({ball, fields::sphere(0.6)}), 16).polygons.empty());
}

TEST(FieldsExtractionSlow, TooFineASurfaceIsRefused) {
  const FieldPointer dust = fields::repeat(fields::sphere(1e-3), glm::dvec3(4e-3), glm::ivec3(250));
  EXPECT_THROW(scanline::extract_surface(*dust, scanline::kMostCells), scanline::UserError);
}

TEST(FieldsError, KnowsHowFarABallIsFromABall) {
  const Mesh small = scanline::extract_surface(*fields::sphere(1), 64);
  const scanline::FieldError error = scanline::measure(*fields::sphere(1.1), small);
  EXPECT_NEAR(error.largest, 0.1, 1e-3);
  EXPECT_NEAR(error.mean, 0.1, 1e-3);
  EXPECT_NEAR(error.missed, 0.1, 1e-3);
}

TEST(FieldsError, SeesWhatThePolygonsLack) {
  const FieldPointer ball = fields::sphere(0.5), second = fields::place(fields::sphere(0.3), {{2, 0, 0}, {}, 1});
  const scanline::FieldError error =
      scanline::measure(*fields::join({ball, second}), scanline::extract_surface(*ball, 32));
  EXPECT_LT(error.largest, 1e-2);
  EXPECT_NEAR(error.missed, 1.8, 2e-2);
}

TEST(FieldsError, IsNotFooledByBoundsThatAreFarFromTrue) {
  // A tenth of every distance is a bound, too.
  class Timid final : public Field {
   public:
    double distance(const glm::dvec3& p) const override { return 0.1 * (glm::length(p) - 1.1); }
    scanline::Bounds bounds() const override { return {glm::dvec3(-1.1), glm::dvec3(1.1)}; }
  };
  EXPECT_NEAR(scanline::measure(Timid(), scanline::extract_surface(*fields::sphere(1), 64)).largest, 0.1, 1e-3);
}

TEST(FieldsError, AskedForIsKept) {
  for (const double error : {0.05, 0.005}) {
    const scanline::MeasuredSurface surface = scanline::extract_within(*fields::torus(1, 0.3), error);
    EXPECT_LE(surface.error.worst(), error);
    EXPECT_EQ(fault(surface.mesh), "");
    const scanline::FieldError again = scanline::measure(*fields::torus(1, 0.3), surface.mesh);
    EXPECT_EQ(again.largest, surface.error.largest);
    EXPECT_EQ(again.missed, surface.error.missed);
  }
  EXPECT_EQ(scanline::extract_within(*fields::box(glm::dvec3(1)), 1e-6).mesh.polygons.size(), 6u);
}

TEST(FieldsExtraction, MistakesAreCaught) {
  Mesh mesh = scanline::extract_surface(*fields::sphere(1), 8);
  Mesh open = mesh, turned = mesh, bent = mesh;
  open.polygons.pop_back();
  EXPECT_NE(fault(open), "");
  std::reverse(turned.polygons[3].begin(), turned.polygons[3].end());
  EXPECT_NE(fault(turned), "");
  for (auto& polygon : bent.polygons) {
    if (polygon.size() == 4) bent.positions[polygon[0]] *= 1.3;
  }
  EXPECT_NE(fault(bent), "");
}

}  // namespace
}  // namespace fields_tests
