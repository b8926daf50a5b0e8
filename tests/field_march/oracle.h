// Solids whose meetings with a ray are roots of polynomials, found in extended precision; the fields of the same
// solids; scenes that hold them. Nothing but the scene is shared with what is tested.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "scanline/field_scene.h"

namespace field_march_tests {

using Real = long double;
using Vector = std::array<Real, 3>;

/// A solid is where a function is negative; along a ray from `origin` in lengths of `direction`, both in the solid's
/// own space, that is a union of intervals. Entries and exits, in order; infinite where there is no end.
using Intervals = std::vector<std::pair<Real, Real>>;

enum class Kind { Sphere, Box, Torus, Slab, Plane };

struct Solid {
  Kind kind = Kind::Sphere;
  /// Sphere: radius. Box: half of its sides. Torus around y: radius of the ring, of its body. Slab: half of its
  /// thickness along y. Plane: all below y = 0.
  std::array<double, 3> size{1, 1, 1};
  scanline::TransformKey key;
};

Intervals meetings(const Solid& solid, const glm::dvec3& origin, const glm::dvec3& direction);

/// The outward unit normal at a point of the surface (both in world space).
glm::dvec3 normal_at(const Solid& solid, const glm::dvec3& point);

/// Whether the ray meets the surface at `t` at an angle of less than a hundredth: marching along it takes long, and may
/// end before.
bool grazes(const Solid& solid, const glm::dvec3& origin, const glm::dvec3& direction, Real t);

/// The field of a solid in its own space, times `share`, and how often it was asked.
struct Asked {
  long distances = 0, normals = 0;
};
std::shared_ptr<const scanline::Field> field_of(const Solid& solid, double share = 1, Asked* asked = nullptr);

scanline::Object object_of(const Solid& solid, double share = 1, Asked* asked = nullptr);
scanline::Scene scene_of(const std::vector<Solid>& solids, double share = 1, Asked* asked = nullptr);

class Random {
 public:
  explicit Random(std::uint64_t own);
  double between(double low, double high);
  glm::dvec3 vector(double size);  ///< each coordinate from -size to size
  glm::dvec3 unit();
  Solid solid(Kind kind);  ///< placed, turned and stretched, within about 5 of the origin
  std::string replay() const;

 private:
  std::uint64_t seed_;
  std::mt19937_64 numbers_;
};

}  // namespace field_march_tests
