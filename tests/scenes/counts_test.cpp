// What a picture is said to cost, for a picture whose regions are known one by one.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "cmodel/pixelflow/instruction.h"
#include "scanline/scene.h"
#include "watkins/renderer.h"

namespace scene_tests {
namespace {

namespace fs = std::filesystem;
using watkins::FrameCounts;
using watkins::RenderedFrame;

constexpr char kShaders[] = R"(
surface narrow(output varying fixed<8,8> px_shader_color[3]) { px_shader_color = { 0.25, 0.5, 0.75 }; }
surface wide(output varying fixed<8,8> px_shader_color[3], varying float a[4] = { 0, 0, 0, 0 },
             varying float b[4] = { 0, 0, 0, 0 }, varying fixed<16,14> c = 0) {
    px_shader_color = { fixed<8,8>(a[0]), fixed<8,8>(b[3]), fixed<8,8>(c) };
}
surface full(output varying fixed<8,8> px_shader_color[3], varying float a[4] = { 0, 0, 0, 0 },
             varying float b[2] = { 0, 0 }, varying fixed<16,14> c = 0) {
    px_shader_color = { fixed<8,8>(a[0]), fixed<8,8>(b[1]), fixed<8,8>(c) };
}
)";

/// A picture of 3 x 2 regions, a unit of the scene each 64 samples, the lower left corner at 0.
class FrameCountsOfRegions : public testing::Test {
 protected:
  FrameCountsOfRegions() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("vsg_counts_") + test->name());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "show.pfman") << kShaders;
    scene_.width = 3 * 128;
    scene_.height = 2 * 64;
    scene_.camera.projection = scanline::Projection::kOrthographic;
    scene_.camera.position = {3, 1, 5};
    scene_.camera.target = {3, 1, 0};
    scene_.camera.height = 2;
    scene_.camera.near = 1;
    scene_.camera.far = 10;
  }
  ~FrameCountsOfRegions() override { fs::remove_all(folder_); }

  /// A rectangle in samples from the lower left corner.
  void add(const std::string& shader, double left, double bottom, double right, double top) {
    scanline::Object& object = scene_.objects.emplace_back();
    object.name = "rectangle " + std::to_string(scene_.objects.size());
    for (const auto& [x, y] : {std::pair{left, bottom}, {right, bottom}, {right, top}, {left, top}}) {
      object.mesh.positions.emplace_back(x / 64, y / 64, 0);
    }
    object.mesh.polygons = {{0, 1, 2, 3}};
    object.shader.name = shader;
    object.shader.file = folder_ / "show.pfman";
    object.keys = {{}};
    for (const auto& [name, components, value] :
         {std::tuple{"a", 4, 0.5}, {"b", shader == "full" ? 2 : 4, 0.25}, {"c", 1, 0.75}}) {
      object.mesh.attributes.push_back(
          {name, components, std::vector<double>(4 * static_cast<std::size_t>(components), value)});
    }
  }
  watkins::RenderOptions options() const {
    watkins::RenderOptions result;
    result.generator.vsg = "model";
    result.pixels.level = "macro";
    return result;
  }

  fs::path folder_;
  scanline::Scene scene_;
};

TEST_F(FrameCountsOfRegions, AreThoseOfEachRegionTogether) {
  add("narrow", 0, 64, 128, 128);  // all of the upper left region
  add("wide", 160, 70, 200, 90);   // a part of the one beside it
  add("full", 300, 10, 310, 20);   // and of the last
  watkins::Renderer renderer(scene_, (folder_ / "scene.toml").string(), options());
  for (const bool is_first : {true, false}) {
    const FrameCounts counts = renderer.shade(renderer.find_visible(1)).counts;
    EXPECT_EQ(counts.regions, 6);
    EXPECT_EQ(counts.covered_regions, 3);
    EXPECT_EQ(counts.samples, 384 * 128);
    EXPECT_EQ(counts.covered_samples, 8192 + 800 + 100);
    EXPECT_EQ(counts.sum.pixels, 8192 + 800 + 100);
    EXPECT_EQ(counts.sum.packets, 2);
    EXPECT_EQ(counts.sum.sources, 1);
    EXPECT_EQ(counts.sum.executions, 3);
    EXPECT_EQ(counts.largest_map, 2 + 34);
    EXPECT_EQ(counts.packet_bytes, (1 + 2 + 1) * 8192 * pixelflow::kPacketBytes);
    EXPECT_EQ(counts.streams_made, is_first ? 3 : 0);
    EXPECT_EQ(counts.streams_reused, is_first ? 0 : 3);
    ASSERT_EQ(counts.region_cycles.size(), 6u);
    std::uint64_t cycles = 0;
    for (std::size_t n = 0; n < 6; ++n) {
      EXPECT_EQ(counts.region_cycles[n] > 0, n == 0 || n == 1 || n == 5) << n;
      cycles += counts.region_cycles[n];
    }
    EXPECT_EQ(counts.sum.shading(), cycles);
    EXPECT_EQ(counts.sum.send % 3, 0u);  // a region costs the same, whatever is in it
    EXPECT_GT(counts.sum.send, 0u);
  }
}

/// All that a region's pixels send has the length of the longest, whichever node shows that one.
TEST_F(FrameCountsOfRegions, PacketsAreThoseOfAllNodes) {
  add("wide", 160, 70, 200, 90);
  for (int n = 0; n < 12; ++n) add("narrow", 130 + 10 * n, 100, 137 + 10 * n, 110);
  std::vector<float> colors;
  for (const int nodes : {1, 2, 3, 5}) {
    watkins::RenderOptions wanted = options();
    wanted.rendering_nodes = nodes;
    watkins::Renderer renderer(scene_, (folder_ / "scene.toml").string(), wanted);
    const RenderedFrame frame = renderer.shade(renderer.find_visible(1));
    EXPECT_EQ(frame.counts.sum.packets, 2) << nodes;
    EXPECT_EQ(frame.counts.sum.sources, nodes);
    EXPECT_EQ(frame.counts.covered_samples, 800 + 12 * 70);
    if (colors.empty()) colors = frame.picture.colors();
    EXPECT_EQ(frame.picture.colors(), colors) << nodes;
    const std::size_t in_wide = 3 * (384 * (128 - 80) + 170);
    EXPECT_EQ(colors[in_wide], 128);
    EXPECT_EQ(colors[in_wide + 1], 64);
  }
}

TEST(FrameCounts, TheBusiestNodeHasEveryNthRegion) {
  FrameCounts counts;
  counts.region_cycles = {5, 1, 2, 7};
  EXPECT_EQ(watkins::busiest_node(counts, 1), 15u);
  EXPECT_EQ(watkins::busiest_node(counts, 2), 8u);
  EXPECT_EQ(watkins::busiest_node(counts, 3), 12u);
  EXPECT_EQ(watkins::busiest_node(counts, 4), 7u);
  EXPECT_EQ(watkins::busiest_node(counts, 9), 7u);
  EXPECT_EQ(watkins::busiest_node(FrameCounts(), 4), 0u);
}

}  // namespace
}  // namespace scene_tests
