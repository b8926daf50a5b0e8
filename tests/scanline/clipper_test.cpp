// The clipper against point sampling: a point of the polygon that lies in the viewing box lies in exactly one piece.
#include "scanline/clipper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>
#include <random>

#include "scanline/shapes.h"
#include "tests/scanline/checks.h"

namespace scanline_tests {
namespace {

using scanline::ClipLoop;
using scanline::Clipper;

using Outline = std::vector<glm::dvec2>;

/// Clips outlines that lie in a plane of their own; `world` of the clipper's vertices holds the plane's coordinates.
class PlaneClipper {
 public:
  PlaneClipper(const Outline& outline, const glm::dmat4& plane_to_clip) {
    for (const glm::dvec2& p : outline) {
      world_.emplace_back(p, 0);
      clip_.push_back(plane_to_clip * glm::dvec4(p, 0, 1));
      indices_.push_back(static_cast<std::uint32_t>(indices_.size()));
    }
  }
  std::vector<Outline> run() {
    Clipper clipper(clip_, world_, {}, 0);
    std::vector<Outline> pieces;
    for (const ClipLoop& loop : clipper.clip(indices_, 0)) {
      Outline& piece = pieces.emplace_back();
      for (const auto& c : loop) piece.emplace_back(clipper.world(c.vertex));
    }
    return pieces;
  }

 private:
  std::vector<glm::dvec3> world_;
  std::vector<glm::dvec4> clip_;
  std::vector<std::uint32_t> indices_;
};

bool contains(const Outline& outline, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

/// A simple polygon, seldom convex. It is off the origin, for what a box around its centre holds would never fall
/// apart.
Outline star(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> radius(0.1, 1), offset(-0.5, 0.5);
  const glm::dvec2 centre(size * offset(random), size * offset(random));
  const int points = std::uniform_int_distribution<int>(3, 24)(random);
  Outline outline;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points, r = size * radius(random);
    outline.emplace_back(centre.x + r * std::cos(angle), centre.y + r * std::sin(angle));
  }
  return outline;
}

/// `teeth` upright teeth on a beam below: cut at the teeth, it falls into as many pieces.
Outline comb(int teeth) {
  Outline outline{{-0.9, -0.5}, {0.9, -0.5}};
  const double pitch = 1.8 / (2 * teeth - 1);
  for (int k = 2 * teeth - 1; k > 0; --k) {
    const double right = -0.9 + k * pitch, left = right - pitch;
    const double height = k % 2 == 1 ? 1.5 : 0.5;
    outline.emplace_back(right, height);
    outline.emplace_back(left, height);
  }
  return outline;
}

glm::dmat4 random_camera(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  const glm::dmat4 view = glm::lookAtRH(2.0 * point(), 0.5 * point(), glm::dvec3(0.1, 1, 0.2));
  if (unit(random) < 0) return glm::orthoRH_NO(-0.7, 0.7, -0.6, 0.6, 0.5, 2.5) * view;
  return glm::perspectiveRH_NO(0.8, 1.2, 0.3, 3.0) * view;
}

TEST(Clipper, PieceHoldsExactlyWhatTheViewingBoxHolds) {
  std::size_t held = 0, missed = 0, split = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Outline outline = star(random, 2.5);
    const glm::dmat4 matrix = random_camera(random);
    const std::vector<Outline> pieces = PlaneClipper(outline, matrix).run();
    split += pieces.size() > 1;
    std::uniform_real_distribution<double> place(-2.5, 2.5);
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 p(place(random), place(random));
      const glm::dvec4 clip = matrix * glm::dvec4(p, 0, 1);
      const double inside = clip.w - std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)});
      if (std::abs(inside) < 1e-9) continue;  // on the border either answer is right
      int count = 0;
      for (const Outline& piece : pieces) count += contains(piece, p);
      const int wanted = inside > 0 && contains(outline, p) ? 1 : 0;
      ASSERT_EQ(count, wanted) << p.x << " " << p.y;
      ++(wanted == 1 ? held : missed);
    }
  }
  EXPECT_GT(held, 5000u);
  EXPECT_GT(missed, 5000u);
  EXPECT_GT(split, 100u);
}

TEST(Clipper, PiecesTurnAsTheOutlineDoes) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Outline outline = star(random, 2.5);
    for (const Outline& piece : PlaneClipper(outline, random_camera(random)).run()) EXPECT_GT(area(piece), -1e-12);
  }
}

TEST(Clipper, NonConvexPolygonIsSplit) {
  for (int teeth = 2; teeth <= 9; ++teeth) {
    // Moved down until the beam is below the box: only the teeth are left, and each is a polygon of its own.
    const glm::dmat4 down = glm::translate(glm::dmat4(1), glm::dvec3(0, -2, 0));
    const std::vector<Outline> pieces = PlaneClipper(comb(teeth), down).run();
    ASSERT_EQ(pieces.size(), static_cast<std::size_t>(teeth));
    for (const Outline& piece : pieces) EXPECT_EQ(piece.size(), 4u);
  }
}

TEST(Clipper, VertexOnThePlaneIsKept) {
  // A diamond whose left point touches the border from inside, and one whose right half begins exactly there.
  const std::vector<Outline> whole = PlaneClipper({{-1, 0}, {0, -0.5}, {0.5, 0}, {0, 0.5}}, glm::dmat4(1)).run();
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].size(), 4u);
  const std::vector<Outline> half = PlaneClipper({{-1.5, 0}, {-1, -0.5}, {-0.5, 0}, {-1, 0.5}}, glm::dmat4(1)).run();
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].size(), 3u);
  EXPECT_DOUBLE_EQ(area(half[0]), 0.25);
}

TEST(Clipper, PolygonThatTouchesThePlaneInsideFallsApartThere) {
  // A W whose middle point reaches the border exactly: what is inside are two triangles with a common point.
  const Outline w{{-0.8, 1.5}, {-0.4, 0.2}, {0, 1}, {0.4, 0.2}, {0.8, 1.5}};
  double inside = 0;
  for (const Outline& piece : PlaneClipper(w, glm::dmat4(1)).run()) inside += std::abs(area(piece));
  // Between y = 1 and the two lower points: two triangles, 0.8 high.
  const double left = -0.8 + 0.4 * 0.5 / 1.3;
  EXPECT_NEAR(inside, 2 * 0.5 * (0 - left) * 0.8, 1e-12);
}

TEST(Clipper, NeighboursShareTheVerticesMadeByClipping) {
  std::size_t made = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const glm::dmat4 camera = random_camera(random);
    const scanline::Mesh mesh = scanline::make_torus(1, 0.45, 17, 9);
    std::vector<glm::dvec4> clip;
    for (const glm::dvec3& p : mesh.positions) clip.push_back(camera * glm::dvec4(p, 1));
    Clipper clipper(clip, mesh.positions, {}, 0);
    scanline::PolygonList result;
    for (const auto& polygon : mesh.polygons) {
      for (const ClipLoop& loop : clipper.clip(polygon, 0)) {
        auto& p = result.emplace_back();
        for (const auto& c : loop) p.push_back(c.vertex);
      }
    }
    made += clipper.vertex_count() - mesh.positions.size();
    // The torus is closed: an edge without a partner was made by a plane, and lies in it.
    for (const auto& [a, b] : open_edges(result)) {
      const glm::dvec4 &p = clipper.position(a), &q = clipper.position(b);
      bool on_plane = false;
      for (int k = 0; k < 3; ++k) {
        for (const double side : {-1.0, 1.0}) {
          const double tolerance = 1e-12 * (p.w + q.w);
          on_plane |= std::abs(side * p[k] - p.w) < tolerance && std::abs(side * q[k] - q.w) < tolerance;
        }
      }
      ASSERT_TRUE(on_plane) << a << " " << b;
    }
  }
  EXPECT_GT(made, 1000u);
}

TEST(Clipper, CornerValuesAreCarriedLinearly) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Outline outline = star(random, 2.5);
    const glm::dmat4 matrix = random_camera(random);
    std::vector<glm::dvec3> world;
    std::vector<glm::dvec4> clip;
    std::vector<double> values;
    std::vector<std::uint32_t> polygon;
    for (const glm::dvec2& p : outline) {
      polygon.push_back(static_cast<std::uint32_t>(world.size()));
      world.emplace_back(p, 0);
      clip.push_back(matrix * glm::dvec4(p, 0, 1));
      values.insert(values.end(), {3 * p.x - p.y + 0.5, p.x + p.y});
    }
    Clipper clipper(clip, world, values, 2);
    for (const ClipLoop& loop : clipper.clip(polygon, 0)) {
      for (const auto& c : loop) {
        const glm::dvec3& p = clipper.world(c.vertex);
        EXPECT_NEAR(clipper.corner(c.corner)[0], 3 * p.x - p.y + 0.5, 1e-9);
        EXPECT_NEAR(clipper.corner(c.corner)[1], p.x + p.y, 1e-9);
      }
    }
  }
}

TEST(Clipper, PolygonOnABorderPlaneIsKept) {
  // All of it in the near plane: nothing is outside.
  const glm::dmat4 near_plane = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -1));
  EXPECT_EQ(PlaneClipper({{0, 0}, {0.5, 0}, {0, 0.5}}, near_plane).run().size(), 1u);
  const glm::dmat4 before = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -1.0001));
  EXPECT_TRUE(PlaneClipper({{0, 0}, {0.5, 0}, {0, 0.5}}, before).run().empty());
}

}  // namespace
}  // namespace scanline_tests
