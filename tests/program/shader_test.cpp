// vsg shader: what it says of shaders, its dumps, its mistakes, its pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr char kShaders[] = R"(surface tiny(output varying fixed<8,8> px_shader_color[3],
             varying float px_shader_texcoord[2],
             uniform float scale = 2.0, uniform int n = 3)
{
    float a[4] = { 0, 0.25, 0.5, 0.75 };
    float s = px_shader_texcoord[0] * scale;
    if (s < 1) s = s + a[n];
    fixed<8,8> c = s;
    illuminance () { c = px_light_color[1]; }
    px_shader_color = { c, c, SHADE };
}
light lamp(uniform float v = 0.5) { solar ({ 0, 0, -1 }, 0) { px_light_color = { v, v, v }; } }
surface flat(output varying fixed<8,8> px_shader_color[3], uniform fixed<8,8> paint[3] = { 0.25, 0.5, 0.75 })
{
    px_shader_color = paint;
}
)";

class ShaderCommand : public ProgramTest {
 protected:
  ShaderCommand() { write("tiny.pfman", kShaders); }

  Outcome shader(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"shader", "tiny.pfman", "-D", "SHADE=s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(ShaderCommand, DescribesEveryShader) {
  const Outcome result = shader({});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, StartsWith("surface tiny (tiny.pfman:1:9)\n  memory      "));
  EXPECT_THAT(result.out, HasSubstr("  transfer    10 bytes, 1 packet a pixel\n"));
  EXPECT_THAT(result.out, HasSubstr(" a region with one light\n"));
  EXPECT_THAT(result.out, HasSubstr("float_multiply 1, "));
  EXPECT_THAT(result.out, HasSubstr("light lamp (tiny.pfman:12:7)\n"));
  EXPECT_THAT(result.out, HasSubstr("surface flat (tiny.pfman:13:9)\n"));
}

TEST_F(ShaderCommand, DescribesTheShaderThatIsNamed) {
  EXPECT_THAT(shader({"--shader", "lamp"}).out, StartsWith("light lamp (tiny.pfman:12:7)\n"));
  const Outcome result = shader({"--shader", "nobody"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "tiny.pfman: error: there is no shader 'nobody'\n");
}

TEST_F(ShaderCommand, ShowsWhatPassesLeave) {
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"ast", "parameter scale: uniform float"},
      {"types", "literal 0.25 : uniform float"},
      {"ssa", "px_shader_texcoord[0]"},
      {"lifetime", "lifetimes of tiny"},
      {"memory-map", "memory map of tiny"},
      {"listing", "tiny.pfman:6: float s = px_shader_texcoord[0] * scale;\n     163  "},
      {"cycles", "  tiny.pfman:6: float s = px_shader_texcoord[0] * scale;"}};
  for (const auto& [phase, part] : parts) {
    const Outcome result = shader({"--shader", "tiny", "--dump", phase});
    EXPECT_EQ(result.status, 0) << phase;
    EXPECT_THAT(result.out, HasSubstr(part)) << phase;
  }
  EXPECT_EQ(shader({"--shader", "tiny", "--listing"}).out, shader({"--shader", "tiny", "--dump", "listing"}).out);
  EXPECT_EQ(shader({"--shader", "tiny", "--memory-map"}).out, shader({"--shader", "tiny", "--dump", "memory-map"}).out);
}

TEST_F(ShaderCommand, ListsOperationsWithAddresses) {
  const Outcome result = shader({"--shader", "flat", "--listing"});
  EXPECT_EQ(result.out,
            "all: 12 cycles\n"
            "  tiny.pfman:13: surface flat(output varying fixed<8,8> px_shader_color[3], uniform fixed<8,8> paint[3] = "
            "{ 0.25, 0.5, 0.75 })\n"
            "       1  xor(01, memory[00]), Z\n"
            "       1  xor(00, memory[01]), Z and\n"
            "       1  E := Z\n"
            "  tiny.pfman:15: px_shader_color = paint;\n"
            "       1  [02] := copy 64\n"
            "       1  [03] := copy 128\n"
            "       1  [04] := copy 192\n"
            "  tiny.pfman:13: surface flat(output varying fixed<8,8> px_shader_color[3], uniform fixed<8,8> paint[3] = "
            "{ 0.25, 0.5, 0.75 })\n"
            "       2  [e8] := copy [02]\n"
            "       2  [e9] := copy [03]\n"
            "       2  [ea] := copy [04]\n");
  EXPECT_THAT(shader({"--shader", "tiny", "--listing"}).out, HasSubstr("float_to_fixed [02-05], scale 8    work ["));
}

TEST_F(ShaderCommand, SetsValues) {
  EXPECT_THAT(shader({"--shader", "flat", "--listing", "--set", "paint=0.5,1,-3"}).out,
              HasSubstr("[02] := copy 128\n       1  [03] := copy 255\n       1  [04] := copy 0\n"));
  Outcome result = shader({"--set", "colour=1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "tiny.pfman: error: --set colour=1: no shader has such a parameter\n");
  result = shader({"--set", "paint=1,2"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "error: 'paint=1,2': parameter 'paint' has 3 numbers, not 2\n");
  EXPECT_EQ(shader({"--set", "scale=1x"}).err,
            "error: 'scale=1x': '1x' is no number; NAME=NUMBER,NUMBER... is wanted\n");
  EXPECT_EQ(shader({"--set", "scale=nan"}).err,
            "error: 'scale=nan': 'nan' is no number; NAME=NUMBER,NUMBER... is wanted\n");
  EXPECT_EQ(shader({"--set", "scale"}).err, "error: 'scale': NAME=NUMBER,NUMBER... is wanted\n");
}

TEST_F(ShaderCommand, ReportsMistakesWithTheirPlaces) {
  Outcome result = shader({"--set", "n=9"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "tiny.pfman:7:26: error: index 9 is outside of the array's 0 to 3\n");
  result = run({"shader", "tiny.pfman"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "tiny.pfman:10:31: error: undeclared identifier 'SHADE' [E110]\n");
  EXPECT_EQ(run({"shader", "none.pfman"}).status, 1);
}

TEST_F(ShaderCommand, GoesOnAfterWarnings) {
  write("warned.pfman",
        "surface s(output varying fixed<8,8> px_shader_color[3], uniform float x = 1) { px_shader_color = { 0, 0, 0 }; "
        "}\n");
  const Outcome result = run({"shader", "warned.pfman"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("warning:"));
  EXPECT_THAT(result.out, StartsWith("surface s "));
}

TEST_F(ShaderCommand, OptimisationsLeaveThePicture) {
  const std::vector<std::string> picture = {"--size", "96x48", "--pe", "macro", "--quiet", "-o"};
  const auto with = [&](std::vector<std::string> arguments, const std::string& image) {
    arguments.insert(arguments.end(), picture.begin(), picture.end());
    arguments.push_back(image);
    const Outcome result = shader(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return read(image);
  };
  const std::string all = with({}, "all.png");
  EXPECT_EQ(all, with({"--no-fuse", "--no-drop-unused", "--no-join-copies", "--no-share-memory"}, "none.png"));
  EXPECT_EQ(all, with({"--threads", "1"}, "one.png"));
  EXPECT_NE(all, with({"--set", "scale=3"}, "other.png"));
}

TEST_F(ShaderCommand, ShowsTheSurfaceAtEveryLevel) {
  const auto picture = [&](const std::string& level, const std::string& image) {
    const Outcome result = shader({"--light", "lamp v=0.25", "--light", "tiny.pfman:lamp", "--on", "sphere", "--size",
                                   "40x30", "--pe", level, "--quiet", "-o", image});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    return read_image(path(image));
  };
  const Image macro = picture("macro", "macro.png"), model = picture("model", "model.png");
  EXPECT_EQ(macro.width, 40);
  EXPECT_EQ(macro.height, 30);
  EXPECT_EQ(macro.values, model.values);
#ifdef VSG_HAVE_RTL
  EXPECT_EQ(macro.values, picture("rtl", "rtl.png").values);
#endif
  EXPECT_EQ(macro.at(20, 15, 0), 128) << "the colour of the last light";
}

TEST_F(ShaderCommand, RefusesWhatItCannotShow) {
  EXPECT_EQ(shader({"-o", "x.png", "--size", "0x9"}).err,
            "error: --size wants WIDTHxHEIGHT, each from 1 to 8192 samples, not '0x9'\n");
  for (const std::string bad : {"nan", "0", "inf", "far"}) {
    const Outcome result = shader({"-o", "x.png", "--distance", bad});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, testing::HasSubstr("'" + bad + "' is not a number from 0.01 to 1000"));
  }
  EXPECT_EQ(shader({"-o", "x.png", "--light", "tiny"}).err, "error: 'tiny' is no light\n");
  EXPECT_EQ(shader({"-o", "x.png", "--shader", "lamp"}).err,
            "tiny.pfman: error: a picture needs a surface, and there is none\n");
  EXPECT_EQ(shader({"-o", "x.none"}).status, 1);
  write("table.pfman",
        "light table(uniform int n = 0) {\n    uniform float a[2] = { 0, 1 };\n"
        "    px_light_color = { a[n], 0.0, 0.0 };\n}\n");
  EXPECT_EQ(shader({"-o", "x.png", "--light", "table.pfman n=2"}).err,
            "table.pfman:3:26: error: index 2 is outside of the array's 0 to 1\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"table.pfman", "tiny.pfman"}));
}

}  // namespace
}  // namespace vsg_tests
