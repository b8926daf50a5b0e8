#include "cmodel/vsg/depth_comparator.h"

#include <algorithm>

namespace vsg {

void DepthComparator::sort_span() {
  box_.segments = 0;
  from_x_sort_ = false;
  active_.start_span();
  SegmentPointer p = active_.first(), previous = 0;
  while (from_active_list(p, previous)) {
  }
  while (from_x_sort_list()) {
  }
}

bool DepthComparator::from_active_list(SegmentPointer& p, SegmentPointer& previous) {
  if (p == 0) return false;
  const SampleSpan& span = samples_.span;
  references_before_ = w_.tally.references() + w_.tally.q[q::kPipeline];
  tested_ = false;
  ++w_.tally.q[q::kSegmentReads];
  SegmentBlock block = w_.memory.read(p);
  const SegmentPointer next = block.active_next;
  const std::int64_t left = w_.x_format.integer(block.left.x), right = w_.x_format.integer(block.right.x);
  if (right > span.right) {
    previous = p;
    if (left < span.right) test(p, block);
  } else {
    ++w_.tally.q[q::kSegmentWrites];
    active_.remove(previous, next);
    if (right >= span.left) {
      ++w_.tally.q[q::kSegmentWrites];
      active_.add_ending(p, block);
      w_.memory.write(p, kGroupActive, block, w_.line);
      test(p, block);
    }
  }
  account();
  p = next;
  return true;
}

bool DepthComparator::from_x_sort_list() {
  const SegmentPointer p = x_sort_.front();
  if (p == 0) return false;
  references_before_ = w_.tally.references() + w_.tally.q[q::kPipeline];
  tested_ = false;
  ++w_.tally.q[q::kSegmentReads];
  SegmentBlock block = w_.memory.read(p);
  if (w_.next_pixel(block.left) >= samples_.span.right) return false;
  from_x_sort_ = true;
  x_sort_.pop(block);
  ++w_.tally.q[q::kIntercepts];
  block.left.x = w_.x_format.wrap(block.left.x + block.left.dx);
  block.right.x = w_.x_format.wrap(block.right.x + block.right.dx);
  block.left.z = w_.z_format.wrap(block.left.z + block.left.dz);
  block.right.z = w_.z_format.wrap(block.right.z + block.right.dz);
  ++block.left_lines;
  ++block.right_lines;
  block.implied ? step_implied(p, block) : step_segment(p, block);
  account();
  return true;
}

void DepthComparator::step_implied(SegmentPointer p, SegmentBlock& block) {
  SampleSpan& span = samples_.span;
  const std::int64_t next_pixel = w_.next_pixel(block.left);
  // It stays only when it made the left end of this span.
  if (w_.x_format.integer(block.left.x) + 1 != span.left || !w_.inside(next_pixel)) {
    w_.return_block(p);
    return;
  }
  span.at_left = {next_pixel, {p, 0}};
  x_sort_.insert_next_line(p, block, next_pixel);
  w_.memory.write(p, kGroupXLinks | kGroupLeft, block, w_.line);
}

void DepthComparator::step_segment(SegmentPointer p, SegmentBlock& block) {
  const SampleSpan& span = samples_.span;
  w_.tally.crossings += 2;
  const bool left_lives = block.left_lines < 0, right_lives = block.right_lines < 0;
  block.x_previous = kNotSorted;
  block.x_next = 0;
  if (left_lives) {
    const std::int64_t next_pixel = w_.next_pixel(block.left);
    if (!w_.inside(next_pixel)) w_.out_of_frame();
    x_sort_.insert_next_line(p, block, next_pixel);
  }
  if (right_lives && !w_.inside(w_.next_pixel(block.right))) w_.out_of_frame();
  if (!left_lives || !right_lives) {
    ++w_.tally.q[q::kPolygonReads];
    if (!w_.polygons.active(block.polygon)) {
      ++w_.tally.q[q::kPolygonWrites];
      w_.polygons.mark_changing(block.polygon);
    }
  }
  const std::int64_t left = w_.x_format.integer(block.left.x), right = w_.x_format.integer(block.right.x);
  if (left < right) right <= span.right ? active_.add_ending(p, block) : active_.add(p, block);
  w_.memory.write(p, kGroupAll & ~(kGroupPolygon | kGroupPolygonNext), block, w_.line);
  if (left < right) test(p, block);
}

void DepthComparator::test(SegmentPointer p, const SegmentBlock& block) {
  SampleSpan& span = samples_.span;
  ++w_.tally.q[q::kDepthTests];
  tested_ = true;
  const std::int64_t left = w_.x_format.integer(block.left.x), right = w_.x_format.integer(block.right.x);
  if (block.left_lines < 0 && left + 1 == span.left) span.at_left = {w_.next_pixel(block.left), {p, 0}, block.left.edge};
  if (block.right_lines < 0 && right == span.right) span.at_right = {w_.next_pixel(block.right), {p, 1}, block.right.edge};
  compare({p, block.polygon, block.left.x, block.right.x, block.left.z, block.right.z, left < span.left ? right : left}, false);
}

void DepthComparator::compare(const Candidate& c, bool intersecting) {
  const SampleSpan& span = samples_.span;
  searching_ = intersecting;
  add_cycles_ = from_x_sort_ ? 2 : 1;
  const std::int64_t left = std::max(w_.x_format.integer(c.x_left), span.left);
  const std::int64_t right = std::min(w_.x_format.integer(c.x_right), span.right);
  DepthOutcome outcome = DepthOutcome::kFirst;
  if (box_.segments == 0) {
    replace(c, left, right);
  } else {
    const ClipExtent extent{left <= box_.left, left >= box_.left, right <= box_.right, right >= box_.right};
    outcome = extent.disjoint_ends() ? DepthOutcome::kBoxed : clip(c, extent, left, right);
    if (outcome == DepthOutcome::kReplaces) replace(c, left, right);
    if (outcome == DepthOutcome::kBoxed) {
      ++box_.segments;
      searching_ ? search_crossing() : enlarge(c, extent, left, right);
    }
  }
  if (w_.events) {
    w_.events({EventKind::kDepthTest, w_.line,
               {c.p, from_x_sort_, intersecting, static_cast<std::int64_t>(outcome), add_cycles_, box_.segments, box_.z_min,
                box_.z_max, box_.left, box_.right, box_.edge, span.left, span.right}});
  }
}

DepthOutcome DepthComparator::clip(const Candidate& c, const ClipExtent& extent, std::int64_t left, std::int64_t right) {
  left_clip_ = w_.x_format.from_integer(std::max(left, box_.left));
  right_clip_ = w_.x_format.from_integer(std::min(right, box_.right));
  std::int64_t halvings = w_.x_format.integer(c.x_right) - w_.x_format.integer(c.x_left);
  if (searching_) halvings <<= 10;
  halvings = std::max(halvings, box_.halvings);

  const bool rising = c.rising();
  const std::int64_t z_min = std::min(c.z_left, c.z_right), z_max = std::max(c.z_left, c.z_right);
  new_left_.load(c.x_left - left_clip_, c.x_right - left_clip_, z_min, z_max, rising);
  new_right_.load(c.x_left - right_clip_, c.x_right - right_clip_, z_min, z_max, rising);
  // A box of several segments is loaded as the diagonal that falls against the new line.
  const bool one = box_.segments == 1, old_rising = one ? box_.rising : !rising;
  const std::int64_t at_left = rising ? box_.z_max : box_.z_min, at_right = rising ? box_.z_min : box_.z_max;
  old_left_.load(box_.x_left - left_clip_, box_.x_right - left_clip_, one ? box_.z_min : at_left,
                 one ? box_.z_max : at_left, old_rising);
  old_right_.load(box_.x_left - right_clip_, box_.x_right - right_clip_, one ? box_.z_min : at_right,
                  one ? box_.z_max : at_right, old_rising);
  for (;;) {
    ++add_cycles_;
    new_behind_left_ = new_left_.z_min >= old_left_.z_max;
    old_behind_left_ = old_left_.z_min >= new_left_.z_max;
    new_behind_right_ = new_right_.z_min >= old_right_.z_max;
    old_behind_right_ = old_right_.z_min >= new_right_.z_max;
    switch (clip_verdict(extent, new_behind_left_, old_behind_left_, new_behind_right_, old_behind_right_, halvings == 0)) {
      case ClipVerdict::kClip: break;
      case ClipVerdict::kNewInFront: return DepthOutcome::kReplaces;
      case ClipVerdict::kBoxed: return DepthOutcome::kBoxed;
      case ClipVerdict::kNewBehind: return DepthOutcome::kHidden;
    }
    halvings >>= 1;
    new_left_.step();
    new_right_.step();
    old_left_.step();
    old_right_.step();
  }
}

void DepthComparator::replace(const Candidate& c, std::int64_t left, std::int64_t right) {
  box_.segments = 1;
  box_.x_left = c.x_left;
  box_.x_right = c.x_right;
  box_.z_min = std::min(c.z_left, c.z_right);
  box_.z_max = std::max(c.z_left, c.z_right);
  box_.left = left;
  box_.right = right;
  box_.edge = c.edge;
  box_.front = c.p;
  box_.front_polygon = c.polygon;
  box_.rising = c.rising();
  box_.halvings = w_.x_format.integer(c.x_right) - w_.x_format.integer(c.x_left);
  if (searching_) box_.halvings <<= 10;
}

void DepthComparator::enlarge(const Candidate& c, const ClipExtent& extent, std::int64_t left, std::int64_t right) {
  if (extent.same()) {
    enlarge_same_extent(c.rising());
  } else {
    box_.z_min = std::min({box_.z_min, c.z_left, c.z_right});
    box_.z_max = std::max({box_.z_max, c.z_left, c.z_right});
  }
  if (extent.left_le) box_.left = left;
  if (extent.right_ge) box_.right = right;
  box_.edge = std::min(box_.edge, c.edge);
  box_.halvings = 0;
  box_.other = c.p;
  box_.other_polygon = c.polygon;
  if (!new_behind_left_) {
    std::swap(box_.other, box_.front);
    std::swap(box_.other_polygon, box_.front_polygon);
  }
}

// With equal extents the registers hold what was clipped away from: the box shrinks to the lines' Z in the span.
void DepthComparator::enlarge_same_extent(bool new_rising) {
  const bool old_rising = old_left_.rising;
  if (new_rising == old_rising) {
    const bool min_left = new_rising;
    const ClipQuadrant& new_low = min_left ? new_left_ : new_right_;
    const ClipQuadrant& old_low = min_left ? old_left_ : old_right_;
    const ClipQuadrant& new_high = min_left ? new_right_ : new_left_;
    const ClipQuadrant& old_high = min_left ? old_right_ : old_left_;
    const bool new_behind_low = min_left ? new_behind_left_ : new_behind_right_;
    const bool old_behind_low = min_left ? old_behind_left_ : old_behind_right_;
    const bool new_behind_high = min_left ? new_behind_right_ : new_behind_left_;
    const bool old_behind_high = min_left ? old_behind_right_ : old_behind_left_;
    if (new_behind_low) {
      box_.z_min = old_low.z_min;
    } else if (old_behind_low) {
      box_.z_min = new_low.z_min;
    }
    if (new_behind_high) {
      box_.z_max = new_high.z_max;
    } else if (old_behind_high) {
      box_.z_max = old_high.z_max;
    }
  } else if (new_rising) {
    box_.z_min = std::min(new_left_.z_min, old_right_.z_min);
    box_.z_max = std::max(new_right_.z_max, old_left_.z_max);
  } else {
    box_.z_min = std::min(new_right_.z_min, old_left_.z_min);
    box_.z_max = std::max(new_left_.z_max, old_right_.z_max);
  }
}

std::int64_t DepthComparator::intersect() {
  const SampleSpan& span = samples_.span;
  box_.segments = 0;
  for (int run = 0; run < 2; ++run) {
    const bool first = run == 0;
    const SegmentPointer p = first ? box_.front : box_.other;
    references_before_ = w_.tally.references() + w_.tally.q[q::kPipeline];
    tested_ = false;
    ++w_.tally.q[q::kSegmentReads];
    const SegmentBlock& block = w_.memory.read(p);
    // The edge inside the span has been judged: what the box holds stays.
    compare({p, first ? box_.front_polygon : box_.other_polygon, block.left.x, block.right.x, block.left.z, block.right.z,
             box_.edge}, true);
    account();
  }
  w_.tally.q[q::kSegmentReads] += 2;
  // A crossing that turned out a tie has no place of its own: the middle of the span stands for it.
  if (box_.segments != 2) return w_.x_format.from_integer((span.left + span.right) >> 1);
  return crossing_;
}

void DepthComparator::search_crossing() {
  std::int64_t x_left = left_clip_, x_right = right_clip_;
  std::int64_t z_left = new_left_.z_min - old_left_.z_min, z_right = new_right_.z_min - old_right_.z_min;
  for (std::int64_t extent = x_right - x_left; extent != 0; extent >>= 1) {
    ++add_cycles_;
    const std::int64_t x = (x_left + x_right) >> 1, z = (z_left + z_right) >> 1;
    const bool left_side = (z < 0) == (z_left < 0);
    (left_side ? x_left : x_right) = x;
    (left_side ? z_left : z_right) = z;
  }
  crossing_ = x_left;
}

void DepthComparator::account() {
  Tally& t = w_.tally;
  const std::int64_t references = t.references() + t.q[q::kPipeline] - references_before_;
  t.q[q::kWaiting] += std::max<std::int64_t>(0, ((add_cycles_ + 1) >> 1) - references);
  if (tested_) t.add_cycles += add_cycles_;
  add_cycles_ = std::clamp<std::int64_t>(add_cycles_, 1, Statistics::kAdds);
  ++t.adds[add_cycles_];
  t.add_cycles_listed += add_cycles_;
}

}  // namespace vsg
