// What the blocks of the processor share: memories, formats, counters, the scan line, the trace.
#pragma once

#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/events.h"
#include "cmodel/vsg/fixed.h"
#include "cmodel/vsg/segment_memory.h"
#include "cmodel/vsg/tally.h"

namespace vsg {

class PolygonMemory;

struct Wiring {
  int width, height;
  WordFormat x_format, z_format;
  SegmentMemory& memory;
  FreeList& free_list;
  PolygonMemory& polygons;
  Tally& tally;
  const EventSink& events;
  int line = 0;  ///< the scan line being worked, from 1

  /// X of an edge on the line after the one it holds, and the pixel it falls on.
  std::int64_t next_x(const SegmentEdge& e) const { return x_format.wrap(e.x + e.dx); }
  std::int64_t next_pixel(const SegmentEdge& e) const { return x_format.integer(next_x(e)); }

  /// A crossing must fall on pixel 1 to `width`; anything else means that the frame was not clipped.
  bool inside(std::int64_t pixel) const { return pixel > 0 && pixel <= width; }
  [[noreturn]] void out_of_frame() const { throw FrameError(FrameError::Kind::kOutOfFrame, line); }

  /// Takes a block from the free list; throws when segment memory is full.
  SegmentPointer take_block(bool& fresh) {
    const SegmentPointer p = free_list.take(fresh);
    if (p == 0) throw FrameError(FrameError::Kind::kSegmentMemoryFull, line);
    tally.block_taken();
    return p;
  }
  void return_block(SegmentPointer p) {
    free_list.put_back(p);
    tally.block_returned();
  }
};

}  // namespace vsg
