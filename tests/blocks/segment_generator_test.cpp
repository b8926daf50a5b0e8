#include <gtest/gtest.h>

#include "cmodel/vsg/polygon_segment_lists.h"
#include "tests/blocks/lists_surroundings.h"

namespace blocks {
namespace {

vsg::FrameBlocks random_frame(Random& random) {
  vsg::FrameBlocks frame = empty_frame(200, 20);
  for (vsg::PolygonBlock& polygon : frame.polygons) polygon.front = !random.once_in(3);
  const bool faulty = random.once_in(5), crowded = random.once_in(5);
  for (auto edges = random.between(1, crowded ? 64 : 30); edges > 0; --edges) {
    vsg::EdgeBlock e;
    e.first_polygon = static_cast<std::uint32_t>(random.between(1, crowded ? 60 : 10));
    e.second_polygon = static_cast<std::uint32_t>(random.once_in(3) ? 0 : random.between(1, crowded ? 60 : 10));
    e.first_line = static_cast<std::int32_t>(random.between(1, 6));
    e.lines = static_cast<std::int32_t>(random.between(1, 10));
    e.x = x_format().from_integer(random.between(1, 200)) + random.between(0, 4095);
    if (random.once_in(10)) e.x = x_format().from_integer(random.coin() ? 1 : 200);
    if (faulty && random.once_in(10)) e.x = random.word(x_format().bits);
    e.dx = random.word(16), e.z = random.word(20), e.dz = random.word(16);
    frame.edges.push_back(e);
  }
  return frame;
}

class SegmentGenerator : public testing::Test {
 protected:
  /// One line; the kind of the error that ended it, if one did.
  std::uint32_t work_line(Machine& other) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    vsg::PolygonSegmentLists lists(other.wiring, other.samples);
    bench->generator_start_i = 1;
    bool done = false;
    bool full = false;
    std::int64_t insert_wait = -1;
    for (int cycle = 0; !done && bench->generator_error_o == 0; ++cycle) {
      EXPECT_LT(cycle, kMostCycles);
      if (cycle == kMostCycles) return 0;
      bench->insert_done_i = insert_wait == 0 && !full;
      bench->insert_full_i = insert_wait == 0 && full;
      if (insert_wait >= 0) --insert_wait;
      bench.settle();
      done = bench->generator_done_o != 0;
      if (bench->insert_o) {
        EXPECT_TRUE(bench->taken_o);
        EXPECT_EQ(bench->taken_polygon_o, bench->enter_polygon_o);
        full = !enter(other, lists);
        insert_wait = random_.between(0, 4);
      }
      const bool bucket = bench->bucket_read_o != 0, edge = bench->edge_read_o != 0, polygon = bench->polygon_read_o != 0;
      const std::uint32_t edge_number = bench->edge_number_o, polygon_number = bench->polygon_o;
      if (bench->polygon_mark_o) other.polygons.mark_changing(read_polygon_);
      rtl_.cycle();
      bench->generator_start_i = 0;
      if (bucket) bench->bucket_edge_i = other.edges.bucket(other.wiring.line);
      if (edge) show_edge(other, edge_number);
      if (polygon) read_polygon_ = static_cast<std::int32_t>(polygon_number);
      if (read_polygon_ != 0) {
        bench->polygon_front_i = other.polygons.front(read_polygon_);
        if (polygon) bench->polygon_active_i = other.polygons.active(read_polygon_);
      }
    }
    bench->insert_done_i = bench->insert_full_i = 0;
    return bench->generator_error_o;
  }
  bool enter(Machine& other, vsg::PolygonSegmentLists& lists) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    const std::uint32_t number = bench->taken_number_o;
    const auto polygon = static_cast<std::int32_t>(bench->taken_polygon_o);
    other.seen.push_back({vsg::EventKind::kEdgeTaken, other.wiring.line,
                          {number, polygon, x_format().wrap(static_cast<std::int64_t>(bench->taken_x_o))}});
    ++entered_;
    try {
      lists.insert(other.edges.edge(number), number, polygon);
    } catch (const vsg::FrameError&) {
      return false;
    }
    return true;
  }
  void show_edge(const Machine& other, std::uint32_t number) {
    Bench<Vlists_bench>& bench = rtl_.bench();
    const vsg::EdgeBlock& e = other.edges.edge(number);
    bench->edge_first_polygon_i = e.first_polygon;
    bench->edge_second_polygon_i = e.second_polygon;
    bench->edge_lines_i = port(e.lines);
    bench->edge_x_i = static_cast<std::uint64_t>(e.x);
    bench->edge_dx_i = static_cast<std::uint64_t>(e.dx);
    bench->edge_z_i = static_cast<std::uint64_t>(e.z);
    bench->edge_dz_i = static_cast<std::uint64_t>(e.dz);
    bench->edge_next_i = other.edges.next(number);
  }

  Random random_{15};
  ListsSurroundings rtl_{random_};
  std::int32_t read_polygon_ = 0;
  int entered_ = 0;
};

TEST_F(SegmentGenerator, TakesEdgesAsTheGoldenModel) {
  int out_of_frame = 0, full = 0;
  for (int scenario = 0; scenario < 200 && !HasFailure(); ++scenario) {
    SCOPED_TRACE(testing::Message() << "scenario " << scenario);
    const vsg::FrameBlocks frame = random_frame(random_);
    Machine golden(frame), other(frame);
    rtl_.start_frame(other);
    // Others may hold most of segment memory.
    const auto used = random_.once_in(4) ? random_.between(40, 60) : 0;
    for (int i = 0; i < used; ++i) static_cast<void>(golden.take_block() + other.take_block());
    std::uint32_t error = 0;
    for (int line = 1; line <= 7 && error == 0 && !HasFailure(); ++line) {
      golden.start_line();
      other.start_line();
      std::uint32_t expected = 0;
      try {
        golden.generator.run();
      } catch (const vsg::FrameError& e) {
        expected = 1 + static_cast<std::uint32_t>(e.kind());
        ++(e.kind() == vsg::FrameError::Kind::kOutOfFrame ? out_of_frame : full);
      }
      error = work_line(other);
      EXPECT_EQ(error, expected) << "line " << line;
      expect_same(golden, other);
    }
  }
  EXPECT_GT(entered_, 0);
  EXPECT_GT(out_of_frame, 0);
  EXPECT_GT(full, 0);
}

}  // namespace
}  // namespace blocks
