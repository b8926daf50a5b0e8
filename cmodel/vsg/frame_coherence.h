// Frame-to-frame coherence (chapter IV): an edge that was visible, in the frame before, on the scan line it entered on is a
// sample point of that line. The original found that it saves 0.1 percent of the references and left it out; here it is
// an option of sequences, in the golden model.
#pragma once

#include <set>
#include <vector>

#include "cmodel/vsg/wiring.h"

namespace vsg {

class FrameCoherence {
 public:
  FrameCoherence(Wiring& wiring, const std::vector<EdgeBlock>& edges, bool enabled)
      : w_(wiring), edges_(edges), visible_(enabled ? edges.size() : 0), enabled_(enabled) {}

  void start_line() { entered_.clear(); }

  /// An edge that was visible in the frame before enters at this pixel.
  void entered(std::int64_t pixel) {
    if (enabled_) entered_.insert(pixel);
  }

  /// The next sample point at or right of `pixel`, when the sample list offers `sample`.
  std::int64_t nearer(std::int64_t pixel, std::int64_t sample) {
    const auto next = entered_.lower_bound(pixel);
    if (next == entered_.end() || *next >= sample) return sample;
    ++w_.tally.coherence_samples;
    return *next;
  }

  /// The edge was visible on this line.
  void visible(std::uint32_t edge) {
    if (enabled_ && edge != 0 && edges_[edge - 1].first_line == w_.line) visible_[edge - 1] = true;
  }

  const std::vector<bool>& edges_visible() const { return visible_; }

 private:
  Wiring& w_;
  const std::vector<EdgeBlock>& edges_;
  std::vector<bool> visible_;
  std::set<std::int64_t> entered_;
  bool enabled_;
};

}  // namespace vsg
