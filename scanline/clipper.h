// Clips polygons against the viewing box in clip space (homogeneous coordinates), plane by plane.
//
// A polygon may have any number of vertices and need not be convex: where a plane cuts it into pieces, the pieces
// become polygons of their own. (The usual way leaves one polygon whose pieces hang together by two edges on top of
// each other along the border, and the processor would see edges that touch and cross there.) The crossings of a
// planar polygon with a plane lie on a line; sorted along it, they pair up to the pieces' new edges.
//
// A vertex made by clipping belongs to the edge it cuts, not to the polygon: two polygons that share the edge get the
// same vertex, computed from the lower numbered end to the higher, so the edge stays shared and without cracks.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <unordered_map>
#include <vector>

namespace scanline {

/// A vertex as one polygon uses it: `vertex` has the position, `corner` the attribute values.
struct ClipCorner {
  std::uint32_t vertex = 0;
  std::uint32_t corner = 0;
};
using ClipLoop = std::vector<ClipCorner>;

class Clipper {
 public:
  static constexpr int kPlanes = 6;

  /// Positions of one object's vertices in clip space and in the world, and `stride` values for every corner.
  Clipper(std::vector<glm::dvec4> clip, std::vector<glm::dvec3> world, std::vector<double> corners, int stride);

  /// Clips one polygon; its corners are numbered from `first_corner`. The result holds until the next call.
  const std::vector<ClipLoop>& clip(std::span<const std::uint32_t> polygon, std::uint32_t first_corner);

  /// Sources first, then vertices made by clipping.
  std::size_t vertex_count() const { return clip_.size(); }
  const glm::dvec4& position(std::uint32_t vertex) const { return clip_[vertex]; }
  const glm::dvec3& world(std::uint32_t vertex) const { return world_[vertex]; }
  std::span<const double> corner(std::uint32_t corner) const {
    return {corners_.data() + std::size_t{corner} * stride_, stride_};
  }

 private:
  struct Cut {
    std::uint32_t low, high, plane;
    bool operator==(const Cut&) const = default;
  };
  struct CutHash {
    std::size_t operator()(const Cut& cut) const;
  };

  /// Distance from a plane in clip space; inside is positive.
  double distance(std::uint32_t vertex, std::uint32_t plane) const;
  void clip_loop(const ClipLoop& loop, std::uint32_t plane, std::vector<ClipLoop>& result);
  ClipCorner crossing(const ClipCorner& inside, const ClipCorner& outside, std::uint32_t plane);
  std::vector<std::size_t> link(const std::vector<ClipLoop>& chains) const;

  std::vector<glm::dvec4> clip_;
  std::vector<glm::dvec3> world_;
  std::vector<double> corners_;
  std::size_t stride_;
  std::uint32_t corner_count_;
  std::vector<std::uint8_t> below_, not_above_;  ///< by source vertex, a bit a plane: distance < 0, distance <= 0
  std::unordered_map<Cut, std::uint32_t, CutHash> cuts_;
  std::vector<ClipLoop> loops_, next_loops_;
};

}  // namespace scanline
