// Polygon blocks (figure 4) and the list of changing polygons: those with an edge that entered on this scan line or left
// on the one before. The list is last in, first out. rtl/vsg/polygon_memory.sv
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/segment_memory.h"
#include "cmodel/vsg/tally.h"

namespace vsg {

class PolygonMemory {
 public:
  /// Throws FrameError when there are more than `capacity`.
  PolygonMemory(const std::vector<PolygonBlock>& polygons, std::uint32_t capacity, Tally& tally);

  bool front(std::int32_t polygon) const { return words_[polygon].front; }
  SegmentPointer first_segment(std::int32_t polygon) const { return words_[polygon].first_segment; }
  void set_first_segment(std::int32_t polygon, SegmentPointer p) { words_[polygon].first_segment = p; }

  /// Puts the polygon into the changing list unless its active bit says that it is there.
  void mark_changing(std::int32_t polygon) {
    Word& w = words_[polygon];
    if (w.active) return;
    w.active = true;
    w.next_changing = changing_;
    changing_ = polygon;
  }
  bool active(std::int32_t polygon) const { return words_[polygon].active; }

  /// Takes the polygon changed last out of the list; 0 when the list is empty.
  std::int32_t take_changing() {
    const std::int32_t polygon = changing_;
    if (polygon != 0) {
      words_[polygon].active = false;
      changing_ = words_[polygon].next_changing;
    }
    return polygon;
  }

 private:
  struct Word {
    bool front = false, active = false;
    SegmentPointer first_segment = 0;
    std::int32_t next_changing = 0;
  };
  std::vector<Word> words_;
  std::int32_t changing_ = 0;
};

}  // namespace vsg
