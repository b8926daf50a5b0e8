// The oracle of distances: a surface as patches over the unit square, and the point of it next to another found by
// search. It knows nothing of distance functions.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace fields_tests {

using Patch = std::function<glm::dvec3(double u, double v)>;

struct Solid {
  std::vector<Patch> surface;
  std::function<bool(const glm::dvec3&)> is_inside;
};

Solid sphere_solid(double radius);
Solid ellipsoid_solid(const glm::dvec3& radii);
Solid torus_solid(double radius, double thickness);
Solid frustum_solid(double radius, double top, double height);
Solid box_solid(const glm::dvec3& size);

/// The distance to the nearest point of all patches: the best of a lattice of parameters, then smaller and smaller
/// steps from there.
double nearest_distance(const std::vector<Patch>& surface, const glm::dvec3& point);

/// Points of a triangle.
Patch triangle_patch(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace fields_tests
