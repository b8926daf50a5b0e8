#include <gtest/gtest.h>

#include "Vmemories_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

vsg::SegmentBlock random_word(Random& random) {
  const int greatest = static_cast<int>(bench_parameters().segment_blocks);
  const auto pointer = [&random, greatest] { return static_cast<std::int32_t>(random.between(0, greatest)); };
  const auto lines = [&random] { return static_cast<std::int32_t>(-random.between(0, (1 << coordinate_bits()) - 1)); };
  const auto edge = [&random] {
    return vsg::SegmentEdge{random.word(x_format().bits), random.word(x_format().bits), random.word(z_format().bits),
                            random.word(z_format().bits)};
  };
  vsg::SegmentBlock w;
  w.x_previous = random.once_in(4) ? vsg::kNotSorted : pointer();
  w.x_next = pointer(), w.polygon = pointer(), w.polygon_next = pointer(), w.active_next = pointer();
  w.left_lines = lines(), w.right_lines = lines();
  w.left = edge(), w.right = edge();
  w.implied = random.coin();
  return w;
}

TEST(SegmentMemory, ReadsWhatItsGroupsWereWritten) {
  Random random(3);
  Bench<Vmemories_bench> bench;
  const vsg::FrameBlocks frame = empty_frame(10, 10);
  Machine golden(frame);
  vsg::SegmentBlock shown;  // the word read last
  int reads = 0;
  const int blocks = static_cast<int>(bench_parameters().segment_blocks);
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const bool first_round = cycle < blocks;  // every word is written whole before it is read
    const bool valid = first_round || !random.once_in(5);
    const auto p = static_cast<vsg::SegmentPointer>(first_round ? cycle + 1 : random.between(1, blocks));
    const unsigned groups = first_round           ? unsigned{vsg::kGroupAll}
                            : random.coin() ? 0u : static_cast<unsigned>(random.between(0, vsg::kGroupAll));
    const vsg::SegmentBlock word = random_word(random);
    std::array<std::int64_t, kRequestFields> request{valid ? 1 : 0, p, groups};
    const WordFields fields = encode(word);
    std::copy(fields.begin(), fields.end(), request.begin() + 3);
    set_fields(bench->segment_request_i, request);
    bench.settle();
    ASSERT_EQ(field(bench->segment_trace_o, 0), valid ? 1 : 0);
    ASSERT_EQ(field(bench->segment_trace_o, 2), groups);
    bench.tick();
    if (valid && groups != 0) golden.memory.write(p, groups, word, 0);
    if (valid && groups == 0) {
      shown = golden.memory.read(p);
      ++reads;
    }
    if (reads == 0) continue;
    const auto seen = fields_of<kWordFields>(bench->segment_word_o);
    ASSERT_EQ(encode(decode_word(seen.data())), encode(shown)) << "cycle " << cycle << ", block " << p;
  }
  EXPECT_GT(reads, 0);
}

}  // namespace
}  // namespace blocks
