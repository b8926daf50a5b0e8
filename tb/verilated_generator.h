// The Visible Segment Generator as the verilated RTL does it, alone or in lock-step with the golden model.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "scanline/visible_segment_generator.h"
#include "tb/vsg/rtl_machine.h"

namespace tb {

struct VerilatedOptions {
  bool lockstep = false;         ///< compare every transaction with the golden model
  std::filesystem::path trace;   ///< FST waveform of everything; empty for none
  std::string replay;            ///< the command that repeats the run, shown when lock-step fails
};

class VerilatedGenerator final : public scanline::VisibleSegmentGenerator {
 public:
  explicit VerilatedGenerator(const VerilatedOptions& options = {});
  /// With a machine of other widths (tests).
  VerilatedGenerator(std::unique_ptr<RtlMachine> machine, const VerilatedOptions& options);

  const vsg::Parameters& parameters() const override { return machine_->parameters(); }
  vsg::FrameAnswer generate(const vsg::FrameBlocks& blocks, const vsg::EventSink& events = {}) override;

  /// The machine itself, for tests.
  RtlMachine& machine() { return *machine_; }

  /// Transactions compared since the generator was made; 0 without lock-step.
  std::int64_t matched() const { return matched_; }

 private:
  VerilatedOptions options_;
  std::unique_ptr<RtlMachine> machine_;
  std::int64_t matched_ = 0;
};

}  // namespace tb
