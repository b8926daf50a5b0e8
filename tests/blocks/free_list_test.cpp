#include <gtest/gtest.h>

#include <vector>

#include "Vmemories_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

// A cycle takes a block or returns one: no block of the machine does both at once.
TEST(FreeList, GivesWhatTheGoldenModelGives) {
  Random random(4);
  Bench<Vmemories_bench> bench;
  int taken = 0, refused = 0;
  for (int frame = 0; frame < 20; ++frame) {
    bench.start_frame();
    vsg::FreeList golden(bench_parameters().segment_blocks);
    std::vector<vsg::SegmentPointer> held;
    int eager = 2;  // how willing to take; now and then the list runs dry, now and then it fills
    for (int cycle = 0; cycle < 1000; ++cycle) {
      if (random.once_in(100)) eager = static_cast<int>(random.between(1, 6));
      const bool take = !random.once_in(eager + 1);
      const bool put_back = !take && !held.empty();
      vsg::FreeList next = golden;
      bool fresh = false;
      const vsg::SegmentPointer expected = next.take(fresh);
      bench->free_take_i = take;
      bench->free_return_i = put_back;
      const auto index = held.empty() ? 0 : random.between(0, static_cast<std::int64_t>(held.size()) - 1);
      const vsg::SegmentPointer returned = put_back ? held[index] : 0;
      bench->free_returned_i = port(returned);
      bench.settle();
      ASSERT_EQ(bench->free_full_o != 0, expected == 0) << "frame " << frame << ", cycle " << cycle;
      if (expected != 0) {
        ASSERT_EQ(bench->free_block_o, static_cast<std::uint32_t>(expected)) << "frame " << frame << ", cycle " << cycle;
        ASSERT_EQ(bench->free_fresh_o != 0, fresh) << "frame " << frame << ", cycle " << cycle;
      }
      if (take) {
        golden = next;
        if (expected != 0) held.push_back(expected);
        ++(expected != 0 ? taken : refused);
      } else if (put_back) {
        golden.put_back(returned);
        held.erase(held.begin() + index);
      }
      bench.tick();
    }
    bench->free_take_i = 0;
    bench->free_return_i = 0;
  }
  EXPECT_GT(taken, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace blocks
