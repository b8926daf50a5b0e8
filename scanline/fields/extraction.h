// Polygons of a distance field, for machines that want polygons: dual contouring on a lattice, with one vertex for each
// sheet of the surface in a cell.
#pragma once

#include "scanline/field.h"
#include "scanline/fields/field_error.h"
#include "scanline/mesh.h"
#include "vsg_parameters.h"

namespace scanline {

constexpr int kFewestCells = 2, kMostCells = 512;
constexpr std::size_t kMostSurfaceCells = 1'000'000;
/// What the machine's memory of polygons holds.
constexpr std::size_t kMostPolygons = vsg::kPolygonBlocks;

/// A closed mesh of planar polygons, outside in front; every edge belongs to exactly two of them. Vertices lie on the
/// solid's edges and corners where it has such; flat parts become large polygons, whatever the number of cells. What
/// is thinner than a cell may be lost. Corners carry "normal", the field's.
/// `cells`: along the longest side of the field's box, kFewestCells to kMostCells. The field's bounds must be finite.
/// No polygons when no corner of the lattice is inside the solid.
Mesh extract_surface(const Field& field, int cells);

struct MeasuredSurface {
  Mesh mesh;
  int cells = 0;
  FieldError error;
};

/// More and more cells, until the polygons are within `error` of the surface and the surface within `error` of the
/// polygons. When that takes more than kMostCells or more polygons than kMostPolygons, the best that was reached: its
/// error tells.
MeasuredSurface extract_within(const Field& field, double error);

}  // namespace scanline
