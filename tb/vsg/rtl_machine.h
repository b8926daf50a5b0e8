// The verilated Visible Segment Generator behind an interface that knows nothing of Verilator.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "cmodel/vsg/answer.h"
#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/events.h"

namespace tb {

/// Who watches a frame being worked. Every call comes in the order of the clock.
class RtlObserver {
 public:
  virtual ~RtlObserver() = default;
  virtual void line_started(int) {}
  virtual void event(const vsg::Event&, std::int64_t /*cycle*/) {}
  virtual void line_finished(int) {}
};

class RtlMachine {
 public:
  virtual ~RtlMachine() = default;

  /// Widths and sizes that the RTL was made with.
  virtual const vsg::Parameters& parameters() const = 0;
  /// The receiver of visible segments is not ready in cycles for which this says so; empty: always ready.
  std::function<bool()> receiver_ready;

  /// Loads and works one frame. `want_events` false: the observer gets line calls only. Throws vsg::FrameError, and
  /// vsg::LockstepError when a scan line takes absurdly long.
  virtual vsg::FrameAnswer work(const vsg::FrameBlocks& blocks, RtlObserver& observer, bool want_events) = 0;
};

/// A machine of the default widths. `trace`: FST file, empty for none.
std::unique_ptr<RtlMachine> make_rtl_machine(const std::filesystem::path& trace = {});

/// A small machine of other widths (tb/CMakeLists.txt), for tests.
std::unique_ptr<RtlMachine> make_small_rtl_machine(const std::filesystem::path& trace = {});

}  // namespace tb
