// vsg tables pixelflow1 and pixelflow4: no shader takes more cycles than its published namesake, allocation saves at
// least the published share, every level counts the same, and docs/shaders.md shows what the program prints.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;

class ShaderTables : public ProgramTest {
 protected:
  std::string print(const std::vector<std::string>& arguments) const {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }
  json table(const std::string& name, const std::string& level = "macro") const {
    return json::parse(print({"tables", name, "--json", "--pe", level}));
  }
};

json published_file() { return json::parse(std::ifstream(project_file("tables/pixelflow.json"))); }

double measured(const json& table, const std::string& name, const std::string& column) {
  for (const json& row : table["rows"]) {
    if (row["name"] == name && row["column"] == column) return row["measured"];
  }
  ADD_FAILURE() << "no cell " << name << ", " << column;
  return 0;
}

/// What stands between the marks of a command in a document, without the four spaces of each line.
std::string made_by(const std::string& command) {
  std::ifstream in(project_file("docs/shaders.md"));
  std::string line, text;
  bool inside = false;
  while (std::getline(in, line)) {
    if (line == "<!-- end -->") inside = false;
    if (inside) text += (line.starts_with("    ") ? line.substr(4) : line) + "\n";
    if (line == "<!-- made by: build/release/" + command + " | sed 's/^/    /' -->") inside = true;
  }
  return text;
}

TEST_F(ShaderTables, EveryPublishedShaderIsMetInMemoryAndCycles) {
  const json found = table("pixelflow1"), file = published_file();
  int rows = 0;
  for (const auto& [name, cells] : file["table1_shaders"].items()) {
    if (name == "columns") continue;
    ++rows;
    EXPECT_GE(measured(found, name, "bytes_free"), 0) << name;
    EXPECT_GT(measured(found, name, "cycles_per_region"), 1000) << name;
    EXPECT_LE(measured(found, name, "cycles_per_region"), cells[1]) << name;
    for (const json& row : found["rows"]) {
      if (row["name"] != name || row["published"].is_null()) continue;
      EXPECT_EQ(row["published"], cells[row["column"] == "bytes_free" ? 0 : 1]);
      EXPECT_EQ(row["note"], file["names"]["table1"][name]);
    }
  }
  EXPECT_EQ(rows, 7);
}

TEST_F(ShaderTables, AllocationSavesAtLeastThePublishedShare) {
  const json found = table("pixelflow4"), file = published_file();
  int rows = 0;
  for (const auto& [name, cells] : file["table4_shader_memory_bytes"].items()) {
    if (name == "columns") continue;
    ++rows;
    const double only = measured(found, name, "varying_only"), with = measured(found, name, "varying_with_allocation");
    EXPECT_GT(with, 0) << name;
    EXPECT_LE(with / only, cells[2].get<double>() / cells[1].get<double>()) << name;
    EXPECT_NEAR(measured(found, name, "saved_percent"), 100 * (only - with) / only, 1e-3) << name;
    EXPECT_GE(measured(found, name, "total_uniform_and_varying"), only) << name;
  }
  EXPECT_EQ(rows, 4);
}

TEST_F(ShaderTables, StagesAndLightAddUpToTheCyclesOfARegion) {
  const json found = table("pixelflow1");
  for (const char* name : {"simple_brick", "volume_wood", "opengl_surface", "mandelbrot_float"}) {
    double sum = 0;
    for (const char* stage : {"cycles_before_lights", "cycles_a_light", "cycles_after_lights", "cycles_of_light"})
      sum += measured(found, name, stage);
    EXPECT_EQ(sum, measured(found, name, "cycles_per_region")) << name;
  }
  EXPECT_LT(2 * measured(found, "mandelbrot_fixed", "cycles_per_region"),
            measured(found, "mandelbrot_float", "cycles_per_region"));
}

TEST_F(ShaderTables, CellsAreUniqueAndEqualAtEveryLevel) {
  const json macro = table("pixelflow1");
  std::set<std::string> cells;
  for (const json& row : macro["rows"]) EXPECT_TRUE(cells.insert(row["name"].dump() + row["column"].dump()).second);
  EXPECT_EQ(macro, table("pixelflow1", "model"));
#ifdef VSG_HAVE_RTL
  EXPECT_EQ(macro, table("pixelflow1", "rtl"));
#endif
}

TEST_F(ShaderTables, TheDocumentShowsWhatTheProgramPrints) {
  for (const std::string name : {"pixelflow1", "pixelflow4"}) {
    const std::string shown = made_by("vsg tables " + name);
    EXPECT_GT(shown.size(), 1000u);
    EXPECT_EQ(shown, print({"tables", name, "--pe", "macro"})) << "scripts/refresh-docs docs/shaders.md renews it";
  }
}

class ShaderPictures : public ShaderTables {};

TEST_F(ShaderPictures, AreTheSameOnAnyNumberOfThreadsAndAtEveryLevel) {
  const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{
        "shader", project_file("shaders/fancy_brick.pfman"), "-o", name, "--size", "140x70", "--turn", "30"};
    words.insert(words.end(), more.begin(), more.end());
    print(words);
    return read_image(path(name)).values;
  };
  const std::vector<float> one = picture("one.png", {"--pe", "macro", "--threads", "1"});
  EXPECT_EQ(one, picture("three.png", {"--pe", "macro", "--threads", "3"}));
  EXPECT_EQ(one, picture("model.png", {"--pe", "model"}));
  EXPECT_GT(std::set<float>(one.begin(), one.end()).size(), 50u);
}

TEST_F(ShaderPictures, StandInTheDocumentAsTheProgramMakesThem) {
  const std::string light =
      project_file("shaders/point_light.pfman") + " position=-0.8,0.9,-1.2 intensity=1.15 falloff=0.06";
  print({"shader", project_file("shaders/simple_brick.pfman"), "--samples", "2", "--turn", "20", "--tilt", "12",
         "--distance", "0.82", "--light", light, "--pe", "macro", "-o", "brick.png"});
  const Image made = read_image(path("brick.png")), shown = read_image(project_file("docs/shaders/simple_brick.png"));
  EXPECT_EQ(made.width, 512);
  EXPECT_EQ(made.height, 512);
  EXPECT_EQ(made.values, shown.values);
}

TEST_F(ShaderPictures, SamplesAreAveraged) {
  const std::string shader = project_file("shaders/simple_brick.pfman");
  print({"shader", shader, "-o", "large.png", "--size", "128x128", "--pe", "macro"});
  print({"shader", shader, "-o", "small.png", "--size", "64x64", "--samples", "2", "--pe", "macro"});
  const Image large = read_image(path("large.png")), small = read_image(path("small.png"));
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      const float mean = (large.at(2 * column, 2 * row, 0) + large.at(2 * column + 1, 2 * row, 0) +
                          large.at(2 * column, 2 * row + 1, 0) + large.at(2 * column + 1, 2 * row + 1, 0)) /
                         4;
      ASSERT_NEAR(small.at(column, row, 0), mean, 0.5) << column << ", " << row;
    }
  }
  EXPECT_EQ(run({"shader", shader, "-o", "a.png", "--size", "8192x8192", "--samples", "2"}).status, 1);
}

}  // namespace
}  // namespace vsg_tests
