// Running counts of a frame. `q` and `pq` have the numbers of the 1970 program (see Statistics); what it had no counter
// for stands beside them. The RTL's tally unit has the same registers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "cmodel/vsg/answer.h"

namespace vsg {

/// Numbers of the counters of the listing that the processor itself steps.
namespace q {
constexpr int kSlopes = 1, kIntercepts = 2, kSamplesStored = 3, kSubdivisions = 4, kDepthTests = 6, kSamplesDeleted = 8,
              kStepsBack = 9, kOutputSegments = 10, kIntersections = 11, kHalvings = 12, kPipeline = 13, kWaiting = 14,
              kPolygonReads = 15, kPolygonWrites = 16, kEdgeReads = 17, kEdgeWrites = 18, kSegmentReads = 19,
              kSegmentWrites = 20, kBlocksTaken = 23, kBlocksReturned = 24, kBucketReads = 25;
}
namespace pq {
constexpr int kBlocksTotal = 1, kBlocksMost = 2, kBlocksNow = 3, kEdges = 4, kFrontEdges = 5, kEnteredEdges = 6,
              kPolygons = 7, kFrontPolygons = 8, kPointDensity = 9, kInvolvedLines = 10;
}

struct Tally {
  std::array<std::int64_t, Statistics::kQ + 1> q{};
  std::array<std::int64_t, Statistics::kPq + 1> pq{};
  std::array<std::int64_t, Statistics::kAdds + 1> adds{};
  std::int64_t crossings = 0;          ///< two for each segment incremented
  std::int64_t implied_edges = 0;      ///< implied edge blocks taken
  std::int64_t insertions = 0;         ///< into the X-sort list of the next line
  std::int64_t not_at_end = 0;         ///< of these, the ones that had to go back
  std::int64_t add_cycles = 0;         ///< of real depth tests
  std::int64_t add_cycles_listed = 0;  ///< as the listing sums them
  std::int64_t stale_samples = 0;
  std::int64_t unclosed_polygons = 0;
  std::int64_t coherence_samples = 0;

  std::int64_t references() const { return q[q::kSegmentReads] + q[q::kSegmentWrites]; }

  void block_taken() {
    ++q[q::kBlocksTaken];
    ++pq[pq::kBlocksTotal];
    ++pq[pq::kBlocksNow];
    pq[pq::kBlocksMost] = std::max(pq[pq::kBlocksMost], pq[pq::kBlocksNow]);
  }
  void block_returned() {
    ++q[q::kBlocksReturned];
    --pq[pq::kBlocksNow];
  }
};

/// Makes the ten columns of the statistics from snapshots of `q` at the phases of each scan line.
class StatisticsRecorder {
 public:
  void frame_started(const Tally& tally);      ///< after edges and polygons were loaded
  void line_started(const Tally& tally);       ///< before segment generation
  void depth_sort_started(const Tally& tally);  ///< after segment elimination
  void line_finished(const Tally& tally);
  /// `height`: scan lines of the frame.
  Statistics finish(const Tally& tally, int height);

 private:
  Statistics s_;
};

/// Everything of an answer but segments, lines, cycles and port accesses, which the caller has filled in.
void complete_answer(FrameAnswer& answer, const Tally& tally, const Statistics& statistics, const Parameters& parameters);

/// Row 13 (chapter VII.D): the greatest number of segments buffered when every scan line is produced as late as its
/// deadline allows, a segment reference taking `memory_cycle_ns`, 30 frames a second, frames repeating.
std::int64_t output_buffer(const std::vector<LineCounts>& lines, int memory_cycle_ns);

}  // namespace vsg
