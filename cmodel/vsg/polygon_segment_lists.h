// Polygon segment lists: the segments of one polygon on a scan line, left to right (chapter III.A). An entering edge finds
// its place here: an empty half of a block, or a new block. rtl/vsg/polygon_segment_lists.sv
#pragma once

#include "cmodel/vsg/polygon_memory.h"
#include "cmodel/vsg/sample_list.h"
#include "cmodel/vsg/wiring.h"

namespace vsg {

class PolygonSegmentLists {
 public:
  PolygonSegmentLists(Wiring& wiring, SampleList& samples) : w_(wiring), samples_(samples) {}

  /// Inserts an edge that enters on this line into the list of a polygon.
  void insert(const EdgeBlock& edge, std::uint32_t number, std::int32_t polygon);

 private:
  enum class Place { kRightOfPrevious, kLeftOfPrevious, kNewBlock, kSplit };
  /// Where the edge belongs: `previous` and the `next` block after it, 0 for none; `found` is the word of `previous`.
  Place find(const EdgeBlock& edge, std::int32_t polygon, SegmentPointer& previous, SegmentPointer& next,
             SegmentBlock& found);
  /// Is the entering edge left of `e` on this line? Equal X: the slope decides.
  bool left_of(const EdgeBlock& edge, const SegmentEdge& e) const;

  Wiring& w_;
  SampleList& samples_;
};

}  // namespace vsg
