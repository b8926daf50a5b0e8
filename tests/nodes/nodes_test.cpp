// Rendering nodes show the closest of what each of them sees; no pixel differs without a reason.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tests/nodes/node_differences.h"

namespace nodes {
namespace {

std::string scene_file(const std::string& name) { return std::string(VSG_SOURCE_DIR) + "/scenes/" + name + ".toml"; }

/// Compares with 2, 3, 4 and 8 nodes; the number of differing pixels of all.
std::int64_t expect_reasons(const scanline::Scene& scene, const std::string& file) {
  std::int64_t differing = 0;
  for (const int count : {2, 3, 4, 8}) {
    const Comparison c = compare(scene, render(scene, file, count, 2));
    EXPECT_EQ(c.of(Difference::kOther), 0) << count << " nodes: " << c.first;
    EXPECT_EQ(c.composed_wrong, 0) << count << " nodes: " << c.first;
    EXPECT_GT(c.covered, 500);
    differing += c.total();
  }
  return differing;
}

class Nodes : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Nodes, testing::Values("shapes", "teapot", "church", "isometric", "spider"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(Nodes, DifferForAReason) {
  scanline::Scene scene = scanline::read_scene_file(scene_file(GetParam()));
  scene.width = 320;
  scene.height = 240;
  expect_reasons(scene, scene_file(GetParam()));
}

/// Triangles through one another.
scanline::Scene triangles(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  const auto number = [&](double reach) { return std::uniform_real_distribution<double>(-reach, reach)(random); };
  scanline::MeshBuilder mesh;
  for (int n = 0; n < count; ++n) {
    std::vector<std::uint32_t> corners;
    const glm::dvec3 middle(number(1.5), number(1.5), number(1.5));
    for (int k = 0; k < 3; ++k) corners.push_back(mesh.vertex(middle + glm::dvec3(number(1), number(1), number(1))));
    mesh.polygon(corners);
  }
  scanline::Scene scene;
  scene.width = 160;
  scene.height = 120;
  scene.camera.position = {0, 1, 6};
  scene.camera.near = 1;
  scene.camera.far = 20;
  scanline::Object& object = scene.objects.emplace_back();
  object.name = "triangles";
  object.mesh = mesh.take();
  object.keys.emplace_back();
  return scene;
}

TEST(NodesOfTriangles, DifferForAReason) {
  const char* const given = std::getenv("VSG_TEST_SEED");
  const std::uint64_t first = given ? std::stoull(given) : 1;
  std::int64_t differing = 0;
  for (std::uint64_t seed = first; seed < first + 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " (set VSG_TEST_SEED to it)");
    differing += expect_reasons(triangles(seed, 60), "triangles");
  }
  EXPECT_GT(differing, 0) << "the generator is not exact: some pixels differ";
}

TEST(NodesOfTriangles, ComposingTheWrongWayRoundIsSeen) {
  const scanline::Scene scene = triangles(3, 300);
  Pictures pictures = render(scene, "triangles", 2, 2);
  int changed = 0;
  for (std::size_t at = 0; at < pictures.composed.size(); ++at) {
    const std::uint32_t first = pictures.each[0][at], second = pictures.each[1][at];
    if (first == 0 || second == 0) continue;
    pictures.composed[at] = pictures.composed[at] == first ? second : first;
    ++changed;
  }
  ASSERT_GT(changed, 1000);
  const Comparison c = compare(scene, pictures);
  EXPECT_GT(c.composed_wrong, 0.95 * changed);
  EXPECT_GT(c.of(Difference::kOther), 0.5 * changed);  // others have edges within a pixel
}

}  // namespace
}  // namespace nodes
