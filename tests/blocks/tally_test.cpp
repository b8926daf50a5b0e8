// The counters against the golden model's tally, into which the testbench enters the counts of each cycle.
#include <gtest/gtest.h>

#include "Vsorter_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

CountFields random_counts(Random& random, const vsg::Tally& tally) {
  CountFields c{};
  const int rarity = static_cast<int>(random.between(1, 6));
  for (std::uint32_t& count : c) count = random.once_in(rarity) ? 1 : 0;
  c[kSegmentReads] = static_cast<std::uint32_t>(random.between(0, 2));
  c[kSegmentWrites] = static_cast<std::uint32_t>(random.between(0, 2));
  if (random.once_in(3)) c[kSegmentReads] = c[kSegmentWrites] = 0;
  c[kAddCycles] = c[kAccount] ? static_cast<std::uint32_t>(random.between(0, random.once_in(5) ? 60000 : 30)) : 0;
  c[kDensity] = static_cast<std::uint32_t>(random.between(-300, 300));
  // No block comes back that was not taken; one at a time is taken or returned.
  if (tally.pq[vsg::pq::kBlocksNow] == 0 || c[kBlocksTaken]) c[kBlocksReturned] = 0;
  return c;
}

void expect_counters(Bench<Vsorter_bench>& bench, const vsg::Tally& t, std::int64_t accesses) {
  const auto& word = bench->tally_counters_o;
  for (int i = 1; i <= vsg::q::kBucketReads; ++i) ASSERT_EQ(word[i], static_cast<std::uint32_t>(t.q[i])) << "counter " << i;
  const std::int64_t others[] = {t.crossings, t.implied_edges, t.insertions, t.not_at_end, t.add_cycles,
                                 t.add_cycles_listed, t.stale_samples, t.unclosed_polygons,
                                 t.pq[vsg::pq::kBlocksNow], t.pq[vsg::pq::kBlocksMost], t.pq[vsg::pq::kPointDensity],
                                 t.pq[vsg::pq::kInvolvedLines], t.pq[vsg::pq::kPolygons], t.pq[vsg::pq::kFrontPolygons],
                                 t.pq[vsg::pq::kEdges], t.pq[vsg::pq::kFrontEdges], t.pq[vsg::pq::kEnteredEdges], accesses};
  int i = 26;
  for (const std::int64_t value : others) {
    ASSERT_EQ(word[i], static_cast<std::uint32_t>(value)) << "counter " << i;
    ++i;
  }
  for (int adds = 1; adds <= vsg::Statistics::kAdds; ++adds, ++i) {
    ASSERT_EQ(word[i], static_cast<std::uint32_t>(t.adds[adds])) << "looks of " << adds << " add cycles";
  }
}

TEST(Tally, CountsAsTheGoldenModel) {
  Random random(7);
  Bench<Vsorter_bench> bench;
  int cycles = 0;
  for (int frame = 0; frame < 5; ++frame) {
    bench.start_frame();
    // References start from nothing in each frame, and so does the mark: a look begins before it ends.
    vsg::Tally tally;
    Counting counting;
    std::int64_t accesses = 0;
    bool looking = false;
    for (int cycle = 0; cycle < 4000; ++cycle, ++cycles) {
      CountFields counts = random_counts(random, tally);
      if (!looking) counts[kAccount] = 0;
      if (counts[kAccount]) counts[kMark] = 0;  // the next look begins later
      looking = looking || counts[kMark] != 0;
      const bool access = random.coin();
      for (std::size_t i = 0; i < counts.size(); ++i) bench->tally_count_i[i] = counts[i];
      bench->tally_port_access_i = access;
      bench.tick();
      counting.add(counts, tally);
      accesses += access ? 1 : 0;
      expect_counters(bench, tally, accesses);
      if (testing::Test::HasFatalFailure()) FAIL() << "frame " << frame << ", cycle " << cycle;
      const auto select = static_cast<int>(random.between(0, 63));
      bench->tally_select_i = static_cast<std::uint8_t>(select);
      bench.settle();
      ASSERT_EQ(bench->tally_counter_o, bench->tally_counters_o[select]);
    }
    for (std::size_t i = 0; i < kCountFields; ++i) bench->tally_count_i[i] = 0;
    bench->tally_port_access_i = 0;
  }
  EXPECT_GT(cycles, 0);
}

}  // namespace
}  // namespace blocks
