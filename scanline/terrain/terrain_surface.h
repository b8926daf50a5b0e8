// Heights as a surface in a scene: x to the east, -z to the north, y up, the middle of the rectangle above the origin.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "scanline/mesh.h"
#include "scanline/terrain/elevation.h"

namespace scanline {

/// A cell's place: column from the west, row from the north.
struct TerrainCell {
  int column = 0, row = 0;
  friend bool operator==(const TerrainCell&, const TerrainCell&) = default;
};

class TerrainSurface {
 public:
  /// `exaggeration` stretches heights alone. `unit`: scene units a metre, by default such that the longer side, from
  /// the first to the last cell's centre, is 1. `base`: the height in metres where y is 0, by default the lowest.
  /// Some cell is known.
  TerrainSurface(Elevation elevation, double exaggeration, std::optional<double> unit, std::optional<double> base);

  const Elevation& elevation() const { return elevation_; }
  int columns() const { return elevation_.columns; }
  int rows() const { return elevation_.rows; }
  bool known(const TerrainCell& cell) const { return elevation_.known(cell.column, cell.row); }
  /// y is NaN where the height is missing.
  glm::dvec3 position(const TerrainCell& cell) const;
  /// Scene units a metre of height, exaggeration included; may be negative.
  double height_scale() const { return height_scale_; }

  /// "normal" (3), "uv" (2: 0 to 1 from west to east and from south to north, over the cells' whole extent), "gradient"
  /// (2: slopes to the east and to the north as they look, exaggeration included), "height" (1: metres, as measured).
  static std::vector<MeshBuilder::Attribute> attributes();
  static constexpr int kValues = 8;
  std::array<double, kValues> values(const TerrainCell& cell) const;

 private:
  Elevation elevation_;
  double exaggeration_, unit_ = 1, height_scale_ = 1, base_ = 0;
};

/// More polygons than this are not made of a terrain.
constexpr std::size_t kMostTerrainPolygons = 2'097'152;

/// Gathers triangles between cells. Vertices are cells, shared by all triangles that name them.
class TerrainMesh {
 public:
  explicit TerrainMesh(const TerrainSurface& surface);

  /// In any order; the front looks up. Left out are triangles without area and those with a corner whose height is
  /// missing.
  void triangle(const TerrainCell& a, const TerrainCell& b, const TerrainCell& c);
  Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t vertex(const TerrainCell& cell);

  const TerrainSurface& surface_;
  Mesh mesh_;
  std::unordered_map<std::size_t, std::uint32_t> numbers_;
  std::vector<std::array<double, TerrainSurface::kValues>> values_;  ///< of each vertex
};

/// A mesh whose vertices are every `step`-th cell to the east and to the south, the last column and row included; each
/// rectangle between them is two triangles, cut alternately along either diagonal. Throws UserError, naming `file`,
/// for more than kMostTerrainPolygons.
Mesh terrain_grid(const TerrainSurface& surface, int step, const std::string& file);

}  // namespace scanline
