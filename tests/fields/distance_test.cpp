// Distances of single solids against closest points found by search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanline/fields/grid_field.h"
#include "scanline/fields/mesh_field.h"
#include "scanline/fields/operations.h"
#include "scanline/shapes.h"
#include "tests/fields/random_field.h"
#include "tests/fields/surface_oracle.h"

namespace fields_tests {
namespace {

namespace fields = scanline::fields;
using scanline::Field;
using scanline::FieldPointer;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Same sign as the solid's, same magnitude as the nearest point's distance.
void expect_exact(const Field& field, const Solid& solid, std::uint64_t own_seed) {
  const std::uint64_t seed = seed_or(own_seed);
  Random random(seed);
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 p = vector_between(random, -2, 2) * (k % 3 == 0 ? 0.3 : 1.0);
    const double expected = nearest_distance(solid.surface, p) * (solid.is_inside(p) ? -1 : 1);
    ASSERT_NEAR(field.distance(p), expected, 1e-6) << p.x << " " << p.y << " " << p.z << ", " << replay(seed);
  }
}

TEST(FieldsDistance, SphereIsExact) { expect_exact(*fields::sphere(0.8), sphere_solid(0.8), 1); }
TEST(FieldsDistance, BoxIsExact) { expect_exact(*fields::box({1, 0.4, 1.7}), box_solid({1, 0.4, 1.7}), 2); }
TEST(FieldsDistance, TorusIsExact) { expect_exact(*fields::torus(0.9, 0.3), torus_solid(0.9, 0.3), 3); }
TEST(FieldsDistance, CylinderIsExact) {
  expect_exact(*fields::frustum(0.7, 0.7, 1.2), frustum_solid(0.7, 0.7, 1.2), 4);
}
TEST(FieldsDistance, ConeIsExact) { expect_exact(*fields::frustum(0.9, 0, 1.4), frustum_solid(0.9, 0, 1.4), 5); }
TEST(FieldsDistance, FrustumsAreExact) {
  expect_exact(*fields::frustum(0.2, 0.9, 0.5), frustum_solid(0.2, 0.9, 0.5), 6);
  expect_exact(*fields::frustum(1.1, 0.9, 0.1), frustum_solid(1.1, 0.9, 0.1), 7);
}

TEST(FieldsDistance, EllipsoidIsExact) {
  for (const glm::dvec3 radii : {glm::dvec3(1, 0.5, 0.25), glm::dvec3(0.4, 0.4, 1.5), glm::dvec3(1, 1, 0.05)}) {
    expect_exact(*fields::ellipsoid(radii), ellipsoid_solid(radii), 8);
  }
}

TEST(FieldsDistance, EllipsoidInItsPlanesOfSymmetry) {
  const glm::dvec3 radii(1, 0.5, 0.25);
  const FieldPointer field = fields::ellipsoid(radii);
  const Solid solid = ellipsoid_solid(radii);
  EXPECT_NEAR(field->distance({0, 0, 0}), -0.25, 1e-15);
  for (double x = -1.5; x <= 1.5; x += 0.125) {
    for (const glm::dvec3 p :
         {glm::dvec3(x, 0, 0), glm::dvec3(0, x, 0), glm::dvec3(x, 0.2, 0), glm::dvec3(0, 0.1, x)}) {
      const double expected = nearest_distance(solid.surface, p) * (solid.is_inside(p) ? -1 : 1);
      EXPECT_NEAR(field->distance(p), expected, 1e-6) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(FieldsDistance, ThinEllipsoidsStayFinite) {
  const FieldPointer field = fields::ellipsoid({1e6, 1, 1e-3});
  EXPECT_NEAR(field->distance({0, 0, 2}), 1.999, 1e-9);
  EXPECT_NEAR(field->distance({2e6, 0, 0}), 1e6, 1e-3);
  EXPECT_NEAR(field->distance({0, 0, 0}), -1e-3, 1e-9);
  EXPECT_NEAR(field->distance({0, 3, 0}), 2, 1e-9);
}

TEST(FieldsDistance, RoundedBoxIsABoxAndItsSurroundings) {
  const std::uint64_t seed = seed_or(9);
  Random random(seed);
  const FieldPointer field = fields::box({1, 0.6, 1.4}, 0.2);
  const Solid core = box_solid({0.6, 0.2, 1.0});
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 p = vector_between(random, -1.5, 1.5);
    if (core.is_inside(p)) continue;
    EXPECT_NEAR(field->distance(p), nearest_distance(core.surface, p) - 0.2, 1e-6) << replay(seed);
  }
}

TEST(FieldsDistance, TriangleIsAllWithinItsThickness) {
  const std::uint64_t seed = seed_or(10);
  Random random(seed);
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 a = vector_between(random, -1, 1), b = vector_between(random, -1, 1),
                     c = vector_between(random, -1, 1);
    const glm::dvec3 p = vector_between(random, -2, 2);
    const double expected = nearest_distance({triangle_patch(a, b, c)}, p) - 0.1;
    EXPECT_NEAR(fields::triangle({a, b, c}, 0.1)->distance(p), expected, 1e-6) << replay(seed);
  }
  // Without area: a rod, and a ball.
  EXPECT_NEAR(fields::triangle({glm::dvec3(0), {1, 0, 0}, {2, 0, 0}}, 0.1)->distance({1.5, 1, 0}), 0.9, 1e-12);
  EXPECT_NEAR(fields::triangle({glm::dvec3(1), glm::dvec3(1), glm::dvec3(1)}, 0.1)->distance({1, 1, 3}), 1.9, 1e-12);
}

TEST(FieldsDistance, PlaneIsAHalfSpace) {
  const FieldPointer field = fields::plane({0, 3, 4});
  EXPECT_NEAR(field->distance({7, 1, 2}), 2.2, 1e-12);
  EXPECT_NEAR(field->distance({0, 0, -5}), -4, 1e-12);
  EXPECT_EQ(fields::plane({0, 2, 0})->bounds().high.y, 0);
  EXPECT_EQ(fields::plane({0, 2, 0})->bounds().high.x, kInfinite);
}

/// Solid angles of all faces as seen from the point (van Oosterom, Strackee 1983): 4 pi inside, 0 outside.
bool is_enclosed(const scanline::Mesh& mesh, const glm::dvec3& p) {
  double angle = 0;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const glm::dvec3 a = mesh.positions[polygon[0]] - p, b = mesh.positions[polygon[k]] - p,
                       c = mesh.positions[polygon[k + 1]] - p;
      const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
      angle += 2 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
    }
  }
  return std::abs(angle) > 6;
}

Solid mesh_solid(const scanline::Mesh& mesh) {
  Solid solid;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      solid.surface.push_back(
          triangle_patch(mesh.positions[polygon[0]], mesh.positions[polygon[k]], mesh.positions[polygon[k + 1]]));
    }
  }
  solid.is_inside = [mesh](const glm::dvec3& p) { return is_enclosed(mesh, p); };
  return solid;
}

TEST(FieldsDistance, MeshAgainstAllItsTriangles) {
  scanline::Mesh inside_out = scanline::make_sphere(0.7, 7, 4);
  for (auto& polygon : inside_out.polygons) std::reverse(polygon.begin(), polygon.end());
  for (const scanline::Mesh& mesh :
       {scanline::make_torus(0.7, 0.3, 9, 5), scanline::make_cone(0.5, 0, 1, 6), inside_out}) {
    ASSERT_EQ(fields::mesh_fault(mesh), "");
    expect_exact(*fields::mesh_field(mesh), mesh_solid(mesh), 11);
  }
}

TEST(FieldsDistance, MeshOfConcavePolygons) {
  // An L: its caps cannot be cut into triangles from just any corner.
  const std::vector<glm::dvec2> outline{{0, 0}, {2, 0}, {2, 0.3}, {0.3, 0.3}, {0.3, 2}, {0, 2}};
  const FieldPointer field = fields::mesh_field(scanline::make_prism(outline, 1));
  const Solid boxes[] = {box_solid({2, 0.3, 1}), box_solid({0.3, 2, 1})};
  const glm::dvec3 centers[] = {{1, 0.15, 0}, {0.15, 1, 0}};
  const std::uint64_t seed = seed_or(12);
  Random random(seed);
  for (int k = 0; k < 60; ++k) {
    const glm::dvec3 p = vector_between(random, -1, 3);
    if (boxes[0].is_inside(p - centers[0]) || boxes[1].is_inside(p - centers[1])) {
      EXPECT_LT(field->distance(p), 0) << replay(seed);
    } else {
      const double expected = std::min(nearest_distance(boxes[0].surface, p - centers[0]),
                                       nearest_distance(boxes[1].surface, p - centers[1]));
      EXPECT_NEAR(field->distance(p), expected, 1e-6) << replay(seed);
    }
  }
}

TEST(FieldsDistance, OpenMeshesAreFaulty) {
  scanline::Mesh mesh = scanline::make_cone(0.5, 0, 1, 6);
  mesh.polygons.pop_back();
  EXPECT_NE(fields::mesh_fault(mesh).find("the mesh is not closed"), std::string::npos);
  EXPECT_EQ(fields::mesh_fault({}), "the mesh has no polygon");
}

TEST(FieldsDistance, GridIsNearWhatItIsMadeFrom) {
  const std::uint64_t seed = seed_or(13);
  Random random(seed);
  const FieldPointer torus = fields::torus(0.9, 0.3), coarse = fields::grid_field(*torus, 32),
                     fine = fields::grid_field(*torus, 64);
  double worst[2] = {0, 0};
  const Patch surface = torus_solid(0.9, 0.3).surface[0];
  for (int k = 0; k < 2000; ++k) {
    const double u = between(random, 0, 1);
    const glm::dvec3 p = surface(u, between(random, 0, 1));
    worst[0] = std::max(worst[0], std::abs(coarse->distance(p)));
    worst[1] = std::max(worst[1], std::abs(fine->distance(p)));
  }
  const double cube = 2.4 / 32;
  EXPECT_LT(worst[0], cube * cube) << replay(seed);
  EXPECT_LT(worst[1], 0.4 * worst[0]) << replay(seed);
  EXPECT_GT(worst[1], 0);
}

TEST(FieldsDistance, PlacementScalesTurnsAndMoves) {
  const FieldPointer field = fields::place(fields::box({2, 1, 1}), {{1, 2, 3}, {0, 0, 90}, 2});
  EXPECT_NEAR(field->distance({1, 2, 3}), -1, 1e-12);
  EXPECT_NEAR(field->distance({1, 5, 3}), 1, 1e-12);
  EXPECT_NEAR(field->distance({3, 2, 3}), 1, 1e-12);
  EXPECT_EQ(field->bounds().low, glm::dvec3(0, 0, 2));
  EXPECT_EQ(field->bounds().high, glm::dvec3(2, 4, 4));
}

TEST(FieldsDistance, RepetitionHasItsCopiesWhereTheyBelong) {
  const FieldPointer endless = fields::repeat(fields::sphere(0.25), {1, 0, 2}, {0, 0, 0});
  for (const double x : {-3.0, 0.0, 1e6}) EXPECT_NEAR(endless->distance({x, 0, 4}), -0.25, 1e-9);
  EXPECT_NEAR(endless->distance({0.5, 0, 0}), 0.25, 1e-12);
  EXPECT_NEAR(endless->distance({0, 0, 1}), 0.5, 1e-12);  // no more than half a spacing
  EXPECT_EQ(endless->bounds().high, glm::dvec3(kInfinite, 0.25, kInfinite));
  const FieldPointer three = fields::repeat(fields::sphere(0.25), {1, 0, 0}, {3, 0, 0});
  EXPECT_NEAR(three->distance({-1, 0, 0}), -0.25, 1e-12);
  EXPECT_NEAR(three->distance({2, 0, 0}), 0.75, 1e-12);
  EXPECT_NEAR(three->distance({11, 0, 0}), 9.75, 1e-12);
}

std::vector<std::pair<const char*, FieldPointer>> all_kinds() {
  const FieldPointer ball = fields::sphere(0.5), box = fields::box({1, 0.5, 0.7}, 0.1);
  return {{"sphere", ball},
          {"box", box},
          {"plane", fields::plane({1, 2, 3})},
          {"torus", fields::torus(0.7, 0.2)},
          {"frustum", fields::frustum(0.5, 0.2, 1)},
          {"cone", fields::frustum(0.5, 0, 1)},
          {"ellipsoid", fields::ellipsoid({1, 0.5, 0.2})},
          {"triangle", fields::triangle({glm::dvec3(0), {1, 0, 0}, {0, 1, 0}}, 0.1)},
          {"mesh", fields::mesh_field(scanline::make_torus(0.7, 0.3, 9, 5))},
          {"grid", fields::grid_field(*fields::torus(0.7, 0.2), 16)},
          {"union", fields::join({ball, box})},
          {"intersection", fields::intersect({ball, box})},
          {"subtraction", fields::subtract({ball, box})},
          {"smooth union", fields::smooth_join({ball, box}, 0.2)},
          {"repetition", fields::repeat(ball, {0.9, 0, 2}, {0, 0, 4})},
          {"placement", fields::place(box, {{0.1, 0.2, 0.3}, {10, 20, 30}, 1.5})}};
}

TEST(FieldsDistance, OddPointsHaveFiniteAnswers) {
  const double numbers[] = {0, -0.0, 1e-310, 1e-160, 0.5, -1, 1e20, -1e155, 1.7e308, -1.7e308};
  for (const auto& [name, field] : all_kinds()) {
    for (const double x : numbers) {
      for (const double y : numbers) {
        for (const double z : numbers) {
          const glm::dvec3 p(x, y, z), n = field->normal(p);
          EXPECT_TRUE(std::isfinite(field->distance(p))) << name << " " << x << " " << y << " " << z;
          EXPECT_NEAR(glm::length(n), 1, 1e-9) << name << " " << x << " " << y << " " << z;
        }
      }
    }
    for (const double odd : {kInfinite, -kInfinite, std::nan("")}) {
      field->distance({odd, 0, 1});
      EXPECT_NEAR(glm::length(field->normal({0, odd, 1})), 1, 1e-9) << name << " " << odd;
    }
  }
}

TEST(FieldsDistance, NormalsRunAlongTheGradient) {
  const std::uint64_t seed = seed_or(14);
  Random random(seed);
  for (const auto& [name, field] : all_kinds()) {
    if (std::string(name) == "grid") continue;  // its normals are smoother than its distances
    int compared = 0;
    for (int k = 0; k < 1500; ++k) {
      const glm::dvec3 p = vector_between(random, -1.2, 1.2);
      glm::dvec3 gradients[2];
      for (int fine = 0; fine < 2; ++fine) {
        const double h = fine ? 1e-5 : 1e-4;
        for (int axis = 0; axis < 3; ++axis) {
          glm::dvec3 aside(0);
          aside[axis] = h;
          gradients[fine][axis] = (field->distance(p + aside) - field->distance(p - aside)) / (2 * h);
        }
      }
      // Where parts meet there is no gradient; far from a repetition its distance is a bound without a direction.
      if (std::abs(field->distance(p)) > 0.3) continue;
      if (glm::length(gradients[0] - gradients[1]) > 1e-4 || glm::length(gradients[0]) < 0.1) continue;
      ++compared;
      EXPECT_GT(glm::dot(field->normal(p), glm::normalize(gradients[1])), 0.9999)
          << name << " " << p.x << " " << p.y << " " << p.z << ", " << replay(seed);
    }
    EXPECT_GT(compared, 40) << name;
  }
}

}  // namespace
}  // namespace fields_tests
