// What can be asked of a single polygon in space.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace scanline {

/// Newell's vector: along the normal (counter-clockwise in front), twice the area long.
glm::dvec3 newell_vector(std::span<const glm::dvec3> points);

/// False when the points coincide or lie on a line, as far as doubles can tell.
bool has_area(std::span<const glm::dvec3> points);

/// Largest distance of a vertex from the mean plane over the polygon's size. Chapter V: depth is interpolated between
/// the edges of a scan line, so a polygon out of its plane shows a horizontal discontinuity.
double unevenness(std::span<const glm::dvec3> points);

/// Above this unevenness a polygon counts as not planar: what modellers' quads commonly show stays below.
constexpr double kPlanarTolerance = 0.01;

/// True when two edges cross each other, seen along the axis from which most of the polygon is seen. Edges that only touch or lie on one another (as in the
/// bridge that joins a hole to its outline) do not cross.
bool crosses_itself(std::span<const glm::dvec3> points);

}  // namespace scanline
