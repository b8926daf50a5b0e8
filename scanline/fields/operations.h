// Fields made of fields. Each keeps the contract of scanline/field.h: what changes by no more than 1 over a length of 1
// stays so under minimum, maximum and blends of the two, and such a function never exceeds the distance to where it is
// zero.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scanline/fields/primitives.h"

namespace scanline::fields {

/// All of these take at least one field.
FieldPointer join(std::vector<FieldPointer> parts);
FieldPointer intersect(std::vector<FieldPointer> parts);

/// The first without all others.
FieldPointer subtract(std::vector<FieldPointer> parts);

/// A union whose parts flow into one another where their distances differ by less than `radius` (the polynomial blend):
/// taken in order, each with all before it. The surface lies up to a quarter of `radius` outside the parts, for each
/// part after the first.
FieldPointer smooth_join(std::vector<FieldPointer> parts, double radius);

/// Copies at a distance of `spacing` along each axis; 0: no copies along that axis. `counts`: how many, centred around
/// the origin; 0: without end, one of them in the origin. Copies may overlap; along an axis with copies the part must
/// be bounded and at most kMostOverlap spacings long.
constexpr double kMostOverlap = 4;
FieldPointer repeat(FieldPointer part, const glm::dvec3& spacing, const glm::ivec3& counts);

struct Placement {
  glm::dvec3 translate{0}, rotate{0};  ///< rotate: degrees about x, then y, then z
  double scale = 1;                    ///< positive; applied first, the translation last
  friend bool operator==(const Placement&, const Placement&) = default;
};
FieldPointer place(FieldPointer part, const Placement& placement);

}  // namespace scanline::fields
