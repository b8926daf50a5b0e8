// What sphere tracing needs of every field: a step as long as the distance never leads through the surface.
#include <gtest/gtest.h>

#include <cmath>

#include "scanline/fields/grid_field.h"
#include "scanline/fields/mesh_field.h"
#include "scanline/fields/operations.h"
#include "scanline/shapes.h"
#include "tests/fields/random_field.h"

namespace fields_tests {
namespace {

namespace fields = scanline::fields;
using scanline::Field;
using scanline::FieldPointer;

constexpr double kRounding = 1e-9;

/// Marches along random rays, and looks between the steps. Says what is wrong; empty when nothing is.
std::string overstep(const Field& field, Random& random, int rays) {
  for (int ray = 0; ray < rays; ++ray) {
    const glm::dvec3 origin = vector_between(random, -3, 3);
    const glm::dvec3 way = glm::normalize(vector_between(random, -1.5, 1.5) - origin);
    double t = 0;
    for (int step = 0; step < 60 && t < 8; ++step) {
      const glm::dvec3 p = origin + t * way;
      const double distance = field.distance(p), length = std::abs(distance);
      for (int k = 1; k <= 8; ++k) {
        // In the ray's direction, and in any other: the whole ball is on one side.
        const glm::dvec3 aside = glm::normalize(vector_between(random, -1, 1) + 1e-3);
        for (const glm::dvec3& q : {p + way * (length * k / 8), p + aside * (length * (k - 0.01) / 8)}) {
          const double there = field.distance(q);
          if ((there > kRounding && distance < -kRounding) || (there < -kRounding && distance > kRounding)) {
            return "from " + std::to_string(distance) + " to " + std::to_string(there) + " at " + std::to_string(q.x) +
                   " " + std::to_string(q.y) + " " + std::to_string(q.z);
          }
        }
      }
      t += std::max(length, 1e-3);
    }
  }
  return {};
}

/// No field changes by more than the way is long: what blends of fields are built on.
std::string too_steep(const Field& field, Random& random, int pairs) {
  for (int k = 0; k < pairs; ++k) {
    const glm::dvec3 p = vector_between(random, -2, 2);
    const glm::dvec3 q = p + vector_between(random, -1, 1) * std::pow(10.0, -between(random, 0, 5));
    const double change = std::abs(field.distance(p) - field.distance(q));
    if (change > glm::length(p - q) + kRounding)
      return std::to_string(change) + " over " + std::to_string(glm::length(p - q));
  }
  return {};
}

/// Sign against the question whether a point is inside, asked of the solids themselves.
std::string wrong_side(const RandomField& f, Random& random, int points) {
  for (int k = 0; k < points; ++k) {
    const glm::dvec3 p = vector_between(random, -2, 2);
    const double distance = f.field->distance(p);
    if (std::abs(distance) < kRounding) continue;
    if ((distance < 0) != f.is_inside(p)) return "distance " + std::to_string(distance);
    const scanline::Bounds box = f.field->bounds();
    if (distance < 0 && (glm::any(glm::lessThan(p, box.low)) || glm::any(glm::greaterThan(p, box.high)))) {
      return "inside, but not in the bounds";
    }
  }
  return {};
}

TEST(FieldsLowerBound, RandomFields) {
  const std::uint64_t seed = seed_or(21);
  int known = 0;
  for (std::uint64_t k = 0; k < 60; ++k) {
    Random random(seed + k);
    const RandomField f = random_field(random, static_cast<int>(k % 4), true);
    EXPECT_EQ(overstep(*f.field, random, 20), "") << f.text << ", " << replay(seed + k);
    EXPECT_EQ(too_steep(*f.field, random, 500), "") << f.text << ", " << replay(seed + k);
    if (!f.is_inside) continue;
    ++known;
    EXPECT_EQ(wrong_side(f, random, 200), "") << f.text << ", " << replay(seed + k);
  }
  EXPECT_GT(known, 20);
}

TEST(FieldsLowerBound, GridsAndMeshes) {
  const std::uint64_t seed = seed_or(22);
  for (std::uint64_t k = 0; k < 12; ++k) {
    Random random(seed + k);
    const RandomField f = random_field(random, static_cast<int>(k % 3), false);
    const FieldPointer grid = fields::grid_field(*f.field, 8 + static_cast<int>(k));
    EXPECT_EQ(overstep(*grid, random, 40), "") << "grid of " << f.text << ", " << replay(seed + k);
    EXPECT_EQ(too_steep(*grid, random, 500), "") << "grid of " << f.text << ", " << replay(seed + k);
  }
  Random random(seed);
  const FieldPointer mesh = fields::mesh_field(scanline::make_torus(0.7, 0.3, 9, 5));
  EXPECT_EQ(overstep(*mesh, random, 100), "") << replay(seed);
  EXPECT_EQ(overstep(*fields::grid_field(*mesh, 20), random, 100), "") << replay(seed);
}

TEST(FieldsLowerBound, EndlessRepetition) {
  const std::uint64_t seed = seed_or(23);
  Random random(seed);
  const FieldPointer part = fields::place(fields::box({0.5, 0.4, 0.9}), {{0.3, 0, 0.1}, {10, 20, 30}, 1});
  const FieldPointer field = fields::repeat(part, {0.8, 0.6, 1.1}, {0, 0, 0});
  EXPECT_EQ(overstep(*field, random, 200), "") << replay(seed);
  EXPECT_EQ(too_steep(*field, random, 5000), "") << replay(seed);
  for (int k = 0; k < 200; ++k) {
    const glm::dvec3 p = vector_between(random, -2, 2);
    bool inside = false;
    for (int i = 0; i < 1331; ++i) {
      const glm::dvec3 number(i % 11 - 5, i / 11 % 11 - 5, i / 121 - 5);
      inside |= part->distance(p - number * glm::dvec3(0.8, 0.6, 1.1)) < 0;
    }
    EXPECT_EQ(field->distance(p) < 0, inside) << replay(seed);
  }
}

/// A repetition as it is usually written: the nearest cell's copy alone.
class HastyRepetition final : public Field {
 public:
  explicit HastyRepetition(FieldPointer part) : part_(std::move(part)) {}
  double distance(const glm::dvec3& p) const override { return part_->distance(p - glm::round(p)); }
  scanline::Bounds bounds() const override { return part_->bounds(); }

 private:
  FieldPointer part_;
};

class Stretched final : public Field {
 public:
  explicit Stretched(FieldPointer part) : part_(std::move(part)) {}
  double distance(const glm::dvec3& p) const override { return 1.1 * part_->distance(p); }
  scanline::Bounds bounds() const override { return part_->bounds(); }

 private:
  FieldPointer part_;
};

TEST(FieldsLowerBound, MistakesAreCaught) {
  const std::uint64_t seed = seed_or(24);
  Random random(seed);
  EXPECT_NE(too_steep(Stretched(fields::sphere(0.7)), random, 100), "") << replay(seed);
  EXPECT_NE(overstep(Stretched(fields::sphere(0.7)), random, 20), "") << replay(seed);
  EXPECT_NE(overstep(HastyRepetition(fields::place(fields::sphere(0.2), {{0.3, 0, 0}, {}, 1})), random, 200), "")
      << replay(seed);
  RandomField wrong = random_field(random, 0, false);
  wrong.is_inside = [inside = wrong.is_inside](const glm::dvec3& p) { return inside(p * 0.9); };
  EXPECT_NE(wrong_side(wrong, random, 20000), "") << replay(seed);
}

}  // namespace
}  // namespace fields_tests
