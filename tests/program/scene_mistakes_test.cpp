// Mistakes in what a scene names: exit status 1, file and line in the message, no output left.
#include <algorithm>
#include <string>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

// Lines 1 to 3 of a scene; what follows begins on line 4.
constexpr char kBegin[] = "version = 1\nsize = [16, 16]\nbackground = [0, 0, 1]\n";
// Lines 4 to 6.
constexpr char kBox[] = "[[object]]\ngeometry = \"shape\"\nshape = \"box\"\n";

class SceneMistakes : public ProgramTest {
 protected:
  void expect_refused(const std::string& scene, const std::vector<std::string>& messages) {
    write("scene.toml", kBegin + scene + "\n");
    const auto before = files();
    const Outcome result = run({"render", "scene.toml", "-o", "a.png", "--stats", "s.json"});
    EXPECT_EQ(result.status, 1) << scene;
    EXPECT_EQ(result.out, "");
    for (const std::string& message : messages) {
      EXPECT_NE(result.err.find(message), std::string::npos) << scene << "\n" << result.err;
    }
    EXPECT_EQ(files(), before) << scene;
  }
};

TEST_F(SceneMistakes, ShadersThatDoNotFitTheMachine) {
  std::string wide = "surface wide(output varying fixed<8,8> px_shader_color[3],\n";
  for (int k = 0; k < 9; ++k) wide += "varying float p" + std::to_string(k) + "[4] = { 0, 0, 0, 0 },\n";
  write("wide.pfman", wide +
                          "uniform float x = 0)\n{ px_shader_color = { p0[0] + p1[0] + p2[0] + p3[0] + p4[0] + p5[0] "
                          "+ p6[0] + p7[0] + p8[0], x, x }; }\n");
  expect_refused(std::string(kBox) + "shader = {name = \"wide\", file = \"wide.pfman\"}",
                 {"wide.pfman:1:9: error: shader 'wide' receives 146 bytes"});

  write("big.pfman",
        "surface big(output varying fixed<8,8> px_shader_color[3], varying float px_shader_position[3])\n"
        "{\n    uniform int i;\n    float a[60];\n"
        "    for (i = 0; i < 60; i++) a[i] = px_shader_position[0] * i;\n"
        "    float sum = 0;\n    for (i = 0; i < 60; i++) sum += a[i] * a[59 - i];\n"
        "    px_shader_color = { sum, sum, sum };\n}\n");
  expect_refused(std::string(kBox) + "shader = {name = \"big\", file = \"big.pfman\"}", {"big.pfman:", "bytes"});

  // What is wrong with a value shows when the stream is made.
  write("index.pfman",
        "surface index(output varying fixed<8,8> px_shader_color[3], uniform int n = 0)\n{\n"
        "    float a[3] = { 0.25, 0.5, 0.75 };\n    px_shader_color = { a[n], a[n], a[n] };\n}\n");
  expect_refused(std::string(kBox) + "shader = {name = \"index\", file = \"index.pfman\", parameters = {n = 3}}",
                 {"index.pfman:4:", "error: index 3 is outside of the array's 0 to 2"});
}

TEST_F(SceneMistakes, ValuesThatAParameterCannotHave) {
  expect_refused(kBox + std::string("shader = {name = \"textured\", parameters = {image = 1.5}}"),
                 {"scene.toml:7: error: parameter 'image' of 'textured' must be a whole number"});
  expect_refused(kBox + std::string("shader = {name = \"flat\", parameters = {rgb = [1, 0, 0], color = [0, 1, 0]}}"),
                 {"scene.toml:7: error: 'color' and 'rgb' are one parameter of 'flat'"});
}

TEST_F(SceneMistakes, MorePolygonsThanTheMachineHolds) {
  expect_refused("[camera]\nposition = [0, 5, 0.1]\n[[object]]\ngeometry = \"shape\"\nshape = \"plane\"\n"
                 "divisions = [400, 400]",
                 {"scene.toml: error: the frame has 160000 polygons"});
}

TEST_F(SceneMistakes, ShadersAndTheirParameters) {
  write("text.png", "no picture");
  expect_refused(kBox + std::string("shader = {name = \"flat\", parameters = {shine = 2}}"),
                 {"scene.toml:7: error: 'flat' has no parameter 'shine'"});
  expect_refused(kBox + std::string("shader = {name = \"flat\", parameters = {rgb = [1, 2]}}"),
                 {"scene.toml:7: error: parameter 'rgb' has 3 numbers, not 2"});
  expect_refused(kBox + std::string("shader = {name = \"textured\", parameters = {image = \"absent.png\"}}"),
                 {"scene.toml:7: error: cannot read 'absent.png'"});
  expect_refused(kBox + std::string("shader = {name = \"textured\", parameters = {image = \"text.png\"}}"),
                 {"scene.toml:7: error: cannot read 'text.png'", "text.png: error: "});
  expect_refused(kBox + std::string("shader = {name = \"flat\", parameters = {rgb = \"text.png\"}}"),
                 {"scene.toml:7: error: parameter 'rgb' of 'flat' is no whole number: a text names an image"});
  expect_refused(kBox + std::string("shader = {name = \"flat\", file = \"absent.pfman\"}"),
                 {"scene.toml:7: error: cannot read 'absent.pfman'"});
  const std::string endless(5000, 'a');  // no file may be called so
  expect_refused(kBox + ("shader = {name = \"" + endless + "\"}"), {"scene.toml:7: error: there is no shader 'aaa"});
  expect_refused(kBox + std::string("shader = {name = \"point_light\"}"), {"scene.toml:7: error: ", "no surface"});
  expect_refused(kBox + std::string("[[light]]\nshader = {name = \"flat\"}"), {"scene.toml:8: error: ", "no light"});
  expect_refused(kBox + std::string("[[light]]\nshader = {name = \"spot_light\", parameters = {conus = 3}}"),
                 {"scene.toml:8: error: 'spot_light' has no parameter 'conus'"});
}

TEST_F(SceneMistakes, ParametersThatNobodyGives) {
  write("warm.pfman",
        "surface warm(output varying fixed<8,8> px_shader_color[3],\n    varying float heat[3])\n"
        "{ px_shader_color = heat; }\n");
  expect_refused(kBox + std::string("shader = {name = \"warm\", file = \"warm.pfman\"}"),
                 {"warm.pfman:2:19: error: parameter 'heat' needs a default"});
}

TEST_F(SceneMistakes, LightsThatDoNotFitASurface) {
  // The surface keeps 150 bytes of its own while lights run; the light wants 120.
  std::string full =
      "surface full(output varying fixed<8,8> px_shader_color[3], varying float px_shader_position[3])\n"
      "{\n    uniform int i;\n    float a[38];\n"
      "    for (i = 0; i < 38; i++) a[i] = px_shader_position[0] * i;\n    float sum = 0;\n"
      "    illuminance () { sum += px_light_color[0]; }\n"
      "    for (i = 0; i < 38; i++) sum += a[i];\n    px_shader_color = { sum, sum, sum };\n}\n";
  write("full.pfman", full);
  write("wide.pfman",
        "light wide(varying float px_shader_position[3])\n{\n    uniform int i;\n    float a[30];\n"
        "    for (i = 0; i < 30; i++) a[i] = px_shader_position[1] * i;\n    float sum = 0;\n"
        "    for (i = 0; i < 30; i++) sum += a[i] * a[29 - i];\n"
        "    illuminate ({ 0, 0, 0 }) { px_light_color = { sum, sum, sum }; }\n}\n");
  expect_refused(std::string(kBox) + "shader = {name = \"full\", file = \"full.pfman\"}\n[[light]]\n" +
                     "shader = {name = \"wide\", file = \"wide.pfman\"}",
                 {"scene.toml", "error: ", "wide", "full"});
}

TEST_F(SceneMistakes, GeometryThatIsNotThere) {
  write("text.tif", "no raster");
  expect_refused("[[object]]\ngeometry = \"field\"\nfield = {kind = \"plane\"}", {"scene.toml:6:", "'bounds'"});
  expect_refused("[[object]]\ngeometry = \"terrain\"\nfile = \"absent.tif\"",
                 {"scene.toml:6:", "absent.tif: error: cannot open"});
  expect_refused("[[object]]\ngeometry = \"terrain\"\nfile = \"text.tif\"", {"scene.toml:6:", "text.tif: error: "});
  expect_refused("[[object]]\ngeometry = \"mesh\"\nfile = \"absent.obj\"", {"scene.toml:6:", "absent.obj: error: "});
}

TEST_F(SceneMistakes, NumbersThatAreNone) {
  const std::string texts[] = {
      "[camera]\nposition = [0, ?, 5]\n" + std::string(kBox),
      "[camera]\nfield_of_view = ?\n" + std::string(kBox),
      "[camera]\nfar = ?\n" + std::string(kBox),
      "[[light]]\ndirection = [0, ?, 1]\n" + std::string(kBox),
      "[[light]]\nintensity = ?\n" + std::string(kBox),
      kBox + std::string("size = ?\n"),
      kBox + std::string("translate = [0, ?, 0]\n"),
      kBox + std::string("scale = ?\n"),
      kBox + std::string("keys = [{frame = ?}]\n"),
      kBox + std::string("shader = {name = \"flat\", parameters = {rgb = [0, ?, 0]}}\n"),
      "[[object]]\ngeometry = \"field\"\nfield = {kind = \"sphere\", radius = ?}\n",
  };
  for (const std::string& text : texts) {
    for (const char* number : {"nan", "-inf"}) {
      std::string scene = text;
      const std::size_t at = scene.find('?');
      const auto line = 4 + std::count(scene.begin(), scene.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      expect_refused(scene.replace(at, 1, number), {"scene.toml:" + std::to_string(line) + ":", "error: "});
    }
  }
}

TEST_F(SceneMistakes, AllAreSaidInOneRun) {
  expect_refused(kBox + std::string("shader = {name = \"flat\", parameters = {shine = 2}}\n[[object]]\n"
                                    "geometry = \"shape\"\nshape = \"sphere\"\nshader = {name = \"mat\"}\n[[light]]\n"
                                    "shader = {name = \"flat\"}"),
                 {"scene.toml:7: error: ", "scene.toml:11: error: ", "scene.toml:13: error: "});
}

}  // namespace
}  // namespace vsg_tests
