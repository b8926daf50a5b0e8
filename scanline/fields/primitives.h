// The solids that fields are made of (chapter 5.3 of the ray marching thesis: spheres, boxes, tori, planes, cylinders),
// around the origin, y up. All distances are exact up to rounding, unless said otherwise: inside, where a solid is a
// rounded one, they are bounds. Lengths must be positive and finite, at least a billionth of one another.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>

#include "scanline/field.h"

namespace scanline {

using FieldPointer = std::shared_ptr<const Field>;

/// Functions that make fields; how they are asked is the contract in scanline/field.h. Their bounds hold the whole
/// solid, not its surface alone.
namespace fields {

FieldPointer sphere(double radius);

/// Edges and corners rounded by `round`, at most half the smallest side.
FieldPointer box(const glm::dvec3& size, double round = 0);
/// A box by its corners.
FieldPointer box(const Bounds& corners);

/// All below a plane through the origin. The normal has any length but 0.
FieldPointer plane(const glm::dvec3& normal);

/// The middle of the ring's body runs at `radius`; the body is `thickness` in radius, less than `radius`.
FieldPointer torus(double radius, double thickness);

/// A frustum: a cylinder when the radii are equal, a cone when the upper one is 0.
FieldPointer frustum(double radius, double top_radius, double height);

/// The nearest point is found by Newton's method, down to rounding.
FieldPointer ellipsoid(const glm::dvec3& radii);

/// All that is within `thickness` of a triangle; one without area is a rod or a ball.
FieldPointer triangle(const std::array<glm::dvec3, 3>& corners, double thickness);

}  // namespace fields
}  // namespace scanline
