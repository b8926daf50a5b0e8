#include "cmodel/vsg/polygon_segment_lists.h"

namespace vsg {

bool PolygonSegmentLists::left_of(const EdgeBlock& edge, const SegmentEdge& e) const {
  const std::int64_t here = w_.next_x(e);
  return edge.x != here ? edge.x < here : edge.dx < e.dx;
}

PolygonSegmentLists::Place PolygonSegmentLists::find(const EdgeBlock& edge, std::int32_t polygon,
                                                     SegmentPointer& previous, SegmentPointer& next, SegmentBlock& found) {
  previous = 0;
  next = w_.polygons.first_segment(polygon);
  bool right_half_empty = false;  // of `previous`
  while (next != 0) {
    ++w_.tally.q[q::kSegmentReads];
    const SegmentBlock& word = w_.memory.read(next);
    const bool has_left = word.left_lines < 0, has_right = word.right_lines < 0;
    if (has_left && left_of(edge, word.left)) break;
    if (has_right && left_of(edge, word.right)) {
      previous = next;
      next = word.polygon_next;
      found = word;
      return has_left ? Place::kSplit : Place::kLeftOfPrevious;
    }
    right_half_empty = !has_right;
    previous = next;
    next = word.polygon_next;
  }
  return right_half_empty ? Place::kRightOfPrevious : Place::kNewBlock;
}

void PolygonSegmentLists::insert(const EdgeBlock& edge, std::uint32_t number, std::int32_t polygon) {
  SegmentPointer previous = 0, next = 0;
  SegmentBlock found;
  const Place place = find(edge, polygon, previous, next, found);

  // The Depth Sorter adds the increments before it uses a segment, so what is stored is one line behind.
  const SegmentEdge half{w_.x_format.wrap(edge.x - edge.dx), edge.dx, w_.z_format.wrap(edge.z - edge.dz), edge.dz,
                         number};

  SegmentBlock word;
  if (place == Place::kNewBlock || place == Place::kSplit) {
    bool fresh = false;
    const SegmentPointer taken = w_.take_block(fresh);
    if (fresh) samples_.clear(taken);
    if (previous != 0) ++w_.tally.q[q::kSegmentWrites];
    word.polygon = polygon;
    word.polygon_next = next;
    if (place == Place::kNewBlock) {
      word.left = half;
      word.left_lines = -edge.lines;
    } else {
      word.right = found.right;
      word.right_lines = found.right_lines;
    }
    w_.memory.write(taken, kGroupAll, word, w_.line);
    word.polygon_next = taken;
    if (previous == 0) {
      w_.polygons.set_first_segment(polygon, taken);
    } else if (place == Place::kNewBlock) {
      w_.memory.write(previous, kGroupPolygonNext, word, w_.line);
    }
  }
  ++w_.tally.q[q::kSegmentWrites];
  switch (place) {
    case Place::kNewBlock: break;
    case Place::kLeftOfPrevious:
      word.left = half;
      word.left_lines = -edge.lines;
      w_.memory.write(previous, kGroupLeft | kGroupLeftLines, word, w_.line);
      break;
    case Place::kRightOfPrevious:
    case Place::kSplit:
      word.right = half;
      word.right_lines = -edge.lines;
      w_.memory.write(previous, kGroupRight | kGroupRightLines | (place == Place::kSplit ? kGroupPolygonNext : 0u), word,
                      w_.line);
      break;
  }
}

}  // namespace vsg
