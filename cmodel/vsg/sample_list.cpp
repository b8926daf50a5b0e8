#include "cmodel/vsg/sample_list.h"

namespace vsg {

void SampleList::start_line() {
  at_ = next_first_;
  last_ = next_last_;
  pixel_ = next_pixel_;
  next_first_ = {};
  next_pixel_ = w_.width;
}

std::int64_t SampleList::read(std::int64_t pixel) {
  if (pixel_ >= pixel) return pixel_;
  pixel_ = w_.width;
  if (at_ == last_) return pixel_;
  const Word& next = word(at_);
  pixel_ = next.pixel;
  at_ = next.next;
  if (pixel_ < pixel || pixel_ > w_.width) {
    // The word was written for the next line before this line read it (a segment of a non-convex polygon was split):
    // the old list ends here.
    ++w_.tally.stale_samples;
    pixel_ = w_.width;
    at_ = last_;
  }
  return pixel_;
}

void SampleList::store(const SamplePoint& point) {
  ++w_.tally.q[q::kSamplesStored];
  if (next_first_.block == 0) {
    next_first_ = point.address;
    next_pixel_ = point.pixel;
  } else if (point.pixel <= next_last_pixel_) {
    return;
  } else {
    word(next_last_) = {point.pixel, point.address};
  }
  next_last_ = point.address;
  next_last_pixel_ = point.pixel;
  if (w_.events) {
    w_.events({EventKind::kSampleStored, w_.line, {point.address.block, point.address.side, point.pixel}});
  }
}

void SampleList::clear(SegmentPointer block) {
  word({block, 0}) = {};
  word({block, 1}) = {};
}

}  // namespace vsg
