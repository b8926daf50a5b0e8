#include "cmodel/vsg/decision_processor.h"

namespace vsg {

bool DecisionProcessor::decide() {
  const VisibleBox& box = comparator_.box();
  SampleSpan& span = samples_.span;
  const bool edge_inside = box.edge < span.right;
  DecisionKind kind = DecisionKind::kBackground;
  std::int64_t new_right = span.right;
  if (box.segments == 1) {
    kind = DecisionKind::kVisible;
  } else if (box.segments == 2 && !edge_inside) {
    kind = DecisionKind::kIntersection;
  } else if (box.segments >= 2) {
    kind = edge_inside ? DecisionKind::kSubdivideAtEdge : DecisionKind::kSubdivideInMiddle;
    new_right = edge_inside ? box.edge : (span.left + span.right) >> 1;
  }
  if (w_.events) {
    w_.events({EventKind::kDecision, w_.line,
               {static_cast<std::int64_t>(kind), span.left, span.right, box.segments, new_right, w_.tally.references()}});
  }
  ++w_.tally.q[q::kPipeline];
  switch (kind) {
    case DecisionKind::kBackground:
      span.at_left.pixel = 0;
      ++w_.tally.q[q::kSamplesDeleted];
      output(span.right, 0);
      return true;
    case DecisionKind::kVisible: output_visible(); return true;
    case DecisionKind::kIntersection: intersection(); return true;
    case DecisionKind::kSubdivideAtEdge: break;
    case DecisionKind::kSubdivideInMiddle: ++w_.tally.q[q::kHalvings]; break;
  }
  ++w_.tally.q[q::kSubdivisions];
  active_.restore_ending();
  span.at_right.pixel = 0;
  span.right = new_right;
  return false;
}

void DecisionProcessor::output_visible() {
  const VisibleBox& box = comparator_.box();
  const SampleSpan& span = samples_.span;
  if (box.left != span.left) output(box.left, 0);
  w_.tally.pq[pq::kPointDensity] += box.right - span.left;
  output(box.right, box.front_polygon);
  if (box.right != span.right) output(span.right, 0);
}

void DecisionProcessor::intersection() {
  SampleSpan& span = samples_.span;
  ++w_.tally.q[q::kIntersections];
  const std::int64_t x = comparator_.intersect();
  const VisibleBox& box = comparator_.box();
  const SamplePoint implied = implied_.crossing(box.front, box.other, x);
  w_.tally.pq[pq::kPointDensity] += span.right - span.left;
  output(w_.x_format.integer(x), box.front_polygon);
  if (implied.pixel != 0) span.at_left = implied;
  output(span.right, box.other_polygon);
}

void DecisionProcessor::output(std::int64_t x_end, std::int32_t polygon) {
  SampleSpan& span = samples_.span;
  if (segments_ != 0 && held_.polygon == static_cast<std::uint32_t>(polygon)) {
    span.at_left.pixel = 0;  // no visible edge here
    ++w_.tally.q[q::kSamplesDeleted];
  } else {
    if (segments_ != 0) hand_over();
    ++segments_;
    ++w_.tally.q[q::kOutputSegments];
    held_.polygon = static_cast<std::uint32_t>(polygon);
  }
  held_.y = w_.line;
  held_.x_end = static_cast<std::int32_t>(x_end);
  if (span.at_left.pixel != 0) {
    list_.store(span.at_left);
    coherence_.visible(span.at_left.edge);
  }
  span.at_left.pixel = 0;
}

void DecisionProcessor::hand_over() {
  output_.push_back(held_);
  if (w_.events) w_.events({EventKind::kOutputSegment, w_.line, {held_.x_end, held_.polygon}});
}

std::int64_t DecisionProcessor::finish_line() {
  hand_over();
  return segments_;
}

}  // namespace vsg
