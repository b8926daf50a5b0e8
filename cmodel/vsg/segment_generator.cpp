#include "cmodel/vsg/segment_generator.h"

namespace vsg {

void SegmentGenerator::run() {
  ++w_.tally.q[q::kBucketReads];
  for (std::uint32_t number = edges_.bucket(w_.line); number != 0; number = edges_.next(number)) {
    ++w_.tally.q[q::kEdgeReads];
    ++w_.tally.q[q::kSlopes];
    const EdgeBlock& edge = edges_.edge(number);
    if (!w_.inside(w_.x_format.integer(edge.x))) w_.out_of_frame();
    if (edge.visible_before) coherence_.entered(w_.x_format.integer(edge.x));
    enter(number, edge.second_polygon);
    enter(number, edge.first_polygon);
  }
}

void SegmentGenerator::enter(std::uint32_t number, std::uint32_t polygon_number) {
  const auto polygon = static_cast<std::int32_t>(polygon_number);
  if (polygon == 0) return;
  ++w_.tally.q[q::kPolygonReads];
  if (!w_.polygons.front(polygon)) return;
  ++w_.tally.q[q::kPolygonWrites];
  w_.polygons.mark_changing(polygon);
  const EdgeBlock& edge = edges_.edge(number);
  if (w_.events) w_.events({EventKind::kEdgeTaken, w_.line, {number, polygon, edge.x}});
  lists_.insert(edge, number, polygon);
}

}  // namespace vsg
