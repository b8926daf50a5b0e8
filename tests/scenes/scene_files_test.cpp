// Every scene file of the project, small and at the level macro: nothing is wrong with it, everything in it can be
// seen, and its pixels fit the network.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scanline/scene.h"
#include "watkins/renderer.h"

namespace scene_tests {
namespace {

namespace fs = std::filesystem;
using scanline::Scene;

constexpr int kWidth = 64, kHeight = 48;
constexpr int kBudget = 142;  // bytes a pixel that the network carries (Olano and Lastra 1998, section 6.2)

const fs::path& folder() {
  static const fs::path path = fs::path(VSG_SOURCE_DIR) / "scenes";
  return path;
}

std::vector<fs::path> scene_files() {
  std::vector<fs::path> files;
  for (const fs::path& in : {folder(), folder() / "watkins"}) {
    for (const auto& entry : fs::directory_iterator(in)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Scene small_scene(const fs::path& file) {
  Scene scene = scanline::read_scene_file(file);
  scene.width = kWidth;
  scene.height = kHeight;
  return scene;
}

watkins::RenderOptions macro() {
  watkins::RenderOptions options;
  options.generator.vsg = "model";
  options.pixels.level = "macro";
  options.threads = 2;
  options.channels = true;
  return options;
}

/// Names of the objects that no pixel shows.
std::set<std::string> hidden(const Scene& scene, const std::vector<scanline::PolygonOrigin>& polygons,
                             const scanline::Picture& picture) {
  std::set<std::string> names;
  for (const scanline::Object& object : scene.objects) names.insert(object.name);
  for (const std::uint32_t polygon : picture.channels->polygon) {
    if (polygon != 0) names.erase(scene.objects[polygons.at(polygon - 1).object].name);
  }
  return names;
}

class SceneFile : public testing::TestWithParam<fs::path> {};

TEST_P(SceneFile, IsShownWithoutMistakesByBothMachines) {
  const Scene scene = small_scene(GetParam());
  watkins::Renderer renderer(scene, GetParam().string(), macro());
  EXPECT_EQ(renderer.shader_warnings(), "");
  std::set<int> moments{scene.first_frame, scene.last_frame};
  for (const int moment : moments) {
    SCOPED_TRACE("frame " + std::to_string(moment));
    watkins::VisibleFrame visible = renderer.find_visible(moment);
    const std::vector<scanline::PolygonOrigin> polygons = visible.frames.at(0).polygons;
    const watkins::RenderedFrame frame = renderer.shade(std::move(visible));
    for (const scanline::Diagnostic& warning : frame.warnings) ADD_FAILURE() << scanline::format(warning, "warning");

    EXPECT_EQ(frame.counts.samples, kWidth * kHeight);
    EXPECT_GT(frame.counts.covered_samples, 0);
    EXPECT_LE(frame.counts.largest_map, kBudget);
    EXPECT_GE(frame.counts.largest_map, 2);  // the shader's ID
    EXPECT_GT(frame.counts.sum.post + frame.counts.sum.pre, 0u);
    const auto shown = std::count_if(frame.picture.channels->polygon.begin(), frame.picture.channels->polygon.end(),
                                     [](std::uint32_t polygon) { return polygon != 0; });
    EXPECT_EQ(frame.counts.covered_samples, shown);
    EXPECT_EQ(hidden(scene, polygons, frame.picture), std::set<std::string>());

    std::set<std::array<float, 3>> colors;
    const std::vector<float>& values = frame.picture.colors();
    for (std::size_t k = 0; k + 2 < values.size(); k += 3) colors.insert({values[k], values[k + 1], values[k + 2]});
    EXPECT_GE(colors.size(), 2u);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SceneFile, testing::ValuesIn(scene_files()), [](const auto& file) {
  std::string name = file.param.stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return file.param.parent_path() == folder() ? name : "watkins_" + name;
});

/// The scene that the program's first command shows has all kinds of geometry, and more than one shader and light.
TEST(DefaultScene, HasEverythingThatTheMachinesCanShow) {
  const Scene scene = scanline::read_scene_file(folder() / "default.toml");
  int meshes = 0, sources = 0, fields = 0, spots = 0, lights = 0;
  std::set<std::string> shaders;
  for (const scanline::Object& object : scene.objects) {
    if (object.field) {
      ++fields;
    } else if (object.source) {
      ++sources;
    } else {
      ++meshes;
    }
    shaders.insert(object.shader.name);
  }
  for (const scanline::Light& light : scene.lights) {
    if (light.shader && light.shader->name == "spot_light") ++spots;
    if (light.shader || light.kind != scanline::Light::Kind::kAmbient) ++lights;
  }
  EXPECT_GE(meshes, 1);
  EXPECT_GE(sources, 1);
  EXPECT_GE(fields, 1);
  EXPECT_GE(lights, 2);
  EXPECT_GE(spots, 1);
  EXPECT_GE(shaders.size(), 4u);
  EXPECT_TRUE(scene.fields.shadows);
  EXPECT_TRUE(scene.fields.reflections);
}

}  // namespace
}  // namespace scene_tests
