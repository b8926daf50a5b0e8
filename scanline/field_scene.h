// All distance fields of a scene at one moment, in world space: what the host of a node finds out about them, ray by
// ray.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scanline/field_line.h"
#include "scanline/scene.h"

namespace scanline {

/// What the host's work on fields costs. Callers add up their own; sums do not depend on who did what.
struct FieldCost {
  std::uint64_t rays = 0;         ///< marched
  std::uint64_t evaluations = 0;  ///< of the fields' distances and normals
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

  /// True when no object has a field. A flattened one (scaled to nothing along an axis) has none.
  bool empty() const { return objects_.empty(); }

  /// The first surface that the ray enters with from <= t <= to, by sphere tracing. One that begins within a solid does
  /// not meet that before it has left it. Nothing where the direction is zero. Fields without bounds end at 1000 times
  /// the camera's farthest distance where `to` is infinite.
  std::optional<FieldHit> first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to,
                                    FieldCost& cost) const;

  /// The true surface of one object near the point at `t` where the ray meets its polygons; nothing where the line of
  /// sight misses it (counted in the cost).
  std::optional<FieldHit> recover(std::uint32_t object, const glm::dvec3& origin, const glm::dvec3& direction, double t,
                                  FieldCost& cost) const;
  glm::dvec3 normal(std::uint32_t object, const glm::dvec3& point, FieldCost& cost) const;

  /// 1 where nothing stands between a point of a surface and the light, 0 where a field does, or the surface itself as
  /// it is turned away; 1 for ambient lights, and for lights of the shading language without a parameter `position` or
  /// `direction`. `normal` lifts the start of the ray off the surface. A ray that keeps so close to a surface that it
  /// does neither meet it nor get away within 5000 steps sees the light.
  double visibility(const glm::dvec3& point, const glm::dvec3& normal, const Light& light, FieldCost& cost) const;

  /// What a mirror at the point shows of the fields: the first one in the mirrored direction, with its surface's
  /// parameter `color` or `rgb` (0.8 each where it has none), lit diffusely by the scene's lights (a second reflection
  /// is not followed), or the scene's background. Lights of the shading language give their parameters `rgb` times
  /// `intensity`, those without a parameter `position` or `direction` nothing. Shadows only where the scene asks for
  /// them. `view` leads from the eye to the point and has any length.
  glm::dvec3 reflection(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& view,
                        FieldCost& cost) const;

 private:
  struct Placed {
    std::uint32_t object;
    const Field* field;
    Bounds bounds;         ///< the field's
    glm::dmat4 to_field;   ///< world to the field's own space
    glm::dmat3 to_normal;  ///< normals of the field to the world, not normalised
  };

  FieldLine line(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction, FieldCost& cost) const;
  FieldHit hit(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction, double t,
               FieldCost& cost) const;
  const Placed* find(std::uint32_t object) const;
  glm::dvec3 lifted(const glm::dvec3& point, const glm::dvec3& normal) const;

  const Scene& scene_;
  std::vector<Placed> objects_;  ///< in order of `object`
  glm::dvec3 eye_;
  double reach_;  ///< of rays without an end
};

}  // namespace scanline
