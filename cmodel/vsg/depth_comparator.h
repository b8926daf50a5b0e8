// Depth Comparator (chapters III.F, G, I): runs through the segments of a span, steps those that are new on this line, and
// keeps the visible box. rtl/vsg/depth_comparator.sv
#pragma once

#include "cmodel/vsg/active_list.h"
#include "cmodel/vsg/clipper.h"
#include "cmodel/vsg/polygon_memory.h"
#include "cmodel/vsg/sample_space_generator.h"
#include "cmodel/vsg/wiring.h"
#include "cmodel/vsg/x_sort.h"

namespace vsg {

/// Visible box: the segments that may be visible in the span. With one segment it is that segment's line.
struct VisibleBox {
  int segments = 0;
  std::int64_t x_left = 0, x_right = 0;   ///< of the one segment; fixed point
  std::int64_t z_min = 0, z_max = 0;      ///< fixed point
  std::int64_t left = 0, right = 0;       ///< ends clipped to the span; pixels
  std::int64_t edge = 0;                  ///< leftmost edge known inside the span; pixel
  SegmentPointer front = 0, other = 0;    ///< the two segments of a crossing; `front` is in front on the left
  std::int32_t front_polygon = 0, other_polygon = 0;
  bool rising = false;                    ///< of the one segment
  std::int64_t halvings = 0;              ///< extent in pixels, halved to know when clipping is exhausted
};

class DepthComparator {
 public:
  DepthComparator(Wiring& wiring, XSort& x_sort, ActiveList& active, SampleSpaceGenerator& samples)
      : w_(wiring), x_sort_(x_sort), active_(active), samples_(samples) {}

  /// Builds the box of the span from the active list and the X-sort list.
  void sort_span();

  /// Runs the registers to 0 or -1 for the two segments of the box, then searches the crossing (figure 21). Returns its X.
  std::int64_t intersect();

  const VisibleBox& box() const { return box_; }

 private:
  /// A segment as the registers are loaded from it.
  struct Candidate {
    SegmentPointer p = 0;
    std::int32_t polygon = 0;
    std::int64_t x_left = 0, x_right = 0, z_left = 0, z_right = 0;
    std::int64_t edge = 0;   ///< leftmost edge inside the span
    bool rising() const { return z_left < z_right; }
  };

  bool from_active_list(SegmentPointer& p, SegmentPointer& previous);
  bool from_x_sort_list();
  void step_implied(SegmentPointer p, SegmentBlock& block);
  void step_segment(SegmentPointer p, SegmentBlock& block);
  void test(SegmentPointer p, const SegmentBlock& block);
  void compare(const Candidate& c, bool intersecting);
  DepthOutcome clip(const Candidate& c, const ClipExtent& extent, std::int64_t left, std::int64_t right);
  void replace(const Candidate& c, std::int64_t left, std::int64_t right);
  void enlarge(const Candidate& c, const ClipExtent& extent, std::int64_t left, std::int64_t right);
  void enlarge_same_extent(bool new_rising);
  void search_crossing();
  /// Every segment looked at, tested or not, is entered into the histogram of add cycles.
  void account();

  Wiring& w_;
  XSort& x_sort_;
  ActiveList& active_;
  SampleSpaceGenerator& samples_;
  VisibleBox box_;

  // Registers of figures 12 and 21: new segment and box, at the left and at the right clip point.
  ClipQuadrant new_left_, new_right_, old_left_, old_right_;
  std::int64_t left_clip_ = 0, right_clip_ = 0;  ///< fixed point
  bool new_behind_left_ = false, old_behind_left_ = false, new_behind_right_ = false, old_behind_right_ = false;
  std::int64_t crossing_ = 0;

  bool from_x_sort_ = false;  ///< the span has reached the X-sort list
  bool tested_ = false;       ///< the segment being looked at was really tested
  bool searching_ = false;    ///< the intersection is being found
  std::int64_t add_cycles_ = 0;
  std::int64_t references_before_ = 0;
};

}  // namespace vsg
