// What a Visible Segment Generator answers for a frame: segments, counters, statistics.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cmodel/vsg/blocks.h"

namespace vsg {

/// The counters of the 1970 program, PQ and Q of its listing (appendix I), with its numbering from 1.
/// Q has ten columns: total, greatest of a line, average of all lines, pre-frame, greatest preparation of a line,
/// nanoseconds each could take at 30 frames a second, greatest depth sort of a line, average of involved lines,
/// total of preparation, total of depth sorting.
struct Statistics {
  static constexpr int kPq = 16, kQ = 26, kColumns = 10, kAdds = 20;
  std::array<std::int64_t, kPq + 1> pq{};
  std::array<std::array<std::int64_t, kColumns + 1>, kQ + 1> q{};
  std::array<std::int64_t, kAdds + 1> adds{};  ///< tests by their number of add cycles, as listed
};

/// Counts of one scan line.
struct LineCounts {
  std::int64_t references = 0;  ///< segment references of the line
  std::int64_t segments = 0;    ///< output segments of the line
};

/// Rows of figure 33 in their order; row 10 twice (real, and as the listing counted).
struct Counters {
  std::int64_t polygon_blocks = 0, edge_blocks = 0, edge_crossings = 0, implied_edges = 0, output_segments = 0;
  std::int64_t segment_blocks_total = 0, segment_blocks_max = 0, segment_references = 0;
  double reference_ratio = 0;
  std::int64_t add_cycles = 0;
  double add_cycles_per_test = 0, percent_not_at_end = 0;
  std::int64_t output_buffer = 0;
  std::int64_t add_cycles_listed = 0;
};

struct FrameAnswer {
  int width = 0, height = 0;
  std::vector<VisibleSegment> segments;
  Counters counters;
  Statistics statistics;
  std::vector<LineCounts> lines;  ///< lines[y - 1]
  std::int64_t depth_tests = 0, samples_stored = 0, subdivisions = 0, intersections = 0;
  std::int64_t stale_samples = 0;       ///< sample points read left of their span (non-convex polygons)
  std::int64_t unclosed_polygons = 0;   ///< a left edge without a right one, seen by the Segment Eliminator
  std::int64_t coherence_samples = 0;   ///< sample points taken from the frame before (chapter IV)
  std::vector<bool> edges_visible;      ///< with frame coherence: visible on the line it entered on; index: edge - 1
  std::int64_t port_accesses = 0;       ///< accesses of the single port of segment memory
  std::optional<std::int64_t> cycles;   ///< clock cycles, when RTL did the work
};

/// The processor cannot finish the frame: it stops with one of these and the frame has no answer.
class FrameError : public std::runtime_error {
 public:
  enum class Kind { kOutOfFrame, kSegmentMemoryFull, kEdgeMemoryFull, kPolygonMemoryFull, kTooManySpans };
  FrameError(Kind kind, int line);
  Kind kind() const { return kind_; }
  int line() const { return line_; }  ///< scan line, 0 before the first

 private:
  Kind kind_;
  int line_;
};

/// Golden model and RTL disagree; the text shows both sides. Exit status 2.
class LockstepError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace vsg
