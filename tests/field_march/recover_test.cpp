// The surface behind or before a polygon, along the line of sight.
#include <gtest/gtest.h>

#include <cmath>

#include "scanline/fields/operations.h"
#include "tests/field_march/oracle.h"

namespace field_march_tests {
namespace {

using scanline::FieldCost;
using scanline::FieldScene;

struct Counts {
  int found = 0, missed = 0, wrong = 0, far = 0;
};

/// Points as polygons would have them: of the true surface, seen from the front, then moved along the normal by up to
/// `error` to either side. Rays go from the eye through the moved points.
Counts compare(const Solid& solid, Random& random, int points, double error, double share = 1) {
  const scanline::Scene scene = scene_of({solid}, share);
  const FieldScene fields(scene, 1);
  Counts counts;
  for (int n = 0; n < points; ++n) {
    const glm::dvec3 eye = random.vector(12), aim = solid.key.translate + random.vector(2);
    const Intervals seen = meetings(solid, eye, aim - eye);
    if (seen.empty() || seen[0].first < 0) continue;
    const std::size_t which = n % seen.size();
    const glm::dvec3 surface = eye + static_cast<double>(seen[which].first) * (aim - eye);
    const glm::dvec3 polygon = surface + random.between(-error, error) * normal_at(solid, surface);
    const glm::dvec3 direction = polygon - eye;

    // Near the outline the moved point may have no entry close by, or none at all.
    const Intervals truth = meetings(solid, eye, direction);
    Real nearest = std::numeric_limits<Real>::infinity();
    for (const auto& interval : truth) {
      if (std::abs(interval.first - 1) < std::abs(nearest - 1)) nearest = interval.first;
    }
    const Real away = std::abs(nearest - 1) * glm::length(direction);
    FieldCost cost;
    const auto hit = fields.recover(0, eye, direction, 1, cost);
    EXPECT_EQ(cost.rays, 1u);
    EXPECT_EQ(cost.missed, hit ? 0u : 1u);
    ++(hit ? counts.found : counts.missed);
    if (!hit) {
      counts.wrong += away < 5 * error ? 1 : 0;
      continue;
    }
    // Any entry that is found is a true one, and the nearest where that is clear.
    bool is_entry = false;
    for (const auto& interval : truth)
      is_entry |= std::abs(hit->t - interval.first) * glm::length(direction) < 1e-9 * (1 + glm::length(eye));
    const bool is_nearest = std::abs(hit->t - nearest) * glm::length(direction) < 1e-8;
    counts.wrong += is_entry && (is_nearest || away > 5 * error) ? 0 : 1;
    counts.far += is_nearest ? 0 : 1;
    if (is_nearest) {
      EXPECT_LT(glm::distance(hit->normal, normal_at(solid, hit->position)), 1e-6);
    }
  }
  return counts;
}

TEST(field_march_recover, finds_the_surface_on_either_side) {
  Random random(21);
  SCOPED_TRACE(random.replay());
  for (const Kind kind : {Kind::Sphere, Kind::Torus}) {
    for (const double error : {1e-6, 1e-4, 1e-2}) {
      Counts sum;
      for (int n = 0; n < 30; ++n) {
        Solid solid = random.solid(kind);
        const Counts c = compare(solid, random, 100, error);
        sum.found += c.found;
        sum.missed += c.missed;
        sum.wrong += c.wrong;
        sum.far += c.far;
      }
      EXPECT_EQ(sum.wrong, 0) << error;
      EXPECT_GT(sum.found, 500);
      EXPECT_LT(sum.missed, sum.found / 50) << error;
      EXPECT_LT(sum.far, sum.found / 100) << error;
    }
  }
}

TEST(field_march_recover, finds_it_where_the_field_is_only_a_bound) {
  Random random(22);
  SCOPED_TRACE(random.replay());
  Counts sum;
  for (int n = 0; n < 10; ++n) sum.wrong += compare(random.solid(Kind::Sphere), random, 100, 1e-3, 0.5).wrong;
  EXPECT_EQ(sum.wrong, 0);
}

TEST(field_march_recover, finds_flat_sides_at_any_angle) {
  const scanline::Scene scene = scene_of({Solid{Kind::Box, {1, 1, 1}, {}}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (const double slope : {1.0, 0.1, 0.02, 0.005}) {
    for (const double error : {1e-4, -1e-4, 1e-3, -1e-3}) {
      // The true entry is in the middle of the top.
      const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -slope, 0)),
                       eye = -4.0 * direction + glm::dvec3(0, 1, 0);
      const double t = 4 + error / direction.y;
      if (std::abs(error / direction.y) > 0.9) continue;  // beyond the side's end
      const auto hit = fields.recover(0, eye, direction, t, cost);
      ASSERT_TRUE(hit) << slope << ' ' << error;
      EXPECT_NEAR(hit->t, 4, 1e-9) << slope << ' ' << error;
      EXPECT_EQ(hit->normal, glm::dvec3(0, 1, 0));
    }
  }
  EXPECT_EQ(cost.missed, 0u);
}

TEST(field_march_recover, keeps_to_the_polygon_that_is_seen) {
  // A ring from its side: a polygon a little outside of the near body, past which the line of sight goes on to the far
  // one.
  const scanline::Scene scene = scene_of({Solid{Kind::Torus, {2, 0.5, 0}, {}}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  const glm::dvec3 eye(0, 4, 10), polygon(0, 0.501, 2);
  const glm::dvec3 above(0, 0.52, 2.0);
  const auto near = fields.recover(0, eye, polygon - eye, 1, cost);
  ASSERT_TRUE(near);
  EXPECT_LT(glm::distance(near->position, polygon), 0.1);
  // Sight along the crest: it passes the near body at 0.02 and meets the far one, 4 behind it.
  const glm::dvec3 level(0, 0.52, 10), down(0, -0.01, -1);
  const Intervals truth = meetings({Kind::Torus, {2, 0.5, 0}, {}}, level + glm::dvec3(0, 0.08, 0), down);
  ASSERT_EQ(truth.size(), 1u);
  ASSERT_GT(truth[0].first, 10);
  EXPECT_FALSE(fields.recover(0, level + glm::dvec3(0, 0.08, 0), down, 8, cost));
  EXPECT_EQ(cost.missed, 1u);
}

TEST(field_march_recover, looks_behind_what_the_sight_has_left) {
  // Polygons that stand over a ball's outline: the line of sight goes through the ball before it meets them.
  const scanline::Scene scene = scene_of({Solid{}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (const double depth : {1e-2, 1e-3, 1e-4}) {
    const glm::dvec3 eye(0, 1 - depth, 10), direction(0, 0, -1);
    const Intervals truth = meetings(Solid{}, eye, direction);
    const auto exit = static_cast<double>(truth[0].second);
    const auto hit = fields.recover(0, eye, direction, exit + std::sqrt(depth), cost);
    ASSERT_TRUE(hit) << depth;
    EXPECT_NEAR(hit->t, static_cast<double>(truth[0].first), 1e-8) << depth;
  }
}

TEST(field_march_recover, finds_the_bottom_of_what_polygons_close) {
  // A groove of 0.02 x 0.01 along z, closed by a polygon at y = 1; in the middle the walls are farther away than at
  // first.
  namespace f = scanline::fields;
  const auto block = f::box({2, 2, 2}), groove = f::box(scanline::Bounds{{-0.01, 0.99, -2}, {0.01, 1.01, 2}});
  scanline::Object object;
  object.field = f::subtract({block, groove});
  object.keys = {{}};
  scanline::Scene scene;
  scene.objects = {object};
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (const double x : {-0.0099, -0.009, -0.005, 0.0}) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.6, -1, 0)), polygon(x, 1, 0);
    const auto hit = fields.recover(0, polygon - 3.0 * direction, direction, 3, cost);
    ASSERT_TRUE(hit) << x;
    EXPECT_NEAR(hit->position.y, 0.99, 1e-9) << x;
    EXPECT_NEAR(hit->position.x, x + 0.006, 1e-9) << x;
  }
}

TEST(field_march_recover, of_objects_without_a_field_is_a_miss) {
  scanline::Scene scene = scene_of({Solid{}});
  scene.objects.insert(scene.objects.begin(), scanline::Object());
  scene.objects[0].keys = {{}};
  const FieldScene fields(scene, 1);
  FieldCost cost;
  EXPECT_FALSE(fields.recover(0, {0, 0, 5}, {0, 0, -1}, 4, cost));
  EXPECT_FALSE(fields.recover(2, {0, 0, 5}, {0, 0, -1}, 4, cost));
  ASSERT_TRUE(fields.recover(1, {0, 0, 5}, {0, 0, -1}, 4.1, cost));
  EXPECT_EQ(fields.recover(1, {0, 0, 5}, {0, 0, -1}, 4.1, cost)->object, 1u);
  EXPECT_EQ(cost.missed, 2u);
  EXPECT_EQ(cost.rays, 4u);
}

TEST(field_march_recover, costs_what_it_asks) {
  Random random(23);
  SCOPED_TRACE(random.replay());
  Asked asked;
  const scanline::Scene scene = scene_of({Solid{}}, 1, &asked);
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (int n = 0; n < 100; ++n) {
    const glm::dvec3 normal = random.unit();
    fields.recover(0, 5.0 * random.unit(), normal * random.between(0.99, 1.01) - 5.0 * normal, 1, cost);
  }
  EXPECT_EQ(cost.evaluations, static_cast<std::uint64_t>(asked.distances + asked.normals));
}

}  // namespace
}  // namespace field_march_tests
