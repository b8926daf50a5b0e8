#include "cmodel/vsg/tally.h"

#include <charconv>

namespace vsg {
namespace {

constexpr double kFramesPerSecond = 30;

// Columns of Statistics::q.
enum Column { kTotal = 1, kMostOfLine, kAverage, kPreFrame, kMostPreparing, kNanoseconds, kMostSorting, kAverageInvolved,
              kPreparing, kSorting };

/// To four decimals as they are printed: the exact binary value decides, a tie goes to the even digit.
double rounded(double value) {
  char text[64];
  const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 4).ptr;
  std::from_chars(text, end, value);
  return value;
}

double ratio(std::int64_t a, std::int64_t b, double scale = 1) {
  return b == 0 ? 0 : rounded(scale * static_cast<double>(a) / static_cast<double>(b));
}

}  // namespace

void StatisticsRecorder::frame_started(const Tally& tally) {
  for (int i = 1; i <= Statistics::kQ; ++i) s_.q[i][kPreFrame] = tally.q[i];
}

void StatisticsRecorder::line_started(const Tally& tally) {
  for (int i = 1; i <= Statistics::kQ; ++i) {
    s_.q[i][kNanoseconds] = tally.q[i];  // until the end, columns 3, 6 and 8 hold what a phase started with
    s_.q[i][kPreparing] -= tally.q[i];
    s_.q[i][kAverage] = tally.q[i];
  }
}

void StatisticsRecorder::depth_sort_started(const Tally& tally) {
  for (int i = 1; i <= Statistics::kQ; ++i) {
    auto& row = s_.q[i];
    row[kNanoseconds] = tally.q[i] - row[kNanoseconds];
    row[kMostPreparing] = std::max(row[kMostPreparing], row[kNanoseconds]);
    row[kPreparing] += tally.q[i];
    row[kSorting] -= tally.q[i];
    row[kAverageInvolved] = tally.q[i];
  }
}

void StatisticsRecorder::line_finished(const Tally& tally) {
  for (int i = 1; i <= Statistics::kQ; ++i) {
    auto& row = s_.q[i];
    row[kSorting] += tally.q[i];
    row[kAverage] = tally.q[i] - row[kAverage];
    row[kMostOfLine] = std::max(row[kMostOfLine], row[kAverage]);
    row[kAverageInvolved] = tally.q[i] - row[kAverageInvolved];
    row[kMostSorting] = std::max(row[kMostSorting], row[kAverageInvolved]);
  }
}

Statistics StatisticsRecorder::finish(const Tally& tally, int height) {
  const auto nanoseconds = [](std::int64_t count) {
    return count == 0 ? 0 : static_cast<std::int64_t>(1e9 / (kFramesPerSecond * static_cast<double>(count)));
  };
  for (int i = 0; i <= Statistics::kPq; ++i) s_.pq[i] = tally.pq[i];
  s_.adds = tally.adds;
  for (int i = 1; i <= Statistics::kQ; ++i) {
    auto& row = s_.q[i];
    row[kTotal] = tally.q[i];
    row[kAverage] = row[kTotal] / height;
    if (row[kTotal] != 0 && s_.pq[pq::kInvolvedLines] != 0) {
      row[kNanoseconds] = 1000000000 / (30 * row[kTotal]);
      row[kAverageInvolved] = row[kTotal] / s_.pq[pq::kInvolvedLines];
    }
    if (i >= q::kPipeline) {
      s_.pq[11] += row[kPreparing];
      s_.pq[13] += row[kSorting];
    }
  }
  s_.pq[12] = nanoseconds(s_.pq[11]);
  s_.pq[14] = nanoseconds(s_.pq[13]);
  s_.pq[15] = s_.pq[11] + s_.pq[13];
  s_.pq[16] = nanoseconds(s_.pq[15]);
  return s_;
}

std::int64_t output_buffer(const std::vector<LineCounts>& lines, int memory_cycle_ns) {
  const auto height = static_cast<std::ptrdiff_t>(lines.size());
  if (height == 0) return 0;
  constexpr int kFrames = 3;  // the later ones are what the first is followed by
  constexpr double kSlack = 1e-15;
  const double line_time = (1.0 / kFramesPerSecond) / static_cast<double>(height);
  const double reference_time = memory_cycle_ns * 1e-9;
  const std::ptrdiff_t n = kFrames * height;
  std::vector<double> done(static_cast<std::size_t>(n));
  double latest = 1e30;
  for (std::ptrdiff_t i = n - 1; i >= 0; --i) {
    done[i] = std::min(static_cast<double>(i) * line_time, latest);
    latest = done[i] - reference_time * static_cast<double>(lines[i % height].references);
  }
  std::int64_t held = 0, most = 0;
  std::ptrdiff_t next = 0;
  for (std::ptrdiff_t shown = 0; shown < height; ++shown) {
    const double begin = static_cast<double>(shown) * line_time + kSlack;
    const double end = static_cast<double>(shown + 1) * line_time;
    for (; next < n && done[next] <= begin; ++next) held += lines[next % height].segments;
    most = std::max(most, held);
    for (; next < n && done[next] < end; ++next) held += lines[next % height].segments;
    most = std::max(most, held);
    held -= lines[shown].segments;
  }
  return most;
}

void complete_answer(FrameAnswer& a, const Tally& t, const Statistics& statistics, const Parameters& parameters) {
  a.statistics = statistics;
  Counters& c = a.counters;
  c.polygon_blocks = t.pq[pq::kPolygons];
  c.edge_blocks = t.pq[pq::kEdges];
  c.edge_crossings = t.crossings;
  c.implied_edges = t.implied_edges;
  c.output_segments = t.q[q::kOutputSegments];
  c.segment_blocks_total = t.pq[pq::kBlocksTotal];
  c.segment_blocks_max = t.pq[pq::kBlocksMost];
  c.segment_references = t.references();
  c.reference_ratio = ratio(c.segment_references, c.edge_crossings);
  c.add_cycles = t.add_cycles;
  c.add_cycles_per_test = ratio(t.add_cycles, t.q[q::kDepthTests]);
  c.percent_not_at_end = ratio(t.not_at_end, t.insertions, 100);
  c.output_buffer = output_buffer(a.lines, parameters.memory_cycle_ns);
  c.add_cycles_listed = t.add_cycles_listed;
  a.depth_tests = t.q[q::kDepthTests];
  a.samples_stored = t.q[q::kSamplesStored];
  a.subdivisions = t.q[q::kSubdivisions];
  a.intersections = t.q[q::kIntersections];
  a.stale_samples = t.stale_samples;
  a.unclosed_polygons = t.unclosed_polygons;
  a.coherence_samples = t.coherence_samples;
}

}  // namespace vsg
