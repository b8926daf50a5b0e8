#include "cmodel/vsg/polygon_memory.h"

namespace vsg {

PolygonMemory::PolygonMemory(const std::vector<PolygonBlock>& polygons, std::uint32_t capacity, Tally& tally)
    : words_(polygons.size() + 1) {
  if (polygons.size() > capacity) throw FrameError(FrameError::Kind::kPolygonMemoryFull, 0);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    words_[i + 1].front = polygons[i].front;
    ++tally.pq[pq::kPolygons];
    ++tally.q[q::kPolygonWrites];
    if (polygons[i].front) ++tally.pq[pq::kFrontPolygons];
  }
}

}  // namespace vsg
