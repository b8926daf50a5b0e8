// Edge blocks (figure 4), sorted by the scan line they enter on: a bucket a line, last in, first out. Edges that are
// horizontal or bound no front polygon are counted and rejected. rtl/vsg/edge_memory.sv
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/polygon_memory.h"

namespace vsg {

class EdgeMemory {
 public:
  /// Throws FrameError at the first edge that lies outside the scan lines of the frame or exceeds `capacity`.
  EdgeMemory(const FrameBlocks& frame, std::uint32_t capacity, const PolygonMemory& polygons, Tally& tally);

  /// First edge of a line's bucket, 0 when none enters.
  std::uint32_t bucket(int line) const { return buckets_[line]; }
  std::uint32_t next(std::uint32_t edge) const { return next_[edge]; }
  const EdgeBlock& edge(std::uint32_t number) const { return edges_[number - 1]; }

 private:
  const std::vector<EdgeBlock>& edges_;
  std::vector<std::uint32_t> buckets_, next_;
};

}  // namespace vsg
