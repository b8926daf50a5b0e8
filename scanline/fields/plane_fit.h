// The vertex that dual contouring puts into a cell: where the planes that touch the surface at the cell's edges meet
// (Ju, Losasso, Schaefer, Warren: "Dual Contouring of Hermite Data", 2002).
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "scanline/field.h"

namespace scanline {

/// The surface at an edge of the lattice.
struct Crossing {
  glm::dvec3 point{0}, normal{0};
};

struct PlaneFit {
  glm::dvec3 point{0};
  std::optional<glm::dvec3> meeting;
};

/// The point inside `room` with the least sum of squared distances from the planes; where they leave directions open,
/// next to the crossings' mean. On flat parts that is the mean itself, on the edge of a solid it lies on the edge, in a
/// corner it is the corner. `meeting`: where the planes meet, when that is outside the room.
PlaneFit fit_planes(std::span<const Crossing> crossings, const Bounds& room);

}  // namespace scanline
