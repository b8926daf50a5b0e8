#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "Vmemories_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

vsg::FrameBlocks random_frame(Random& random) {
  vsg::FrameBlocks frame = empty_frame(200, static_cast<int>(random.between(2, 255)));
  for (vsg::PolygonBlock& polygon : frame.polygons) polygon.front = !random.once_in(3);
  const auto greatest = static_cast<std::int64_t>(frame.polygons.size());
  const bool faulty = random.once_in(4);  // its edges may leave the frame
  // One more than there are numbers, now and then.
  const auto edges = random.once_in(8) ? bench_parameters().edge_blocks + (random.coin() ? 1 : 0) : random.between(0, 40);
  for (std::int64_t i = 0; i < edges; ++i) {
    vsg::EdgeBlock e;
    e.first_polygon = static_cast<std::uint32_t>(random.between(1, greatest));
    e.second_polygon = static_cast<std::uint32_t>(random.coin() ? 0 : random.between(1, greatest));
    e.first_line = static_cast<std::int32_t>(random.between(faulty && random.once_in(20) ? 0 : 1, frame.height - 1));
    if (random.coin()) e.first_line = std::min(e.first_line, 3);
    const int room = frame.height - e.first_line;
    e.lines = random.once_in(6) ? 0 : static_cast<std::int32_t>(random.between(0, std::max(0, room - 1)));
    if (random.once_in(4)) e.lines = std::max(0, room - 1);
    if (faulty && random.once_in(20)) e.lines = std::min(room + static_cast<int>(random.between(0, 3)), 255);
    e.x = random.word(x_format().bits), e.dx = random.word(x_format().bits);
    e.z = random.word(z_format().bits), e.dz = random.word(z_format().bits);
    frame.edges.push_back(e);
  }
  return frame;
}

class EdgeMemory : public testing::Test {
 protected:
  void cycle(const vsg::FrameBlocks& frame) {
    bench_.settle();
    counting_.add(counts_of(bench_->edge_count_o), counted_);
    const bool read = bench_->edge_polygon_read_o != 0;
    const std::uint32_t polygon = bench_->edge_polygon_o;
    bench_.tick();
    if (read) bench_->edge_polygon_front_i = polygon != 0 && frame.polygons[polygon - 1].front;
    bench_.settle();
  }
  void load(const vsg::FrameBlocks& frame, Random& random) {
    bench_->edge_height_i = port(frame.height);
    bench_.start_frame();
    for (const vsg::EdgeBlock& e : frame.edges) {
      while (random.once_in(4)) cycle(frame);
      bench_->edge_load_valid_i = 1;
      bench_->edge_first_polygon_i = e.first_polygon;
      bench_->edge_second_polygon_i = e.second_polygon;
      bench_->edge_first_line_i = port(e.first_line);
      bench_->edge_lines_i = port(e.lines);
      bench_->edge_x_i = static_cast<std::uint64_t>(e.x);
      bench_->edge_dx_i = static_cast<std::uint64_t>(e.dx);
      bench_->edge_z_i = static_cast<std::uint64_t>(e.z);
      bench_->edge_dz_i = static_cast<std::uint64_t>(e.dz);
      bench_.settle();
      for (int i = 0; !bench_->edge_load_ready_o && bench_->edge_error_o == 0; ++i) {
        ASSERT_LT(i, kMostCycles);
        cycle(frame);
      }
      if (bench_->edge_error_o == 0) cycle(frame);
      bench_->edge_load_valid_i = 0;
      bench_.settle();
      if (bench_->edge_error_o != 0) return;
    }
    for (int i = 0; bench_->edge_loading_o; ++i) {
      ASSERT_LT(i, kMostCycles);
      cycle(frame);
    }
  }
  void expect_buckets(const vsg::EdgeMemory& golden, const vsg::FrameBlocks& frame) {
    for (int line = 0; line <= frame.height; ++line) {
      bench_->edge_bucket_read_i = 1;
      bench_->edge_bucket_line_i = port(line);
      cycle(frame);
      bench_->edge_bucket_read_i = 0;
      std::uint32_t number = bench_->edge_bucket_edge_o;
      ASSERT_EQ(number, golden.bucket(line)) << "line " << line;
      while (number != 0) {
        bench_->edge_read_i = 1;
        bench_->edge_number_i = number;
        cycle(frame);
        bench_->edge_read_i = 0;
        const vsg::EdgeBlock& e = golden.edge(number);
        ASSERT_EQ(bench_->edge_first_polygon_o, e.first_polygon);
        ASSERT_EQ(bench_->edge_second_polygon_o, e.second_polygon);
        ASSERT_EQ(bench_->edge_first_line_o, static_cast<std::uint32_t>(e.first_line));
        ASSERT_EQ(bench_->edge_lines_o, static_cast<std::uint32_t>(e.lines));
        ASSERT_EQ(x_format().wrap(static_cast<std::int64_t>(bench_->edge_x_o)), e.x);
        ASSERT_EQ(x_format().wrap(static_cast<std::int64_t>(bench_->edge_dx_o)), e.dx);
        ASSERT_EQ(z_format().wrap(static_cast<std::int64_t>(bench_->edge_z_o)), e.z);
        ASSERT_EQ(z_format().wrap(static_cast<std::int64_t>(bench_->edge_dz_o)), e.dz);
        ASSERT_EQ(bench_->edge_next_o, golden.next(number)) << "edge " << number;
        number = bench_->edge_next_o;
        ++edges_;
      }
    }
  }

  Bench<Vmemories_bench> bench_;
  Counting counting_;
  vsg::Tally counted_;
  int edges_ = 0;
};

TEST_F(EdgeMemory, SortsAndRefusesAsTheGoldenModel) {
  Random random(6);
  int refused = 0, full = 0;
  for (int i = 0; i < 200 && !HasFatalFailure(); ++i) {
    SCOPED_TRACE(testing::Message() << "frame " << i);
    const vsg::FrameBlocks frame = random_frame(random);
    vsg::Tally tally, none;
    const vsg::PolygonMemory polygons(frame.polygons, bench_parameters().polygon_blocks, none);
    std::optional<vsg::EdgeMemory> golden;
    std::optional<vsg::FrameError::Kind> refusal;
    try {
      golden.emplace(frame, bench_parameters().edge_blocks, polygons, tally);
    } catch (const vsg::FrameError& error) {
      refusal = error.kind();
    }
    counted_ = {};
    load(frame, random);
    ASSERT_FALSE(HasFatalFailure());
    if (refusal) {
      EXPECT_EQ(bench_->edge_error_o, 1u + static_cast<unsigned>(*refusal));
      *refusal == vsg::FrameError::Kind::kEdgeMemoryFull ? ++full : ++refused;
    } else {
      EXPECT_EQ(bench_->edge_error_o, 0u);
      EXPECT_EQ(counted_.q, tally.q);
      EXPECT_EQ(counted_.pq, tally.pq);
      expect_buckets(*golden, frame);
    }
  }
  EXPECT_GT(edges_, 0);
  EXPECT_GT(refused, 0);
  EXPECT_GT(full, 0);
}

}  // namespace
}  // namespace blocks
