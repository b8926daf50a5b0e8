// Golden model beside RTL: every transaction of one is compared with the other's. Each kind of transaction is compared in
// its order within the scan line; the order between kinds is the RTL's own, as blocks may work at the same time.
#pragma once

#include <array>
#include <deque>
#include <exception>
#include <optional>
#include <string>

#include "cmodel/vsg/processor.h"
#include "tb/vsg/rtl_machine.h"

namespace tb {

class Lockstep final : public RtlObserver {
 public:
  /// `replay`: the command that repeats the run, for the message. `also`: gets every RTL event that matched.
  Lockstep(const vsg::Parameters& parameters, const vsg::FrameBlocks& blocks, std::string replay, vsg::EventSink also = {});

  void line_started(int line) override;
  void event(const vsg::Event& event, std::int64_t cycle) override;
  void line_finished(int line) override;

  /// Compares the answers as a whole: segments, counters, statistics. Throws LockstepError.
  void frame_finished(const vsg::FrameAnswer& rtl);
  /// The RTL stopped with an error: the golden model must have stopped with the same. Throws LockstepError if not.
  void frame_failed(const vsg::FrameError& rtl);

  /// Transactions that matched so far.
  std::int64_t matched() const { return matched_; }

 private:
  struct Seen {
    vsg::Event event;
    std::int64_t cycle;
  };
  [[noreturn]] void mismatch(const std::string& what, int line, const vsg::Event* golden, const vsg::Event* rtl,
                             std::int64_t cycle) const;

  std::array<std::deque<vsg::Event>, vsg::kEventKinds> expected_;
  std::optional<vsg::FrameError> golden_error_;
  std::optional<vsg::Processor> golden_;
  std::string replay_;
  vsg::EventSink also_;
  std::deque<Seen> last_;
  std::int64_t matched_ = 0, last_cycle_ = 0;
};

/// One line for a person: name and fields.
std::string describe(const vsg::Event& event);

}  // namespace tb
