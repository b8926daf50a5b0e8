// All distance fields of a scene at one moment, in world space: what the host of a node finds out about them, ray by
// ray.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scanline/scene.h"

namespace scanline {

/// What the host's work on fields costs. Callers add up their own; sums do not depend on who did what.
struct FieldCost {
  std::uint64_t rays = 0;         ///< marched
  std::uint64_t evaluations = 0;  ///< of Field::distance, those of normals included
  std::uint64_t missed = 0;       ///< pixels of a field's polygons whose line of sight misses the field itself
  FieldCost& operator+=(const FieldCost& other);
  friend bool operator==(const FieldCost&, const FieldCost&) = default;
};

struct FieldHit {
  std::uint32_t object = 0;  ///< index into Scene::objects
  double t = 0;              ///< along the ray, in lengths of its direction
  glm::dvec3 position{0};
  glm::dvec3 normal{0};  ///< unit, outwards
};

/// Immutable: any number of threads may ask. The scene must outlive it. All rays and points are in world space.
class FieldScene {
 public:
  FieldScene(const Scene& scene, double moment);

  /// True when no object has a field.
  bool empty() const { return objects_.empty(); }

  /// The first surface that the ray enters with from <= t <= to; sphere tracing of all objects at once.
  std::optional<FieldHit> first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to,
                                    FieldCost& cost) const;

  /// The true surface of one object near the point at `t` where the ray meets its polygons; nothing where the line of
  /// sight misses it (counted in the cost).
  std::optional<FieldHit> recover(std::uint32_t object, const glm::dvec3& origin, const glm::dvec3& direction, double t,
                                  FieldCost& cost) const;
  glm::dvec3 normal(std::uint32_t object, const glm::dvec3& point, FieldCost& cost) const;

  /// 1 where nothing stands between a point of a surface and the light, 0 where a field does; 1 for ambient lights, and
  /// for lights of the shading language without a parameter `position` or `direction`. `normal` lifts the start of the
  /// ray off the surface.
  double visibility(const glm::dvec3& point, const glm::dvec3& normal, const Light& light, FieldCost& cost) const;

  /// What a mirror at the point shows of the other fields: the color of the first one in the mirrored direction, lit
  /// diffusely by the scene's lights (a second reflection is not followed), or the scene's background.
  glm::dvec3 reflection(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& view,
                        FieldCost& cost) const;

 private:
  struct Placed {
    std::uint32_t object;
    glm::dmat4 to_field;  ///< world to the field's own space
    glm::dmat4 to_world;
  };
  const Scene& scene_;
  std::vector<Placed> objects_;
};

}  // namespace scanline
