// Random segments of a scan line, the same in two machines, for the testbenches of the Depth Sorter.
#pragma once

#include "tests/blocks/machine.h"
#include "tests/blocks/random.h"

namespace blocks {

class SegmentScene {
 public:
  /// A scene has a manner of its own: few or many segments, near or apart in depth, faulty or not.
  SegmentScene(Random& random, int width);

  /// Puts new segments into this line's X-sort lists of both machines, while they have blocks.
  void enter(Machine& golden, Machine& other);

 private:
  vsg::SegmentBlock random_segment();

  Random& random_;
  int width_;
  std::int64_t most_, slope_, depth_;
  bool coarse_, faulty_;
};

}  // namespace blocks
