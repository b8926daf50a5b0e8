// Segment Generator (chapter III.A): takes the edges that enter on this scan line and enters them into the segment lists of
// their polygons. rtl/vsg/segment_generator.sv
#pragma once

#include "cmodel/vsg/edge_memory.h"
#include "cmodel/vsg/frame_coherence.h"
#include "cmodel/vsg/polygon_segment_lists.h"
#include "cmodel/vsg/wiring.h"

namespace vsg {

class SegmentGenerator {
 public:
  SegmentGenerator(Wiring& wiring, const EdgeMemory& edges, SampleList& samples, FrameCoherence& coherence)
      : w_(wiring), edges_(edges), lists_(wiring, samples), coherence_(coherence) {}
  void run();

 private:
  void enter(std::uint32_t number, std::uint32_t polygon);

  Wiring& w_;
  const EdgeMemory& edges_;
  PolygonSegmentLists lists_;
  FrameCoherence& coherence_;
};

}  // namespace vsg
