#include <gtest/gtest.h>

#include "Vmemories_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

class PolygonMemory : public testing::Test {
 protected:
  void cycle() {
    bench_.settle();
    counting_.add(counts_of(bench_->polygon_count_o), counted_);
    bench_.tick();
    bench_->polygon_load_i = bench_->polygon_read_i = bench_->polygon_mark_i = bench_->polygon_set_first_i = 0;
    bench_->polygon_take_i = 0;
    bench_.settle();
  }
  void load(const std::vector<vsg::PolygonBlock>& polygons) {
    bench_.start_frame();
    for (const vsg::PolygonBlock& polygon : polygons) {
      ASSERT_FALSE(bench_->polygon_load_full_o);
      bench_->polygon_load_i = 1;
      bench_->polygon_load_front_i = polygon.front;
      cycle();
    }
    ASSERT_EQ(bench_->polygon_load_full_o != 0, polygons.size() == bench_parameters().polygon_blocks);
  }
  void expect_word(const vsg::PolygonMemory& golden, std::int32_t polygon, bool active) {
    ASSERT_EQ(bench_->polygon_front_o != 0, golden.front(polygon)) << "polygon " << polygon;
    ASSERT_EQ(bench_->polygon_active_o != 0, active) << "polygon " << polygon;
    ASSERT_EQ(bench_->polygon_first_segment_o, static_cast<std::uint32_t>(golden.first_segment(polygon)))
        << "polygon " << polygon;
    ++words_;
  }
  void read(const vsg::PolygonMemory& golden, std::int32_t polygon) {
    bench_->polygon_read_i = 1;
    bench_->polygon_read_polygon_i = port(polygon);
    cycle();
    expect_word(golden, polygon, golden.active(polygon));
  }

  Bench<Vmemories_bench> bench_;
  Counting counting_;
  vsg::Tally counted_;
  int words_ = 0;
};

TEST_F(PolygonMemory, KeepsWordsAndTheChangingList) {
  Random random(5);
  int taken = 0;
  for (int frame = 0; frame < 20; ++frame) {
    const int greatest = static_cast<int>(bench_parameters().polygon_blocks);
    const auto count = frame == 0 ? greatest : static_cast<int>(random.between(1, greatest));
    std::vector<vsg::PolygonBlock> polygons(static_cast<std::size_t>(count));
    for (vsg::PolygonBlock& polygon : polygons) polygon.front = random.coin();
    vsg::Tally tally;
    counted_ = {};
    vsg::PolygonMemory golden(polygons, bench_parameters().polygon_blocks, tally);
    load(polygons);
    EXPECT_EQ(counted_.q, tally.q);
    EXPECT_EQ(counted_.pq, tally.pq);
    for (int step = 0; step < 500 && !HasFailure(); ++step) {
      const auto polygon = static_cast<std::int32_t>(random.between(1, count));
      switch (random.between(0, 3)) {
        case 0:
          read(golden, polygon);
          break;
        case 1:  // as its users do: a polygon is marked after it was read, when it is not yet in the list
          read(golden, polygon);
          if (!golden.active(polygon)) {
            bench_->polygon_mark_i = 1;
            cycle();
            golden.mark_changing(polygon);
          }
          break;
        case 2: {
          const auto segment = static_cast<std::int32_t>(random.between(0, bench_parameters().segment_blocks));
          bench_->polygon_set_first_i = 1;
          bench_->polygon_set_polygon_i = port(polygon);
          bench_->polygon_set_segment_i = port(segment);
          cycle();
          golden.set_first_segment(polygon, segment);
          break;
        }
        default: {
          const std::int32_t changing = golden.take_changing();
          ASSERT_EQ(bench_->polygon_changing_o, static_cast<std::uint32_t>(changing));
          if (changing == 0) break;
          bench_->polygon_take_i = 1;
          cycle();
          expect_word(golden, changing, true);
          cycle();
          ++taken;
          break;
        }
      }
    }
  }
  EXPECT_GT(words_, 0);
  EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace blocks
