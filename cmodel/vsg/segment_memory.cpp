#include "cmodel/vsg/segment_memory.h"

namespace vsg {

void SegmentMemory::write(SegmentPointer p, unsigned mask, const SegmentBlock& word, int line) {
  ++accesses_;
  SegmentBlock& w = words_[p];
  if (mask & kGroupXPrevious) w.x_previous = word.x_previous;
  if (mask & kGroupXNext) w.x_next = word.x_next;
  if (mask & kGroupPolygon) w.polygon = word.polygon;
  if (mask & kGroupPolygonNext) w.polygon_next = word.polygon_next;
  if (mask & kGroupLeftLines) w.left_lines = word.left_lines;
  if (mask & kGroupRightLines) w.right_lines = word.right_lines;
  if (mask & kGroupLeft) w.left = word.left;
  if (mask & kGroupRight) w.right = word.right;
  if (mask & kGroupActive) {
    w.implied = word.implied;
    w.active_next = word.active_next;
  }
  if (!events_) return;
  // Fields outside the written groups are shown as 0: what a port carries there means nothing.
  const auto shown = [mask](unsigned group, std::int64_t value) { return (mask & group) ? value : 0; };
  events_({EventKind::kBlockWritten,
           line,
           {p, mask, shown(kGroupXPrevious, word.x_previous), shown(kGroupXNext, word.x_next),
            shown(kGroupPolygon, word.polygon), shown(kGroupPolygonNext, word.polygon_next),
            shown(kGroupLeftLines, word.left_lines), shown(kGroupLeft, word.left.x), shown(kGroupLeft, word.left.dx),
            shown(kGroupLeft, word.left.z), shown(kGroupLeft, word.left.dz), shown(kGroupRightLines, word.right_lines),
            shown(kGroupRight, word.right.x), shown(kGroupRight, word.right.dx), shown(kGroupRight, word.right.z),
            shown(kGroupRight, word.right.dz), shown(kGroupActive, word.implied), shown(kGroupActive, word.active_next)}});
}

}  // namespace vsg
