#include <gtest/gtest.h>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

using vsg::SegmentPointer;

class ImpliedEdges : public testing::Test {
 protected:
  void start_line(Machine& golden) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->implied_last_lines_i = golden.wiring.line + 1 == golden.wiring.height;
    bench->implied_line_start_i = 1;
    rtl_.cycle();
    bench->implied_line_start_i = 0;
    rtl_.run([&] { return bench->implied_line_done_o != 0; });
    golden.implied.start_line();
  }
  /// False when segment memory is full.
  bool cross(Machine& golden, SegmentPointer left, SegmentPointer right, std::int64_t x) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->implied_left_i = port(left);
    bench->implied_right_i = port(right);
    bench->implied_x_i = static_cast<std::uint64_t>(x);
    bench->implied_crossing_i = 1;
    rtl_.cycle();
    bench->implied_crossing_i = 0;
    vsg::SamplePoint point;
    bool full = false;
    rtl_.run([&] { return bench->implied_done_o || bench->implied_full_o; },
             [&] {
               full = bench->implied_full_o != 0;
               point = point_of(bench->implied_point_o);
             });
    try {
      const vsg::SamplePoint expected = golden.implied.crossing(left, right, x);
      EXPECT_FALSE(full);
      EXPECT_EQ(point.pixel, expected.pixel);
      if (expected.pixel != 0) {
        EXPECT_EQ(point.address, expected.address);
        ++again_;
      }
      ++crossings_;
    } catch (const vsg::FrameError&) {
      EXPECT_TRUE(full);
      ++full_;
      return false;
    }
    return true;
  }
  /// Implied edges that came out of the X-sort list go back to the free list, as when they are not met again.
  static void pop_all(Machine& m) {
    while (const SegmentPointer p = m.x_sort.front()) {
      m.x_sort.pop(m.memory.read(p));
      m.wiring.return_block(p);
    }
  }

  Random random_{13};
  ListsSurroundings rtl_{random_};
  int crossings_ = 0, again_ = 0, full_ = 0;
};

TEST_F(ImpliedEdges, WaitMatchAndReturnAsTheGoldenModel) {
  for (int scenario = 0; scenario < 60 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(200, static_cast<int>(random_.between(3, 30)));
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    const auto segments = random_.between(2, 5);
    const bool crowded = random_.once_in(4);
    bool full = false;
    for (int line = 1; line <= frame.height && !full && !HasFailure(); ++line) {
      golden.start_line();
      other.start_line();
      pop_all(golden);
      pop_all(other);
      start_line(golden);
      for (auto crossings = random_.between(0, crowded ? 50 : 8); crossings > 0 && !full && !HasFailure(); --crossings) {
        const auto left = static_cast<SegmentPointer>(random_.between(1, segments));
        const auto right = static_cast<SegmentPointer>(random_.between(1, crowded ? 60 : segments));
        full = !cross(golden, left, right, x_format().from_integer(random_.between(1, 199)) + random_.between(0, 4095));
      }
    }
    expect_same(golden, other);
  }
  EXPECT_GT(crossings_, 0);
  EXPECT_GT(again_, 0);
  EXPECT_GT(full_, 0);
}

}  // namespace
}  // namespace blocks
