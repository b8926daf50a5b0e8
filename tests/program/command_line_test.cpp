// What the program answers to its command line: help, exit status, messages.
#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using testing::TestWithParam;

class CommandLine : public ProgramTest {
 protected:
  void SetUp() override {
    write("scene.toml", flat_scene(8, 8, "[[object]]\ngeometry = \"mesh\"\nfile = \"r.off\"\n"));
    write("r.off", rectangle_off(-0.5, -0.5, 0.5, 0.5));
    write("one.frame", "vsgframe 1\nsize 16 16\nv 3 3 1\nv 3 9 1\nv 9 9 1\np 1 2 3\n");
  }

  /// Exit status 1, the words on standard error, nothing on standard output, no new file.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
    const auto before = files();
    const Outcome result = run(arguments);
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find("error: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(CommandLine, HelpNamesCommandsAndOptionsWithDefaults) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"render", "frame", "segments", "explain", "tables", "shader"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    EXPECT_EQ(run({command, "--help"}).status, 0) << command;
  }
  EXPECT_EQ(help.out.find("study"), std::string::npos) << "a command exists from the day that it works";
  const Outcome render = run({"render", "--help"});
  for (const char* option : {"--vsg", "--lockstep", "--show", "--channels", "--frames", "--size", "--samples",
                             "--stats", "--trace", "--threads", "--quiet", "--pe", "--rendering-nodes",
                             "--shading-nodes", "--traced"}) {
    EXPECT_NE(render.out.find(option), std::string::npos) << option;
  }
#ifdef VSG_HAVE_RTL
  EXPECT_NE(render.out.find("=rtl"), std::string::npos);
#else
  EXPECT_NE(render.out.find("=model"), std::string::npos);
#endif
  EXPECT_NE(run({"segments", "--help"}).out.find("=model"), std::string::npos);
}

TEST_F(CommandLine, HelpIsGroupedAndSaysNothingTwice) {
  const std::string help = run({"--help"}).out, tables = run({"tables", "--help"}).out;
  EXPECT_EQ(help.find("Subcommands:"), std::string::npos) << "a command without a group:\n" << help;
  EXPECT_NE(help.find("\n  tables "), std::string::npos) << help;
  EXPECT_NE(tables.find("fig32|fig33|claims"), std::string::npos) << tables;
  EXPECT_EQ(tables.find("{fig32"), std::string::npos) << tables;
}

TEST_F(CommandLine, MistakesOnTheCommandLineAreExplained) {
  expect_refused({}, "command");
  expect_refused({"paint"}, "paint");
  expect_refused({"render"}, "SCENE");
  expect_refused({"render", "scene.toml"}, "--output");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--nonsense"}, "--nonsense");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--vsg", "silicon"}, "--vsg");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--show", "magic"}, "--show");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--samples", "0"}, "--samples");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--threads", "0"}, "--threads");
  for (const char* size : {"10", "10x", "x10", "axb", "10x10x10", "-1x5", "1e3x4"}) {
    expect_refused({"render", "scene.toml", "-o", "a.png", "--size=" + std::string(size)}, "WxH");
  }
  for (const char* size : {"0x5", "8190x5", "5x8191"}) {
    expect_refused({"render", "scene.toml", "-o", "a.png", "--size=" + std::string(size)}, "1 to 8189 pixels wide");
  }
  expect_refused({"render", "scene.toml", "-o", "a.png", "--size", "512x512", "--samples", "16"}, "8192 x 8192");
}

TEST_F(CommandLine, OptionsThatContradictEachOtherAreRefused) {
  expect_refused({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--pe", "macro", "--lockstep"}, "--lockstep");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--trace", "t.fst"}, "--trace");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--channels"}, ".exr");
  expect_refused({"render", "scene.toml", "-o", "a.exr", "--channels", "--show", "tests"}, "exclude");
  expect_refused({"segments", "one.frame", "--lockstep"}, "--lockstep");
}

TEST_F(CommandLine, NodesHaveBounds) {
  for (const char* option : {"--rendering-nodes", "--shading-nodes"}) {
    for (const char* number : {"0", "-1", "x", "100000"}) {
      expect_refused({"render", "scene.toml", "-o", "a.png", option + std::string("=") + number}, option);
    }
  }
  expect_refused({"render", "scene.toml", "-o", "a.png", "--show", "tests", "--rendering-nodes", "2"}, "--show");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--traced"}, "scene.toml:14: error: object 'object 1' is no");
}

TEST_F(CommandLine, SequencesWantOnePlaceForTheNumber) {
  expect_refused({"render", "scene.toml", "-o", "a.png", "--frames", "1-2"}, "%04d");
  expect_refused({"render", "scene.toml", "-o", "a%04d-%04d.png", "--frames", "1-2"}, "%04d");
  expect_refused({"render", "scene.toml", "-o", "a%04d.png"}, "--frames");
  for (const char* frames : {"2-1", "1", "a-b", "1-", "-1-2", "1-2-3"}) {
    expect_refused({"render", "scene.toml", "-o", "a%04d.png", "--frames=" + std::string(frames)}, "A-B");
  }
}

#ifndef VSG_HAVE_RTL
TEST_F(CommandLine, AProgramWithoutRtlSaysSo) {
  expect_refused({"render", "scene.toml", "-o", "a.png", "--vsg", "rtl"}, "without the RTL");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--lockstep"}, "without the RTL");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--pe", "rtl"}, "without the RTL");
  expect_refused({"segments", "one.frame", "--vsg", "rtl"}, "without the RTL");
}
#endif

TEST_F(CommandLine, BadFilesAreNamedWithTheLine) {
  expect_refused({"render", "absent.toml", "-o", "a.png"}, "absent.toml");
  expect_refused({"frame", "absent.toml", "-o", "a.frame"}, "absent.toml");
  expect_refused({"segments", "absent.frame"}, "absent.frame");
  expect_refused({"segments", "."}, ".: error");

  write("broken.toml", "version = 1\nsize = [8\n");
  expect_refused({"render", "broken.toml", "-o", "a.png"}, "broken.toml:");
  write("shader.toml",
        flat_scene(8, 8, "[[object]]\ngeometry = \"mesh\"\nfile = \"r.off\"\nshader = {name = \"marble\"}\n"));
  expect_refused({"render", "shader.toml", "-o", "a.png"}, "shader.toml:17: error: there is no shader 'marble'");
  write("color.toml", flat_scene(8, 8,
                                 "[[object]]\ngeometry = \"mesh\"\nfile = \"r.off\"\n"
                                 "shader = {name = \"flat\", parameters = {color = [1, 2]}}\n"));
  expect_refused({"render", "color.toml", "-o", "a.png"}, "color.toml:17: error: parameter 'rgb'");

  write("nan.frame", "vsgframe 1\nsize 16 16\nv 3 3 1\nv nan 9 1\nv 9 9 1\np 1 2 3\n");
  expect_refused({"segments", "nan.frame"}, "nan.frame:4:");
  write("two.frame", "vsgframe 1\nsize 16 16\nv 3 3 1\nv 3 9 1\nv 9 9 1\np 1 2\n");
  expect_refused({"segments", "two.frame"}, "two.frame:6:");
  write("outside.frame", "vsgframe 1\nsize 16 16\nv 3 3 1\nv 3 9 1\nv 16 9 1\np 1 2 3\n");
  expect_refused({"segments", "outside.frame"}, "outside.frame:5:");
}

TEST_F(CommandLine, AFullSegmentMemoryStopsTheFrame) {
  // 8,193 polygons on the same lines need as many segment blocks; the machine has 8,192.
  std::string frame = "vsgframe 1\nsize 16 16\nv 3 3 1\nv 3 9 1\nv 9 9 1\n";
  for (int i = 0; i < 8192; ++i) frame += "v 3 3 2\nv 3 9 2\nv 9 9 2\n";
  for (int i = 0; i <= 8192; ++i) {
    for (const int vertex : {1, 2, 3}) frame += (vertex == 1 ? "p " : " ") + std::to_string(3 * i + vertex);
    frame += '\n';
  }
  write("full.frame", frame);
  expect_refused({"segments", "full.frame"}, "full.frame: error: scan line 4: segment memory is full");
#ifdef VSG_HAVE_RTL
  expect_refused({"segments", "full.frame", "--vsg", "rtl"}, "full.frame: error: scan line 4: segment memory is full");
#endif
}

TEST_F(CommandLine, WhatIsReadIsNotOverwritten) {
  expect_refused({"frame", "scene.toml", "-o", "./scene.toml"}, "named twice");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--stats", "scene.toml"}, "named twice");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--stats", "a.png"}, "named twice");
}

TEST_F(CommandLine, DoubtfulPolygonsAreWarnings) {
  // The fourth corner lies behind the plane of the others.
  write("r.off", "OFF\n4 1 0\n-0.5 -0.5 0\n0.5 -0.5 0\n0.5 0.5 0\n-0.5 0.5 -1\n4 0 1 2 3\n");
  const Outcome loud = run({"render", "scene.toml", "-o", "a.png", "--vsg", "model"});
  EXPECT_EQ(loud.status, 0);
  EXPECT_NE(loud.err.find("warning: "), std::string::npos) << loud.err;
  EXPECT_NE(loud.err.find("scene.toml:"), std::string::npos) << loud.err;
  const Outcome quiet = run({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--quiet"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.err, "");
}

TEST_F(CommandLine, AnUnwritableOutputIsFoundAtOnce) {
  expect_refused({"render", "scene.toml", "-o", "absent/a.png"}, "absent/a.png");
  expect_refused({"render", "scene.toml", "-o", "a.nosuffix"}, ".nosuffix");
  expect_refused({"render", "scene.toml", "-o", "."}, "suffix");
  expect_refused({"render", "scene.toml", "-o", "a.png", "--stats", "absent/s.json"}, "absent/s.json");
  expect_refused({"frame", "scene.toml", "-o", "absent/a.frame"}, "absent/a.frame");
  expect_refused({"frame", "scene.toml", "-o", "."}, "folder");
}

TEST_F(CommandLine, ExplainWantsALineOfTheFrame) {
  expect_refused({"explain", "one.frame"}, "--line");
  for (const std::string line : {"0", "17", "-1"}) {
    expect_refused({"explain", "one.frame", "--line=" + line},
                   "error: --line " + line + ": one.frame has scan lines 1 to 16\n");
    EXPECT_EQ(run({"explain", "one.frame", "--line=" + line}).err.find("error: --line"), 0u)
        << "the option is at fault";
  }
}

}  // namespace
}  // namespace vsg_tests
