#include "tests/blocks/ports.h"

#include <algorithm>

#include "tests/blocks/machine.h"

namespace blocks {
namespace {

std::int64_t signed_of(std::int64_t field, int bits) { return vsg::WordFormat{bits, 0}.wrap(field); }
std::int64_t x(std::int64_t field) { return x_format().wrap(field); }
std::int64_t z(std::int64_t field) { return z_format().wrap(field); }
std::int32_t number(std::int64_t field) { return static_cast<std::int32_t>(field); }
std::int32_t lines(std::int64_t field) { return number(signed_of(field, coordinate_bits() + 2)); }

}  // namespace

WordFields encode(const vsg::SegmentBlock& w) {
  return {w.x_previous,  w.x_next,   w.polygon,     w.polygon_next, w.left_lines, w.left.x,  w.left.dx,
          w.left.z,      w.left.dz,  w.right_lines, w.right.x,      w.right.dx,   w.right.z, w.right.dz,
          w.implied ? 1 : 0, w.active_next};
}

PointFields encode(const vsg::SamplePoint& p) { return {p.pixel, p.address.block, p.address.side}; }

SpanFields encode(const vsg::SampleSpan& s) {
  const PointFields l = encode(s.at_left), r = encode(s.at_right);
  return {s.left, s.right, l[0], l[1], l[2], r[0], r[1], r[2]};
}

BoxFields encode(const vsg::VisibleBox& b) {
  return {b.segments, b.x_left, b.x_right, b.z_min,         b.z_max,         b.left,            b.right,
          b.edge,     b.front,  b.other,   b.front_polygon, b.other_polygon, b.rising ? 1 : 0, b.halvings};
}

vsg::SegmentBlock decode_word(const std::int64_t* f) {
  vsg::SegmentBlock w;
  const std::int64_t not_sorted = (std::int64_t{1} << pointer_bits()) - 1;
  w.x_previous = f[0] == not_sorted ? vsg::kNotSorted : number(f[0]);
  w.x_next = number(f[1]);
  w.polygon = number(f[2]);
  w.polygon_next = number(f[3]);
  w.left_lines = lines(f[4]);
  w.left = {x(f[5]), x(f[6]), z(f[7]), z(f[8])};
  w.right_lines = lines(f[9]);
  w.right = {x(f[10]), x(f[11]), z(f[12]), z(f[13])};
  w.implied = f[14] != 0;
  w.active_next = number(f[15]);
  return w;
}

std::int64_t decode_pixel(std::int64_t field) { return signed_of(field, bench_parameters().integer_bits); }

vsg::SamplePoint decode_point(const PointFields& f) {
  return {decode_pixel(f[0]), {number(f[1]), static_cast<int>(f[2])}};
}

vsg::SampleSpan decode_span(const SpanFields& f) {
  return {decode_pixel(f[0]), decode_pixel(f[1]), decode_point({f[2], f[3], f[4]}), decode_point({f[5], f[6], f[7]})};
}

vsg::VisibleBox decode_box(const BoxFields& f) {
  vsg::VisibleBox b;
  b.segments = static_cast<int>(f[0]);
  b.x_left = x(f[1]), b.x_right = x(f[2]);
  b.z_min = z(f[3]), b.z_max = z(f[4]);
  b.left = decode_pixel(f[5]), b.right = decode_pixel(f[6]), b.edge = decode_pixel(f[7]);
  b.front = number(f[8]), b.other = number(f[9]);
  b.front_polygon = number(f[10]), b.other_polygon = number(f[11]);
  b.rising = f[12] != 0;
  b.halvings = f[13];
  return b;
}

void Counting::add(const CountFields& c, vsg::Tally& t) {
  namespace q = vsg::q;
  namespace pq = vsg::pq;
  // A look at a segment is timed from its mark on; what is counted with the mark belongs to it.
  const auto references = [&t] { return t.references() + t.q[q::kPipeline]; };
  if (c[kMark]) marked_ = references();
  if (c[kAccount]) {
    const std::int64_t adds = c[kAddCycles];
    const std::int64_t waited = references() - marked_;
    t.q[q::kWaiting] += std::max<std::int64_t>(0, (adds + 1) / 2 - waited);
    if (c[kTested]) t.add_cycles += adds;
    const std::int64_t listed = std::clamp<std::int64_t>(adds, 1, vsg::Statistics::kAdds);
    ++t.adds[listed];
    t.add_cycles_listed += listed;
  }
  t.q[q::kSlopes] += c[kSlopes];
  t.q[q::kIntercepts] += c[kIntercepts];
  t.q[q::kSamplesStored] += c[kSamplesStored];
  t.q[q::kSubdivisions] += c[kSubdivisions];
  t.q[q::kDepthTests] += c[kDepthTests];
  t.q[q::kSamplesDeleted] += c[kSamplesDeleted];
  t.q[q::kStepsBack] += c[kStepsBack];
  t.q[q::kOutputSegments] += c[kOutputSegments];
  t.q[q::kIntersections] += c[kIntersections];
  t.q[q::kHalvings] += c[kHalvings];
  t.q[q::kPipeline] += c[kPipeline];
  t.q[q::kPolygonReads] += c[kPolygonReads];
  t.q[q::kPolygonWrites] += c[kPolygonWrites];
  t.q[q::kEdgeReads] += c[kEdgeReads];
  t.q[q::kEdgeWrites] += c[kEdgeWrites];
  t.q[q::kSegmentReads] += c[kSegmentReads];
  t.q[q::kSegmentWrites] += c[kSegmentWrites];
  t.q[q::kBucketReads] += c[kBucketReads];
  if (c[kBlocksReturned]) t.block_returned();
  if (c[kBlocksTaken]) t.block_taken();
  t.crossings += 2 * std::int64_t{c[kCrossings]};
  t.implied_edges += c[kImpliedEdges];
  t.insertions += c[kInsertions];
  t.not_at_end += c[kNotAtEnd];
  t.stale_samples += c[kStaleSamples];
  t.unclosed_polygons += c[kUnclosedPolygons];
  t.pq[pq::kPolygons] += c[kPolygons];
  t.pq[pq::kFrontPolygons] += c[kFrontPolygons];
  t.pq[pq::kEdges] += c[kEdges];
  t.pq[pq::kFrontEdges] += c[kFrontEdges];
  t.pq[pq::kEnteredEdges] += c[kEnteredEdges];
  t.pq[pq::kInvolvedLines] += c[kInvolvedLines];
  t.pq[pq::kPointDensity] += decode_pixel(c[kDensity]);
}

}  // namespace blocks
