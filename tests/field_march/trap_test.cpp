// What is hard to march: thin walls, grazing rays, sizes far apart, numbers that are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanline/fields/operations.h"
#include "tests/field_march/oracle.h"

namespace field_march_tests {
namespace {

using scanline::FieldCost;
using scanline::FieldScene;

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(field_march_traps, thin_walls_stop_every_ray) {
  Random random(41);
  SCOPED_TRACE(random.replay());
  for (const double half : {1e-2, 1e-4, 1e-6, 1e-7}) {
    const Solid slab{Kind::Slab, {half, 0, 0}, {.translate = {0.1, 0.2, 0.3}, .rotate = {20, 30, 40}}};
    const scanline::Scene scene = scene_of({slab, Solid{}});
    const FieldScene fields(scene, 1);
    const glm::dvec3 up = normal_at(slab, slab.key.translate + glm::dvec3(0, 5, 0));
    FieldCost cost;
    for (int n = 0; n < 300; ++n) {
      // From 6 over the wall to 6 under it, at angles down to a twentieth.
      const glm::dvec3 aside = glm::cross(up, random.unit());
      const glm::dvec3 origin = slab.key.translate + 6.0 * up, direction = -12.0 * up + random.between(0, 200) * aside;
      const auto hit = fields.first_hit(origin, direction, 0, 1, cost);
      ASSERT_TRUE(hit) << half;
      Real first = meetings(slab, origin, direction)[0].first;
      if (const Intervals ball = meetings(Solid{}, origin, direction); !ball.empty())
        first = std::min(first, ball[0].first);
      ASSERT_NEAR(hit->t, static_cast<double>(first), 1e-8) << half;
    }
  }
}

TEST(field_march_traps, grazing_rays_tell_touching_from_passing) {
  Random random(42);
  SCOPED_TRACE(random.replay());
  const scanline::Scene scene = scene_of({Solid{}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 direction = random.unit();
    const glm::dvec3 aside = glm::normalize(glm::cross(direction, random.unit()));
    const double gap = n % 2 == 0 ? std::pow(10.0, random.between(-8, -1)) : -std::pow(10.0, random.between(-6, -1));
    const glm::dvec3 origin = (1 + gap) * aside - random.between(2, 20) * direction;
    const auto hit = fields.first_hit(origin, direction, 0, 100, cost);
    ASSERT_EQ(hit.has_value(), gap < 0) << gap;
    if (hit) {
      EXPECT_NEAR(hit->t, static_cast<double>(meetings(Solid{}, origin, direction)[0].first), 1e-7);
    }
  }
}

TEST(field_march_traps, the_horizon_of_a_plane_is_reached) {
  const scanline::Scene scene = scene_of({Solid{Kind::Plane, {}, {}}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (const double slope : {0.5, 0.05, 0.01, 0.002}) {
    const auto hit = fields.first_hit({0, 1, 0}, {1, -slope, 0}, 0, 1e6, cost);
    ASSERT_TRUE(hit) << slope;
    EXPECT_NEAR(hit->t * slope, 1, 1e-8) << slope;
    EXPECT_FALSE(fields.first_hit({0, 1, 0}, {1, slope, 0}, 0, kEndless, cost));
    EXPECT_FALSE(fields.first_hit({0, 0, 0}, {1, slope, 0}, 0, kEndless, cost));
  }
  // In the plane itself, and level over it: they end, and find nothing.
  EXPECT_FALSE(fields.first_hit({0, 0, 0}, {1, 0, 0}, 0, kEndless, cost));
  EXPECT_FALSE(fields.first_hit({0, 1e-3, 0}, {1, 0, 0}, 0, kEndless, cost));
  EXPECT_LT(cost.evaluations, 100000u);
}

TEST(field_march_traps, sizes_do_not_matter) {
  for (const double size : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    Solid solid{Kind::Torus, {1, 0.25, 0}, {}};
    solid.key.scale = glm::dvec3(size);
    const scanline::Scene scene = scene_of({solid});
    const FieldScene fields(scene, 1);
    FieldCost cost;
    for (const double unit : {1e-9, 1.0, 1e9}) {
      const glm::dvec3 origin = size * glm::dvec3(1, 2, 5), aim = size * glm::dvec3(0.9, 0.05, 0.1);
      const glm::dvec3 straight = glm::normalize(aim - origin), direction = unit * straight;
      const double t = static_cast<double>(meetings(solid, origin, straight)[0].first) / unit;
      const auto hit = fields.first_hit(origin, direction, 0, kEndless, cost);
      ASSERT_TRUE(hit) << size << ' ' << unit;
      EXPECT_NEAR(hit->t, t, 1e-9 * t) << size << ' ' << unit;
      const auto recovered = fields.recover(0, origin, direction, t * (1 + 1e-4), cost);
      ASSERT_TRUE(recovered) << size << ' ' << unit;
      EXPECT_NEAR(recovered->t, t, 1e-9 * t) << size << ' ' << unit;
    }
  }
}

TEST(field_march_traps, objects_far_from_the_origin) {
  Random random(43);
  SCOPED_TRACE(random.replay());
  const glm::dvec3 far(1e6, -2e6, 3e5);
  int hits = 0;
  for (int k = 0; k < 20; ++k) {
    Solid solid = random.solid(Kind::Torus);
    solid.key.translate += far;
    const scanline::Scene scene = scene_of({solid});
    const FieldScene fields(scene, 1);
    for (int n = 0; n < 100; ++n) {
      const glm::dvec3 origin = far + random.vector(8), direction = far + random.vector(4) - origin;
      const Intervals truth = meetings(solid, origin, direction);
      bool is_close = false;
      for (const auto& [entry, exit] : truth) is_close |= exit - entry < 1e-3 || std::abs(entry) < 1e-3;
      if (is_close) continue;
      FieldCost cost;
      const auto hit = fields.first_hit(origin, direction, 0, 1e3, cost);
      const auto entry = std::find_if(truth.begin(), truth.end(), [](const auto& i) { return i.first > 0; });
      ASSERT_EQ(hit.has_value(), entry != truth.end());
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->t, static_cast<double>(entry->first), 1e-6);
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(field_march_traps, numbers_that_are_none_end_in_nothing) {
  const scanline::Scene scene = scene_of({Solid{}, Solid{Kind::Plane, {}, {.translate = {0, -2, 0}}}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (const double x : {kNone, kEndless, -kEndless, 1e308, 1e200}) {
    fields.first_hit({x, 0, 0}, {-1, 0, 0}, 0, 100, cost);
    EXPECT_FALSE(fields.first_hit({-5, 5, 0}, {x, 0, 0}, 0, 100, cost)) << x;
    EXPECT_FALSE(fields.first_hit({-5, 0, 0}, {1, 0, 0}, x < 0 ? kNone : x, 100, cost)) << x;
    fields.recover(0, {x, 0, 0}, {-1, 0, 0}, 1, cost);
    fields.recover(0, {5, 0, 0}, {x, 0, 0}, 1, cost);
    fields.recover(1, {5, 0, 0}, {-1, -1, 0}, x, cost);
    const glm::dvec3 normal = fields.normal(0, {x, 0, 0}, cost);
    EXPECT_FALSE(std::isnan(normal.x) && x == x) << x;
    scanline::Light light;
    fields.visibility({x, 0, 0}, {0, 1, 0}, light, cost);
    light.direction = {x, -1, 0};
    fields.visibility({0, 1, 0}, {0, 1, 0}, light, cost);
    fields.reflection({0, 1, x}, {0, 1, 0}, {x, -1, 0}, cost);
  }
  EXPECT_FALSE(fields.first_hit({-5, 0, 0}, {1, 0, 0}, 0, kNone, cost));
  EXPECT_FALSE(fields.first_hit({-5, 0, 0}, {1, 0, 0}, 10, 1, cost));
  EXPECT_FALSE(fields.first_hit({-5, 0, 0}, {0, 0, 0}, 0, 100, cost));
  EXPECT_FALSE(fields.recover(0, {-5, 0, 0}, {0, 0, 0}, 1, cost));
  EXPECT_LT(cost.evaluations, 1000000u);
}

TEST(field_march_traps, flattened_objects_are_not_there) {
  Solid flat;
  flat.key.scale = {1, 0, 1};
  scanline::Scene scene = scene_of({flat});
  EXPECT_TRUE(FieldScene(scene, 1).empty());
  EXPECT_FALSE(FieldScene(scene_of({Solid{}}), 1).empty());
  scene.objects.push_back(object_of(Solid{}));
  const FieldScene fields(scene, 1);
  FieldCost cost;
  EXPECT_FALSE(fields.recover(0, {0, 5, 0}, {0, -1, 0}, 5, cost));
  EXPECT_EQ(cost, (FieldCost{1, 0, 1}));
  const auto hit = fields.first_hit({0, 5, 0}, {0, -1, 0}, 0, 100, cost);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->object, 1u);
}

TEST(field_march_traps, balls_without_end) {
  // A ray level between two layers of balls meets none; another one its first ball.
  scanline::Scene scene;
  scanline::Object balls;
  balls.field = scanline::fields::repeat(scanline::fields::sphere(0.4), {2, 2, 2}, {0, 0, 0});
  balls.keys = {{}};
  scene.objects = {balls};
  const FieldScene fields(scene, 1);
  FieldCost cost;
  EXPECT_FALSE(fields.first_hit({0.3, 1, 1}, {1, 0, 0}, 0, kEndless, cost));
  const auto hit = fields.first_hit({1, 0, 1}, glm::dvec3(5, 0, 5), 0, kEndless, cost);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t * std::sqrt(50.0), std::sqrt(2.0) - 0.4, 1e-9);
  const auto far = fields.first_hit({1, 0, 1}, glm::dvec3(40, 0, 1), 0, kEndless, cost);
  ASSERT_TRUE(far);
  EXPECT_NEAR(std::hypot(std::remainder(far->position.x, 2), far->position.y, std::remainder(far->position.z, 2)), 0.4,
              1e-9);
}

}  // namespace
}  // namespace field_march_tests
