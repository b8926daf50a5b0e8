#include "cmodel/vsg/implied_edges.h"

namespace vsg {

void ImpliedEdges::start_line() {
  while (before_ != 0) {
    const SegmentPointer p = before_;
    before_ = w_.memory.read(p).x_next;
    w_.return_block(p);
  }
  before_ = now_;
  now_ = 0;
}

SamplePoint ImpliedEdges::crossing(SegmentPointer left, SegmentPointer right, std::int64_t x) {
  SegmentPointer previous = 0;
  for (SegmentPointer p = before_; p != 0;) {
    ++w_.tally.q[q::kSegmentReads];
    SegmentBlock block = w_.memory.read(p);
    if (block.polygon == left && block.polygon_next == right) {
      if (previous == 0) {
        before_ = block.x_next;
      } else {
        w_.memory.write(previous, kGroupXNext, block, w_.line);
      }
      return found_again(p, block, x);
    }
    previous = p;
    p = block.x_next;
  }
  // A crossing first seen on the last line that shows anything would never be found again.
  if (w_.line != w_.height - 1) wait(left, right, x);
  return {};
}

SamplePoint ImpliedEdges::found_again(SegmentPointer p, SegmentBlock& block, std::int64_t x) {
  block.left.dx = w_.x_format.wrap(x - block.left.x);
  block.left.x = x;
  const std::int64_t pixel = w_.next_pixel(block.left);
  if (!w_.inside(pixel)) {
    w_.return_block(p);
    return {};
  }
  x_sort_.insert_next_line(p, block, pixel);
  w_.memory.write(p, kGroupXLinks | kGroupLeft, block, w_.line);
  return {pixel, {p, 0}};
}

void ImpliedEdges::wait(SegmentPointer left, SegmentPointer right, std::int64_t x) {
  bool fresh = false;
  const SegmentPointer p = w_.take_block(fresh);
  if (fresh) samples_.clear(p);
  ++w_.tally.implied_edges;
  SegmentBlock block;
  block.x_next = now_;
  block.polygon = left;
  block.polygon_next = right;
  block.left.x = x;
  block.implied = true;
  now_ = p;
  w_.memory.write(p, kGroupAll, block, w_.line);
}

}  // namespace vsg
