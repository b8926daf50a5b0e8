#include "tb/verilated_generator.h"

#include <utility>

#include "tb/vsg/lockstep.h"

namespace tb {
namespace {

/// Passes events on and tells of finished lines.
class Forwarding : public RtlObserver {
 public:
  Forwarding(RtlObserver* inner, const vsg::EventSink& events, const std::function<void(int)>& on_line)
      : inner_(inner), events_(events), on_line_(on_line) {}
  void line_started(int line) override {
    if (inner_ != nullptr) inner_->line_started(line);
  }
  void event(const vsg::Event& event, std::int64_t cycle) override {
    if (inner_ != nullptr) {
      inner_->event(event, cycle);
    } else if (events_) {
      events_(event);
    }
  }
  void line_finished(int line) override {
    if (inner_ != nullptr) inner_->line_finished(line);
    if (on_line_) on_line_(line);
  }

 private:
  RtlObserver* inner_;
  const vsg::EventSink& events_;
  const std::function<void(int)>& on_line_;
};

}  // namespace

VerilatedGenerator::VerilatedGenerator(const VerilatedOptions& options)
    : VerilatedGenerator(make_rtl_machine(options.trace), options) {}

VerilatedGenerator::VerilatedGenerator(std::unique_ptr<RtlMachine> machine, const VerilatedOptions& options)
    : options_(options), machine_(std::move(machine)) {}

vsg::FrameAnswer VerilatedGenerator::generate(const vsg::FrameBlocks& blocks, const vsg::EventSink& events) {
  if (!options_.lockstep) {
    Forwarding observer(nullptr, events, on_line);
    return machine_->work(blocks, observer, static_cast<bool>(events));
  }
  Lockstep lockstep(machine_->parameters(), blocks, options_.replay, events);
  Forwarding observer(&lockstep, events, on_line);
  try {
    vsg::FrameAnswer answer = machine_->work(blocks, observer, true);
    lockstep.frame_finished(answer);
    matched_ += lockstep.matched();
    return answer;
  } catch (const vsg::FrameError& error) {
    lockstep.frame_failed(error);
    matched_ += lockstep.matched();
    throw;
  }
}

}  // namespace tb
