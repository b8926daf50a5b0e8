// Driver of a verilated vsg_harness. A template, as each set of widths is a class of its own.
#pragma once

#include <verilated.h>
#include <verilated_fst_c.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "cmodel/vsg/tally.h"
#include "tb/vsg/rtl_machine.h"

namespace tb {

template <class Harness>
class RtlDriver final : public RtlMachine {
 public:
  /// `most_cycles_of_line`: a machine that takes longer is stuck. The true machine needs no limit: it gives up a line
  /// that is subdivided without end by itself.
  explicit RtlDriver(const std::filesystem::path& trace,
                     std::int64_t most_cycles_of_line = std::numeric_limits<std::int64_t>::max())
      : most_cycles_of_line_(most_cycles_of_line) {
    context_.traceEverOn(!trace.empty());
    top_ = std::make_unique<Harness>(&context_);
    if (!trace.empty()) {
      trace_ = std::make_unique<VerilatedFstC>();
      top_->trace(trace_.get(), 99);
      trace_->open(trace.c_str());
    }
    top_->rst_ni = 0;
    top_->segment_ready_i = 1;
    tick();
    tick();
    top_->rst_ni = 1;
    tick();
    parameters_ = {static_cast<int>(top_->fraction_bits_x_o), static_cast<int>(top_->fraction_bits_z_o),
                   static_cast<int>(top_->integer_bits_o), top_->segment_blocks_o, top_->edge_blocks_o,
                   top_->polygon_blocks_o};
  }
  ~RtlDriver() override {
    if (trace_) trace_->close();
    top_->final();
  }

  const vsg::Parameters& parameters() const override { return parameters_; }

  vsg::FrameAnswer work(const vsg::FrameBlocks& blocks, RtlObserver& observer, bool want_events) override {
    vsg::FrameAnswer answer;
    answer.width = blocks.width;
    answer.height = blocks.height;
    load(blocks);
    recorder_ = {};
    recorder_.frame_started(tally());
    top_->run_i = 1;
    settle();
    const std::int64_t first_cycle = cycle_;
    std::int64_t line_began = cycle_;
    for (bool done = false; !done;) {
      // Sampled before the clock edge, as a register behind the ports would.
      done = top_->done_o != 0;
      if (top_->line_started_o) {
        line_began = cycle_;
        observer.line_started(static_cast<int>(top_->line_o));
        recorder_.line_started(tally());
        references_before_ = references();
        segments_before_ = top_->counters_o[vsg::q::kOutputSegments];
      }
      if (top_->sort_started_o) recorder_.depth_sort_started(tally());
      if (want_events) report(observer);
      if (top_->segment_valid_o && top_->segment_ready_i) {
        answer.segments.push_back({static_cast<std::int32_t>(top_->segment_y_o),
                                   static_cast<std::int32_t>(top_->segment_x_end_o), top_->segment_polygon_o});
      }
      if (top_->line_finished_o) finish_line(answer, observer, want_events);
      if (top_->error_o != 0) {
        throw vsg::FrameError(static_cast<vsg::FrameError::Kind>(top_->error_o - 1), static_cast<int>(top_->line_o));
      }
      if (cycle_ - line_began > most_cycles_of_line_) {
        throw vsg::LockstepError("scan line " + std::to_string(top_->line_o) + ": the RTL does not finish the line (cycle " +
                                 std::to_string(cycle_) + ")");
      }
      tick();
      top_->run_i = 0;
      top_->segment_ready_i = !receiver_ready || receiver_ready();
      settle();
    }
    vsg::complete_answer(answer, tally(), recorder_.finish(tally(), blocks.height), parameters_);
    answer.port_accesses = top_->counters_o[kPortAccesses];
    answer.cycles = cycle_ - first_cycle;
    return answer;
  }

 private:
  // Words of counters_o beyond the numbers of the 1970 program: vsg_pkg::counter_e.
  enum { kCrossings = 26, kImplied, kInsertions, kNotAtEnd, kAddCycles, kAddCyclesListed, kStale, kUnclosed, kBlocksNow,
         kBlocksMost, kDensity, kInvolved, kPolygons, kFrontPolygons, kEdges, kFrontEdges, kEnteredEdges, kPortAccesses,
         kAdds };

  void settle() { top_->eval(); }
  void tick() {
    top_->clk_i = 0;
    top_->eval();
    if (trace_) trace_->dump(static_cast<std::uint64_t>(2 * cycle_));
    top_->clk_i = 1;
    top_->eval();
    if (trace_) trace_->dump(static_cast<std::uint64_t>(2 * cycle_ + 1));
    ++cycle_;
  }

  void load(const vsg::FrameBlocks& blocks) {
    if (std::max(blocks.width, blocks.height) >> top_->coordinate_bits_o != 0) {
      throw std::invalid_argument("the frame is larger than this machine's coordinates");
    }
    top_->width_i = static_cast<std::uint32_t>(blocks.width);
    top_->height_i = static_cast<std::uint32_t>(blocks.height);
    top_->frame_start_i = 1;
    tick();
    top_->frame_start_i = 0;
    settle();
    for (const vsg::PolygonBlock& polygon : blocks.polygons) {
      top_->polygon_valid_i = 1;
      top_->polygon_front_i = polygon.front;
      transfer([this] { return top_->polygon_ready_o != 0; });
      top_->polygon_valid_i = 0;
    }
    for (const vsg::EdgeBlock& edge : blocks.edges) {
      top_->edge_valid_i = 1;
      top_->edge_first_polygon_i = edge.first_polygon;
      top_->edge_second_polygon_i = edge.second_polygon;
      top_->edge_first_line_i = static_cast<std::uint32_t>(edge.first_line);
      top_->edge_lines_i = static_cast<std::uint32_t>(edge.lines);
      top_->edge_x_i = static_cast<std::uint64_t>(edge.x);
      top_->edge_dx_i = static_cast<std::uint64_t>(edge.dx);
      top_->edge_z_i = static_cast<std::uint64_t>(edge.z);
      top_->edge_dz_i = static_cast<std::uint64_t>(edge.dz);
      transfer([this] { return top_->edge_ready_o != 0; });
      top_->edge_valid_i = 0;
    }
    settle();
    while (top_->loading_o) {
      check_error();
      tick();
      settle();
    }
    check_error();
  }

  /// Waits for ready and lets the clock take what is offered.
  template <class Ready>
  void transfer(Ready ready) {
    settle();
    while (!ready()) {
      check_error();
      tick();
      settle();
    }
    tick();
    settle();
  }

  void check_error() {
    if (top_->error_o == 0) return;
    throw vsg::FrameError(static_cast<vsg::FrameError::Kind>(top_->error_o - 1), static_cast<int>(top_->line_o));
  }

  std::int64_t references() const {
    return std::int64_t{top_->counters_o[vsg::q::kSegmentReads]} + top_->counters_o[vsg::q::kSegmentWrites];
  }

  vsg::Tally tally() const {
    const auto& word = top_->counters_o;
    vsg::Tally t;
    for (int i = 1; i <= vsg::q::kBucketReads; ++i) t.q[i] = word[i];
    for (int i = 1; i <= vsg::Statistics::kAdds; ++i) t.adds[i] = word[kAdds + i - 1];
    t.pq[vsg::pq::kBlocksTotal] = word[vsg::q::kBlocksTaken];
    t.pq[vsg::pq::kBlocksMost] = word[kBlocksMost];
    t.pq[vsg::pq::kBlocksNow] = word[kBlocksNow];
    t.pq[vsg::pq::kEdges] = word[kEdges];
    t.pq[vsg::pq::kFrontEdges] = word[kFrontEdges];
    t.pq[vsg::pq::kEnteredEdges] = word[kEnteredEdges];
    t.pq[vsg::pq::kPolygons] = word[kPolygons];
    t.pq[vsg::pq::kFrontPolygons] = word[kFrontPolygons];
    t.pq[vsg::pq::kPointDensity] = static_cast<std::int32_t>(word[kDensity]);
    t.pq[vsg::pq::kInvolvedLines] = word[kInvolved];
    t.crossings = word[kCrossings];
    t.implied_edges = word[kImplied];
    t.insertions = word[kInsertions];
    t.not_at_end = word[kNotAtEnd];
    t.add_cycles = word[kAddCycles];
    t.add_cycles_listed = word[kAddCyclesListed];
    t.stale_samples = word[kStale];
    t.unclosed_polygons = word[kUnclosed];
    return t;
  }

  void finish_line(vsg::FrameAnswer& answer, RtlObserver& observer, bool want_events) {
    recorder_.line_finished(tally());
    const vsg::LineCounts counts{references() - references_before_,
                                 top_->counters_o[vsg::q::kOutputSegments] - segments_before_};
    answer.lines.push_back(counts);
    const auto line = static_cast<std::int32_t>(top_->line_o);
    if (want_events) observer.event({vsg::EventKind::kLineDone, line, {counts.references, counts.segments}}, cycle_);
    observer.line_finished(line);
  }

  void report(RtlObserver& observer);
  vsg::Event written() const;

  VerilatedContext context_;
  std::unique_ptr<Harness> top_;
  std::unique_ptr<VerilatedFstC> trace_;
  vsg::Parameters parameters_;
  vsg::StatisticsRecorder recorder_;
  std::int64_t cycle_ = 0;
  std::int64_t most_cycles_of_line_;
  std::int64_t references_before_ = 0, segments_before_ = 0;
};

template <class Harness>
void RtlDriver<Harness>::report(RtlObserver& observer) {
  using vsg::EventKind;
  const auto line = static_cast<std::int32_t>(top_->line_o);
  const auto s = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  if (top_->edge_taken_o) {
    observer.event({EventKind::kEdgeTaken, line,
                    {top_->edge_taken_number_o, top_->edge_taken_polygon_o, s(top_->edge_taken_x_o)}}, cycle_);
  }
  if (top_->access_o && top_->access_groups_o != 0) observer.event(written(), cycle_);
  if (top_->test_o) {
    observer.event({EventKind::kDepthTest, line,
                    {s(top_->test_segment_o), s(top_->test_from_x_sort_o), s(top_->test_intersecting_o),
                     s(top_->test_outcome_o), s(top_->test_add_cycles_o), s(top_->test_box_segments_o),
                     s(top_->test_box_z_min_o), s(top_->test_box_z_max_o), s(top_->test_box_left_o),
                     s(top_->test_box_right_o), s(top_->test_box_edge_o), s(top_->test_span_left_o),
                     s(top_->test_span_right_o)}}, cycle_);
  }
  if (top_->decision_o) {
    observer.event({EventKind::kDecision, line,
                    {s(top_->decision_kind_o), s(top_->decision_span_left_o), s(top_->decision_span_right_o),
                     s(top_->decision_segments_o), s(top_->decision_new_right_o), references()}}, cycle_);
  }
  if (top_->segment_valid_o && top_->segment_ready_i) {
    observer.event({EventKind::kOutputSegment, line, {top_->segment_x_end_o, top_->segment_polygon_o}}, cycle_);
  }
  if (top_->sample_o) {
    observer.event({EventKind::kSampleStored, line, {s(top_->sample_block_o), s(top_->sample_side_o), s(top_->sample_x_o)}},
                   cycle_);
  }
}

/// A write of segment memory; fields outside the groups written are shown as 0, as the golden model shows them.
template <class Harness>
vsg::Event RtlDriver<Harness>::written() const {
  const std::uint32_t mask = top_->access_groups_o;
  const auto shown = [mask](int group, std::uint64_t value) {
    return (mask >> group & 1) != 0 ? static_cast<std::int64_t>(value) : 0;
  };
  return {vsg::EventKind::kBlockWritten, static_cast<std::int32_t>(top_->line_o),
          {top_->access_block_o, mask, shown(0, top_->access_x_previous_o), shown(1, top_->access_x_next_o),
           shown(2, top_->access_polygon_o), shown(3, top_->access_polygon_next_o), shown(4, top_->access_left_lines_o),
           shown(6, top_->access_left_x_o), shown(6, top_->access_left_dx_o), shown(6, top_->access_left_z_o),
           shown(6, top_->access_left_dz_o), shown(5, top_->access_right_lines_o), shown(7, top_->access_right_x_o),
           shown(7, top_->access_right_dx_o), shown(7, top_->access_right_z_o), shown(7, top_->access_right_dz_o),
           shown(8, top_->access_implied_o), shown(8, top_->access_active_next_o)}};
}

}  // namespace tb
