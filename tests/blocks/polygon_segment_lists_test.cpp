#include <gtest/gtest.h>

#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

using vsg::SegmentPointer;

class PolygonSegmentLists : public testing::Test {
 protected:
  vsg::EdgeBlock random_edge() {
    vsg::EdgeBlock e;
    e.lines = static_cast<std::int32_t>(random_.between(1, 200));
    e.x = random_.once_in(4) ? x_format().from_integer(random_.between(10, 14)) : random_.word(x_format().bits);
    e.dx = random_.coin() ? random_.between(-2, 2) : random_.word(x_format().bits);
    e.z = random_.word(z_format().bits), e.dz = random_.word(z_format().bits);
    return e;
  }
  /// Whether a block was left for it.
  bool insert(const vsg::EdgeBlock& e, std::int32_t polygon) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->edge_lines_i = port(e.lines);
    bench->edge_x_i = static_cast<std::uint64_t>(e.x);
    bench->edge_dx_i = static_cast<std::uint64_t>(e.dx);
    bench->edge_z_i = static_cast<std::uint64_t>(e.z);
    bench->edge_dz_i = static_cast<std::uint64_t>(e.dz);
    bench->lists_polygon_i = port(polygon);
    bench->first_segment_i = port(rtl_.machine().polygons.first_segment(polygon));
    bench->lists_insert_i = 1;
    rtl_.cycle();
    bench->lists_insert_i = 0;
    bool full = false;
    rtl_.run([&] { return bench->lists_done_o || bench->lists_full_o; }, [&] { full = bench->lists_full_o != 0; });
    return !full;
  }
  /// Edges of blocks in use go on by a line, some end: the same on both sides.
  void live_on(Machine& golden, Machine& other, SegmentPointer first, SegmentPointer last) {
    for (SegmentPointer p = first; p <= last; ++p) {
      vsg::SegmentBlock block = golden.memory.read(p);
      if (random_.once_in(3)) block.left_lines = 0;
      if (random_.once_in(3)) block.right_lines = 0;
      block.left.x = x_format().wrap(block.left.x + block.left.dx);
      block.right.x = x_format().wrap(block.right.x + block.right.dx);
      golden.store(p, block);
      static_cast<void>(other.memory.read(p));
      other.store(p, block);
    }
  }

  Random random_{11};
  ListsSurroundings rtl_{random_};
};

TEST_F(PolygonSegmentLists, InsertAsTheGoldenModel) {
  const std::int64_t before = compared();
  int full = 0;
  for (int scenario = 0; scenario < 150 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(200, 40);
    Machine golden(frame), other(frame);
    vsg::PolygonSegmentLists lists(golden.wiring, golden.samples);
    rtl_.start_frame(other);
    const auto polygons = random_.between(1, 6);
    const int used = static_cast<int>(random_.once_in(3) ? random_.between(40, 60) : 0);  // by others
    for (int i = 0; i < used; ++i) static_cast<void>(golden.take_block() + other.take_block());
    for (int step = 0; step < 100 && !HasFailure(); ++step) {
      if (random_.once_in(6)) {
        live_on(golden, other, used + 1, used + static_cast<int>(golden.tally.pq[vsg::pq::kBlocksNow]));
      }
      const auto polygon = static_cast<std::int32_t>(random_.between(1, polygons));
      const vsg::EdgeBlock edge = random_edge();
      const bool taken = insert(edge, polygon);
      try {
        lists.insert(edge, 0, polygon);
        ASSERT_TRUE(taken) << "step " << step;
      } catch (const vsg::FrameError&) {
        ASSERT_FALSE(taken) << "step " << step;
        ++full;
        break;
      }
    }
    expect_same(golden, other);
  }
  EXPECT_GT(compared(), before);
  EXPECT_GT(full, 0);
}

}  // namespace
}  // namespace blocks
