// Polygon meshes with named attributes at their corners.
//
// Positions are shared: two polygons that meet at a point name the same vertex, so that the edge between them is one
// edge block. Attributes belong to corners (a vertex as one polygon uses it), because a flat normal or a texture seam
// differs between neighbours where the position does not; a mesh split at such seams would lose its shared edges.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace scanline {

/// Polygons as vertex indices from 0, any number of vertices, convex or not.
using PolygonList = std::vector<std::vector<std::uint32_t>>;

/// A value for every corner, polygon by polygon: corner k of polygon p has the `components` values that start at
/// components * (first_corners(polygons)[p] + k).
struct MeshAttribute {
  std::string name;    ///< "normal", "uv", "color", or what a file calls it
  int components = 3;  ///< 1 to 4
  std::vector<double> values;
};

/// In object space, counter-clockwise in front. Zeros stand where a corner has no value of its own (a consumer of
/// "normal" then takes the polygon's).
struct Mesh {
  std::vector<glm::dvec3> positions;
  PolygonList polygons;
  std::vector<MeshAttribute> attributes;
};

/// Number of corners before each polygon, and of all at the end (one entry more than polygons).
std::vector<std::uint32_t> first_corners(const PolygonList& polygons);

/// Gathers a mesh polygon by polygon. Vertices of exactly equal position become one; polygons without area (fewer
/// than three different vertices, or collinear ones) are left out silently, as real meshes have them. One that crosses
/// itself is kept, even if its parts cancel.
class MeshBuilder {
 public:
  struct Attribute {
    std::string name;
    int components;
  };

  /// Every corner will carry these attributes, in this order.
  explicit MeshBuilder(std::vector<Attribute> attributes = {});

  std::uint32_t vertex(const glm::dvec3& position);

  /// From here on vertices are no longer joined to earlier ones: a new solid begins.
  void begin_part() { index_.clear(); }

  /// `corners`: all attributes of the first vertex, then of the second...; empty when the mesh has none.
  void polygon(std::span<const std::uint32_t> vertices, std::span<const double> corners = {});

  /// Values a corner carries.
  int stride() const { return stride_; }
  Mesh take() { return std::move(mesh_); }

 private:
  struct PositionHash {
    std::size_t operator()(const std::array<double, 3>& p) const;
  };
  Mesh mesh_;
  int stride_ = 0;
  std::unordered_map<std::array<double, 3>, std::uint32_t, PositionHash> index_;
};

}  // namespace scanline
