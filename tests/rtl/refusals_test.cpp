// What the machine refuses, golden model and RTL alike: the frame stops with an error, and the next frame is not harmed.
#include <gtest/gtest.h>

#include "scanline/frame.h"
#include "scanline/golden_generator.h"
#include "tb/verilated_generator.h"

namespace vsg_tests {
namespace {

constexpr int kSize = 200;

/// `count` polygons that are all present on the same lines; left edges enter first, so each needs one block.
vsg::FrameBlocks overlapping(int count, const vsg::Parameters& parameters) {
  scanline::Frame frame{kSize, kSize, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double x = 2 + i * 0.5, z = 10 + i;
    const auto first = static_cast<std::uint32_t>(frame.vertices.size()) + 1;
    frame.vertices.insert(frame.vertices.end(), {{x + 50, 100, z}, {x + 50, 10, z}, {x, 10, z}, {x, 100, z}});
    frame.polygons.push_back({first, first + 1, first + 2, first + 3});
  }
  return scanline::make_blocks(frame, parameters, true);
}

tb::VerilatedGenerator small_machine() { return {tb::make_small_rtl_machine(), {.lockstep = true, .trace = {}, .replay = {}}}; }

vsg::FrameError::Kind refusal(scanline::VisibleSegmentGenerator& generator, const vsg::FrameBlocks& blocks, int& line) {
  try {
    generator.generate(blocks);
  } catch (const vsg::FrameError& error) {
    line = error.line();
    return error.kind();
  }
  ADD_FAILURE() << "the frame was not refused";
  return {};
}

TEST(Refusals, AsManyBlocksAsThereAreFit) {
  auto generator = small_machine();
  const int blocks = static_cast<int>(generator.parameters().segment_blocks);
  const auto answer = generator.generate(overlapping(blocks, generator.parameters()));
  EXPECT_EQ(answer.counters.segment_blocks_max, blocks);
}

TEST(Refusals, FullSegmentMemoryStopsTheFrame) {
  auto generator = small_machine();
  const auto blocks = overlapping(static_cast<int>(generator.parameters().segment_blocks) + 1, generator.parameters());
  int line = 0;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kSegmentMemoryFull);
  EXPECT_EQ(line, 11);

  const auto good = overlapping(3, generator.parameters());
  const auto after = generator.generate(good);
  scanline::GoldenGenerator golden(generator.parameters());
  EXPECT_EQ(after.segments, golden.generate(good).segments);
}

TEST(Refusals, FullSegmentMemoryForAnImpliedEdge) {
  auto generator = small_machine();
  // The first two polygons cross in the middle, where no block is left for the crossing.
  scanline::Frame frame{kSize, kSize, {}, {}};
  for (int i = 0; i < 64; ++i) {
    const double x = 2, z = i < 2 ? 10 : 100 + i, tilt = i == 0 ? 40 : 0, lift = i == 1 ? 40 : 0;
    const auto first = static_cast<std::uint32_t>(frame.vertices.size()) + 1;
    frame.vertices.insert(frame.vertices.end(),
                          {{x + 50, 100, z + tilt}, {x + 50, 10, z + tilt}, {x, 10, z + lift}, {x, 100, z + lift}});
    frame.polygons.push_back({first, first + 1, first + 2, first + 3});
  }
  int line = 0;
  EXPECT_EQ(refusal(generator, scanline::make_blocks(frame, generator.parameters(), true), line),
            vsg::FrameError::Kind::kSegmentMemoryFull);
  EXPECT_EQ(line, 11);
}

TEST(Refusals, MoreEdgesThanEdgeMemory) {
  auto generator = small_machine();
  auto blocks = overlapping(3, generator.parameters());
  blocks.edges.resize(generator.parameters().edge_blocks + 1, blocks.edges.front());
  int line = -1;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kEdgeMemoryFull);
  EXPECT_EQ(line, 0);
}

TEST(Refusals, MorePolygonsThanPolygonMemory) {
  auto generator = small_machine();
  auto blocks = overlapping(3, generator.parameters());
  blocks.polygons.resize(generator.parameters().polygon_blocks + 1);
  int line = -1;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kPolygonMemoryFull);
  EXPECT_EQ(line, 0);
}

TEST(Refusals, AnEdgeThatEntersOutsideTheFrame) {
  auto generator = small_machine();
  auto blocks = overlapping(1, generator.parameters());
  for (auto& edge : blocks.edges) edge.x = 0;
  int line = -1;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kOutOfFrame);
  EXPECT_EQ(line, 11);
}

TEST(Refusals, AnEdgeThatRunsOutOfTheFrame) {
  auto generator = small_machine();
  auto blocks = overlapping(1, generator.parameters());
  for (auto& edge : blocks.edges) edge.dx = 5 << generator.parameters().fraction_bits_x;
  int line = -1;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kOutOfFrame);
  EXPECT_GT(line, 11);
}

/// A corner on the left border: rounding down puts the edge's X a last place below 1, as it did in 1970.
TEST(Refusals, AnEdgeThatRoundingPutsOutOfTheFrame) {
  tb::VerilatedGenerator generator({.lockstep = true, .trace = {}, .replay = {}});
  const scanline::Frame frame{64, 64, {{1, 36, 5}, {60, 38, 5}, {2.92, 32.08, 5}}, {{1, 2, 3}}};
  int line = -1;
  EXPECT_EQ(refusal(generator, scanline::make_blocks(frame, generator.parameters(), true), line),
            vsg::FrameError::Kind::kOutOfFrame);
  EXPECT_EQ(line, 35);
}

TEST(Refusals, AnEdgeBeyondTheLastLine) {
  auto generator = small_machine();
  auto blocks = overlapping(1, generator.parameters());
  for (auto& edge : blocks.edges) {
    if (edge.lines != 0) edge.lines = kSize;
  }
  int line = -1;
  EXPECT_EQ(refusal(generator, blocks, line), vsg::FrameError::Kind::kOutOfFrame);
  EXPECT_EQ(line, 0);
}

}  // namespace
}  // namespace vsg_tests
