#include <gtest/gtest.h>

#include "Vsorter_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/segment_scenes.h"

namespace blocks {
namespace {

using vsg::SegmentPointer;

SegmentPointer pointer(std::uint32_t port) { return static_cast<SegmentPointer>(port); }

class DepthComparator : public testing::Test {
 protected:
  void start_frame(Machine& other) {
    other_ = &other;
    counting_ = {};
    sort_wait_ = -1;
    bench_->width_i = port(other.wiring.width);
    bench_.start_frame();
    show();
  }
  /// Builds the box of the span. The error that the RTL shows.
  std::uint32_t sort_span() {
    bench_->comparator_sort_i = 1;
    run([this] { return bench_->comparator_sort_done_o || bench_->comparator_error_o; });
    return bench_->comparator_error_o;
  }
  std::int64_t intersect() {
    bench_->comparator_intersect_i = 1;
    run([this] { return bench_->comparator_intersect_done_o != 0; });
    return x_format().wrap(static_cast<std::int64_t>(bench_->comparator_crossing_o));
  }

  template <class Done>
  void run(Done done) {
    for (int i = 0;; ++i) {
      ASSERT_LT(i, kMostCycles) << "the block hangs";
      bench_.settle();
      const bool last = done();
      serve();
      bench_.tick();
      bench_->comparator_sort_i = bench_->comparator_intersect_i = 0;
      show();
      if (last) return;
    }
  }
  void serve();
  void show();
  void report_test();
  void work_line(Machine& golden, Machine& other);
  void judge(Machine& golden, Machine& other, bool& again);

  Random random_{16};
  Bench<Vsorter_bench> bench_;
  MemoryPort memory_;
  Counting counting_;
  Machine* other_ = nullptr;
  std::int64_t sort_wait_ = -1;
  vsg::SegmentBlock links_;
  std::int32_t polygon_ = 0;
  int spans_ = 0, crossings_ = 0, ties_ = 0;
};

void DepthComparator::serve() {
  vsg::SampleSpan& span = other_->space.span;
  if (bench_->active_span_start_o) other_->active.start_span();
  if (bench_->active_remove_o) {
    other_->active.remove(pointer(bench_->active_previous_o), pointer(bench_->active_next_o));
  }
  if (bench_->active_add_o || bench_->active_add_ending_o) {
    vsg::SegmentBlock block;
    const SegmentPointer p = pointer(bench_->active_block_o);
    bench_->active_add_o ? other_->active.add(p, block) : other_->active.add_ending(p, block);
    bench_->active_link_i = port(block.active_next);
    bench_.settle();
  }
  memory_.take(bench_->request_o, *other_);
  counting_.add(counts_of(bench_->comparator_count_o), other_->tally);
  if (bench_->pop_o) {
    vsg::SegmentBlock block;
    block.x_next = pointer(bench_->pop_next_o);
    other_->x_sort.pop(block);
  }
  if (bench_->sort_next_o) {
    links_ = {};
    other_->x_sort.insert_next_line(pointer(bench_->sort_block_o), links_, pixel_of(bench_->sort_pixel_o));
    memory_.disturb();
    sort_wait_ = random_.between(0, 5);
  }
  if (bench_->return_o) other_->free_list.put_back(pointer(bench_->returned_o));
  if (bench_->polygon_mark_o) other_->polygons.mark_changing(polygon_);
  if (bench_->polygon_read_o) polygon_ = pointer(bench_->polygon_o);
  if (bench_->set_left_o) span.at_left = point_of(bench_->left_point_o);
  if (bench_->set_right_o) span.at_right = point_of(bench_->right_point_o);
  if (bench_->test_o) report_test();
}

void DepthComparator::report_test() {
  const vsg::VisibleBox box = decode_box(fields_of<kBoxFields>(bench_->test_box_o));
  const vsg::SampleSpan span = decode_span(fields_of<kSpanFields>(bench_->test_span_o));
  other_->seen.push_back({vsg::EventKind::kDepthTest, other_->wiring.line,
                          {bench_->test_block_o, bench_->test_from_x_sort_o, bench_->test_intersecting_o,
                           bench_->test_outcome_o, bench_->test_add_cycles_o, box.segments, box.z_min, box.z_max, box.left,
                           box.right, box.edge, span.left, span.right}});
}

void DepthComparator::show() {
  memory_.show(bench_->word_i);
  set_fields(bench_->span_i, encode(other_->space.span));
  bench_->active_first_i = port(other_->active.first());
  bench_->front_i = port(other_->x_sort.front());
  if (polygon_ != 0) bench_->polygon_active_i = other_->polygons.active(polygon_);
  bench_->sort_done_i = sort_wait_ == 0;
  bench_->sort_previous_i = port(sort_wait_ == 0 ? links_.x_previous : 0);
  bench_->sort_following_i = port(sort_wait_ == 0 ? links_.x_next : 0);
  if (sort_wait_ >= 0) --sort_wait_;
  bench_.settle();
}

/// A simple decision in the place of the Decision Processor, so that all kinds of spans come.
void DepthComparator::judge(Machine& golden, Machine& other, bool& again) {
  const vsg::VisibleBox box = golden.comparator.box();
  const vsg::SampleSpan span = golden.space.span;
  again = box.segments >= 2 && (box.edge < span.right || box.segments > 2);
  if (again) {
    for (Machine* m : {&golden, &other}) {
      m->active.restore_ending();
      m->space.span.at_right.pixel = 0;
      m->space.span.right = box.edge < span.right ? box.edge : (span.left + span.right) >> 1;
    }
  } else if (box.segments == 2) {
    const std::int64_t expected = golden.comparator.intersect();
    ASSERT_EQ(intersect(), expected);
    ++(golden.comparator.box().segments == 2 ? crossings_ : ties_);
  }
  if (again) return;
  for (Machine* m : {&golden, &other}) {
    if (m->space.span.at_left.pixel != 0) m->samples.store(m->space.span.at_left);
    m->space.span.at_left.pixel = 0;
  }
}

void DepthComparator::work_line(Machine& golden, Machine& other) {
  do {
    golden.space.next_span();
    other.space.next_span();
    int tries = 0;
    for (bool again = true; again;) {
      ASSERT_LT(++tries, 1000) << "subdivided without end";
      std::uint32_t expected = 0;
      try {
        golden.comparator.sort_span();
      } catch (const vsg::FrameError& e) {
        expected = 1 + static_cast<std::uint32_t>(e.kind());
      }
      show();
      ASSERT_EQ(sort_span(), expected);
      if (expected != 0) throw vsg::FrameError(vsg::FrameError::Kind::kOutOfFrame, golden.wiring.line);
      ASSERT_EQ(encode(golden.space.span), encode(other.space.span));
      ASSERT_EQ(encode(decode_box(fields_of<kBoxFields>(bench_->comparator_box_o))), encode(golden.comparator.box()));
      ++spans_;
      judge(golden, other, again);
      if (HasFatalFailure()) return;
    }
  } while (!golden.space.line_finished());
}

TEST_F(DepthComparator, BuildsBoxesAndCrossingsAsTheGoldenModel) {
  int out_of_frame = 0;
  for (int scenario = 0; scenario < 150 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(static_cast<int>(random_.between(4, 200)), 100);
    SegmentScene scene(random_, frame.width);
    Machine golden(frame), other(frame);
    start_frame(other);
    try {
      for (int line = 0; line < 10 && !HasFailure(); ++line) {
        golden.start_line();
        other.start_line();
        while (golden.polygons.take_changing() != 0 && other.polygons.take_changing() != 0) {
        }
        scene.enter(golden, other);
        work_line(golden, other);
        expect_same(golden, other);
      }
    } catch (const vsg::FrameError&) {
      ++out_of_frame;
      expect_same(golden, other);
    }
  }
  EXPECT_GT(spans_, 0);
  EXPECT_GT(crossings_, 0);
  EXPECT_GT(out_of_frame, 0);
  RecordProperty("spans", spans_);
  RecordProperty("crossings", crossings_);
  RecordProperty("ties", ties_);
}

}  // namespace
}  // namespace blocks
