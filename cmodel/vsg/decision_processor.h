// Decision Processor (chapter III.H): from the box of a span, output, subdivision or intersection; builds the sample list
// (III.J). rtl/vsg/decision_processor.sv
#pragma once

#include <vector>

#include "cmodel/vsg/depth_comparator.h"
#include "cmodel/vsg/implied_edges.h"

namespace vsg {

class DecisionProcessor {
 public:
  DecisionProcessor(Wiring& wiring, DepthComparator& comparator, ActiveList& active, SampleSpaceGenerator& samples,
                    SampleList& list, ImpliedEdges& implied, FrameCoherence& coherence,
                    std::vector<VisibleSegment>& output)
      : w_(wiring), comparator_(comparator), active_(active), samples_(samples), list_(list), implied_(implied),
        coherence_(coherence), output_(output) {}

  void start_line() { segments_ = 0; }
  /// Judges the span. False: it was subdivided and must be sorted again.
  bool decide();
  /// Hands over the last segment of the line. Returns how many the line had.
  std::int64_t finish_line();

 private:
  void intersection();
  void output_visible();
  /// Enters a piece that ends at pixel `x_end` into the display file; the same polygon goes on in the same entry.
  void output(std::int64_t x_end, std::int32_t polygon);
  void hand_over();

  Wiring& w_;
  DepthComparator& comparator_;
  ActiveList& active_;
  SampleSpaceGenerator& samples_;
  SampleList& list_;
  ImpliedEdges& implied_;
  FrameCoherence& coherence_;
  std::vector<VisibleSegment>& output_;
  std::int64_t segments_ = 0;  ///< of this line so far
  VisibleSegment held_;        ///< the last of them, which may still grow
};

}  // namespace vsg
