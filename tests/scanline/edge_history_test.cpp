// Frame-to-frame coherence: edges are known again in the next frame, and the processor samples at them.
#include <gtest/gtest.h>

#include "scanline/edge_history.h"
#include "scanline/golden_generator.h"

namespace {

/// Two triangles side by side, moved to the right by `shift`.
scanline::SceneFrame two_triangles(double shift) {
  scanline::SceneFrame frame;
  frame.frame = {100, 100, {}, {}};
  for (const double x : {10.0, 50.0}) {
    const auto first = static_cast<std::uint32_t>(frame.frame.vertices.size()) + 1;
    for (const auto& [dx, y] : {std::pair{0.0, 10.0}, {10.0, 60.0}, {20.0, 12.0}}) {
      frame.frame.vertices.push_back({x + dx + shift, y, 5});
    }
    frame.frame.polygons.push_back({first, first + 1, first + 2});
    frame.polygons.push_back({0, static_cast<std::uint32_t>(frame.polygons.size()), {}});
  }
  return frame;
}

vsg::FrameAnswer work(scanline::EdgeHistory& history, const scanline::SceneFrame& frame, bool coherence = true) {
  vsg::Parameters parameters;
  parameters.frame_coherence = coherence;
  vsg::FrameBlocks blocks = scanline::make_blocks(frame.frame, parameters, false);
  history.mark(frame, blocks);
  const auto answer = scanline::GoldenGenerator(parameters).generate(blocks);
  history.remember(frame, blocks, answer);
  return answer;
}

TEST(EdgeHistory, TheFirstFrameHasNoSamplesFromBefore) {
  scanline::EdgeHistory history;
  const auto answer = work(history, two_triangles(0));
  EXPECT_EQ(answer.coherence_samples, 0);
  EXPECT_EQ(answer.edges_visible.size(), 6u);
  EXPECT_GT(std::count(answer.edges_visible.begin(), answer.edges_visible.end(), true), 0);
}

TEST(EdgeHistory, TheNextFrameSamplesAtEdgesVisibleBefore) {
  scanline::EdgeHistory history, none;
  const auto first = work(history, two_triangles(0));
  const auto second = work(history, two_triangles(1));
  const auto alone = work(none, two_triangles(1), false);
  EXPECT_GT(second.coherence_samples, 0);
  EXPECT_LT(second.subdivisions, alone.subdivisions);
  EXPECT_EQ(second.segments, alone.segments);
  EXPECT_EQ(first.segments.size(), second.segments.size());
}

TEST(EdgeHistory, WithoutTheOptionNothingIsRemembered) {
  scanline::EdgeHistory history;
  work(history, two_triangles(0), false);
  EXPECT_EQ(work(history, two_triangles(0), true).coherence_samples, 0);
}

}  // namespace
