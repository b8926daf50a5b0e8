// Segment memory (figure 5): one wide word a segment block, one port. A write names the groups of fields that it
// changes, as the word's chips have write enables of their own. rtl/vsg/segment_memory.sv
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/vsg/answer.h"
#include "cmodel/vsg/events.h"

namespace vsg {

/// Number of a segment block, from 1; 0 is none.
using SegmentPointer = std::int32_t;

/// `x_previous` of a block that is not in the X-sort list.
constexpr SegmentPointer kNotSorted = -1;

/// One edge of a segment, "half a block". `x` and `z` are those of the scan line worked last.
struct SegmentEdge {
  std::int64_t x = 0, dx = 0;  ///< fixed point, format of X
  std::int64_t z = 0, dz = 0;  ///< fixed point, format of Z
  std::uint32_t edge = 0;      ///< number of the edge block, kept for frame coherence alone (chapter IV)
};

/// An implied edge is a block as well: the intersection's X is in `left`, the two segments that make it are
/// in `polygon` (the one in front on the left) and `polygon_next`, and `x_next` links the implied edge lists.
struct SegmentBlock {
  SegmentPointer x_previous = kNotSorted;  ///< X-sort list
  SegmentPointer x_next = 0;
  std::int32_t polygon = 0;
  SegmentPointer polygon_next = 0;         ///< next segment of the same polygon
  std::int32_t left_lines = 0;             ///< minus the scan lines left for the left edge; 0: that half is empty
  std::int32_t right_lines = 0;
  SegmentEdge left, right;
  bool implied = false;
  SegmentPointer active_next = 0;          ///< active list, or the list of segments that end in the span
};

/// Groups of fields with a write enable of their own.
enum SegmentGroup : unsigned {
  kGroupXPrevious = 1, kGroupXNext = 2, kGroupPolygon = 4, kGroupPolygonNext = 8, kGroupLeftLines = 16,
  kGroupRightLines = 32, kGroupLeft = 64, kGroupRight = 128, kGroupActive = 256, kGroupAll = 511
};

class SegmentMemory {
 public:
  SegmentMemory(std::uint32_t blocks, const EventSink& events) : words_(blocks + 1), events_(events) {}

  const SegmentBlock& read(SegmentPointer p) {
    ++accesses_;
    return words_[p];
  }

  /// Writes the groups of `mask`.
  void write(SegmentPointer p, unsigned mask, const SegmentBlock& word, int line);

  std::int64_t accesses() const { return accesses_; }

 private:
  std::vector<SegmentBlock> words_;
  const EventSink& events_;
  std::int64_t accesses_ = 0;
};

/// Free list: the block returned last is taken first. rtl/vsg/free_list.sv
class FreeList {
 public:
  explicit FreeList(std::uint32_t blocks) : blocks_(static_cast<std::int32_t>(blocks)) {}

  /// 0 when segment memory is full. `fresh` tells that the block was never used in this frame.
  SegmentPointer take(bool& fresh) {
    fresh = returned_.empty();
    if (!fresh) {
      const SegmentPointer p = returned_.back();
      returned_.pop_back();
      return p;
    }
    return top_ == blocks_ ? 0 : ++top_;
  }
  void put_back(SegmentPointer p) { returned_.push_back(p); }

 private:
  std::vector<SegmentPointer> returned_;
  SegmentPointer top_ = 0;
  std::int32_t blocks_;
};

}  // namespace vsg
