// A field known by samples on a grid: cheap to ask, whatever it is made from.
#pragma once

#include "scanline/fields/primitives.h"

namespace scanline::fields {

constexpr int kMostGridCells = 256;

/// Samples `field`, whose bounds must be finite, in cubes: `cells` along its longest side, 2 to kMostGridCells. Between
/// the samples the value is trilinear. It is divided by the steepest slope that the samples allow in any cube, outside
/// and inside the solid each by its own (from 1 to the root of 3), so that its magnitude never exceeds the distance to
/// the surface that it has itself. What is thinner than a cube may be lost, and edges are rounded. Normals are
/// trilinear between those at the samples.
FieldPointer grid_field(const Field& field, int cells);

}  // namespace scanline::fields
