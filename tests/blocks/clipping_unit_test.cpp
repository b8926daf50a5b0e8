// The arithmetic unit alone: every depth test that the golden Depth Comparator makes is made here again from the segment's
// words, with pauses between, and must end alike.
#include <gtest/gtest.h>

#include <algorithm>

#include "Vsorter_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/segment_scenes.h"

namespace blocks {
namespace {

class ClippingUnit : public testing::Test {
 protected:
  void clear(bool searching) {
    bench_->clip_clear_i = 1;
    bench_->clip_searching_i = searching;
    bench_.tick();
    bench_->clip_clear_i = 0;
  }
  void test(const std::array<std::int64_t, kCandidateFields>& candidate, bool from_x_sort, bool searching,
            const vsg::SampleSpan& span) {
    set_fields(bench_->clip_candidate_i, candidate);
    set_fields(bench_->span_i, encode(span));
    bench_->clip_from_x_sort_i = from_x_sort;
    bench_->clip_searching_i = searching;
    bench_->clip_start_i = 1;
    bench_.tick();
    bench_->clip_start_i = 0;
    // The candidate is there for one cycle only.
    set_fields(bench_->clip_candidate_i, std::array<std::int64_t, kCandidateFields>{});
    for (int i = 0; !bench_->clip_done_o; ++i) {
      ASSERT_LT(i, kMostCycles) << "the unit hangs";
      bench_.tick();
    }
  }
  /// After `test`: the look is over, the count of add cycles is clamped for the histogram.
  void account() {
    bench_.tick();
    for (auto pause = random_.between(0, 2); pause > 0; --pause) bench_.tick();
    bench_->clip_account_i = 1;
    bench_.tick();
    bench_->clip_account_i = 0;
  }
  void repeat(const vsg::Event& event, Machine& golden, std::int64_t edge_of_box);
  void repeat_span(Machine& golden);

  Random random_{18};
  Bench<Vsorter_bench> bench_;
  int tests_ = 0, crossings_ = 0;
};

void ClippingUnit::repeat(const vsg::Event& event, Machine& golden, std::int64_t edge_of_box) {
  const auto get = [&event](std::string_view name) { return event.fields[vsg::event_field(event.kind, name)]; };
  const vsg::SegmentBlock word = golden.memory.read(static_cast<vsg::SegmentPointer>(get("segment")));
  const bool searching = get("intersecting") != 0;
  vsg::SampleSpan span = golden.space.span;
  span.left = get("span_left"), span.right = get("span_right");
  const std::int64_t left = x_format().integer(word.left.x), right = x_format().integer(word.right.x);
  const std::int64_t edge = searching ? edge_of_box : left < span.left ? right : left;
  test({get("segment"), word.polygon, word.left.x, word.right.x, word.left.z, word.right.z, edge},
       get("from_x_sort") != 0, searching, span);
  EXPECT_EQ(bench_->clip_outcome_o, get("outcome"));
  EXPECT_EQ(bench_->clip_add_cycles_o, get("add_cycles"));
  account();
  EXPECT_EQ(bench_->clip_add_cycles_o, std::clamp<std::int64_t>(get("add_cycles"), 1, vsg::Statistics::kAdds));
  const vsg::VisibleBox box = decode_box(fields_of<kBoxFields>(bench_->clip_box_o));
  const std::array<std::int64_t, 6> seen{box.segments, box.z_min, box.z_max, box.left, box.right, box.edge};
  const std::array<std::int64_t, 6> expected{get("box_segments"), get("box_z_min"), get("box_z_max"),
                                             get("box_left"),     get("box_right"), get("box_edge")};
  EXPECT_EQ(seen, expected);
  ++tests_;
}

/// Builds the box of the golden comparator's span, and the crossing of a box of two, here and there.
void ClippingUnit::repeat_span(Machine& golden) {
  golden.seen.clear();
  golden.comparator.sort_span();
  clear(false);
  const auto repeat_all = [&](std::int64_t edge) {
    const std::vector<vsg::Event> seen = std::move(golden.seen);
    golden.seen.clear();
    for (const vsg::Event& event : seen) {
      if (event.kind == vsg::EventKind::kDepthTest && !HasFailure()) repeat(event, golden, edge);
    }
    ASSERT_EQ(encode(decode_box(fields_of<kBoxFields>(bench_->clip_box_o))), encode(golden.comparator.box()));
  };
  repeat_all(0);
  const vsg::VisibleBox& box = golden.comparator.box();
  if (box.segments != 2 || box.edge < golden.space.span.right || HasFailure()) return;
  const std::int64_t edge = box.edge;
  const std::int64_t crossing = golden.comparator.intersect();
  clear(true);
  repeat_all(edge);
  if (box.segments != 2) return;
  EXPECT_EQ(x_format().wrap(static_cast<std::int64_t>(bench_->clip_crossing_o)), crossing);
  ++crossings_;
}

TEST_F(ClippingUnit, TestsAndSearchesAsTheGoldenModel) {
  for (int scenario = 0; scenario < 200 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(static_cast<int>(random_.between(8, 200)), 100);
    SegmentScene scene(random_, frame.width);
    Machine golden(frame), other(frame);  // the second only holds the same segments
    bench_.start_frame();
    try {
      for (int line = 0; line < 8 && !HasFailure(); ++line) {
        golden.start_line();
        other.start_line();
        scene.enter(golden, other);
        for (std::int64_t right = 1; right < frame.width && !HasFailure();) {
          golden.space.span = {};
          golden.space.span.left = right + 1;
          right = std::min<std::int64_t>(frame.width, right + random_.between(1, random_.coin() ? 8 : 60));
          golden.space.span.right = right;
          repeat_span(golden);
        }
      }
    } catch (const vsg::FrameError&) {
      // An edge left the frame, which the Depth Comparator sees before it tests.
    }
  }
  EXPECT_GT(tests_, 0);
  EXPECT_GT(crossings_, 0);
  RecordProperty("tests", tests_);
  RecordProperty("crossings", crossings_);
}

}  // namespace
}  // namespace blocks
