#include "cmodel/vsg/segment_eliminator.h"

#include "cmodel/vsg/polygon_memory.h"

namespace vsg {

void SegmentEliminator::run() {
  while (const std::int32_t polygon = w_.polygons.take_changing()) {
    ++w_.tally.q[q::kPolygonReads];
    ++w_.tally.q[q::kPolygonWrites];
    pack(polygon);
  }
}

void SegmentEliminator::pack(std::int32_t polygon) {
  SegmentPointer previous = 0;
  for (SegmentPointer p = w_.polygons.first_segment(polygon); p != 0;) {
    ++w_.tally.q[q::kSegmentReads];
    SegmentBlock block = w_.memory.read(p);
    const SegmentPointer next = block.polygon_next;
    if (block.left_lines == 0 && block.right_lines == 0) {
      if (previous != 0) {
        ++w_.tally.q[q::kSegmentWrites];
        w_.memory.write(previous, kGroupPolygonNext, block, w_.line);
      } else {
        w_.polygons.set_first_segment(polygon, next);
      }
      w_.return_block(p);
      p = next;
      continue;
    }
    unsigned changed = 0;
    if (block.right_lines < 0 && block.left_lines >= 0) {
      block.left = block.right;
      block.left_lines = block.right_lines;
      block.right_lines = 0;
      changed = kGroupLeft | kGroupLeftLines;
    }
    if (block.right_lines >= 0) changed |= take_right_edge(block);
    if (block.x_previous == kNotSorted) {
      x_sort_.insert(p, block, previous);
      changed |= kGroupXLinks;
    }
    if (changed != 0) w_.memory.write(p, changed, block, w_.line);
    previous = p;
    p = next;
  }
}

unsigned SegmentEliminator::take_right_edge(SegmentBlock& block) {
  for (SegmentPointer donor = block.polygon_next; donor != 0;) {
    ++w_.tally.q[q::kSegmentReads];
    SegmentBlock word = w_.memory.read(donor);
    if (word.left_lines < 0) {
      block.right = word.left;
      block.right_lines = word.left_lines;
      ++w_.tally.q[q::kSegmentWrites];
      unsigned changed = kGroupLeftLines;
      if (word.x_previous != kNotSorted) {
        x_sort_.unlink(donor, word);
        word.x_previous = kNotSorted;
        changed |= kGroupXPrevious;
      }
      word.left_lines = 0;
      w_.memory.write(donor, changed, word, w_.line);
      return kGroupRight | kGroupRightLines;
    }
    if (word.right_lines < 0) {
      w_.tally.q[q::kSegmentWrites] += 2;
      block.right = word.right;
      block.right_lines = word.right_lines;
      word.left_lines = word.right_lines = 0;
      w_.memory.write(donor, kGroupLeftLines | kGroupRightLines, word, w_.line);
      return kGroupRight | kGroupRightLines;
    }
    donor = word.polygon_next;
  }
  // No right edge anywhere: the polygon is not closed on this line. It gets no width.
  ++w_.tally.unclosed_polygons;
  block.right.x = block.left.x;
  block.right.dx = block.left.dx;
  block.right_lines = 0;
  return kGroupRight | kGroupRightLines;
}

}  // namespace vsg
