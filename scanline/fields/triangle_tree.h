// The nearest of many triangles: a tree of boxes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scanline/fields/geometry.h"
#include "scanline/mesh.h"

namespace scanline {

/// The corners of each triangle, as indices into a mesh's positions.
using Triangle = std::array<std::uint32_t, 3>;

/// Triangles that cover the same as a mesh's polygons, which need not be convex; the corners of a polygon that crosses
/// itself are joined to fans anyway.
std::vector<Triangle> triangles_of(const Mesh& mesh);

class TriangleTree {
 public:
  TriangleTree(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles);

  struct Nearest {
    std::uint32_t triangle = 0;
    TrianglePoint place;
    double distance = 0;
  };
  /// Nothing when all triangles are farther than `limit`, or there are none. Of several at the same distance any.
  std::optional<Nearest> nearest(const glm::dvec3& point, double limit = kInfinite) const;

  const std::vector<glm::dvec3>& positions() const { return positions_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Around all triangles.
  Bounds bounds() const { return nodes_.empty() ? Bounds{} : nodes_[0].box; }

 private:
  /// A leaf holds the triangles from `first` on; an inner node has its children at `first` and `first + 1`.
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;  ///< count 0: an inner node
  };
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, std::vector<glm::dvec3>& centers);
  std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const;

  std::vector<glm::dvec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;  ///< of triangles, as the leaves hold them
  std::vector<Node> nodes_;
};

}  // namespace scanline
