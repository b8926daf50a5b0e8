#include "tb/vsg/lockstep.h"

#include <utility>

namespace tb {
namespace {

constexpr std::size_t kEventsShown = 12;

}  // namespace

std::string describe(const vsg::Event& event) {
  std::string text = "line " + std::to_string(event.line) + ", " + std::string(vsg::event_name(event.kind)) + ":";
  const auto names = vsg::event_field_names(event.kind);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text.append(" ").append(names[i]).append("=").append(std::to_string(event.fields[i]));
  }
  return text;
}

Lockstep::Lockstep(const vsg::Parameters& parameters, const vsg::FrameBlocks& blocks, std::string replay, vsg::EventSink also)
    : replay_(std::move(replay)), also_(std::move(also)) {
  try {
    golden_.emplace(parameters, blocks,
                    [this](const vsg::Event& e) { expected_[static_cast<std::size_t>(e.kind)].push_back(e); });
  } catch (const vsg::FrameError& error) {
    golden_error_ = error;
  }
}

void Lockstep::line_started(int line) {
  if (golden_error_) mismatch("the golden model refused the frame: " + std::string(golden_error_->what()), line, nullptr, nullptr, 0);
  try {
    golden_->step_line();
  } catch (const vsg::FrameError& error) {
    golden_error_ = error;  // the RTL must come to it as well
  }
}

void Lockstep::event(const vsg::Event& rtl, std::int64_t cycle) {
  last_cycle_ = cycle;
  auto& queue = expected_[static_cast<std::size_t>(rtl.kind)];
  if (queue.empty()) mismatch("the golden model has no such transaction", rtl.line, nullptr, &rtl, cycle);
  const vsg::Event& golden = queue.front();
  const std::size_t fields = vsg::event_field_names(rtl.kind).size();
  if (golden.line != rtl.line || !std::equal(golden.fields.begin(), golden.fields.begin() + fields, rtl.fields.begin())) {
    mismatch("the transactions differ", rtl.line, &golden, &rtl, cycle);
  }
  queue.pop_front();
  ++matched_;
  last_.push_back({rtl, cycle});
  if (last_.size() > kEventsShown) last_.pop_front();
  if (also_) also_(rtl);
}

void Lockstep::line_finished(int line) {
  if (golden_error_) mismatch("only the golden model stopped: " + std::string(golden_error_->what()), line, nullptr, nullptr, last_cycle_);
  for (const auto& queue : expected_) {
    if (!queue.empty()) mismatch("the RTL finished the line without a transaction", line, &queue.front(), nullptr, last_cycle_);
  }
}

void Lockstep::frame_finished(const vsg::FrameAnswer& rtl) {
  const vsg::FrameAnswer golden = golden_->answer();
  const auto check = [&](const std::string& name, std::int64_t g, std::int64_t r) {
    if (g != r) {
      mismatch("counter " + name + ": golden " + std::to_string(g) + ", RTL " + std::to_string(r), golden_->line(), nullptr,
               nullptr, last_cycle_);
    }
  };
  if (golden.segments != rtl.segments) mismatch("the visible segments differ", golden_->line(), nullptr, nullptr, last_cycle_);
  for (int i = 1; i <= vsg::Statistics::kPq; ++i) check("PQ(" + std::to_string(i) + ")", golden.statistics.pq[i], rtl.statistics.pq[i]);
  for (int i = 1; i <= vsg::Statistics::kQ; ++i) {
    for (int column = 1; column <= vsg::Statistics::kColumns; ++column) {
      check("Q(" + std::to_string(column) + "," + std::to_string(i) + ")", golden.statistics.q[i][column],
            rtl.statistics.q[i][column]);
    }
  }
  for (int i = 1; i <= vsg::Statistics::kAdds; ++i) {
    check("ADDS(" + std::to_string(i) + ")", golden.statistics.adds[i], rtl.statistics.adds[i]);
  }
  const vsg::Counters &g = golden.counters, &r = rtl.counters;
  check("edge_crossings", g.edge_crossings, r.edge_crossings);
  check("implied_edges", g.implied_edges, r.implied_edges);
  check("add_cycles", g.add_cycles, r.add_cycles);
  check("add_cycles_listed", g.add_cycles_listed, r.add_cycles_listed);
  check("percent_not_at_end * 10000", std::int64_t(g.percent_not_at_end * 1e4), std::int64_t(r.percent_not_at_end * 1e4));
  check("output_buffer", g.output_buffer, r.output_buffer);
  check("stale_samples", golden.stale_samples, rtl.stale_samples);
  check("unclosed_polygons", golden.unclosed_polygons, rtl.unclosed_polygons);
  check("port_accesses", golden.port_accesses, rtl.port_accesses);
  if (matched_ == 0) mismatch("not one transaction was compared", golden_->line(), nullptr, nullptr, last_cycle_);
}

void Lockstep::frame_failed(const vsg::FrameError& rtl) {
  if (golden_error_ && golden_error_->kind() == rtl.kind() && golden_error_->line() == rtl.line()) return;
  mismatch("the RTL stopped: " + std::string(rtl.what()) + "; the golden model " +
               (golden_error_ ? "stopped: " + std::string(golden_error_->what()) : std::string("did not")),
           rtl.line(), nullptr, nullptr, last_cycle_);
}

void Lockstep::mismatch(const std::string& what, int line, const vsg::Event* golden, const vsg::Event* rtl,
                        std::int64_t cycle) const {
  std::string text = "lock-step mismatch on scan line " + std::to_string(line) + ", cycle " + std::to_string(cycle) + ": " + what;
  if (golden != nullptr) text += "\n  golden: " + describe(*golden);
  if (rtl != nullptr) text += "\n  RTL:    " + describe(*rtl);
  if (golden != nullptr && rtl != nullptr) {
    const auto names = vsg::event_field_names(rtl->kind);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (golden->fields[i] == rtl->fields[i]) continue;
      text.append("\n  field ").append(names[i]).append(": golden ").append(std::to_string(golden->fields[i]));
      text.append(", RTL ").append(std::to_string(rtl->fields[i]));
    }
  }
  text += "\n  " + std::to_string(matched_) + " transactions matched before; the last of them:";
  for (const Seen& seen : last_) text += "\n    cycle " + std::to_string(seen.cycle) + ", " + describe(seen.event);
  if (!replay_.empty()) text += "\n  replay: " + replay_;
  throw vsg::LockstepError(text);
}

}  // namespace tb
