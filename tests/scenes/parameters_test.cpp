// What scenes give to shaders' parameters, shown as colours and worked out here a second time.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "scanline/fields/primitives.h"
#include "scanline/scene.h"
#include "watkins/renderer.h"

namespace scene_tests {
namespace {

namespace fs = std::filesystem;
using glm::dvec3;
using Numbers = std::vector<double>;

/// Numbers from -4 up to 4 are shown in steps of 1/32.
constexpr char kShaders[] = R"(
surface vectors(output varying fixed<8,8> px_shader_color[3], uniform int which = 0,
                varying transform_as_point float a_point[3] = { 0, 0, 0 },
                varying transform_as_point float a_point4[4] = { 0, 0, 0, 0 },
                varying transform_as_vector float a_vector[3] = { 0, 0, 0 },
                varying transform_as_normal float a_normal[3] = { 0, 0, 0 },
                varying float plain[3] = { 0.5, 1, 1.5 },
                uniform transform_as_point float a_place[3] = { 0, 0, 0 }) {
    float v[3] = plain;
    if (which == 1) v = a_point;
    if (which == 2) v = { a_point4[0], a_point4[1], a_point4[2] };
    if (which == 3) v = a_vector;
    if (which == 4) v = a_normal;
    if (which == 5) v = a_place;
    px_shader_color = { sat fixed<8,8>(v[0] / 8 + 0.5), sat fixed<8,8>(v[1] / 8 + 0.5),
                        sat fixed<8,8>(v[2] / 8 + 0.5) };
}
surface normals(output varying fixed<8,8> px_shader_color[3], varying transform_as_normal float px_material_normal[3]) {
    px_shader_color = { sat fixed<8,8>(px_material_normal[0] / 8 + 0.5),
                        sat fixed<8,8>(px_material_normal[1] / 8 + 0.5),
                        sat fixed<8,8>(px_material_normal[2] / 8 + 0.5) };
}
surface places(output varying fixed<8,8> px_shader_color[3], varying float px_shader_texcoord[2]) {
    px_shader_color = { sat fixed<8,8>(px_shader_texcoord[0] / 8 + 0.5),
                        sat fixed<8,8>(px_shader_texcoord[1] / 8 + 0.5), 0 };
}
surface frames(output varying fixed<8,8> px_shader_color[3], uniform float px_shader_time,
               uniform float px_shader_frame) {
    px_shader_color = { fixed<8,8>(px_shader_time), fixed<8,8>(px_shader_frame / 16), 0 };
}
surface around(output varying fixed<8,8> px_shader_color[3], uniform fixed<16,12> scene_ambient[3] = { 0, 0, 0 }) {
    px_shader_color = sat fixed<8,8>(scene_ambient);
}
surface lights(output varying fixed<8,8> px_shader_color[3],
               varying fixed<8,8> field_visibility[3] = { 0.5, 0.5, 0.5 }) {
    px_shader_color = field_visibility;
}
surface mirror(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> field_reflection[3] = { 0, 0, 0 }) {
    px_shader_color = field_reflection;
}
)";

constexpr int kWidth = 16, kHeight = 8;

class SceneParameters : public testing::Test {
 protected:
  SceneParameters() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("vsg_parameters_") + test->name());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "show.pfman") << kShaders;
    // The eye looks along -x: its axes are -z, y and x. The picture shows 0 < y < 2 and 0 < z < 4.
    scene_.width = kWidth;
    scene_.height = kHeight;
    scene_.camera.projection = scanline::Projection::kOrthographic;
    scene_.camera.position = {3, 1, 2};
    scene_.camera.target = {0, 1, 2};
    scene_.camera.height = 2;
    scene_.camera.near = 0.5;
    scene_.camera.far = 20;
  }
  ~SceneParameters() override { fs::remove_all(folder_); }

  static dvec3 turned_to_eye(const dvec3& v) { return {-v.z, v.y, v.x}; }
  static dvec3 to_eye(const dvec3& p) { return turned_to_eye(p - dvec3(3, 1, 2)); }
  /// Where the middle of a pixel meets the plane x = slope (z - 2).
  static dvec3 seen(int column, int row, double slope) {
    const double z = 4 - (column + 0.5) * 4 / kWidth, y = 2 - (row + 0.5) * 2 / kHeight;
    return {slope * (z - 2), y, z};
  }

  /// Four corners that more than fill the part of the picture with low < z < high, on the plane x = slope (z - 2), as
  /// an object that `key` takes there; it is not turned.
  scanline::Object& add_wall(const std::string& shader, const scanline::TransformKey& key = {}, double slope = 0,
                             double low = -1, double high = 5) {
    scanline::Object& object = scene_.objects.emplace_back();
    object.name = "wall " + std::to_string(scene_.objects.size());
    for (const auto& [y, z] : {std::pair{-1.0, high}, {-1.0, low}, {3.0, low}, {3.0, high}}) {
      object.mesh.positions.push_back((dvec3(slope * (z - 2), y, z) - key.translate) / key.scale);
    }
    object.mesh.polygons = {{0, 1, 2, 3}};
    object.shader.name = shader;
    object.shader.file = folder_ / "show.pfman";
    object.keys = {key};
    return object;
  }
  static void give(scanline::Object& object, const std::string& name, const Numbers& value) {
    scanline::MeshAttribute attribute{name, static_cast<int>(value.size()), {}};
    for (int k = 0; k < 4; ++k) attribute.values.insert(attribute.values.end(), value.begin(), value.end());
    object.mesh.attributes.push_back(attribute);
  }
  void add_ball(const dvec3& middle, double radius) {
    scanline::Object& object = scene_.objects.emplace_back();
    object.name = "ball " + std::to_string(scene_.objects.size());
    object.field = scanline::fields::sphere(radius);
    object.keys = {{0, middle, dvec3(0), dvec3(1)}};
  }
  void add_light(scanline::Light::Kind kind, const dvec3& direction, const dvec3& color, double intensity) {
    scanline::Light& light = scene_.lights.emplace_back();
    light.kind = kind;
    light.direction = direction;
    light.color = color;
    light.intensity = intensity;
  }

  watkins::RenderedFrame render(double moment = 1, watkins::RenderOptions options = {}) {
    options.generator.vsg = "model";
    options.pixels.level = "macro";
    watkins::Renderer renderer(scene_, (folder_ / "scene.toml").string(), options);
    return renderer.shade(renderer.find_visible(moment));
  }
  static dvec3 color(const watkins::RenderedFrame& frame, int column, int row) {
    const auto& colors = frame.picture.colors();
    const auto at = static_cast<std::size_t>(3 * (row * frame.picture.width() + column));
    return {colors[at], colors[at + 1], colors[at + 2]};
  }
  /// Every pixel from `first` up to `last` shows the numbers that it should, to a step.
  static void expect_numbers(const watkins::RenderedFrame& frame, const std::function<dvec3(int, int)>& should,
                             int numbers = 3, int first = 0, int last = kWidth) {
    for (int row = 0; row < kHeight; ++row) {
      for (int column = first; column < last; ++column) {
        const dvec3 is = color(frame, column, row), wanted = should(column, row);
        for (int n = 0; n < numbers; ++n) {
          ASSERT_GT(std::abs(wanted[n]), 1.0 / 20) << "would not be told from what was never given";
          ASSERT_NEAR(is[n], 128 + 32 * wanted[n], 1.01) << "column " << column << ", row " << row << ", number " << n;
        }
      }
    }
  }

  fs::path folder_;
  scanline::Scene scene_;
};

TEST_F(SceneParameters, AttributesGoToEyeSpaceAsTheirParametersAsk) {
  const scanline::TransformKey key{0, {1, 0.5, 1.5}, dvec3(0), {2, 0.5, 4}};
  const dvec3 v(0.75, -1.5, 0.25);
  const dvec3 point = v * key.scale + key.translate;
  const dvec3 should[] = {{0.25, -0.75, 2},
                          to_eye(point),
                          turned_to_eye(v * key.scale + 0.5 * (key.translate - dvec3(3, 1, 2))),
                          turned_to_eye(v * key.scale),
                          turned_to_eye(v / key.scale)};
  for (int which = 0; which < 5; ++which) {
    SCOPED_TRACE("parameter " + std::to_string(which));
    scene_.objects.clear();
    scanline::Object& wall = add_wall("vectors", key);
    wall.shader.parameters["which"] = static_cast<double>(which);
    give(wall, "plain", {0.25, -0.75, 2});
    give(wall, "a_point", {v.x, v.y, v.z});
    give(wall, "a_point4", {v.x, v.y, v.z, 0.5});
    give(wall, "a_vector", {v.x, v.y, v.z});
    give(wall, "a_normal", {v.x, v.y, v.z});
    expect_numbers(render(), [&](int, int) { return should[which]; });
  }
}

TEST_F(SceneParameters, BoundValuesGoBeforeAttributesAndTheseBeforeDefaults) {
  add_wall("vectors");
  expect_numbers(render(), [](int, int) { return dvec3(0.5, 1, 1.5); });
  give(scene_.objects[0], "plain", {-1, 2, -3});
  expect_numbers(render(), [](int, int) { return dvec3(-1, 2, -3); });
  scene_.objects[0].shader.parameters["plain"] = Numbers{3, -2, 1};
  expect_numbers(render(), [](int, int) { return dvec3(3, -2, 1); });
}

/// Two objects of one shader with the same values, which are not the same in eye space.
TEST_F(SceneParameters, BoundOnesAreInTheSpaceOfEachObject) {
  const scanline::TransformKey left{0, {1, 0.5, 0}, dvec3(0), {1, 1, 1}},
      right{0, {2.5, 0, 2.5}, dvec3(0), {2, 1, 0.5}};
  const auto walls = [&](const std::string& shader, const std::string& parameter, double which) {
    scene_.objects.clear();
    add_wall(shader, left, 0, 2, 5);
    add_wall(shader, right, 0, -1, 2);
    for (scanline::Object& object : scene_.objects) {
      object.shader.parameters[parameter] = Numbers{1, 2, 1};
      if (which > 0) object.shader.parameters["which"] = which;
    }
  };
  const dvec3 v(1, 2, 1);
  walls("vectors", "a_place", 5);
  expect_numbers(
      render(), [&](int, int) { return to_eye(v * left.scale + left.translate); }, 3, 0, 8);
  expect_numbers(
      render(), [&](int, int) { return to_eye(v * right.scale + right.translate); }, 3, 8);
  walls("vectors", "a_normal", 4);
  expect_numbers(
      render(), [&](int, int) { return turned_to_eye(v / left.scale); }, 3, 0, 8);
  expect_numbers(
      render(), [&](int, int) { return turned_to_eye(v / right.scale); }, 3, 8);
  walls("normals", "px_material_normal", 0);
  expect_numbers(
      render(), [&](int, int) { return turned_to_eye(v / left.scale); }, 3, 0, 8);
  expect_numbers(
      render(), [&](int, int) { return turned_to_eye(v / right.scale); }, 3, 8);
}

/// The normal of the plane x = slope (z - 2), in the object's space and in the world, has its greatest part along
/// different axes.
TEST_F(SceneParameters, CoordinatesOnAFaceGoByTheFacesTurnInTheObject) {
  for (const double stretch : {1.0, 0.25, 4.0}) {
    SCOPED_TRACE("stretched by " + std::to_string(stretch));
    const double slope = 0.5;
    const scanline::TransformKey key{0, {0, 0.25, 0.25}, dvec3(0), {1, 1, stretch}};
    scene_.objects.clear();
    add_wall("places", key, slope);
    // The normal in the world is (1, 0, -slope), in the object (1, 0, -slope * stretch).
    const bool across = slope * stretch > 1;
    expect_numbers(
        render(),
        [&](int column, int row) {
          const dvec3 p = (seen(column, row, slope) - key.translate) / key.scale;
          dvec3 shown(across ? p.x : p.z, p.y, 0);
          for (int n = 0; n < 2; ++n) shown[n] = std::clamp(shown[n], -4.0, 3.97);
          return shown;
        },
        2);
  }
}

TEST_F(SceneParameters, TimeIsTheFrameOverTheRate) {
  scene_.frame_rate = 8;
  add_wall("frames");
  EXPECT_EQ(color(render(3), 5, 5), dvec3(96, 48, 0));
  EXPECT_EQ(color(render(6), 5, 5), dvec3(192, 96, 0));
}

TEST_F(SceneParameters, AmbientLightsAreSummedUpUnlessTheObjectHasItsOwn) {
  add_light(scanline::Light::Kind::kAmbient, {}, {0.5, 0.25, 0}, 0.5);
  add_light(scanline::Light::Kind::kDirectional, {-1, 0, 0}, {1, 1, 1}, 1);
  add_light(scanline::Light::Kind::kAmbient, {}, {0.25, 0, 0.125}, 2);
  add_wall("around", {}, 0, 2, 5);
  add_wall("around", {}, 0, -1, 2).shader.parameters["scene_ambient"] = Numbers{0, 0, 0};
  const watkins::RenderedFrame frame = render();
  EXPECT_EQ(color(frame, 2, 3), dvec3(192, 32, 64));
  EXPECT_EQ(color(frame, 12, 3), dvec3(0, 0, 0));
}

TEST_F(SceneParameters, VisibilityIsOfLightsInTheirOrderButAmbientOnes) {
  using Kind = scanline::Light::Kind;
  add_wall("lights");
  add_ball({1.5, 1, 2}, 0.75);
  add_light(Kind::kAmbient, {}, {1, 1, 1}, 1);
  add_light(Kind::kDirectional, {-1, 0, 0}, {1, 1, 1}, 1);  // straight onto the wall, past the ball
  add_light(Kind::kDirectional, {1, 0, 0}, {1, 1, 1}, 1);   // from behind
  const watkins::RenderedFrame bright = render();
  for (int column = 0; column < kWidth; ++column) EXPECT_EQ(color(bright, column, 4), dvec3(255, 255, 255));
  scene_.fields.shadows = true;
  const watkins::RenderedFrame frame = render();
  int shaded = 0;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const dvec3 p = seen(column, row, 0);
      const bool in_shadow = std::hypot(p.y - 1, p.z - 2) < 0.75;
      shaded += in_shadow;
      // The wall itself is no field. There is no third light.
      EXPECT_EQ(color(frame, column, row), dvec3(in_shadow ? 0 : 255, 0, 255)) << column << ", " << row;
    }
  }
  EXPECT_GT(shaded, 20);
}

/// With and without perspective a wall that stands at 45 degrees shows what lies in the direction of +z.
TEST_F(SceneParameters, ReflectionsLeadAwayFromTheEye) {
  constexpr double kRadius = 1;
  scene_.fields.reflections = true;
  scene_.background = {0, 0, 0.5};
  add_light(scanline::Light::Kind::kAmbient, {}, {1, 0.5, 0.25}, 0.5);
  add_wall("mirror", {}, -1);
  add_ball({0, 1, 9}, kRadius);
  scene_.objects.back().shader.parameters["color"] = Numbers{0.5, 0.5, 1};
  for (const bool is_perspective : {false, true}) {
    if (is_perspective) {
      scene_.camera.projection = scanline::Projection::kPerspective;
      scene_.camera.position.x = 6;
      scene_.camera.field_of_view = 20;
    }
    const watkins::RenderedFrame frame = render();
    int balls = 0;
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const double s = (column + 0.5) / kWidth * 2 - 1, t = 1 - (row + 0.5) / kHeight * 2;
        const double half = std::tan(glm::radians(10.0));
        dvec3 from = scene_.camera.position, way(-1, 0, 0);
        (is_perspective ? way : from) += is_perspective ? half * dvec3(0, t, -2 * s) : dvec3(0, t, -2 * s);
        from += (2 - from.z - from.x) / (way.x + way.z) * way;
        // Mirrored at the wall, x and z change places and signs.
        way = {-way.z, way.y, -way.x};
        const dvec3 to_ball = dvec3(0, 1, 9) - from;
        const double distance = glm::length(glm::cross(to_ball, glm::normalize(way)));
        if (std::abs(distance - kRadius) < 1e-3) continue;
        const bool is_ball = distance < kRadius;
        balls += is_ball;
        EXPECT_EQ(color(frame, column, row), is_ball ? dvec3(64, 32, 32) : dvec3(0, 0, 128)) << column << ", " << row;
      }
    }
    EXPECT_GT(balls, 5);
    EXPECT_LT(balls, 100);
  }
}

}  // namespace
}  // namespace scene_tests
