// The surfaces that scenes use most against their formulas in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "pixelflow/shading/test_textures.h"
#include "tests/shaders/region.h"

namespace shader_tests {
namespace {

using Color = std::array<double, 3>;
using pfman::Vector;
using Point = pfman::TestSurface::Point;

constexpr Color kColor{0.6, 0.3, 0.8}, kAmbient{0.1, 0.15, 0.05};

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
std::vector<double> values(const Color& c) { return {c.begin(), c.end()}; }

struct Sun {
  Vector towards;
  Color rgb;
};
const std::array<Sun, 3> kSuns{{{unit({-1, 1, 1.2}), {0.5, 0.4, 0.3}},
                                {unit({1, 0.2, 0.8}), {0.2, 0.3, 0.4}},
                                {unit({0, -1, 0.3}), {0.3, 0, 0.1}}}};

/// What arrives at a point; `seen`: the share of each sun.
Color light_at(const Point& point, const std::array<double, 3>& seen = {1, 1, 1}) {
  Color sum = kAmbient;
  for (std::size_t k = 0; k < kSuns.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += std::max(dot(point.normal, kSuns[k].towards), 0.0) * kSuns[k].rgb[c] * seen[k];
  }
  return sum;
}

/// Colours on a sphere differ from the formula's by at most `levels` of 256.
void expect_formula(const std::string& name, const std::map<std::string, std::vector<double>>& parameters,
                    const std::function<Color(const Point&)>& formula, double levels = 1.25) {
  const Compiled surface = compile(name), sun = compile("directional_light");
  ASSERT_EQ(surface.said + sun.said, "");
  pfman::Instance instance(surface.shader(), 1);
  pfman::TestSurface::make_ordinary(instance);
  instance.set("rgb", values(kColor));
  instance.set("scene_ambient", values(kAmbient));
  for (const auto& [parameter, numbers] : parameters) instance.set(parameter, numbers);
  std::vector<pfman::Instance> lights;
  for (const Sun& s : kSuns) {
    pfman::Instance& light = lights.emplace_back(sun.shader());
    light.set("direction", {-s.towards[0], -s.towards[1], -s.towards[2]});
    light.set("rgb", values(s.rgb));
  }
  pfman::TestView view;
  view.shape = pfman::TestShape::Sphere;
  const pfman::TestSurface scene(view);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, 8192);
  int compared = 0;
  for (const int row : {120, 200, 280}) {
    const Shaded shaded = shade(scene, instance, lights, 192, row, *array);
    const std::size_t lanes = shaded.ids.size();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const int column = 192 + static_cast<int>(lane) % 128, line = row + static_cast<int>(lane) / 128;
      const auto point = scene.at(column, line);
      if (!point || shaded.ids[lane] == 0) continue;
      const Color color = formula(*point);
      for (std::size_t c = 0; c < 3; ++c) {
        const double byte = std::clamp(color[c] * 256, 0.0, 255.0);
        // Floored: never more than the formula has, but for the last places of what comes before.
        ASSERT_NEAR(shaded.color[c * lanes + lane] + 0.5, byte, levels)
            << name << ' ' << column << ' ' << line << ' ' << c;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000);
}

Color product(const Color& a, const Color& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

TEST(shaders_surfaces, flat_and_matte_are_diffuse) {
  const auto diffuse = [](const Point& point) { return product(kColor, light_at(point)); };
  expect_formula("flat", {}, diffuse);
  expect_formula("matte", {}, diffuse);
}

TEST(shaders_surfaces, plastic_has_phongs_highlight) {
  constexpr double kGloss = 0.4, kShine = 23.5;
  // The power makes some thirty of an error of the cosine.
  expect_formula(
      "plastic", {{"gloss", {kGloss}}, {"shine", {kShine}}},
      [](const Point& point) {
        Color color = product(kColor, light_at(point));
        const Vector& p = point.position;
        const Vector to_eye = unit({-p[0], -p[1], -p[2]});
        for (const Sun& sun : kSuns) {
          const double nl = dot(point.normal, sun.towards);
          if (nl <= 0) continue;
          Vector mirrored;
          for (std::size_t n = 0; n < 3; ++n) mirrored[n] = 2 * nl * point.normal[n] - sun.towards[n];
          const double gleam = std::pow(std::clamp(dot(mirrored, to_eye), 0.0, 1.0), kShine);
          for (std::size_t c = 0; c < 3; ++c) color[c] += kGloss * gleam * sun.rgb[c];
        }
        return color;
      },
      2);
}

TEST(shaders_surfaces, textured_lets_light_through_its_image) {
  const pfman::TextureMemory textures = pfman::test_textures();
  expect_formula("textured", {{"image", {3}}}, [&](const Point& point) {
    const auto texel =
        textures.lookup(3, static_cast<float>(point.shape.texcoord[0]), static_cast<float>(point.shape.texcoord[1]));
    const Color image{texel[0] / 256.0, texel[1] / 256.0, texel[2] / 256.0};
    return product(product(kColor, image), light_at(point));
  });
}

TEST(shaders_surfaces, field_matte_takes_the_visibility_of_the_first_two_lights) {
  for (const double first : {0.0, 0.5, 255 / 256.0}) {
    for (const double second : {0.0, 255 / 256.0}) {
      const auto share = [](double visibility) { return visibility > 0.99 ? 1 : visibility; };
      expect_formula("field_matte", {{"field_visibility", {first, second}}}, [&](const Point& point) {
        return product(kColor, light_at(point, {share(first), share(second), 1}));
      });
    }
  }
}

TEST(shaders_surfaces, field_mirror_mixes_in_the_reflection) {
  constexpr double kMirror = 0.7;
  expect_formula(
      "field_mirror",
      {{"field_visibility", {0, 255 / 256.0}}, {"field_reflection", {0.25, 0.5, 255 / 256.0}}, {"mirror", {kMirror}}},
      [&](const Point& point) {
        Color color = product(kColor, light_at(point, {0, 1, 1}));
        const Color seen{0.25, 0.5, 1};
        for (std::size_t c = 0; c < 3; ++c) color[c] = (1 - kMirror) * color[c] + kMirror * seen[c];
        return color;
      });
}

}  // namespace
}  // namespace shader_tests
