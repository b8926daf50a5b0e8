#include "cmodel/vsg/x_sort.h"

namespace vsg {

void XSort::start_line() {
  first_ = next_first_;
  last_ = next_last_;
  next_first_ = next_last_ = 0;
}

void XSort::link(SegmentPointer p, SegmentBlock& block, SegmentPointer before, SegmentPointer after,
                 SegmentPointer& first, SegmentPointer& last) {
  block.x_previous = before;
  block.x_next = after;
  SegmentBlock neighbour;
  if (before != 0) {
    neighbour.x_next = p;
    w_.memory.write(before, kGroupXNext, neighbour, w_.line);
  } else {
    first = p;
  }
  if (after != 0) {
    neighbour.x_previous = p;
    w_.memory.write(after, kGroupXPrevious, neighbour, w_.line);
  } else {
    last = p;
  }
}

void XSort::insert(SegmentPointer p, SegmentBlock& block, SegmentPointer start) {
  const std::int64_t pixel = w_.next_pixel(block.left);
  SegmentPointer before = start, after = first_;
  if (before != 0) after = w_.memory.read(before).x_next;
  for (;;) {
    if (before == last_) after = 0;
    ++w_.tally.q[q::kSegmentReads];
    if (after == 0) break;
    const SegmentBlock& candidate = w_.memory.read(after);
    if (pixel <= w_.next_pixel(candidate.left)) break;
    before = after;
    after = candidate.x_next;
  }
  ++w_.tally.q[q::kSegmentWrites];
  link(p, block, before, after, first_, last_);
}

void XSort::unlink(SegmentPointer p, const SegmentBlock& block) {
  SegmentBlock link;
  const SegmentPointer after = p == last_ ? 0 : block.x_next;
  if (block.x_previous != 0) {
    link.x_next = after;
    w_.memory.write(block.x_previous, kGroupXNext, link, w_.line);
  } else {
    first_ = after;
  }
  if (p == last_) {
    last_ = block.x_previous;
  } else {
    link.x_previous = block.x_previous;
    w_.memory.write(after, kGroupXPrevious, link, w_.line);
  }
}

void XSort::insert_next_line(SegmentPointer p, SegmentBlock& block, std::int64_t pixel) {
  ++w_.tally.insertions;
  SegmentPointer before = next_last_, after = 0;
  std::int64_t before_pixel = next_last_pixel_;
  SegmentPointer before_previous = kNotSorted;  // not known: the end's word has not been read
  while (before != 0 && pixel < before_pixel) {
    if (after == 0) ++w_.tally.not_at_end;
    ++w_.tally.q[q::kSegmentReads];
    ++w_.tally.q[q::kStepsBack];
    if (before_previous == kNotSorted) before_previous = w_.memory.read(before).x_previous;
    after = before;
    before = before_previous;
    if (before != 0) {
      const SegmentBlock& word = w_.memory.read(before);
      before_pixel = w_.next_pixel(word.left);
      before_previous = word.x_previous;
    }
  }
  ++w_.tally.q[q::kSegmentWrites];
  if (after != 0) ++w_.tally.q[q::kSegmentWrites];
  if (after == 0) next_last_pixel_ = pixel;
  link(p, block, before, after, next_first_, next_last_);
}

}  // namespace vsg
