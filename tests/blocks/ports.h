// The fields of rtl/bench_pkg.sv as the golden model's types. Fields come unsigned; here they get their signs.
#pragma once

#include <array>
#include <cstdint>

#include "cmodel/vsg/depth_comparator.h"

namespace blocks {

constexpr std::size_t kWordFields = 16, kRequestFields = 19, kPointFields = 3, kSpanFields = 8, kCandidateFields = 7,
                      kBoxFields = 14, kCountFields = 37;

using WordFields = std::array<std::int64_t, kWordFields>;
using PointFields = std::array<std::int64_t, kPointFields>;
using SpanFields = std::array<std::int64_t, kSpanFields>;
using BoxFields = std::array<std::int64_t, kBoxFields>;

WordFields encode(const vsg::SegmentBlock& word);
PointFields encode(const vsg::SamplePoint& point);
SpanFields encode(const vsg::SampleSpan& span);
BoxFields encode(const vsg::VisibleBox& box);

/// `fields`: kWordFields of them.
vsg::SegmentBlock decode_word(const std::int64_t* fields);
vsg::SamplePoint decode_point(const PointFields& fields);
vsg::SampleSpan decode_span(const SpanFields& fields);
vsg::VisibleBox decode_box(const BoxFields& fields);
std::int64_t decode_pixel(std::int64_t field);

/// Counts of one cycle, in the order of vsg_pkg::count_t.
using CountFields = std::array<std::uint32_t, kCountFields>;
enum CountField {
  kSlopes, kIntercepts, kSamplesStored, kSubdivisions, kDepthTests, kSamplesDeleted, kStepsBack, kOutputSegments,
  kIntersections, kHalvings, kPipeline, kPolygonReads, kPolygonWrites, kEdgeReads, kEdgeWrites, kSegmentReads,
  kSegmentWrites, kBlocksTaken, kBlocksReturned, kBucketReads, kCrossings, kImpliedEdges, kInsertions, kNotAtEnd,
  kStaleSamples, kUnclosedPolygons, kPolygons, kFrontPolygons, kEdges, kFrontEdges, kEnteredEdges, kInvolvedLines, kMark,
  kAccount, kTested, kAddCycles, kDensity
};

/// Enters the counts of one cycle into a tally, as tally.h and the Depth Comparator's account say.
class Counting {
 public:
  void add(const CountFields& counts, vsg::Tally& tally);

 private:
  std::int64_t marked_ = 0;  ///< references when the look at a segment began
};

}  // namespace blocks
