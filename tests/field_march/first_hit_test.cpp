// First hits against the roots of polynomials.
#include <gtest/gtest.h>

#include "tests/field_march/oracle.h"

namespace field_march_tests {
namespace {

using scanline::FieldCost;
using scanline::FieldHit;
using scanline::FieldScene;

struct Expected {
  Real t = 0;
  std::uint32_t object = 0;
  bool is_hit = false;
  bool is_close = false;  ///< the answer hangs on less than the search promises
};

/// The first entry of any solid within from <= t <= to. Close: a way through a solid or between two of them, or between
/// an entry and an end of the ray, of less than 1e-6.
Expected expected(const std::vector<Solid>& solids, const glm::dvec3& origin, const glm::dvec3& direction, double from,
                  double to) {
  constexpr Real kClose = 1e-6;
  Expected result;
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const Intervals intervals = meetings(solids[k], origin, direction);
    for (std::size_t n = 0; n < intervals.size(); ++n) {
      const auto [entry, exit] = intervals[n];
      result.is_close |= exit - entry < kClose || std::abs(entry - from) < kClose || std::abs(entry - to) < kClose;
      result.is_close |= n > 0 && entry - intervals[n - 1].second < kClose;
      if (entry < from || entry > to) continue;
      result.is_close |= grazes(solids[k], origin, direction, entry);
      if (result.is_hit) result.is_close |= std::abs(entry - result.t) < kClose;
      if (!result.is_hit || entry < result.t) {
        result.t = entry;
        result.object = static_cast<std::uint32_t>(k);
        result.is_hit = true;
      }
    }
  }
  return result;
}

struct Comparison {
  int hits = 0, misses = 0, close = 0, wrong = 0;
  Comparison& operator+=(const Comparison& other) {
    hits += other.hits;
    misses += other.misses;
    close += other.close;
    wrong += other.wrong;
    return *this;
  }
};

/// Random rays into a scene: `rays` of them, from `from` to `to`.
Comparison compare(const std::vector<Solid>& solids, Random& random, int rays, double share = 1) {
  const scanline::Scene scene = scene_of(solids, share);
  const FieldScene fields(scene, 1);
  Comparison result;
  for (int n = 0; n < rays; ++n) {
    const glm::dvec3 origin = random.vector(8), direction = (random.vector(4) - origin) * random.between(0.01, 3);
    const double from = n % 3 == 0 ? random.between(0, 1) : 0, to = n % 5 == 0 ? random.between(1, 2) : 1e3;
    const Expected e = expected(solids, origin, direction, from, to);
    if (e.is_close) {
      ++result.close;
      continue;
    }
    FieldCost cost;
    const auto hit = fields.first_hit(origin, direction, from, to, cost);
    bool right = hit.has_value() == e.is_hit;
    if (right && hit) {
      const glm::dvec3 position = origin + static_cast<double>(e.t) * direction;
      const double exact = 1e-9 * (1 + glm::distance(position, origin));
      right = hit->object == e.object && glm::distance(hit->position, position) < exact &&
              std::abs(hit->t - static_cast<double>(e.t)) * glm::length(direction) < exact;
      // Where a box's sides meet, either normal is right.
      const glm::dvec3 normal = normal_at(solids[e.object], position);
      const bool edge = solids[e.object].kind == Kind::Box && glm::dot(normal, hit->normal) < 0.999;
      right &= edge || glm::distance(hit->normal, normal) < 1e-7;
    }
    ++(e.is_hit ? result.hits : result.misses);
    result.wrong += right ? 0 : 1;
  }
  return result;
}

void expect_right(const Comparison& c, int hits, int misses) {
  EXPECT_EQ(c.wrong, 0);
  EXPECT_GT(c.hits, hits);
  EXPECT_GT(c.misses, misses);
  EXPECT_LT(c.close, (c.hits + c.misses) / 20);
}

class OfOne : public testing::TestWithParam<Kind> {};

TEST_P(OfOne, IsTheFirstRootThatLeadsInwards) {
  Random random(100 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.replay());
  Comparison sum;
  for (int n = 0; n < 20; ++n) sum += compare({random.solid(GetParam())}, random, 200);
  expect_right(sum, 100, 100);
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::Sphere: return "sphere";
    case Kind::Box: return "box";
    case Kind::Torus: return "torus";
    case Kind::Slab: return "slab";
    case Kind::Plane: return "plane";
  }
  return "";
}

INSTANTIATE_TEST_SUITE_P(field_march_first_hit, OfOne,
                         testing::Values(Kind::Sphere, Kind::Box, Kind::Torus, Kind::Slab, Kind::Plane),
                         [](const auto& chosen) { return name_of(chosen.param); });

Comparison compare_scenes(Random& random, const std::vector<Kind>& kinds, int scenes, int rays, double share = 1) {
  Comparison sum;
  for (int n = 0; n < scenes; ++n) {
    std::vector<Solid> solids;
    for (const Kind kind : kinds) solids.push_back(random.solid(kind));
    sum += compare(solids, random, rays, share);
  }
  return sum;
}

TEST(field_march_first_hit, of_many_solids_is_the_nearest) {
  Random random(7);
  SCOPED_TRACE(random.replay());
  const std::vector<Kind> kinds{Kind::Sphere, Kind::Box, Kind::Torus, Kind::Sphere,
                                Kind::Torus,  Kind::Box, Kind::Plane};
  expect_right(compare_scenes(random, kinds, 10, 200), 800, 200);
}

TEST(field_march_first_hit, needs_no_more_than_a_bound_of_the_distance) {
  Random random(8);
  SCOPED_TRACE(random.replay());
  expect_right(compare_scenes(random, {Kind::Torus, Kind::Box}, 10, 100, 0.3), 100, 100);
}

TEST(field_march_first_hit, is_seen_to_fail_where_a_field_promises_too_much) {
  Random random(9);
  SCOPED_TRACE(random.replay());
  EXPECT_GT(compare_scenes(random, {Kind::Torus, Kind::Box}, 10, 100, 8).wrong, 3);
}

TEST(field_march_first_hit, moves_with_the_object) {
  scanline::Scene scene = scene_of({Solid{}});
  scene.objects[0].keys = {{.frame = 1}, {.frame = 3, .translate = {0, 0, -4}}};
  FieldCost cost;
  for (const double moment : {1.0, 1.5, 2.0, 3.0, 9.0}) {
    const auto hit = FieldScene(scene, moment).first_hit({0, 0, 10}, {0, 0, -2}, 0, 100, cost);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (9 + 2 * (std::min(moment, 3.0) - 1)) / 2, 1e-12);
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
  }
}

TEST(field_march_first_hit, of_equal_surfaces_is_the_first_object) {
  const scanline::Scene scene = scene_of({Solid{}, Solid{}});
  FieldCost cost;
  EXPECT_EQ(FieldScene(scene, 1).first_hit({0, 0, 5}, {0, 0, -1}, 0, 100, cost)->object, 0u);
}

TEST(field_march_first_hit, ends_where_it_is_told) {
  const scanline::Scene scene = scene_of({Solid{}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  const auto hits = [&](double from, double to) {
    return fields.first_hit({-3, 0, 0}, {1, 0, 0}, from, to, cost).has_value();
  };
  EXPECT_TRUE(hits(0, 2 + 1e-6));
  EXPECT_FALSE(hits(0, 2 - 1e-6));
  EXPECT_TRUE(hits(2 - 1e-6, 100));
  EXPECT_FALSE(hits(2 + 1e-6, 100));
  EXPECT_FALSE(hits(4, 100));
}

TEST(field_march_first_hit, begins_on_a_surface_or_within) {
  Solid ring{Kind::Torus, {2, 0.5, 0}, {}};
  const scanline::Scene scene = scene_of({ring});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  const auto outwards = fields.first_hit({2.5, 0, 0}, {1, 0, 0}, 0, 100, cost);
  EXPECT_FALSE(outwards);
  const auto inwards = fields.first_hit({2.5, 0, 0}, {-1, 0, 0}, 0, 100, cost);
  ASSERT_TRUE(inwards);
  EXPECT_NEAR(inwards->t, 0, 1e-8);
  const auto across = fields.first_hit({1.5, 0, 0}, {-1, 0, 0}, 0, 100, cost);  // leaves the ring, meets the other side
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->t, 3, 1e-9);
  const auto from_within = fields.first_hit({2, 0, 0}, {-1, 0, 0}, 0, 100, cost);
  ASSERT_TRUE(from_within);
  EXPECT_NEAR(from_within->t, 3.5, 1e-9);
  EXPECT_FALSE(fields.first_hit({2, 0, 0}, {1, 0, 0}, 0, 100, cost));
}

TEST(field_march_first_hit, costs_what_it_asks) {
  Random random(10);
  SCOPED_TRACE(random.replay());
  Asked asked;
  const scanline::Scene scene = scene_of({random.solid(Kind::Torus), random.solid(Kind::Box)}, 1, &asked);
  const FieldScene fields(scene, 1);
  FieldCost cost;
  std::uint64_t hits = 0;
  for (int n = 0; n < 200; ++n) {
    const glm::dvec3 origin = random.vector(8);
    hits += fields.first_hit(origin, random.vector(3) - origin, 0, 10, cost) ? 1 : 0;
  }
  EXPECT_EQ(cost.rays, 200u);
  EXPECT_EQ(cost.evaluations, static_cast<std::uint64_t>(asked.distances + asked.normals));
  EXPECT_EQ(static_cast<std::uint64_t>(asked.normals), hits);
  EXPECT_EQ(cost.missed, 0u);
  // Past the bounds: nothing is asked. Straight at a sphere: little.
  FieldCost none;
  EXPECT_FALSE(fields.first_hit({0, 100, 0}, {1, 0, 0}, 0, 1e9, none));
  EXPECT_EQ(none, (FieldCost{1, 0, 0}));
  const scanline::Scene ball = scene_of({Solid{}});
  EXPECT_TRUE(FieldScene(ball, 1).first_hit({0, 0, 5}, {0, 0, -1}, 0, 100, none));
  EXPECT_LT(none.evaluations, 15u);
}

}  // namespace
}  // namespace field_march_tests
