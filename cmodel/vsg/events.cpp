#include "cmodel/vsg/events.h"

#include <cassert>

namespace vsg {
namespace {

using Names = std::span<const std::string_view>;

// edge, polygon: numbers; x: X at its first line (fixed point).
constexpr std::string_view kEdgeTaken[] = {"edge", "polygon", "x"};
// mask: groups written (segment_memory.h); the rest is the word offered, whether its group is written or not.
constexpr std::string_view kBlockWritten[] = {"block",   "mask",    "x_previous", "x_next", "polygon", "polygon_next",
                                              "left_lines", "left_x", "left_dx", "left_z", "left_dz", "right_lines",
                                              "right_x", "right_dx", "right_z", "right_dz", "implied", "active_next"};
// from_x_sort: 1 when the segment came from the X-sort list, 0 from the active list. intersecting: 1 for the two runs
// that find an intersection. box_*: the box after the test (Z fixed point, X whole pixels).
constexpr std::string_view kDepthTest[] = {"segment",   "from_x_sort", "intersecting", "outcome",  "add_cycles", "box_segments",
                                           "box_z_min", "box_z_max",   "box_left",     "box_right", "box_edge",  "span_left",
                                           "span_right"};
// references: segment references of the frame so far, as the 1970 program counts them.
constexpr std::string_view kDecision[] = {"decision", "span_left", "span_right", "box_segments", "new_right", "references"};
// side: 0 the left edge of the block, 1 the right one. x: pixel of the edge on the next line.
constexpr std::string_view kSampleStored[] = {"block", "side", "x"};
constexpr std::string_view kOutputSegment[] = {"x_end", "polygon"};
constexpr std::string_view kLineDone[] = {"references", "segments"};

}  // namespace

Names event_field_names(EventKind kind) {
  switch (kind) {
    case EventKind::kEdgeTaken: return kEdgeTaken;
    case EventKind::kBlockWritten: return kBlockWritten;
    case EventKind::kDepthTest: return kDepthTest;
    case EventKind::kDecision: return kDecision;
    case EventKind::kSampleStored: return kSampleStored;
    case EventKind::kOutputSegment: return kOutputSegment;
    case EventKind::kLineDone: return kLineDone;
  }
  return {};
}

std::string_view event_name(EventKind kind) {
  constexpr std::string_view kNames[] = {"edge taken",     "segment block written", "depth test", "decision",
                                         "sample stored", "output segment",        "line done"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::size_t event_field(EventKind kind, std::string_view name) {
  const Names names = event_field_names(kind);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return i;
  }
  assert(!"the kind has no such field");
  return 0;
}

}  // namespace vsg
