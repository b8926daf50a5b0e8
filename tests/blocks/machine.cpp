#include "tests/blocks/machine.h"

#include <gtest/gtest.h>

#include <bit>
#include <sstream>

namespace blocks {
namespace {

std::int64_t items_compared = 0;

std::string text(const vsg::Event& event) {
  std::ostringstream out;
  out << vsg::event_name(event.kind) << ", line " << event.line << ":";
  const auto names = vsg::event_field_names(event.kind);
  for (std::size_t i = 0; i < names.size(); ++i) out << ' ' << names[i] << ' ' << event.fields[i];
  return out.str();
}

std::vector<std::int64_t> fields(const vsg::SegmentBlock& w) {
  return {w.x_previous,  w.x_next,   w.polygon,    w.polygon_next, w.left_lines, w.left.x,  w.left.dx,
          w.left.z,      w.left.dz,  w.right_lines, w.right.x,      w.right.dx,   w.right.z, w.right.dz,
          w.implied ? 1 : 0, w.active_next};
}

bool same_events(const Machine& golden, const Machine& other) {
  const std::size_t count = std::min(golden.seen.size(), other.seen.size());
  for (std::size_t i = 0; i < count; ++i) {
    const vsg::Event &a = golden.seen[i], &b = other.seen[i];
    if (a.kind == b.kind && a.line == b.line && a.fields == b.fields) continue;
    ADD_FAILURE() << "event " << i << "\n  golden model: " << text(a) << "\n  RTL:          " << text(b);
    return false;
  }
  if (golden.seen.size() != other.seen.size()) {
    const bool more = golden.seen.size() > count;
    ADD_FAILURE() << (more ? "only the golden model: " : "only the RTL: ")
                  << text(more ? golden.seen[count] : other.seen[count]);
    return false;
  }
  items_compared += static_cast<std::int64_t>(count);
  return true;
}

}  // namespace

vsg::Parameters bench_parameters() {
  vsg::Parameters p;
  p.fraction_bits_x = VSG_FRACTION_BITS_X;
  p.fraction_bits_z = VSG_FRACTION_BITS_Z;
  p.segment_blocks = VSG_SEGMENT_BLOCKS;
  p.edge_blocks = VSG_EDGE_BLOCKS;
  p.polygon_blocks = VSG_POLYGON_BLOCKS;
  return p;
}

vsg::WordFormat x_format() {
  const vsg::Parameters p = bench_parameters();
  return {p.integer_bits + p.fraction_bits_x, p.fraction_bits_x};
}

vsg::WordFormat z_format() {
  const vsg::Parameters p = bench_parameters();
  return {p.integer_bits + p.fraction_bits_z, p.fraction_bits_z};
}

int pointer_bits() { return std::bit_width(bench_parameters().segment_blocks); }
int coordinate_bits() { return VSG_COORDINATE_BITS; }

Machine::Machine(const vsg::FrameBlocks& frame)
    : polygons(frame.polygons, bench_parameters().polygon_blocks, tally),
      edges(frame, bench_parameters().edge_blocks, polygons, tally),
      memory(bench_parameters().segment_blocks, events),
      free_list(bench_parameters().segment_blocks),
      wiring{frame.width, frame.height, x_format(), z_format(), memory, free_list, polygons, tally, events},
      coherence(wiring, frame.edges, bench_parameters().frame_coherence) {}

void Machine::start_line() {
  ++wiring.line;
  x_sort.start_line();
  samples.start_line();
  space.start_line();
  active.start_line();
  decision.start_line();
}

vsg::SegmentPointer Machine::take_block() {
  bool fresh = false;
  const vsg::SegmentPointer p = free_list.take(fresh);
  if (fresh) samples.clear(p);
  return p;
}

vsg::FrameBlocks empty_frame(int width, int height) {
  vsg::FrameBlocks frame;
  frame.width = width;
  frame.height = height;
  frame.polygons.assign(bench_parameters().polygon_blocks, {true});
  return frame;
}

bool expect_same(Machine& golden, Machine& other) {
  if (!same_events(golden, other)) return false;
  const vsg::Tally &a = golden.tally, &b = other.tally;
  for (std::size_t i = 0; i < a.q.size(); ++i) EXPECT_EQ(a.q[i], b.q[i]) << "counter Q " << i;
  for (std::size_t i = 0; i < a.pq.size(); ++i) EXPECT_EQ(a.pq[i], b.pq[i]) << "counter PQ " << i;
  EXPECT_EQ(a.adds, b.adds);
  EXPECT_EQ(a.crossings, b.crossings);
  EXPECT_EQ(a.implied_edges, b.implied_edges);
  EXPECT_EQ(a.insertions, b.insertions);
  EXPECT_EQ(a.not_at_end, b.not_at_end);
  EXPECT_EQ(a.add_cycles, b.add_cycles);
  EXPECT_EQ(a.add_cycles_listed, b.add_cycles_listed);
  EXPECT_EQ(a.stale_samples, b.stale_samples);
  EXPECT_EQ(a.unclosed_polygons, b.unclosed_polygons);
  EXPECT_EQ(golden.memory.accesses(), other.memory.accesses()) << "accesses of segment memory";
  const auto blocks = static_cast<vsg::SegmentPointer>(bench_parameters().segment_blocks);
  for (vsg::SegmentPointer p = 1; p <= blocks; ++p) {
    EXPECT_EQ(fields(golden.memory.read(p)), fields(other.memory.read(p))) << "segment block " << p;
    ++items_compared;
  }
  for (int polygon = 1; polygon <= static_cast<int>(bench_parameters().polygon_blocks); ++polygon) {
    EXPECT_EQ(golden.polygons.first_segment(polygon), other.polygons.first_segment(polygon)) << "polygon " << polygon;
    EXPECT_EQ(golden.polygons.active(polygon), other.polygons.active(polygon)) << "polygon " << polygon;
  }
  return !testing::Test::HasFailure();
}

std::int64_t compared() { return items_compared; }

}  // namespace blocks
