#include <gtest/gtest.h>

#include <vector>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

using vsg::SegmentPointer;

class ActiveList : public testing::Test {
 protected:
  void start_line() {
    rtl_.bench()->line_start_i = 1;
    rtl_.cycle();
    rtl_.bench()->line_start_i = 0;
  }
  void start_span() {
    rtl_.bench()->active_span_start_i = 1;
    rtl_.cycle();
    rtl_.bench()->active_span_start_i = 0;
  }
  void add(Machine& golden, Machine& other, SegmentPointer p, bool ending) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    vsg::SegmentBlock block;
    ending ? golden.active.add_ending(p, block) : golden.active.add(p, block);
    bench->active_add_i = !ending;
    bench->active_add_ending_i = ending;
    bench->active_add_block_i = port(p);
    bench.settle();
    vsg::SegmentBlock linked;
    linked.active_next = static_cast<SegmentPointer>(bench->active_link_o);
    rtl_.cycle();
    bench->active_add_i = bench->active_add_ending_i = 0;
    golden.memory.write(p, vsg::kGroupActive, block, golden.wiring.line);
    other.memory.write(p, vsg::kGroupActive, linked, other.wiring.line);
  }
  void remove(Machine& golden, SegmentPointer previous, SegmentPointer next) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    golden.active.remove(previous, next);
    bench->active_remove_i = 1;
    bench->active_remove_previous_i = port(previous);
    bench->active_remove_next_i = port(next);
    rtl_.cycle();
    bench->active_remove_i = 0;
  }
  void restore(Machine& golden) {
    golden.active.restore_ending();
    rtl_.bench()->active_restore_i = 1;
    rtl_.cycle();
    rtl_.bench()->active_restore_i = 0;
  }

  Random random_{10};
  ListsSurroundings rtl_{random_};
};

TEST_F(ActiveList, LinksAsTheGoldenModel) {
  const std::int64_t before = compared();
  int restored = 0;
  for (int scenario = 0; scenario < 20 && !HasFailure(); ++scenario) {
    const vsg::FrameBlocks frame = empty_frame(200, 40);
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    // What the lists hold, first to last.
    std::vector<SegmentPointer> active, ending, idle;
    for (int step = 0; step < 600 && !HasFailure(); ++step) {
      if (step % 100 == 0) {
        golden.start_line();
        other.start_line();
        start_line();
        golden.active.start_span();
        start_span();
        active.clear(), ending.clear(), idle.clear();
        for (int p = 1; p <= static_cast<int>(bench_parameters().segment_blocks); ++p) idle.push_back(p);
      }
      switch (random_.between(0, 9)) {
        case 0:
          golden.active.start_span();
          start_span();
          idle.insert(idle.end(), ending.begin(), ending.end());
          ending.clear();
          break;
        case 1:
          restore(golden);
          restored += ending.empty() ? 0 : 1;
          active.insert(active.begin(), ending.begin(), ending.end());
          ending.clear();
          golden.active.start_span();  // a span that is sorted again starts anew
          start_span();
          break;
        case 2: case 3: case 4:
          if (!active.empty()) {
            const std::int64_t at = random_.between(0, static_cast<std::int64_t>(active.size()) - 1);
            const SegmentPointer p = active[at];
            remove(golden, at == 0 ? 0 : active[at - 1],
                   at + 1 == static_cast<std::int64_t>(active.size()) ? 0 : active[at + 1]);
            active.erase(active.begin() + at);
            if (random_.coin()) {
              add(golden, other, p, true);
              ending.insert(ending.begin(), p);
            } else {
              idle.push_back(p);
            }
          }
          break;
        default:
          if (!idle.empty()) {
            const SegmentPointer p = idle.back();
            idle.pop_back();
            const bool ends = random_.once_in(3);
            add(golden, other, p, ends);
            (ends ? ending : active).insert((ends ? ending : active).begin(), p);
          }
          break;
      }
      ASSERT_EQ(rtl_.bench()->active_first_o, static_cast<std::uint32_t>(golden.active.first())) << "step " << step;
      ASSERT_EQ(golden.active.first(), active.empty() ? 0 : active.front()) << "step " << step;
    }
    expect_same(golden, other);
  }
  EXPECT_GT(compared(), before);
  EXPECT_GT(restored, 0);
}

}  // namespace
}  // namespace blocks
