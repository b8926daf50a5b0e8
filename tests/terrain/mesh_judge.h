// What a mesh of a terrain is, found from its triangles alone.
#pragma once

#include <glm/glm.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scanline/mesh.h"
#include "scanline/terrain/elevation.h"
#include "scanline/terrain/terrain_surface.h"

namespace terrain_tests {

/// An edge between two cells (their numbers, row by row), the lower one first.
using CellEdge = std::pair<int, int>;

class MeshJudge {
 public:
  MeshJudge(const scanline::Mesh& mesh, const scanline::TerrainSurface& surface);

  /// What is wrong with the mesh as a surface over the map, or nothing: a vertex that is not at a cell's centre, a
  /// triangle that does not look up, an edge that more than two triangles have or two in the same direction.
  std::string fault() const { return fault_; }
  /// Edges that one triangle alone has, those on the raster's border left out.
  const std::set<CellEdge>& open_edges() const { return open_; }
  /// In cells.
  double area() const { return area_; }
  const std::vector<glm::ivec2>& cells() const { return cells_; }

  /// Largest distance between a known cell's height and the mesh, in pixels for an eye at `eye` whose pixels are
  /// `angle` wide, or if `angle` is 0 in scene units.
  double largest_deviation(const glm::dvec3& eye, double angle) const;

 private:
  const scanline::Mesh& mesh_;
  const scanline::TerrainSurface& surface_;
  std::vector<glm::ivec2> cells_;  ///< of each vertex: column, row
  std::set<CellEdge> open_;
  std::string fault_;
  double area_ = 0;
};

}  // namespace terrain_tests
