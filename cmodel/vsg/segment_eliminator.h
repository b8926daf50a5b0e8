// Segment Eliminator (chapter III.B, figure 7): packs the segment lists of the changing polygons, so that every block has
// both edges, returns empty blocks, and enters complete ones into the X-sort list. rtl/vsg/segment_eliminator.sv
#pragma once

#include "cmodel/vsg/wiring.h"
#include "cmodel/vsg/x_sort.h"

namespace vsg {

class SegmentEliminator {
 public:
  SegmentEliminator(Wiring& wiring, XSort& x_sort) : w_(wiring), x_sort_(x_sort) {}
  void run();

 private:
  void pack(std::int32_t polygon);
  /// Gives `block` the right edge that it lacks, from the blocks that follow it.
  unsigned take_right_edge(SegmentBlock& block);

  Wiring& w_;
  XSort& x_sort_;
};

}  // namespace vsg
