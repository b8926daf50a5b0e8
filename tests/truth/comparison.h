// Where the Visible Segment Generator's answer differs from the exact one, and why.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cmodel/vsg/blocks.h"
#include "tests/truth/exact_frame.h"

namespace truth {

/// Why a pixel shows another polygon than it should; in the order in which they are tried.
enum class Difference : std::uint8_t {
  kDepth,  ///< both cover the pixel, their depths differ by no more than one pixel's worth of both slopes: the clipper
           ///< stops when its brackets are one pixel wide
  kChain,  ///< the same by way of a third polygon
  kStart,  ///< the polygon shown begins right of the sample, inside the pixel that follows: an edge that falls on the
           ///< first pixel of a span fills it
  kLeft,   ///< the same at the left border, where the first span begins at pixel 2
  kEdge,   ///< an edge of one of the two lies within a pixel: slopes are truncated, edges may even cross
  kOther,  ///< none of these: an error of ours
};
constexpr std::array<std::string_view, 6> kDifferenceNames{"depth", "chain", "start", "left", "edge", "other"};

struct Comparison {
  std::int64_t pixels = 0;   ///< of the frame
  std::int64_t covered = 0;  ///< that show a polygon in truth
  std::int64_t ties = 0;     ///< that show one of several polygons of equal depth: right, whichever it is
  std::array<std::int64_t, kDifferenceNames.size()> wrong{};
  int longest_run = 0;  ///< neighbouring wrong pixels

  std::int64_t wrong_total() const;
  std::int64_t of(Difference kind) const { return wrong[static_cast<std::size_t>(kind)]; }
  Comparison& operator+=(const Comparison& other);
};

/// Compares an answer, in output order, with the exact spans of every scan line.
Comparison compare(const ExactFrame& frame, bool keep_back_faces, const std::vector<vsg::VisibleSegment>& answer);

}  // namespace truth
