#include <gtest/gtest.h>

#include "Vsorter_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/segment_scenes.h"

namespace blocks {
namespace {

class DecisionProcessor : public testing::Test {
 protected:
  void start_frame(Machine& other) {
    other_ = &other;
    counting_ = {};
    intersect_wait_ = implied_wait_ = -1;
    bench_->width_i = port(other.wiring.width);
    bench_.start_frame();
    show();
  }
  void start_line() {
    bench_->line_start_i = 1;
    bench_->line_i = port(other_->wiring.line);
    cycle();
    bench_->line_start_i = 0;
  }
  /// Judges the span; 0, or the error that the RTL shows. `again`: it was subdivided.
  std::uint32_t decide(bool& again) {
    again = false;
    bench_->decide_i = 1;
    run([this] { return bench_->decided_o || bench_->decision_error_o; }, again);
    return bench_->decision_error_o;
  }
  void finish_line() {
    bool unused = false;
    bench_->finish_line_i = 1;
    run([this] { return bench_->finished_o != 0; }, unused);
  }

  void cycle() {
    serve();
    bench_.tick();
    bench_->decide_i = bench_->finish_line_i = 0;
    show();
  }
  template <class Done>
  void run(Done done, bool& again) {
    for (int i = 0;; ++i) {
      ASSERT_LT(i, kMostCycles) << "the block hangs";
      bench_->ready_i = random_.coin();
      bench_.settle();
      const bool last = done();
      if (last) again = bench_->again_o != 0;
      cycle();
      if (last) return;
    }
  }
  void serve();
  void show();
  void work_line(Machine& golden, Machine& other);

  Random random_{17};
  Bench<Vsorter_bench> bench_;
  Counting counting_;
  Machine* other_ = nullptr;
  std::int64_t intersect_wait_ = -1, implied_wait_ = -1, crossing_ = 0;
  vsg::SamplePoint implied_;
  bool full_ = false;
  int decisions_ = 0, crossings_ = 0;
};

void DecisionProcessor::serve() {
  bench_.settle();
  Machine& m = *other_;
  vsg::SampleSpan& span = m.space.span;
  if (bench_->decision_o) {
    const vsg::SampleSpan judged = decode_span(fields_of<kSpanFields>(bench_->decision_span_o));
    m.seen.push_back({vsg::EventKind::kDecision, m.wiring.line,
                      {bench_->decision_kind_o, judged.left, judged.right, bench_->decision_segments_o,
                       pixel_of(bench_->decision_new_right_o), m.tally.references()}});
    ++decisions_;
  }
  counting_.add(counts_of(bench_->decision_count_o), m.tally);
  if (bench_->intersect_o) {
    crossing_ = m.comparator.intersect();
    intersect_wait_ = random_.between(0, 6);
    ++crossings_;
  }
  if (bench_->implied_o) {
    const vsg::VisibleBox& box = m.comparator.box();
    implied_ = {};
    full_ = false;
    try {
      implied_ = m.implied.crossing(box.front, box.other, crossing_);
    } catch (const vsg::FrameError&) {
      full_ = true;
    }
    implied_wait_ = random_.between(0, 6);
  }
  if (bench_->valid_o && bench_->ready_i) {
    m.output.push_back({static_cast<std::int32_t>(bench_->segment_y_o), static_cast<std::int32_t>(bench_->segment_x_end_o),
                        bench_->segment_polygon_o});
    m.seen.push_back({vsg::EventKind::kOutputSegment, m.wiring.line,
                      {bench_->segment_x_end_o, bench_->segment_polygon_o}});
  }
  if (bench_->store_o) {
    // The sample list is a golden one and counts what it stores.
    m.samples.store(span.at_left);
  }
  if (bench_->restore_o) m.active.restore_ending();
  if (bench_->set_implied_o) span.at_left = point_of(bench_->implied_point_o);
  if (bench_->clear_left_o) span.at_left.pixel = 0;
  if (bench_->subdivide_o) {
    span.at_right.pixel = 0;
    span.right = pixel_of(bench_->new_right_o);
  }
}

void DecisionProcessor::show() {
  set_fields(bench_->span_i, encode(other_->space.span));
  set_fields(bench_->decision_box_i, encode(other_->comparator.box()));
  // The crossing is there from the cycle after `done` on.
  if (intersect_wait_ < 0) bench_->crossing_i = static_cast<std::uint64_t>(crossing_);
  bench_->intersect_done_i = intersect_wait_ == 0;
  if (intersect_wait_ >= 0) --intersect_wait_;
  bench_->implied_done_i = implied_wait_ == 0 && !full_;
  bench_->implied_full_i = implied_wait_ == 0 && full_;
  set_point(bench_->implied_point_i, implied_wait_ == 0 ? implied_ : vsg::SamplePoint{});
  if (implied_wait_ >= 0) --implied_wait_;
  bench_.settle();
}

void DecisionProcessor::work_line(Machine& golden, Machine& other) {
  do {
    golden.space.next_span();
    other.space.next_span();
    int tries = 0;
    for (bool again = true; again;) {
      ASSERT_LT(++tries, 1000) << "subdivided without end";
      golden.comparator.sort_span();
      other.comparator.sort_span();
      show();
      std::uint32_t expected = 0;
      bool finished = true;
      try {
        finished = golden.decision.decide();
      } catch (const vsg::FrameError& e) {
        expected = 1 + static_cast<std::uint32_t>(e.kind());
      }
      ASSERT_EQ(decide(again), expected);
      if (expected != 0) throw vsg::FrameError(vsg::FrameError::Kind::kSegmentMemoryFull, golden.wiring.line);
      ASSERT_EQ(again, !finished);
      ASSERT_EQ(encode(golden.space.span), encode(other.space.span));
    }
  } while (!golden.space.line_finished());
  if (golden.decision.finish_line() != 1) ++golden.tally.pq[vsg::pq::kInvolvedLines];
  finish_line();
}

TEST_F(DecisionProcessor, DecidesAndAnswersAsTheGoldenModel) {
  int full = 0;
  for (int scenario = 0; scenario < 300 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(static_cast<int>(random_.between(4, 200)), 12);
    SegmentScene scene(random_, frame.width);
    Machine golden(frame), other(frame);
    start_frame(other);
    const int used = static_cast<int>(random_.once_in(3) ? random_.between(40, 63) : 0);  // by others
    for (int i = 0; i < used; ++i) static_cast<void>(golden.take_block() + other.take_block());
    try {
      for (int line = 0; line < 11 && !HasFailure(); ++line) {
        golden.start_line();
        other.start_line();
        start_line();
        golden.implied.start_line();
        other.implied.start_line();
        scene.enter(golden, other);
        work_line(golden, other);
        expect_same(golden, other);
        EXPECT_EQ(golden.output, other.output);
      }
    } catch (const vsg::FrameError& e) {
      full += e.kind() == vsg::FrameError::Kind::kSegmentMemoryFull ? 1 : 0;
    }
  }
  EXPECT_GT(decisions_, 0);
  EXPECT_GT(crossings_, 0);
  EXPECT_GT(full, 0);
  RecordProperty("decisions", decisions_);
  RecordProperty("crossings", crossings_);
}

}  // namespace
}  // namespace blocks
