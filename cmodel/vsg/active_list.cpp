#include "cmodel/vsg/active_list.h"

namespace vsg {

void ActiveList::remove(SegmentPointer previous, SegmentPointer next) {
  if (previous == 0) {
    first_ = next;
    return;
  }
  SegmentBlock link;
  link.active_next = next;
  w_.memory.write(previous, kGroupActive, link, w_.line);
}

void ActiveList::restore_ending() {
  if (ending_ == 0) return;
  SegmentBlock link;
  link.active_next = first_;
  w_.memory.write(ending_last_, kGroupActive, link, w_.line);
  first_ = ending_;
  ++w_.tally.q[q::kSegmentReads];
  ++w_.tally.q[q::kSegmentWrites];
}

}  // namespace vsg
