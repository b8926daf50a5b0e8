// The arithmetic unit of the Depth Comparator (figures 12 and 13): four quadrants, each with the ends of a line, clipped
// towards one clip point by halving. Adders, shifts and comparisons only. rtl/vsg/clip_quadrant.sv
#pragma once

#include <cstdint>

namespace vsg {

/// One quadrant: X of both ends relative to the clip point, and Z as maximum and minimum with the sign bit that tells
/// which end is which.
struct ClipQuadrant {
  std::int64_t x_left = 0, x_right = 0;  ///< fixed point, clip point at 0
  std::int64_t z_min = 0, z_max = 0;
  bool rising = false;  ///< sign of Zleft - Zright: the left end holds the minimum

  void load(std::int64_t xl, std::int64_t xr, std::int64_t zmin, std::int64_t zmax, bool rises) {
    x_left = xl, x_right = xr, z_min = zmin, z_max = zmax, rising = rises;
  }

  /// One add cycle: the midpoint replaces the end that lies on its side of the clip point.
  void step() {
    const std::int64_t x = (x_left + x_right) >> 1, z = (z_min + z_max) >> 1;
    const bool replaces_left = x < 0;
    (replaces_left ? x_left : x_right) = x;
    (replaces_left == rising ? z_min : z_max) = z;
  }
};

/// What the gates of the comparator make of the four quadrants in one add cycle.
enum class ClipVerdict { kClip, kNewInFront, kBoxed, kNewBehind };

/// Relation of the new segment's extent in the span to that of the box.
struct ClipExtent {
  bool left_le = false, left_ge = false;    ///< new left end against the box's left end
  bool right_le = false, right_ge = false;  ///< and the right ends

  bool disjoint_ends() const { return (!left_ge && !right_ge) || (!left_le && !right_le); }
  bool inside() const { return left_ge && right_le; }
  bool covers() const { return left_le && right_ge; }
  bool same() const { return inside() && covers(); }
};

/// `new_behind_*`: the nearest Z of the new segment is not nearer than the farthest of the box at that clip point;
/// `old_behind_*`: the other way round. `exhausted`: no halving left.
ClipVerdict clip_verdict(const ClipExtent& extent, bool new_behind_left, bool old_behind_left, bool new_behind_right,
                         bool old_behind_right, bool exhausted);

}  // namespace vsg
