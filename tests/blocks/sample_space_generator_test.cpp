#include <gtest/gtest.h>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

class SampleSpaceGenerator : public testing::Test {
 protected:
  vsg::SamplePoint random_point() {
    const auto block = static_cast<vsg::SegmentPointer>(random_.between(1, bench_parameters().segment_blocks));
    return {random_.between(0, 200), {block, random_.coin() ? 1 : 0}};
  }
  void next(Machine& golden, Machine& other) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->space_next_i = 1;
    bench.settle();
    EXPECT_TRUE(bench->space_read_o);
    const std::int64_t from = pixel_of(bench->space_from_o);
    rtl_.cycle();
    bench->space_next_i = 0;
    for (auto wait = random_.between(0, 2); wait > 0; --wait) {
      bench.settle();
      EXPECT_FALSE(bench->space_done_o);
      rtl_.cycle();
    }
    bench->space_sample_valid_i = 1;
    bench->space_sample_i = port(other.samples.read(from));
    bench.settle();
    EXPECT_TRUE(bench->space_done_o);
    rtl_.cycle();
    bench->space_sample_valid_i = 0;
    golden.space.next_span();
  }
  /// What the Depth Comparator and the Decision Processor may say about the span, one at a time.
  void change(vsg::SampleSpan& span) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    const vsg::SamplePoint point = random_point();
    switch (random_.between(0, 4)) {
      case 0:
        set_point(bench->space_left_point_i, point);
        bench->space_set_left_i = 1;
        span.at_left = point;
        break;
      case 1:
        set_point(bench->space_right_point_i, point);
        bench->space_set_right_i = 1;
        span.at_right = point;
        break;
      case 2:
        set_point(bench->space_implied_point_i, point);
        bench->space_set_implied_i = 1;
        span.at_left = point;
        break;
      case 3:
        bench->space_clear_left_i = 1;
        span.at_left.pixel = 0;
        break;
      default:
        span.at_right.pixel = 0;
        span.right = random_.between(span.left, span.right);
        bench->space_new_right_i = port(span.right);
        bench->space_subdivide_i = 1;
        break;
    }
    rtl_.cycle();
    bench->space_set_left_i = bench->space_set_right_i = bench->space_set_implied_i = 0;
    bench->space_clear_left_i = bench->space_subdivide_i = 0;
  }
  void expect_span(const vsg::SampleSpan& span) {
    ASSERT_EQ(encode(decode_span(fields_of<kSpanFields>(rtl_.bench()->space_span_o))), encode(span));
    ++spans_;
  }

  Random random_{14};
  ListsSurroundings rtl_{random_};
  int spans_ = 0;
};

TEST_F(SampleSpaceGenerator, MakesTheSpansOfTheGoldenModel) {
  const vsg::FrameBlocks frame = empty_frame(200, 1000);
  Machine golden(frame), other(frame);
  rtl_.start_frame(other);
  for (int line = 0; line < 200 && !HasFailure(); ++line) {
    golden.start_line();
    other.start_line();
    rtl_.bench()->line_start_i = 1;
    rtl_.cycle();
    rtl_.bench()->line_start_i = 0;
    do {
      next(golden, other);
      expect_span(golden.space.span);
      for (auto changes = random_.between(0, 4); changes > 0 && !HasFailure(); --changes) {
        change(golden.space.span);
        expect_span(golden.space.span);
      }
    } while (!golden.space.line_finished() && !HasFailure());
    // Sample points of the next line.
    for (std::int64_t pixel = random_.between(1, 40); pixel <= frame.width; pixel += random_.between(1, 40)) {
      const vsg::SamplePoint point{pixel, random_point().address};
      golden.samples.store(point);
      other.samples.store(point);
    }
  }
  EXPECT_GT(spans_, 0);
}

}  // namespace
}  // namespace blocks
