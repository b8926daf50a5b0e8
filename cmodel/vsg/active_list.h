// Active list (chapter III.F): segments already taken from the X-sort list that reach beyond the right sample point. Those
// that end inside the span go to a second list, in case the span is subdivided. rtl/vsg/active_list.sv
#pragma once

#include "cmodel/vsg/wiring.h"

namespace vsg {

class ActiveList {
 public:
  explicit ActiveList(Wiring& wiring) : w_(wiring) {}

  void start_line() { first_ = 0; }
  void start_span() { ending_ = 0; }
  SegmentPointer first() const { return first_; }

  /// Takes a segment, whose successor is `next`, out of the list; `previous` is the one before it, 0 for none.
  void remove(SegmentPointer previous, SegmentPointer next);
  /// Sets the link of a segment that ends in the span and puts it into that list; the caller writes kGroupActive.
  void add_ending(SegmentPointer p, SegmentBlock& block) {
    block.active_next = ending_;
    if (ending_ == 0) ending_last_ = p;
    ending_ = p;
  }
  /// Likewise for a segment that reaches beyond the span.
  void add(SegmentPointer p, SegmentBlock& block) {
    block.active_next = first_;
    first_ = p;
  }
  /// The span is subdivided: segments that ended in it are active again, in front of the others.
  void restore_ending();

 private:
  Wiring& w_;
  SegmentPointer first_ = 0, ending_ = 0, ending_last_ = 0;
};

}  // namespace vsg
