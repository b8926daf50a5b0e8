// The project's shaders: all compile without a word, fit, and give the same bits and cycles at every level of
// modelling, and with every optimisation on or off.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "tests/shaders/scenes.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace shader_tests {
namespace {

using pixelflow::Level;

constexpr int kLanes = pixelflow::kElements;

class Shaders : public testing::TestWithParam<std::string> {};
class Surfaces : public testing::TestWithParam<std::string> {
 protected:
  /// The surface under all its lights at once, in the middle of its picture.
  Shaded shade_with(const pfman::Options& options, pixelflow::PixelArray& array) const {
    const Scene scene = make_scene(GetParam(), options);
    return shade(pfman::TestSurface(scene.view), scene.instance.front(), scene.lights, 192, 250, array);
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

std::string file_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Project, Shaders, testing::ValuesIn(shader_files()), file_name);
INSTANTIATE_TEST_SUITE_P(Project, Surfaces, testing::ValuesIn(surface_files()), file_name);

}  // namespace
}  // namespace shader_tests
