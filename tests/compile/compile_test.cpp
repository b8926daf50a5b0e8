// Every file of cases/ is compiled; what the compiler says must be the text of the file of the same name that ends in
// .txt, whole and exact. A case's name begins with the code that it is about; `ok` cases compile without a word.
//
// A new case: write the .pfman file, run with PFMAN_WRITE_EXPECTED=1, and read the .txt file that this writes.
#include "pixelflow/compiler/compile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string messages(const fs::path& file) {
  pfman::Diagnostics diagnostics;
  pfman::compile_file(file, {}, diagnostics);
  return diagnostics.text();
}

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(PFMAN_CASES)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".pfman") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class diagnostics : public testing::TestWithParam<std::string> {
 protected:
  // Messages name the file as it was given, so it is given without its folder.
  void SetUp() override { fs::current_path(PFMAN_CASES); }
};

TEST_P(diagnostics, are_exactly) {
  const std::string actual = messages(GetParam() + ".pfman");
  const fs::path expected = GetParam() + ".txt";
  if (std::getenv("PFMAN_WRITE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << actual;
  EXPECT_EQ(read(expected), actual);
}

INSTANTIATE_TEST_SUITE_P(compile, diagnostics, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param; });

TEST(compile, every_case_shows_its_code) {
  for (const std::string& name : cases()) {
    const std::string text = read(fs::path(PFMAN_CASES) / (name + ".txt"));
    std::string code = name.substr(0, name.find('_'));
    if (code == "ok") {
      EXPECT_EQ(text, "") << name;
      continue;
    }
    code[0] = static_cast<char>(std::toupper(code[0]));
    EXPECT_NE(text.find("[" + code + "]"), std::string::npos) << name;
  }
}

TEST(compile, examples_of_the_manual_compile) {
  const std::string manual = read(PFMAN_MANUAL);
  const std::string fence = "\n```pfman\n";
  int examples = 0;
  for (std::size_t at = manual.find(fence); at != std::string::npos; at = manual.find(fence, at)) {
    at += fence.size();
    pfman::Diagnostics diagnostics;
    pfman::compile_text(manual.substr(at, manual.find("\n```", at) - at), "example", {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    ++examples;
  }
  EXPECT_GT(examples, 0);
}

TEST(compile, every_code_of_the_manual_has_a_case) {
  std::set<std::string> shown;
  for (const std::string& name : cases()) shown.insert(name.substr(0, name.find('_')));
  const std::string manual = read(PFMAN_MANUAL);
  const std::regex row("\n\\| ([EW])([0-9]{3}) \\|");
  int codes = 0;
  for (auto at = std::sregex_iterator(manual.begin(), manual.end(), row); at != std::sregex_iterator(); ++at) {
    const std::string code = std::string(1, static_cast<char>(std::tolower((*at)[1].str()[0]))) + (*at)[2].str();
    EXPECT_TRUE(shown.contains(code)) << code << " has no case";
    ++codes;
  }
  EXPECT_GT(codes, 0);
  // And the other way round: nothing is shown that the manual does not list.
  for (const std::string& code : shown) {
    std::string listed = code;
    listed[0] = static_cast<char>(std::toupper(listed[0]));
    if (code == "ok") continue;
    EXPECT_NE(manual.find("\n| " + listed + " |"), std::string::npos) << code << " is not in the manual";
  }
}

}  // namespace
