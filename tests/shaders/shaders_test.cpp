// The project's shaders: all compile without a word, fit, and give the same bits and cycles at every level of
// modelling, and with every optimisation on or off.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "tests/shaders/region.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace shader_tests {
namespace {

using pfman::Instance;
using pfman::Shader;
using pixelflow::Level;

constexpr int kLanes = pixelflow::kElements;

/// Shapes that show something of each shader.
pfman::TestView view_of(const std::string& surface) {
  pfman::TestView view;
  if (surface.starts_with("data_")) view = {.shape = pfman::TestShape::Relief, .turn = 25, .tilt = 48};
  if (surface == "bowling_pin") view.shape = pfman::TestShape::Pin;
  if (surface == "volume_wood" || surface == "opengl_surface") view.shape = pfman::TestShape::Sphere;
  return view;
}

Instance instance_of(const Compiled& compiled) {
  Instance instance(compiled.shader(), 1);
  pfman::TestSurface::make_ordinary(instance);
  const std::string name = compiled.shader().shader->name;
  if (name == "ripple_mirror") instance.set("px_shader_time", {1.25});
  // Deep nests of masked loops take long in the RTL.
  if (name.starts_with("mandelbrot")) instance.set("iterations", {12});
  return instance;
}

/// Lights that a surface can be used with, each seen from where the surface is.
std::vector<std::string> lights_for(const Compiled& surface) {
  if (!surface.shader().code.has_illuminance) return {};
  if (surface.shader().shader->three_colours) return {"opengl_light"};
  return {"point_light", "directional_light", "spot_light", "paned_window", "opengl_light"};
}

Instance light_instance(const Compiled& compiled) {
  const std::string name = compiled.shader().shader->name;
  Instance light(compiled.shader());
  const auto set = [&](const char* parameter, std::vector<double> values) { light.set(parameter, values); };
  if (name == "point_light") {
    set("position", {-1, 1.5, -1.2});
    set("falloff", {0.1});
  } else if (name == "spot_light") {
    set("position", {1, 1, 0});
    set("target", {0, 0, -2.8});
  } else if (name == "directional_light") {
    set("direction", {1, -1, -2});
  } else if (name == "paned_window") {
    set("lamp", {1, 2, 1});
    set("middle", {0.5, 1, -0.8});
  } else if (name == "opengl_light") {
    set("position", {-1, 1, -0.5, 1});
    set("quadratic_attenuation", {0.2});
    set("spot_direction", {0.4, -0.4, -0.8});
    set("spot_cutoff", {60});
    set("spot_exponent", {4});
  }
  return light;
}

class Shaders : public testing::TestWithParam<std::string> {};
class Surfaces : public testing::TestWithParam<std::string> {
 protected:
  /// The surface under all its lights at once, in the middle of its picture.
  Shaded shade_with(const pfman::Options& options, pixelflow::PixelArray& array) const {
    const Compiled surface = compile(GetParam(), options);
    std::vector<Compiled> units;
    for (const std::string& name : lights_for(surface)) units.push_back(compile(name, options));
    std::vector<Instance> lights;
    for (const Compiled& unit : units) lights.push_back(light_instance(unit));
    return shade(pfman::TestSurface(view_of(GetParam())), instance_of(surface), lights, 192, 250, array);
  }
};

TEST_P(Shaders, CompileWithoutErrorsAndWarnings) {
  const Compiled compiled = compile(GetParam());
  EXPECT_EQ(compiled.said, "");
  ASSERT_EQ(compiled.unit->shaders.size(), 1u);
  EXPECT_EQ(compiled.shader().shader->name, GetParam());
  EXPECT_GT(compiled.shader().code.code.size(), 0u);
}

TEST_P(Surfaces, ShowSomething) {
  const auto array = pixelflow::make_golden_array(Level::Macro, pixelflow::kRegionWidth * pixelflow::kRegionHeight);
  const Shaded shaded = shade_with({}, *array);
  std::set<std::uint8_t> colors;
  int shown = 0;
  for (std::size_t lane = 0; lane < shaded.ids.size(); ++lane) {
    if (shaded.ids[lane] == 0) continue;
    ++shown;
    for (std::size_t n = 0; n < 3; ++n) colors.insert(shaded.color[n * shaded.ids.size() + lane]);
  }
  EXPECT_GT(shown, 1000);
  EXPECT_GT(colors.size(), 4u);
}

TEST_P(Surfaces, HaveTheSameBitsAndCyclesAtEveryLevel) {
  const auto macro = pixelflow::make_golden_array(Level::Macro, kLanes);
  const Shaded expected = shade_with({}, *macro);
  const auto same = [&](pixelflow::PixelArray& array, const char* level) {
    const Shaded shaded = shade_with({}, array);
    EXPECT_EQ(shaded.color, expected.color) << level;
    EXPECT_EQ(shaded.counters.cycles, expected.counters.cycles) << level;
  };
  same(*pixelflow::make_golden_array(Level::Model, kLanes), "model");
#ifdef VSG_HAVE_RTL
  same(*tb::make_rtl_array(kLanes), "rtl");
#endif
}

TEST_P(Surfaces, HaveTheSameBitsWithoutAnOptimisation) {
  const auto colors = [&](const pfman::Options& options) {
    return shade_with(options, *pixelflow::make_golden_array(Level::Macro, kLanes)).color;
  };
  const auto without = [](bool pfman::Options::*optimisation) {
    pfman::Options options;
    options.*optimisation = false;
    return options;
  };
  const std::vector<std::uint8_t> expected = colors({});
  EXPECT_EQ(colors(without(&pfman::Options::fuse)), expected);
  EXPECT_EQ(colors(without(&pfman::Options::drop_unused)), expected);
  EXPECT_EQ(colors(without(&pfman::Options::join_copies)), expected);
}

std::vector<std::string> surface_files() {
  std::vector<std::string> names;
  for (const std::string& name : shader_files()) {
    if (!name.ends_with("_light") && name != "paned_window") names.push_back(name);
  }
  return names;
}

std::string file_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Project, Shaders, testing::ValuesIn(shader_files()), file_name);
INSTANTIATE_TEST_SUITE_P(Project, Surfaces, testing::ValuesIn(surface_files()), file_name);

}  // namespace
}  // namespace shader_tests
