// Where a scan line cuts the polygons of a frame, in double precision from the frame's own vertices: exact to a
// billionth of a pixel, and nothing of the machine's fixed point.
#pragma once

#include <cstdint>
#include <vector>

#include "scanline/frame.h"

namespace nodes {

struct LineCut {
  double left = 0, right = 0;  ///< it covers the pixels p with left < p <= right
  double left_z = 0, right_z = 0;

  bool covers(int pixel) const { return left < pixel && pixel <= right; }
  double depth(int pixel) const { return left_z + (right_z - left_z) * (pixel - left) / (right - left); }
  double slope() const;
};

/// All cuts of one scan line.
class LineCuts {
 public:
  /// Polygons that face away have none.
  LineCuts(const scanline::Frame& frame, int line);

  /// Of a polygon, numbered from 1; null where none covers the pixel.
  const LineCut* covering(std::uint32_t polygon, int pixel) const;
  const std::vector<LineCut>& of(std::uint32_t polygon) const { return cuts_[polygon - 1]; }
  /// Numbers of the polygons that the line cuts.
  const std::vector<std::uint32_t>& polygons() const { return polygons_; }

 private:
  std::vector<std::vector<LineCut>> cuts_;
  std::vector<std::uint32_t> polygons_;
};

}  // namespace nodes
