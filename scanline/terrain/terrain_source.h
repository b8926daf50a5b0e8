// Terrain for a viewer: few polygons far away, many nearby. A right-triangulated irregular network: right isosceles
// triangles that are halved from the middle of the longest side, where both that share the side are halved together, so
// that there are neither cracks nor T-junctions (Evans, Kirkpatrick and Townsend 1997).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scanline/mesh_source.h"
#include "scanline/terrain/terrain_surface.h"

namespace scanline {

class TerrainSource : public MeshSource {
 public:
  /// `detail`: on the screen no cell's height deviates by more pixels from the polygon that stands for it (in the
  /// picture's middle; by less where the line of sight is steep). `file` is named in errors.
  TerrainSource(TerrainSurface surface, double detail, std::string file);

  /// Every polygon is exact where its corners are: at centres of cells. Holes have the resolution of cells. Throws
  /// UserError for more than kMostTerrainPolygons.
  Mesh mesh(const Viewer& viewer) const override;
  std::vector<MeshBuilder::Attribute> attributes() const override { return TerrainSurface::attributes(); }

  const TerrainSurface& surface() const { return surface_; }

 private:
  /// A vertex of the network, which covers the rectangle with whole squares: what lies beyond the last column and row
  /// is moved onto them.
  struct Place {
    int x = 0, y = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// Two triangles (one at the border) with a common longest side from `a` to `b`, halved at `middle`.
  struct Diamond {
    Place middle, a, b, apexes[2];
    int triangles = 2;
  };
  /// Right triangle; `apex` is opposite to the longest side.
  struct Triangle {
    Place a, b, apex;
  };

  bool inside(const Place& p) const { return p.x >= 0 && p.y >= 0 && p.x < width_ && p.y < height_; }
  std::size_t index(const Place& p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(p.x);
  }
  TerrainCell cell(const Place& p) const;
  template <typename Visit>
  void each_diamond(Visit visit) const;
  double deviation(const Place& a, const Place& b, const Place& c) const;
  bool too_coarse(const Diamond& diamond, const Viewer& viewer) const;
  std::vector<bool> find_halved(const Viewer& viewer) const;
  template <typename Visit>
  void each_triangle(const std::vector<bool>& halved, Visit visit) const;

  TerrainSurface surface_;
  double detail_;
  std::string file_;
  int square_ = 1;              ///< side of the coarsest squares, a power of two
  int width_ = 0, height_ = 0;  ///< vertices of the network
  /// Metres by which cells deviate from the triangles that the vertex halves; infinite where one of them covers known
  /// and missing cells.
  std::vector<float> deviation_;
};

}  // namespace scanline
