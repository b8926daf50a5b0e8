// How far a field's polygons are from its surface.
#pragma once

#include <algorithm>

#include "scanline/field.h"
#include "scanline/mesh.h"

namespace scanline {

/// In the field's units. Distances of points from the surface are measured along the field's gradient, and so are never
/// too small.
struct FieldError {
  double largest = 0;  ///< of all vertices, middles of edges, and points spread over the polygons
  double mean = 0;     ///< over the polygons' area
  double missed = 0;   ///< largest distance from the polygons of points of the surface, found on lines through the box

  double worst() const { return std::max(largest, missed); }
};

/// The same for the same field and mesh. The field's bounds must be finite.
FieldError measure(const Field& field, const Mesh& mesh);

}  // namespace scanline
