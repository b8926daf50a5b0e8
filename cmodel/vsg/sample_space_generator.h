// Sample Space Generator (chapter III.E): the span between two sample points, and the edges that lie on them.
// rtl/vsg/sample_space_generator.sv
#pragma once

#include "cmodel/vsg/frame_coherence.h"
#include "cmodel/vsg/sample_list.h"
#include "cmodel/vsg/wiring.h"

namespace vsg {

/// Pixels `left` to `right`, both included, with the edges that were seen to end on its borders.
struct SampleSpan {
  std::int64_t left = 0, right = 0;
  SamplePoint at_left, at_right;
};

class SampleSpaceGenerator {
 public:
  SampleSpaceGenerator(Wiring& wiring, SampleList& samples, FrameCoherence& coherence)
      : w_(wiring), samples_(samples), coherence_(coherence) {}

  void start_line() {
    span.right = 1;  // the left border of the screen
    span.at_right.pixel = 0;
  }
  /// The next span begins where the last one ended and goes to the next sample point.
  void next_span() {
    span.left = span.right + 1;
    span.at_left = span.at_right;
    span.at_right.pixel = 0;
    span.right = coherence_.nearer(span.left, samples_.read(span.left));
  }
  bool line_finished() const { return span.right == w_.width; }

  SampleSpan span;

 private:
  Wiring& w_;
  SampleList& samples_;
  FrameCoherence& coherence_;
};

}  // namespace vsg
