#include "cmodel/vsg/edge_memory.h"

namespace vsg {

EdgeMemory::EdgeMemory(const FrameBlocks& frame, std::uint32_t capacity, const PolygonMemory& polygons, Tally& tally)
    : edges_(frame.edges), buckets_(frame.height + 1), next_(frame.edges.size() + 1) {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (i == capacity) throw FrameError(FrameError::Kind::kEdgeMemoryFull, 0);
    const EdgeBlock& e = edges_[i];
    ++tally.pq[pq::kEdges];
    ++tally.q[q::kEdgeReads];
    // The polygon blocks are looked at one after the other, the second only when the first does not decide.
    if (e.first_polygon != 0) ++tally.q[q::kPolygonReads];
    bool front = e.first_polygon != 0 && polygons.front(static_cast<std::int32_t>(e.first_polygon));
    if (!front && e.second_polygon != 0 && polygons.front(static_cast<std::int32_t>(e.second_polygon))) {
      ++tally.q[q::kPolygonReads];
      front = true;
    }
    if (!front) continue;
    ++tally.pq[pq::kFrontEdges];
    if (e.lines == 0) continue;
    ++tally.pq[pq::kEnteredEdges];
    if (e.first_line <= 0 || e.first_line - 1 + e.lines >= frame.height) {
      throw FrameError(FrameError::Kind::kOutOfFrame, 0);
    }
    ++tally.q[q::kEdgeWrites];
    next_[i + 1] = buckets_[e.first_line];
    buckets_[e.first_line] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace vsg
