// Whole shaders.
#include "tests/reference/shaders.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "pixelflow/language/parser.h"

namespace reference_tests {
namespace {

using namespace reference;

class PlainTextures : public Textures {
 public:
  std::array<std::uint8_t, 4> look_up(std::int64_t, float, float) const override { return {10, 20, 30, 40}; }
  std::array<std::uint8_t, 4> environment(std::int64_t, std::array<float, 3>) const override {
    return {50, 60, 70, 80};
  }
};

TEST(Shaders, brick_of_the_paper) {
  // Rows of bricks, 0.25 wide and 0.125 high, every other row moved by half a brick; mortar at each brick's start.
  const std::string text =
      "surface s(output varying fixed<8,8> px_shader_color[3], varying float st[2] = {0, 0}, uniform float width = "
      "0.25,"
      "uniform float height = 0.125, uniform float mortar = 0.02) { float ss = st[0]; float tt = st[1];"
      "fixed<8,0> row = tt / height; if (row % 2 == 0) ss += width/2; ss = ss % width; tt = tt % height;"
      "float c[3] = {0.5, 0.25, 0}; if (ss < mortar || tt < mortar) c = {0.75, 0.75, 0.75}; px_shader_color = c; }";
  Input input;
  input.lanes = 4;
  for (const float s : {0.13f, 0.01f, 0.1f, 0.0f}) input.varying["st"].push_back(float_bits(s));
  for (const float t : {0.06f, 0.06f, 0.126f, 0.2f}) input.varying["st"].push_back(float_bits(t));
  // Row 0: 0.13 + 0.125 wraps to 0.005, mortar; 0.01 moves into the brick. Row 1: its first line; its first column.
  EXPECT_EQ(run(text, input).color,
            (std::vector<std::uint8_t>{192, 128, 192, 192, 192, 64, 192, 192, 192, 0, 192, 192}));
}

/// Every shader of the folder runs, with the default of every parameter but the varying ones, which count up.
TEST(Shaders, all_of_the_projects_run) {
  const std::filesystem::path folder = PFMAN_SHADERS;
  int run_count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".pfman") continue;
    SCOPED_TRACE(entry.path().filename().string());
    pfman::Diagnostics diagnostics;
    const pfman::ast::Unit unit = pfman::parse_file(entry.path(), {}, diagnostics);
    ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.text();
    const Interpreter interpreter(unit);
    for (const auto& definition : unit.definitions) {
      const bool light = definition.kind == pfman::ast::Definition::Kind::Light;
      if (!light && definition.kind != pfman::ast::Definition::Kind::Surface) continue;
      Input input;
      input.lanes = 4;
      const PlainTextures textures;
      input.textures = &textures;
      for (int n = 0; n < 12; ++n) input.position.push_back(float_bits(0.25f * static_cast<float>(n) - 1));
      if (light) {
        EXPECT_EQ(interpreter.light(definition.name, {}, input).color.size(), 12u);
      } else {
        for (const ParameterInfo& parameter : interpreter.parameters(definition.name)) {
          if (parameter.uniform || parameter.output || parameter.name.starts_with("px_shader_")) continue;
          for (int n = 0; n < 4 * parameter.elements; ++n) {
            const Raw value = float_bits(0.125f * static_cast<float>(n));
            input.varying[parameter.name].push_back(
                parameter.number.floating ? value : float_to_fixed(value, parameter.number));
          }
        }
        EXPECT_EQ(interpreter.surface(definition.name, input).color.size(), 12u);
      }
      ++run_count;
    }
  }
  EXPECT_GT(run_count, 0);
}

}  // namespace
}  // namespace reference_tests
