// vsg tables pixelflow2 and pixelflow3: the paper's cycles are met, at every level of modelling the same.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;

class PixelflowTables : public ProgramTest, public testing::WithParamInterface<const char*> {
 protected:
  json table(const std::string& name, const std::string& level) const {
    const Outcome result = run({"tables", name, "--json", "--pe", level});
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out);
  }
};

json published(const std::string& section) {
  return json::parse(std::ifstream(project_file("tables/pixelflow.json"))).at(section);
}

std::string section_of(const std::string& name) {
  return name == "pixelflow2" ? "table2_operation_cycles" : "table3_float_function_cycles";
}

TEST_P(PixelflowTables, HoldEveryPublishedFigureAndExceedNone) {
  const std::string name = GetParam();
  const json answer = table(name, "model");
  EXPECT_EQ(answer["table"], name);
  const json file = published(section_of(name));
  int found = 0, expected = 0;
  for (const auto& [row, cells] : file.items()) {
    if (row == "columns") continue;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      if (cells[n].is_null()) continue;
      ++expected;
      for (const json& measured : answer["rows"]) {
        if (measured["name"] != row || measured["column"] != file["columns"][n]) continue;
        ++found;
        EXPECT_EQ(measured["published"], cells[n]) << row;
        EXPECT_LE(measured["measured"], cells[n]) << row << " " << measured["column"];
        EXPECT_GT(measured["measured"], 0);
      }
    }
  }
  EXPECT_EQ(found, expected);
}

TEST_P(PixelflowTables, AreTheSameAtEveryLevel) {
  const json model = table(GetParam(), "model");
  EXPECT_EQ(model, table(GetParam(), "macro"));
#ifdef VSG_HAVE_RTL
  EXPECT_EQ(model, table(GetParam(), "rtl"));
#endif
}

INSTANTIATE_TEST_SUITE_P(Paper, PixelflowTables, testing::Values("pixelflow2", "pixelflow3"),
                         [](const auto& chosen) { return std::string(chosen.param); });

class PixelflowErrors : public PixelflowTables {};

TEST_F(PixelflowErrors, AreWithinWhatExactFormsPromise) {
  int functions = 0, arithmetic = 0;
  const json of_functions = table("pixelflow3", "model"), of_arithmetic = table("pixelflow2", "model");
  for (const json& row : of_functions["rows"]) {
    if (row["column"] != "exact") continue;
    EXPECT_LE(row["max_error_ulp"], 1.0) << row["name"];
    ++functions;
  }
  EXPECT_EQ(functions, 13);
  for (const json& row : of_arithmetic["rows"]) {
    if (!row.contains("max_error_ulp")) continue;
    EXPECT_LE(row["max_error_ulp"], row["column"] == "float32" ? 0.5 : 0.0) << row["name"] << " " << row["column"];
    ++arithmetic;
  }
  EXPECT_GE(arithmetic, 18);
}

TEST_F(PixelflowErrors, AnUnknownLevelIsRefused) {
  const Outcome result = run({"tables", "pixelflow2", "--pe", "fast"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("--pe"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace vsg_tests
