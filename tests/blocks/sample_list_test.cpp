#include <gtest/gtest.h>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

class SampleList : public testing::Test {
 protected:
  void clear(Machine& golden, vsg::SegmentPointer p) {
    golden.samples.clear(p);
    rtl_.bench()->sample_clear_i = 1;
    rtl_.bench()->sample_clear_block_i = port(p);
    rtl_.cycle();
    rtl_.bench()->sample_clear_i = 0;
  }
  void read(Machine& golden, std::int64_t from) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->sample_read_i = 1;
    bench->sample_from_i = port(from);
    rtl_.cycle();
    bench->sample_read_i = 0;
    rtl_.run([&] { return bench->sample_valid_o != 0; },
             [&] { EXPECT_EQ(pixel_of(bench->sample_o), golden.samples.read(from)) << "from " << from; });
    ++reads_;
  }
  void store(Machine& golden, Machine& other, const vsg::SamplePoint& point) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->sample_store_i = 1;
    set_point(bench->sample_point_i, point);
    bench.settle();
    if (bench->sample_trace_o) {
      const vsg::SamplePoint seen = point_of(bench->sample_trace_point_o);
      other.seen.push_back({vsg::EventKind::kSampleStored, other.wiring.line,
                            {seen.address.block, seen.address.side, seen.pixel}});
    }
    rtl_.cycle();
    bench->sample_store_i = 0;
    golden.samples.store(point);
  }

  Random random_{9};
  ListsSurroundings rtl_{random_};
  int reads_ = 0;
};

TEST_F(SampleList, ReadsAndStoresAsTheGoldenModel) {
  std::int64_t stale = 0, stored = 0;
  for (int scenario = 0; scenario < 20 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(static_cast<int>(random_.between(2, 250)), 50);
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    const int blocks = static_cast<int>(random_.between(2, bench_parameters().segment_blocks));
    for (vsg::SegmentPointer p = 1; p <= blocks; ++p) clear(golden, p);
    for (int line = 0; line < 40 && !HasFailure(); ++line) {
      golden.start_line();
      other.start_line();
      rtl_.bench()->line_start_i = 1;
      rtl_.cycle();
      rtl_.bench()->line_start_i = 0;
      const bool empty = random_.once_in(6);
      std::int64_t from = 1, near = 1;
      while (from < frame.width && !HasFailure()) {
        from = std::min<std::int64_t>(from + random_.between(1, 20), frame.width);
        read(golden, from);
        near = std::max<std::int64_t>(1, from + random_.between(-4, 4));
        if (!empty && random_.coin()) {
          const auto block = static_cast<vsg::SegmentPointer>(random_.between(1, blocks));
          store(golden, other, {std::min<std::int64_t>(near, frame.width), {block, random_.coin() ? 1 : 0}});
        }
        if (random_.once_in(20)) clear(golden, static_cast<vsg::SegmentPointer>(random_.between(1, blocks)));
      }
    }
    expect_same(golden, other);
    stale += golden.tally.stale_samples;
    stored += golden.tally.q[vsg::q::kSamplesStored];
  }
  EXPECT_GT(reads_, 0);
  EXPECT_GT(stored, 0);
  EXPECT_GT(stale, 0);
}

}  // namespace
}  // namespace blocks
