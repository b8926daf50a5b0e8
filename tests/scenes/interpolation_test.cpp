// How polygons of many corners are cut where their attributes are not linear over them.
#include "watkins/interpolation.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <vector>

namespace scene_tests {
namespace {

using Outline = std::vector<glm::dvec2>;
using watkins::PolygonSurface;

scanline::SceneFrame frame_of(const Outline& outline) {
  scanline::SceneFrame frame;
  std::vector<std::uint32_t> polygon;
  for (const glm::dvec2& p : outline) {
    frame.frame.vertices.push_back({p.x, p.y, 100});
    frame.w.push_back(1 + static_cast<double>(polygon.size()) / 8);
    polygon.push_back(static_cast<std::uint32_t>(frame.frame.vertices.size()));
  }
  frame.frame.polygons = {polygon};
  frame.first_corner = {0, static_cast<std::uint32_t>(outline.size())};
  return frame;
}

/// By the number of sides to the right.
bool inside(const Outline& outline, const glm::dvec2& p) {
  bool result = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) result = !result;
  }
  return result;
}

/// Comb with three teeth, a spiral, and an arrow, either way round.
std::vector<Outline> outlines() {
  std::vector<Outline> all = {{{10, 10},
                               {60, 12},
                               {61, 40},
                               {50, 39},
                               {49, 20},
                               {40, 21},
                               {41, 44},
                               {30, 43},
                               {31, 19},
                               {20, 20},
                               {19, 41},
                               {9, 40}},
                              {{10, 10},
                               {60, 11},
                               {59, 50},
                               {20, 49},
                               {21, 25},
                               {45, 26},
                               {44, 36},
                               {35, 35},
                               {34, 41},
                               {51, 42},
                               {50, 20},
                               {11, 19}},
                              {{10, 10}, {30, 20}, {50, 11}, {31, 60}}};
  for (std::size_t k = 0; k < 3; ++k) all.emplace_back(all[k].rbegin(), all[k].rend());
  return all;
}

TEST(PolygonSurfaces, AreCutIntoTrianglesThatLieInThem) {
  for (const Outline& outline : outlines()) {
    const scanline::SceneFrame frame = frame_of(outline);
    const PolygonSurface surface(frame, 0);
    int judged = 0;
    for (double y = 5.3; y < 65; y += 0.71) {
      for (double x = 5.1; x < 65; x += 0.73) {
        const glm::dvec2 p(x, y);
        if (!inside(outline, p)) continue;
        ++judged;
        const PolygonSurface::Point point = surface.at(x, y);
        // Weights are those of attributes: share / w of each corner, scaled. The shares give back the sample.
        glm::dvec2 corner[3], sample(0);
        double weights = 0, shares = 0;
        for (int n = 0; n < 3; ++n) {
          corner[n] = outline[point.corner[n]];
          const double share = point.weight[n] * frame.w[point.corner[n]] / point.w;
          EXPECT_GE(share, 0);
          weights += point.weight[n];
          shares += share;
          sample += share * corner[n];
        }
        EXPECT_NEAR(weights, 1, 1e-9);
        EXPECT_NEAR(shares, 1, 1e-9);
        EXPECT_NEAR(glm::distance(sample, p), 0, 1e-9) << x << ", " << y;
        const glm::dvec2 middle = (corner[0] + corner[1] + corner[2]) / 3.0;
        EXPECT_TRUE(inside(outline, middle)) << x << ", " << y;
        for (int n = 0; n < 3; ++n) {
          const glm::dvec2 side = (corner[n] + corner[(n + 1) % 3]) / 2.0;
          EXPECT_TRUE(inside(outline, side + (middle - side) * 1e-6)) << x << ", " << y;
        }
        if (testing::Test::HasFailure()) return;
      }
    }
    EXPECT_GT(judged, 500);
  }
}

}  // namespace
}  // namespace scene_tests
