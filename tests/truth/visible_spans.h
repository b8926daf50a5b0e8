// Exact visible spans of a scan line: the lower envelope of the segments in which the polygons cut the plane y = line.
#pragma once

#include <vector>

#include "tests/truth/exact_frame.h"

namespace truth {

/// The pixels first..last show `polygons`: one, or several whose depths are equal there; none where the background
/// shows.
struct VisibleSpan {
  int first = 0, last = 0;
  std::vector<std::uint32_t> polygons;
};

/// Spans from pixel 1 to `width`, without gaps. A pixel samples at x = its number.
std::vector<VisibleSpan> visible_spans(const std::vector<Cut>& cuts, int width);

}  // namespace truth
