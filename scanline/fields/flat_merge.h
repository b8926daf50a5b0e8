// Fewer polygons for the same surface: the machine takes polygons of any number of sides, and works by the edge.
#pragma once

#include "scanline/mesh.h"

namespace scanline {

/// Joins neighbours that lie in one plane into one polygon, convex or not, without holes; then leaves out vertices that
/// lie on a line between two polygons. `tolerance`: how far from plane or line a vertex may be. For closed meshes whose
/// vertex pairs have one edge each: the result is one, too. A merged corner keeps the attributes of one of its own.
void merge_flat(Mesh& mesh, double tolerance);

}  // namespace scanline
