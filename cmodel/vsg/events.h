// What the processor did, transaction by transaction. The golden model and the RTL's trace ports make the same
// events; lock-step compares them, and pictures (`--show`) and `vsg explain` are drawn from them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace vsg {

enum class EventKind : std::uint8_t {
  kEdgeTaken,      ///< the Segment Generator takes an edge for one of its polygons
  kBlockWritten,   ///< a write to segment memory: block, groups written, the whole word offered
  kDepthTest,      ///< the Depth Comparator has tried a segment against the box of the span
  kDecision,       ///< the Decision Processor has judged a span
  kSampleStored,   ///< an edge enters the sample list of the next scan line
  kOutputSegment,  ///< a visible segment (merged with its neighbour when the polygon is the same)
  kLineDone,       ///< a scan line is complete
};
constexpr std::size_t kEventKinds = 7;
constexpr std::size_t kMaxEventFields = 20;

/// Outcomes of a depth test (field `outcome`).
enum class DepthOutcome : std::int64_t {
  kHidden = 0,    ///< the new segment is behind the box
  kReplaces = 1,  ///< it is in front and becomes the one visible segment
  kBoxed = 2,     ///< neither: the box grows
  kFirst = 3,     ///< the first segment of the span
};

/// Decisions (field `decision`).
enum class DecisionKind : std::int64_t {
  kBackground = 0,        ///< nothing in the span
  kVisible = 1,           ///< one visible segment
  kSubdivideAtEdge = 2,   ///< the span is cut at an edge inside it
  kSubdivideInMiddle = 3, ///< more than two segments, no edge inside: cut in half
  kIntersection = 4,      ///< two segments cross
};

struct Event {
  EventKind kind = EventKind::kLineDone;
  std::int32_t line = 0;
  std::array<std::int64_t, kMaxEventFields> fields{};
};

/// Names of the fields of a kind, in the order of `Event::fields`; see events.cpp for the meaning of each.
std::span<const std::string_view> event_field_names(EventKind kind);
std::string_view event_name(EventKind kind);

/// Index of a field by its name; asserts that the kind has it.
std::size_t event_field(EventKind kind, std::string_view name);

using EventSink = std::function<void(const Event&)>;

}  // namespace vsg
