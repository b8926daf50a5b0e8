// Mistakes of scenes that only show when shaders meet geometry: each is named with its line, all of them in one run.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "scanline/scene.h"
#include "watkins/renderer.h"

namespace scene_tests {
namespace {

namespace fs = std::filesystem;

/// What is said about a scene of this text, lines of messages; empty when nothing is. It seems to stand in scenes/.
std::vector<std::string> said(const std::string& text) {
  const fs::path file = fs::path(VSG_SOURCE_DIR) / "scenes" / "scene.toml";
  watkins::RenderOptions options;
  options.generator.vsg = "model";
  options.pixels.level = "macro";
  std::vector<std::string> lines;
  try {
    const scanline::Scene scene = scanline::read_scene(text, file);
    watkins::Renderer renderer(scene, file.string(), options);
    renderer.shade(renderer.find_visible(1));
  } catch (const scanline::UserError& error) {
    for (scanline::Diagnostic d : error.diagnostics()) {
      d.file = fs::path(d.file).filename().string();
      d.column = 0;
      lines.push_back(scanline::format(d));
    }
  }
  return lines;
}

using Lines = std::vector<std::string>;

/// One object a line, from line 3 on.
std::string scene_of(const std::vector<std::string>& shaders) {
  std::string text = "version = 1\nsize = [32, 32]\n";
  for (const std::string& shader : shaders) {
    text += "object = [{geometry = \"shape\", shape = \"sphere\", shader = " + shader + "}]\n";
  }
  return text;
}

TEST(SceneMistakes, ASceneWithoutAnyIsShown) { EXPECT_EQ(said(scene_of({"{name = \"matte\"}"})), Lines()); }

TEST(SceneMistakes, UnknownShader) {
  EXPECT_EQ(said(scene_of({"{name = \"mate\"}"})),
            Lines{"scene.toml:3: error: there is no shader 'mate'; one of your own needs a 'file'"});
}

TEST(SceneMistakes, AllObjectsAndLightsAreLookedAt) {
  const Lines lines = said(R"(version = 1
size = [32, 32]

[[light]]
shader = {name = "matte"}

[[object]]
geometry = "shape"
shape = "sphere"
shader = {name = "matte", parameters = {rgp = [1, 0, 0]}}

[[object]]
geometry = "shape"
shape = "box"
shader = {name = "point_light"}

[[object]]
geometry = "shape"
shape = "torus"
shader = {name = "textured", parameters = {image = "nowhere.png"}}

[[object]]
geometry = "shape"
shape = "cone"
shader = {name = "plastic", parameters = {shine = "letters.png"}}
)");
  ASSERT_EQ(lines.size(), 6u) << testing::PrintToString(lines);
  EXPECT_EQ(lines[0], "scene.toml:10: error: 'matte' has no parameter 'rgp'");
  EXPECT_NE(lines[1].find("scene.toml:15: error: "), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("has no surface 'point_light'"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("scene.toml:20: error: cannot read '"), std::string::npos) << lines[2];
  EXPECT_NE(lines[3].find("nowhere.png"), std::string::npos) << lines[3];
  EXPECT_EQ(lines[4], "scene.toml:25: error: parameter 'shine' of 'plastic' is no whole number: a text names an image");
  EXPECT_NE(lines[5].find("scene.toml:5: error: "), std::string::npos) << lines[5];
  EXPECT_NE(lines[5].find("has no light 'matte'"), std::string::npos) << lines[5];
}

TEST(SceneMistakes, ParametersOfTheWrongShape) {
  EXPECT_EQ(said(scene_of({"{name = \"matte\", parameters = {rgb = [1, 0]}}"})).size(), 1u);
  EXPECT_EQ(said(scene_of({"{name = \"matte\", parameters = {rgb = 1}}"})).size(), 1u);
  EXPECT_EQ(said(scene_of({"{name = \"matte\", parameters = {rgb = [1, 0, 0]}}"})), Lines());
  EXPECT_EQ(said(scene_of({"{name = \"matte\", parameters = {color = [1, 0, 0]}}"})), Lines());
}

TEST(SceneMistakes, AShaderFileThatIsNotThere) {
  const Lines lines = said(scene_of({"{name = \"own\", file = \"own.pfman\"}"}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].starts_with("scene.toml:3: error: cannot read '")) << lines[0];
}

TEST(SceneMistakes, AShaderFileWithMistakesIsNamedInstead) {
  const fs::path file = fs::temp_directory_path() / "vsg_scene_mistakes.pfman";
  std::FILE* out = std::fopen(file.c_str(), "w");
  ASSERT_NE(out, nullptr);
  std::fputs("surface own(output varying fixed<8,8> px_shader_color[3])\n{\n    px_shader_color = none;\n}\n", out);
  std::fclose(out);
  const Lines lines = said(scene_of({"{name = \"own\", file = \"" + file.string() + "\"}"}));
  fs::remove(file);
  ASSERT_EQ(lines.size(), 1u) << testing::PrintToString(lines);
  EXPECT_TRUE(lines[0].starts_with("vsg_scene_mistakes.pfman:3: error: ")) << lines[0];
}

}  // namespace
}  // namespace scene_tests
