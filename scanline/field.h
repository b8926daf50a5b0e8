// Signed distance fields: solids given by the distance to their surface.
#pragma once

#include <glm/glm.hpp>

namespace scanline {

struct Bounds {
  glm::dvec3 low{0}, high{0};
};

/// A solid in its own space. Fields are immutable: any number of threads may ask.
class Field {
 public:
  virtual ~Field() = default;

  /// Negative inside, positive outside, zero on the surface; its magnitude is never more than the distance to the
  /// surface, so that a step of that length along a ray stays on this side of it. Finite for finite points.
  virtual double distance(const glm::dvec3& point) const = 0;

  /// Unit vector along the gradient, outwards on the surface. By central differences unless a field knows better; never
  /// zero and never NaN, also where the gradient does not exist.
  virtual glm::dvec3 normal(const glm::dvec3& point) const;

  /// A box that holds all of the surface; infinite where the surface is (a plane, a repetition).
  virtual Bounds bounds() const = 0;
};

}  // namespace scanline
