// A verilated lists_bench among golden neighbours: what the block under test asks of segment memory, free list, X-sort list
// and polygon memory is done by those of a machine of the golden model.
#pragma once

#include <gtest/gtest.h>

#include "Vlists_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {

class ListsSurroundings {
 public:
  explicit ListsSurroundings(Random& random) : random_(random) {}

  Bench<Vlists_bench>& bench() { return bench_; }
  Machine& machine() { return *machine_; }

  /// The frame starts: `machine` is what surrounds the block from now on.
  void start_frame(Machine& machine);
  /// One clock cycle; the ports of the neighbours are served.
  void cycle();
  /// Cycles until `done`, an output, is seen; it is sampled before the clock edge, `before_edge` then.
  template <class Done, class BeforeEdge>
  void run(Done done, BeforeEdge before_edge);
  template <class Done>
  void run(Done done) {
    run(done, [] {});
  }

 private:
  void serve();
  void show();
  void sort();

  Random& random_;
  Bench<Vlists_bench> bench_;
  MemoryPort memory_;
  Counting counting_;
  Machine* machine_ = nullptr;
  std::int64_t sort_wait_ = -1;  ///< cycles until the X-sort list is done
  vsg::SegmentBlock links_;
  std::int32_t taken_polygon_ = 0;
};

template <class Done, class BeforeEdge>
void ListsSurroundings::run(Done done, BeforeEdge before_edge) {
  for (int i = 0;; ++i) {
    ASSERT_LT(i, kMostCycles) << "the block hangs";
    bench_.settle();
    const bool last = done();
    if (last) before_edge();
    cycle();
    if (last) return;
  }
}

}  // namespace blocks
