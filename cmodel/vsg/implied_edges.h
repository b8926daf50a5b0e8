// Implied edges (chapter III.I): where two segments cross, a block holds the crossing's X and its increment, so that it is
// a sample point of the lines to come. Found once, it waits in a list; found again on the next line, it gets its
// increment and enters the X-sort list; not found again, it goes back to the free list. rtl/vsg/implied_edges.sv
#pragma once

#include "cmodel/vsg/sample_list.h"
#include "cmodel/vsg/wiring.h"
#include "cmodel/vsg/x_sort.h"

namespace vsg {

class ImpliedEdges {
 public:
  ImpliedEdges(Wiring& wiring, XSort& x_sort, SampleList& samples) : w_(wiring), x_sort_(x_sort), samples_(samples) {}

  /// Returns the blocks of the line before last that were not found again.
  void start_line();

  /// Segments `left` and `right` cross at `x`. Returns the implied edge as a sample point of the next line when this
  /// crossing was there on the line before; pixel 0 otherwise.
  SamplePoint crossing(SegmentPointer left, SegmentPointer right, std::int64_t x);

 private:
  SamplePoint found_again(SegmentPointer p, SegmentBlock& block, std::int64_t x);
  void wait(SegmentPointer left, SegmentPointer right, std::int64_t x);

  Wiring& w_;
  XSort& x_sort_;
  SampleList& samples_;
  SegmentPointer before_ = 0;  ///< found on the line before, not yet matched
  SegmentPointer now_ = 0;     ///< found on this line
};

}  // namespace vsg
