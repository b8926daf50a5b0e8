// A closed mesh as a distance field.
#pragma once

#include <string>

#include "scanline/fields/primitives.h"
#include "scanline/mesh.h"

namespace scanline::fields {

/// What keeps a mesh from being the surface of a solid; empty when nothing does. Every edge must belong to two polygons
/// that run along it in opposite directions.
std::string mesh_fault(const Mesh& mesh);

/// Exact distances to the polygons; inside and outside by the normal of the nearest face, edge or vertex, the latter
/// weighted by angles (Baerentzen, Aanaes 2005), which is right where the mesh does not cross itself. One that is
/// inside out is turned. The mesh must be without fault.
FieldPointer mesh_field(const Mesh& mesh);

}  // namespace scanline::fields
