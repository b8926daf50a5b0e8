// X-sort list: the segments of a scan line in the order of their left edges, with back pointers (chapter III.F). While
// the list of this line is consumed from its front, the list of the next line grows at its end. rtl/vsg/x_sort.sv
#pragma once

#include "cmodel/vsg/wiring.h"

namespace vsg {

/// The groups that hold a block's links in the X-sort list.
constexpr unsigned kGroupXLinks = kGroupXPrevious | kGroupXNext;

class XSort {
 public:
  explicit XSort(Wiring& wiring) : w_(wiring) {}

  /// The list built for the next line becomes the list of this one.
  void start_line();

  // --- from the Segment Eliminator

  /// Inserts a block just made complete into this line's list: the search runs forward from `start` (0: the front).
  /// Sets the block's links; the caller writes them with the rest of the block.
  void insert(SegmentPointer p, SegmentBlock& block, SegmentPointer start);
  /// Takes a block out of this line's list; its own word stays as it is.
  void unlink(SegmentPointer p, const SegmentBlock& block);

  // --- from the Depth Comparator

  SegmentPointer front() const { return first_; }
  /// Removes the front, whose word is `block`.
  void pop(const SegmentBlock& block) { first_ = first_ == last_ ? 0 : block.x_next; }
  /// Inserts into the next line's list: at its end, or as far back as `pixel` (of the left edge on that line) demands.
  /// Sets the block's links; the caller writes them.
  void insert_next_line(SegmentPointer p, SegmentBlock& block, std::int64_t pixel);

 private:
  /// Puts `p` between two neighbours of a list, 0 for none.
  void link(SegmentPointer p, SegmentBlock& block, SegmentPointer before, SegmentPointer after, SegmentPointer& first,
            SegmentPointer& last);

  Wiring& w_;
  SegmentPointer first_ = 0, last_ = 0;
  SegmentPointer next_first_ = 0, next_last_ = 0;
  std::int64_t next_last_pixel_ = 0;  ///< of next_last_: appending needs no access
};

}  // namespace vsg
