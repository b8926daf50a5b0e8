// The Visible Segment Generator VSG6 (figure 10), golden model: Segment Generator, Segment Eliminator and Depth Sorter, run
// scan line by scan line. Bit for bit and access for access what rtl/vsg does.
#pragma once

#include <memory>

#include "cmodel/vsg/answer.h"
#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/events.h"

namespace vsg {

class Processor {
 public:
  /// Loads edge and polygon memory. `frame` must outlive the processor. `events` sees every transaction in order.
  /// Throws FrameError: edges outside the frame, more blocks than the memories hold.
  Processor(const Parameters& parameters, const FrameBlocks& frame, EventSink events = {});
  ~Processor();
  Processor(const Processor&) = delete;
  Processor& operator=(const Processor&) = delete;

  bool finished() const;
  /// The scan line worked last, 0 before the first.
  int line() const;
  /// Works the next scan line. Throws FrameError.
  void step_line();
  /// Segments and counters; everything when finished, otherwise what there is so far.
  FrameAnswer answer() const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace vsg
