// The Visible Segment Generator as pre-frame processing and shading see it: blocks in, visible segments out. The
// program gives them the golden model (scanline/golden_generator.h) or the verilated RTL (tb/).
#pragma once

#include "cmodel/vsg/answer.h"
#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/events.h"

namespace scanline {

class VisibleSegmentGenerator {
 public:
  virtual ~VisibleSegmentGenerator() = default;

  /// Widths and sizes; blocks must have been made for them.
  virtual const vsg::Parameters& parameters() const = 0;

  /// Works one frame. `events`, when given, sees every transaction in order. Throws vsg::FrameError when the
  /// frame cannot be finished, vsg::LockstepError when golden model and RTL disagree.
  virtual vsg::FrameAnswer generate(const vsg::FrameBlocks& blocks, const vsg::EventSink& events = {}) = 0;

  /// Called after each scan line (1 to height), for a progress bar. May be empty.
  std::function<void(int line)> on_line;
};

}  // namespace scanline
