#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

using vsg::SegmentPointer;

class XSort : public testing::Test {
 protected:
  enum Command { kInsert, kUnlink, kInsertNext };

  /// Gives the RTL a command and returns the links it answers with.
  vsg::SegmentBlock command(Command kind, SegmentPointer p, const vsg::SegmentBlock& block, SegmentPointer start,
                            std::int64_t pixel) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->x_command_valid_i = 1;
    bench->x_command_i = kind;
    bench->x_block_i = port(p);
    bench->x_start_i = port(start);
    bench->x_pixel_i = port(pixel);
    bench->x_previous_i = port(block.x_previous);
    bench->x_next_i = port(block.x_next);
    rtl_.cycle();
    bench->x_command_valid_i = 0;
    vsg::SegmentBlock links = block;
    rtl_.run([&] { return bench->x_done_o != 0; },
             [&] {
               links.x_previous = static_cast<SegmentPointer>(bench->x_previous_o);
               links.x_next = static_cast<SegmentPointer>(bench->x_next_o);
             });
    return links;
  }
  void insert(Machine& golden, Machine& other, SegmentPointer p, SegmentPointer start) {
    vsg::SegmentBlock block;
    const std::int64_t pixel = random_.between(1, 60);
    block.left.dx = random_.word(14);
    block.left.x = x_format().from_integer(pixel) + random_.between(0, 100) - block.left.dx;
    golden.store(p, block);
    other.store(p, block);
    const vsg::SegmentBlock links = command(kInsert, p, block, start, pixel);
    golden.x_sort.insert(p, block, start);
    golden.memory.write(p, vsg::kGroupXLinks, block, golden.wiring.line);
    other.memory.write(p, vsg::kGroupXLinks, links, other.wiring.line);
  }
  void unlink(Machine& golden, Machine& other, SegmentPointer p) {
    vsg::SegmentBlock block = golden.memory.read(p);
    command(kUnlink, p, other.memory.read(p), 0, 0);
    golden.x_sort.unlink(p, block);
  }
  /// The front of this line's list goes; nearly always it enters the next line's list.
  SegmentPointer pop(Machine& golden, Machine& other) {
    const SegmentPointer p = golden.x_sort.front();
    EXPECT_EQ(rtl_.bench()->x_front_o, static_cast<std::uint32_t>(p));
    vsg::SegmentBlock block = golden.memory.read(p);
    rtl_.bench()->x_pop_i = 1;
    rtl_.bench()->x_pop_next_i = port(other.memory.read(p).x_next);
    rtl_.cycle();
    rtl_.bench()->x_pop_i = 0;
    golden.x_sort.pop(block);
    if (random_.once_in(6)) return 0;
    block.left.x += random_.word(15);
    const std::int64_t pixel = golden.wiring.next_pixel(block.left);
    golden.memory.write(p, vsg::kGroupLeft, block, golden.wiring.line);
    other.memory.write(p, vsg::kGroupLeft, block, other.wiring.line);
    const vsg::SegmentBlock links = command(kInsertNext, p, block, 0, pixel);
    golden.x_sort.insert_next_line(p, block, pixel);
    golden.memory.write(p, vsg::kGroupXLinks, block, golden.wiring.line);
    other.memory.write(p, vsg::kGroupXLinks, links, other.wiring.line);
    return p;
  }

  Random random_{8};
  ListsSurroundings rtl_{random_};
};

TEST_F(XSort, SortsAsTheGoldenModel) {
  const std::int64_t before = compared();
  for (int scenario = 0; scenario < 30 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(200, 40);
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    std::vector<SegmentPointer> here, next, idle;
    for (SegmentPointer p = 1; p <= static_cast<SegmentPointer>(bench_parameters().segment_blocks); ++p) idle.push_back(p);
    const auto take = [this](std::vector<SegmentPointer>& from) {
      const auto at = from.begin() + random_.between(0, static_cast<std::int64_t>(from.size()) - 1);
      const SegmentPointer p = *at;
      from.erase(at);
      return p;
    };
    for (int line = 0; line < 20 && !HasFailure(); ++line) {
      golden.start_line();
      other.start_line();
      rtl_.bench()->line_start_i = 1;
      rtl_.cycle();
      rtl_.bench()->line_start_i = 0;
      here = std::move(next);
      next.clear();
      for (auto ops = random_.between(0, 12); ops > 0; --ops) {
        if (!here.empty() && random_.once_in(4)) {
          const SegmentPointer p = take(here);
          unlink(golden, other, p);
          idle.push_back(p);
        } else if (!idle.empty()) {
          const SegmentPointer start =
              here.empty() || random_.once_in(3) ? 0 : here[random_.between(0, static_cast<std::int64_t>(here.size()) - 1)];
          const SegmentPointer p = take(idle);
          insert(golden, other, p, start);
          here.push_back(p);
        }
        ASSERT_EQ(rtl_.bench()->x_front_o, static_cast<std::uint32_t>(golden.x_sort.front()));
      }
      while (golden.x_sort.front() != 0 && !HasFailure()) {
        const SegmentPointer front = golden.x_sort.front();
        const bool kept = pop(golden, other) != 0;
        std::erase(here, front);
        (kept ? next : idle).push_back(front);
      }
      ASSERT_EQ(rtl_.bench()->x_front_o, 0u);
      ASSERT_TRUE(here.empty()) << "the list has lost blocks";
    }
    expect_same(golden, other);
    EXPECT_GT(golden.tally.not_at_end, 0);
  }
  EXPECT_GT(compared(), before);
}

}  // namespace
}  // namespace blocks
