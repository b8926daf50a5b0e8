// What the distance fields share: numbers that stay in reach, boxes, and the point of a triangle next to another point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <memory>

#include "scanline/field.h"

namespace scanline {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The nearest point whose coordinates can be squared and added without leaving the doubles' range. Taking a point to
/// a convex set's nearest point brings it no farther from anything in the set: bounds of distances stay bounds.
inline glm::dvec3 reachable(const glm::dvec3& p) {
  constexpr double kReach = 1e150;
  return glm::clamp(p, glm::dvec3(-kReach), glm::dvec3(kReach));
}

/// `v` at length 1; `otherwise` where it has none, or is no vector of numbers.
inline glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return otherwise;
  const glm::dvec3 scaled = v / largest;
  const glm::dvec3 unit = scaled / glm::length(scaled);
  return std::isfinite(unit.x + unit.y + unit.z) ? unit : otherwise;
}

/// The vector from the nearest point of a box (whose sides may be infinite) to `p`; zero inside.
inline glm::dvec3 from_box(const Bounds& box, const glm::dvec3& p) {
  return glm::max(p - box.high, 0.0) - glm::max(box.low - p, 0.0);
}

inline bool is_finite(const Bounds& box) {
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(box.low[k]) || !std::isfinite(box.high[k])) return false;
  }
  return true;
}

/// The box of a field's solid, at hand when its distance is asked for. Outside that box both are bounds, and the
/// greater is the better one.
struct BoundedField {
  explicit BoundedField(std::shared_ptr<const Field> of) : field(std::move(of)), box(field->bounds()) {}

  double distance(const glm::dvec3& p) const {
    const glm::dvec3 outside = from_box(box, p);
    const double distance = field->distance(p);
    return outside == glm::dvec3(0) ? distance : std::max(distance, glm::length(outside));
  }

  std::shared_ptr<const Field> field;
  Bounds box;
};

/// The point of the triangle abc next to p, and where on the triangle it lies.
struct TrianglePoint {
  glm::dvec3 point{0};
  enum Feature { kFace, kEdgeAb, kEdgeBc, kEdgeCa, kA, kB, kC } feature = kFace;
};
TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& p);

/// Rotation about x, then y, then z, by degrees; quarter turns are exact.
glm::dmat3 rotation(const glm::dvec3& degrees);

}  // namespace scanline
