// The Visible Segment Generator as the golden model does it.
#pragma once

#include "scanline/visible_segment_generator.h"

namespace scanline {

class GoldenGenerator final : public VisibleSegmentGenerator {
 public:
  explicit GoldenGenerator(const vsg::Parameters& parameters = {}) : parameters_(parameters) {}
  const vsg::Parameters& parameters() const override { return parameters_; }
  vsg::FrameAnswer generate(const vsg::FrameBlocks& blocks, const vsg::EventSink& events = {}) override;

 private:
  vsg::Parameters parameters_;
};

}  // namespace scanline
