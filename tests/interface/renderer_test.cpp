// A context and the renderer on the same scene, written down for each in its own way: equal pictures.
#include "watkins/renderer.h"

#include <gtest/gtest.h>

#include <thread>

#include "scanline/mesh.h"
#include "scanline/scene.h"
#include "tests/interface/drawing.h"
#include "watkins/data_folder.h"

namespace interface_tests {
namespace {

using scanline::MeshAttribute;

constexpr double kWall[4][3] = {{-1.5, -1, -1}, {1.25, -1, -0.25}, {1.25, 1, -0.25}, {-1.5, 1, -1}};
constexpr double kWallUv[4][2] = {{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}};
constexpr double kTriangle[3][3] = {{-0.75, -0.75, 0.5}, {0.5, -0.5, 0.75}, {0, 0.75, -1.5}};
constexpr double kTriangleColors[3][3] = {{1, 0.25, 0}, {0, 1, 0.25}, {0.25, 0, 1}};

template <std::size_t n>
std::vector<glm::dvec3> positions(const double (&points)[n][3]) {
  std::vector<glm::dvec3> result;
  for (const auto& p : points) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

template <std::size_t n, std::size_t m>
MeshAttribute attribute(const std::string& name, const double (&values)[n][m]) {
  MeshAttribute result{name, static_cast<int>(m), {}};
  for (const auto& corner : values) result.values.insert(result.values.end(), corner, corner + m);
  return result;
}

MeshAttribute same_everywhere(const std::string& name, std::size_t corners, const std::vector<double>& value) {
  MeshAttribute result{name, static_cast<int>(value.size()), {}};
  for (std::size_t k = 0; k < corners; ++k) result.values.insert(result.values.end(), value.begin(), value.end());
  return result;
}

scanline::Scene written_scene() {
  scanline::Scene scene;
  scene.width = kWidth;
  scene.height = kHeight;
  scene.background = {0.25, 0.5, 0.75};
  scene.camera.position = {0.5, 0.25, 4};
  scene.camera.near = 1;
  scene.camera.far = 16;
  const std::filesystem::path shaders = watkins::data_folder() / "shaders";

  scanline::Object wall;
  wall.name = "wall";
  wall.mesh.positions = positions(kWall);
  wall.mesh.polygons = {{0, 1, 2, 3}};
  wall.mesh.attributes = {same_everywhere("normal", 4, {-0.25, 0, 1}), attribute("uv", kWallUv)};
  wall.shader.name = "simple_brick";
  wall.shader.file = shaders / "simple_brick.pfman";
  wall.shader.parameters = {{"brick_color", std::vector<double>{0.75, 0.5, 0.25}}, {"width", 0.375}};
  wall.keys = {{}};

  scanline::Object triangle;
  triangle.name = "triangle";
  triangle.mesh.positions = positions(kTriangle);
  triangle.mesh.polygons = {{0, 1, 2}};
  triangle.mesh.attributes = {same_everywhere("normal", 3, {0, 0.5, 1}),
                              attribute("px_material_diffuse", kTriangleColors),
                              same_everywhere("px_material_ambient", 3, {0.2, 0.2, 0.2}),
                              same_everywhere("px_material_specular", 3, {0.5, 0.5, 0.5}),
                              same_everywhere("px_material_emission", 3, {0, 0, 0.125}),
                              same_everywhere("px_material_shininess", 3, {16})};
  triangle.shader.name = "opengl_surface";
  triangle.shader.parameters = {{"scene_ambient", std::vector<double>{0.2, 0.2, 0.2}}};
  triangle.keys = {{}};
  scene.objects = {wall, triangle};

  scanline::Light near_eye;
  near_eye.shader = scanline::ShaderCall{};
  near_eye.shader->name = "opengl_light";
  near_eye.shader->parameters = {{"position", std::vector<double>{1, 2, 3, 1}}, {"quadratic_attenuation", 0.03125}};
  scanline::Light lamp;
  lamp.shader = scanline::ShaderCall{};
  lamp.shader->name = "opengl_light";
  lamp.shader->parameters = {{"position", std::vector<double>{-1, 0, 1, 0}},
                             {"diffuse", std::vector<double>{0.25, 0.25, 0}},
                             {"specular", std::vector<double>{0, 0, 0}}};
  scene.lights = {near_eye, lamp};
  return scene;
}

void draw_same(watkins::Context& context) {
  context.size(kWidth, kHeight);
  context.background(0.25, 0.5, 0.75);
  context.look_at({0.5, 0.25, 4}, {0, 0, 0}, {0, 1, 0});
  context.perspective(45, 1, 16);
  context.light(watkins::LightId{0}, "position", {1, 2, 3, 1});
  context.light(watkins::LightId{0}, "quadratic_attenuation", {0.03125});
  context.light(watkins::LightId{3}, "position", {-1, 0, 1, 0});
  context.light(watkins::LightId{3}, "diffuse", {0.25, 0.25, 0});
  context.enable(watkins::LightId{3});
  context.enable(watkins::LightId{0});

  context.load_extension_code("simple_brick.pfman");
  const watkins::ShaderId brick = context.new_shader("simple_brick");
  context.bound_material(brick, "brick_color", {0.75, 0.5, 0.25});
  context.bound_material(brick, "width", {0.375});
  context.end_shader();
  context.shader(brick);
  context.normal(-0.25, 0, 1);
  context.begin();
  for (int k = 0; k < 4; ++k) {
    context.tex_coord(kWallUv[k][0], kWallUv[k][1]);
    context.vertex(kWall[k][0], kWall[k][1], kWall[k][2]);
  }
  context.end();

  context.shader(watkins::kOpenGlShader);
  context.normal(0, 0.5, 1);
  context.material("px_material_specular", {0.5, 0.5, 0.5});
  context.material("px_material_emission", {0, 0, 0.125});
  context.material("px_material_shininess", {16});
  context.begin();
  for (int k = 0; k < 3; ++k) {
    context.color(kTriangleColors[k][0], kTriangleColors[k][1], kTriangleColors[k][2]);
    context.vertex(kTriangle[k][0], kTriangle[k][1], kTriangle[k][2]);
  }
  context.end();
}

struct Case {
  watkins::Level level;
  const char* name;
  int samples, rendering_nodes, threads;
};

class InterfaceAndRenderer : public testing::TestWithParam<Case> {};

TEST_P(InterfaceAndRenderer, EqualsRenderer) {
  const Case& wanted = GetParam();
  const scanline::Scene scene = written_scene();
  watkins::RenderOptions options;
  options.generator.vsg = "model";
  options.pixels.level = wanted.name;
  options.samples = wanted.samples;
  options.rendering_nodes = wanted.rendering_nodes;
  watkins::Renderer renderer(scene, "scene.toml", options);
  const watkins::RenderedFrame expected = renderer.shade(renderer.find_visible(1));

  watkins::Context context;
  watkins::Machine machine = fast();
  machine.pixels = wanted.level;
  machine.samples = wanted.samples;
  machine.rendering_nodes = wanted.rendering_nodes;
  machine.threads = wanted.threads;
  context.machine(machine);
  draw_same(context);
  const watkins::Picture picture = context.render();
  ASSERT_EQ(picture.width, kWidth);
  ASSERT_EQ(picture.height, kHeight);
  EXPECT_EQ(picture.colors, expected.picture.colors());
  EXPECT_EQ(picture.counts.covered_samples, expected.counts.covered_samples);
  EXPECT_EQ(picture.counts.shading_cycles, static_cast<std::int64_t>(expected.counts.sum.shading()));
  EXPECT_EQ(picture.counts.segment_references,
            expected.answers.at(0).counters.segment_references +
                (wanted.rendering_nodes > 1 ? expected.answers.at(1).counters.segment_references : 0));
  EXPECT_GT(picture.counts.covered_samples, picture.counts.samples / 4);
}

INSTANTIATE_TEST_SUITE_P(Levels, InterfaceAndRenderer,
                         testing::Values(Case{watkins::Level::Macro, "macro", 1, 1, 1},
                                         Case{watkins::Level::Macro, "macro", 2, 1, 2},
                                         Case{watkins::Level::Macro, "macro", 1, 2, 1},
                                         Case{watkins::Level::Model, "model", 1, 1, 1}),
                         [](const auto& test) {
                           return std::string(test.param.name) + "_samples_" + std::to_string(test.param.samples) +
                                  "_nodes_" + std::to_string(test.param.rendering_nodes);
                         });

TEST(InterfaceContexts, DontKnowEachOther) {
  std::vector<float> pictures[3];
  const auto work = [&](int n) {
    watkins::Context context;
    context.machine(fast());
    draw_same(context);
    pictures[n] = context.render().colors;
  };
  std::thread first(work, 0), second(work, 1);
  work(2);
  first.join();
  second.join();
  EXPECT_EQ(pictures[0], pictures[2]);
  EXPECT_EQ(pictures[1], pictures[2]);
  EXPECT_FALSE(pictures[2].empty());
}

/// The comparison above sees a single number that is another.
TEST(InterfaceContexts, DifferWhereTheirScenesDo) {
  const scanline::Scene scene = written_scene();
  scanline::Scene other = written_scene();
  other.objects[1].mesh.attributes[4].values[2] = 0.25;
  watkins::RenderOptions options;
  options.generator.vsg = "model";
  options.pixels.level = "macro";
  watkins::Renderer first(scene, "a.toml", options), second(other, "b.toml", options);
  EXPECT_NE(first.shade(first.find_visible(1)).picture.colors(), second.shade(second.find_visible(1)).picture.colors());
}

}  // namespace
}  // namespace interface_tests
