// The default surface and light against OpenGL's lighting equation in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/shaders/region.h"

namespace shader_tests {
namespace {

using Color = std::array<double, 3>;
using pfman::Vector;

struct Lamp {
  std::array<double, 4> position;
  Color ambient, diffuse, specular;
  double constant = 1, linear = 0, quadratic = 0;
  Vector spot{0, 0, -1};
  double exponent = 0, cutoff = 180;
};

struct Material {
  Color ambient{0.3, 0.2, 0.1}, diffuse{0.5, 0.6, 0.3}, specular{0.6, 0.5, 0.7}, emission{0.02, 0.0, 0.04};
  double shininess = 18;
};

constexpr double kSceneAmbient = 0.2;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Color expected(const pfman::TestSurface::Point& point, const Material& material, const std::vector<Lamp>& lamps) {
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = material.emission[c] + material.ambient[c] * kSceneAmbient;
  const Vector& p = point.position;
  const Vector to_eye = unit({-p[0], -p[1], -p[2]});
  for (const Lamp& lamp : lamps) {
    Vector to_lamp{lamp.position[0], lamp.position[1], lamp.position[2]};
    double strength = 1;
    if (lamp.position[3] != 0) {
      for (std::size_t n = 0; n < 3; ++n) to_lamp[n] = lamp.position[n] / lamp.position[3] - p[n];
      const double distance = std::sqrt(dot(to_lamp, to_lamp));
      strength = 1 / (lamp.constant + lamp.linear * distance + lamp.quadratic * distance * distance);
    }
    to_lamp = unit(to_lamp);
    if (lamp.cutoff <= 90) {
      const Vector axis = unit(lamp.spot);
      const double inside = -dot(to_lamp, axis);
      strength *= inside < std::cos(lamp.cutoff * std::numbers::pi / 180) ? 0 : std::pow(inside, lamp.exponent);
    }
    const double facing = dot(point.normal, to_lamp);
    const Vector half = unit({to_lamp[0] + to_eye[0], to_lamp[1] + to_eye[1], to_lamp[2] + to_eye[2]});
    const double gleam = facing > 0 ? std::pow(std::max(dot(point.normal, half), 0.0), material.shininess) : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      color[c] += strength * (material.ambient[c] * lamp.ambient[c] +
                              material.diffuse[c] * lamp.diffuse[c] * std::max(facing, 0.0) +
                              material.specular[c] * lamp.specular[c] * gleam);
    }
  }
  return color;
}

void expect_equation(const std::vector<Lamp>& lamps) {
  const Compiled surface = compile("opengl_surface"), light = compile("opengl_light");
  ASSERT_EQ(surface.said + light.said, "");
  const Material material;
  const auto values = [](const auto& color) { return std::vector<double>(color.begin(), color.end()); };
  pfman::Instance instance(surface.shader(), 1);
  pfman::TestSurface::make_ordinary(instance);
  instance.set("px_material_ambient", values(material.ambient));
  instance.set("px_material_diffuse", values(material.diffuse));
  instance.set("px_material_specular", values(material.specular));
  instance.set("px_material_emission", values(material.emission));
  instance.set("px_material_shininess", {material.shininess});
  std::vector<pfman::Instance> lights;
  for (const Lamp& lamp : lamps) {
    pfman::Instance& made = lights.emplace_back(light.shader(), static_cast<int>(lights.size()) + 1);
    made.set("position", values(lamp.position));
    made.set("ambient", values(lamp.ambient));
    made.set("diffuse", values(lamp.diffuse));
    made.set("specular", values(lamp.specular));
    made.set("constant_attenuation", {lamp.constant});
    made.set("linear_attenuation", {lamp.linear});
    made.set("quadratic_attenuation", {lamp.quadratic});
    made.set("spot_direction", values(lamp.spot));
    made.set("spot_exponent", {lamp.exponent});
    made.set("spot_cutoff", {lamp.cutoff});
  }
  pfman::TestView view;
  view.shape = pfman::TestShape::Sphere;
  view.width = view.height = 128;
  const pfman::TestSurface scene(view);
  const auto array =
      pixelflow::make_golden_array(pixelflow::Level::Macro, pixelflow::kRegionWidth * pixelflow::kRegionHeight);
  const Shaded shaded = shade(scene, instance, lights, 0, 32, *array);
  const std::size_t lanes = shaded.ids.size();
  int compared = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto point = scene.at(static_cast<int>(lane) % 128, 32 + static_cast<int>(lane) / 128);
    ASSERT_EQ(point.has_value(), shaded.ids[lane] != 0);
    if (!point) continue;
    const Color wanted = expected(*point, material, lamps);
    for (std::size_t c = 0; c < 3; ++c) {
      const double bytes = std::min(256 * wanted[c], 255.0);
      // The picture's byte is floored; four sums of U(16,12) colours and 14-bit directions are below one byte.
      EXPECT_NEAR(shaded.color[c * lanes + lane] + 0.5, bytes, 2.0) << "element " << lane << ", component " << c;
    }
    ++compared;
  }
  EXPECT_GT(compared, 4000);
}

TEST(OpenGl, ALightInfinitelyFarAway) {
  expect_equation({{{-2, 3, 2, 0}, {0.1, 0.1, 0.2}, {0.8, 0.7, 0.6}, {0.5, 0.5, 0.5}}});
}

TEST(OpenGl, AttenuationWithTheDistance) {
  expect_equation({{{1.5, -0.5, -0.6, 1}, {0, 0.1, 0}, {0.9, 0.4, 0.2}, {0.9, 0.9, 0.9}, 0.5, 0.2, 0.15}});
}

TEST(OpenGl, ASpotWithoutASharpEdge) {
  Lamp lamp{{1, 1, 0, 1}, {0, 0, 0}, {1, 1, 1}, {0.6, 0.6, 0.6}};
  lamp.spot = {-0.35, -0.35, -1};
  lamp.exponent = 12;
  lamp.cutoff = 85;
  expect_equation({lamp});
}

TEST(OpenGl, EightLights) {
  std::vector<Lamp> lamps;
  for (int n = 0; n < 8; ++n) {
    const double angle = n * std::numbers::pi / 4;
    lamps.push_back({{3 * std::cos(angle), 3 * std::sin(angle), -1, n % 2 ? 1.0 : 0.0},
                     {0.02, 0.01, 0.0},
                     {0.05 + 0.02 * n, 0.1, 0.2 - 0.02 * n},
                     {0.1, 0.1, 0.1}});
  }
  expect_equation(lamps);
}

}  // namespace
}  // namespace shader_tests
