#include <gtest/gtest.h>

#include "cmodel/vsg/polygon_segment_lists.h"
#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

class SegmentEliminator : public testing::Test {
 protected:
  vsg::EdgeBlock random_edge() {
    vsg::EdgeBlock e;
    e.lines = static_cast<std::int32_t>(random_.between(1, 6));
    e.x = x_format().from_integer(random_.between(60, 140)) + random_.between(0, 4000);
    e.dx = random_.between(-(4 << 12), 4 << 12);
    e.z = random_.word(20), e.dz = random_.word(12);
    return e;
  }
  /// Edges enter on both sides, in polygons that need not be closed.
  void enter(Machine& golden, Machine& other, int polygons) {
    for (auto edges = random_.between(0, 7); edges > 0; --edges) {
      const vsg::EdgeBlock e = random_edge();
      const auto polygon = static_cast<std::int32_t>(random_.between(1, polygons));
      for (Machine* m : {&golden, &other}) {
        vsg::PolygonSegmentLists(m->wiring, m->samples).insert(e, 0, polygon);
        m->polygons.mark_changing(polygon);
      }
    }
  }
  /// The Depth Comparator takes every segment through the line: ends of edges mark polygons, the next list is made.
  static void sort(Machine& m) {
    m.space.span.left = 2;
    m.space.span.right = m.wiring.width + 1;
    m.comparator.sort_span();
  }
  void eliminate() {
    Bench<Vlists_bench>& bench = rtl_.bench();
    bench->eliminator_start_i = 1;
    rtl_.cycle();
    bench->eliminator_start_i = 0;
    rtl_.run([&] { return bench->eliminator_done_o != 0; });
  }
  void work(Machine& golden, Machine& other, int polygons) {
    for (int line = 0; line < 30 && !HasFailure(); ++line) {
      golden.start_line();
      other.start_line();
      enter(golden, other, polygons);
      golden.eliminator.run();
      eliminate();
      if (!expect_same(golden, other)) return;
      ++lines_;
      sort(golden);
      sort(other);
    }
  }

  Random random_{12};
  ListsSurroundings rtl_{random_};
  int lines_ = 0;
};

TEST_F(SegmentEliminator, PacksAsTheGoldenModel) {
  std::int64_t unclosed = 0, returned = 0;
  for (int scenario = 0; scenario < 60 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = empty_frame(200, 40);
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    try {
      work(golden, other, static_cast<int>(random_.between(1, 5)));
    } catch (const vsg::FrameError&) {
      // Segment memory is full, or an edge left the frame: the frame ends.
    }
    unclosed += golden.tally.unclosed_polygons;
    returned += golden.tally.q[vsg::q::kBlocksReturned];
  }
  EXPECT_GT(lines_, 0);
  EXPECT_GT(unclosed, 0);
  EXPECT_GT(returned, 0);
}

}  // namespace
}  // namespace blocks
