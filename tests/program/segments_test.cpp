// vsg segments and vsg frame: JSON, statistics, frame files.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

class Segments : public ProgramTest {};

std::string vector_file(const std::string& name) { return project_file("tests/vectors/" + name); }

json parse_file(const std::string& name) { return json::parse(std::ifstream(name)); }

TEST_F(Segments, JsonHasTheKeysOfTheContractInOrder) {
  const Outcome result = run({"segments", vector_file("figure6.frame")});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const ordered_json answer = ordered_json::parse(result.out);
  std::vector<std::string> keys, counters;
  for (const auto& [key, value] : answer.items()) keys.push_back(key);
  for (const auto& [key, value] : answer["counters"].items()) counters.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"size", "segments", "counters"}));
  EXPECT_EQ(counters,
            (std::vector<std::string>{"polygon_blocks", "edge_blocks", "edge_crossings", "implied_edges",
                                      "output_segments", "segment_blocks_total", "segment_blocks_max",
                                      "segment_references", "reference_ratio", "add_cycles", "add_cycles_per_test",
                                      "percent_not_at_end", "output_buffer", "add_cycles_listed"}));
}

TEST_F(Segments, TheProgramAnswersAsTheOneOf1970) {
  for (const char* name : {"quads_penetrate", "ten_cube1", "sheet"}) {
    const Outcome result = run({"segments", vector_file(std::string(name) + ".frame")});
    ASSERT_EQ(result.status, 0) << result.err;
    const json answer = json::parse(result.out), expected = parse_file(vector_file(std::string(name) + ".json"));
    for (const char* key : {"size", "segments", "counters"}) EXPECT_EQ(answer[key], expected[key]) << name << key;
  }
}

TEST_F(Segments, BackFacesAreVisibleOnRequestOnly) {
  // Counter-clockwise: faces away.
  write("away.frame", "vsgframe 1\nsize 16 16\nv 3 3 1\nv 9 9 1\nv 3 9 1\np 1 2 3\n");
  EXPECT_EQ(json::parse(run({"segments", "away.frame"}).out)["counters"]["output_segments"], 16);
  EXPECT_GT(json::parse(run({"segments", "away.frame", "--keep-back-faces"}).out)["counters"]["output_segments"], 16);
}

TEST_F(Segments, FewerFractionBitsGiveACoarserPicture) {
  const std::string frame = vector_file("cubes25_rotated.frame");
  const json fine = json::parse(run({"segments", frame, "--fraction-bits", "18"}).out);
  const json coarse = json::parse(run({"segments", frame, "--fraction-bits", "4"}).out);
  EXPECT_EQ(fine, json::parse(run({"segments", frame}).out));
  EXPECT_NE(coarse["segments"], fine["segments"]);
  EXPECT_EQ(coarse["counters"]["edge_blocks"], fine["counters"]["edge_blocks"]);
  EXPECT_EQ(run({"segments", frame, "--fraction-bits", "99"}).status, 1);
}

TEST_F(Segments, StatisticsAreATableForPeople) {
  const Outcome result = run({"segments", vector_file("ten_cube1.frame"), "--statistics"});
  ASSERT_EQ(result.status, 0) << result.err;
  // Cube1's published counts: 25 blocks, 1228 output segments.
  EXPECT_NE(result.out.find("PQ counters"), std::string::npos);
  EXPECT_NE(result.out.find("Q counters"), std::string::npos);
  EXPECT_NE(result.out.find("ADDS"), std::string::npos);
  for (const char* row :
       {"\n   1  segment blocks taken for the whole frame .* 25\n", "\n  10  output segments +1228 "}) {
    EXPECT_THAT(result.out, testing::ContainsRegex(row));
  }
}

TEST_F(Segments, AFullStandardOutputIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const std::string command = std::string(VSG_PROGRAM) + " segments " + vector_file("figure6.frame") +
                              " > /dev/full 2> " + path("err").string();
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(read("err").find("standard output: error: cannot write"), std::string::npos);
}

TEST_F(Segments, AFrameOfASceneIsWhatRenderWorksOn) {
  write("scene.toml", flat_scene(20, 10, "[[object]]\ngeometry = \"shape\"\nshape = \"sphere\"\nradius = 0.8\n"));
  ASSERT_EQ(run({"frame", "scene.toml", "-o", "scene.frame"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"scene.frame", "scene.toml"}));
  EXPECT_EQ(read("scene.frame").substr(0, 23), "vsgframe 1\nsize 22 11\nv");

  const Outcome segments = run({"segments", "scene.frame"});
  ASSERT_EQ(segments.status, 0) << segments.err;
  ASSERT_EQ(run({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--stats", "stats.json"}).status, 0);
  const json stats = json::parse(read("stats.json"));
  EXPECT_EQ(stats["frames"][0]["counters"], json::parse(segments.out)["counters"]);
}

#ifdef VSG_HAVE_RTL
TEST_F(Segments, RtlGivesTheSameAnswerAndItsCycles) {
  for (const char* name : {"quads_penetrate", "figure6"}) {
    const std::string frame = vector_file(std::string(name) + ".frame");
    const json model = json::parse(run({"segments", frame}).out);
    const Outcome run_rtl = run({"segments", frame, "--vsg", "rtl", "--lockstep"});
    ASSERT_EQ(run_rtl.status, 0) << run_rtl.err;
    json rtl = json::parse(run_rtl.out);
    EXPECT_GT(rtl["cycles"], 0);
    EXPECT_GT(rtl["port_accesses"], 0);
    rtl.erase("cycles");
    rtl.erase("port_accesses");
    EXPECT_EQ(rtl, model) << name;
  }
  EXPECT_EQ(run({"segments", vector_file("figure6.frame"), "--vsg", "rtl", "--fraction-bits", "12"}).status, 1);
}
#endif

}  // namespace
}  // namespace vsg_tests
