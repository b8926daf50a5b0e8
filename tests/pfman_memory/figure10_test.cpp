// The fragment of figure 10 (Olano and Lastra 1998), as the paper shows it: the code, its SSA form, and merged.
#include <gtest/gtest.h>

#include "pixelflow/compiler/lifetime.h"
#include "tests/pfman_memory/code_builder.h"

namespace pfman_tests {
namespace {

using pixelflow::Code;

/// The lines of a dump without places and indentation, the surface's name left out.
std::vector<std::string> statements(const pfman::ir::Code& code) {
  const pfman::Diagnostics none;
  std::vector<std::string> lines;
  std::string text = pfman::ir::dump(code, none);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    std::string line = text.substr(at, end - at);
    at = end + 1;
    line = line.substr(0, line.find("//"));
    const std::size_t first = line.find_first_not_of(' ');
    const std::size_t last = line.find_last_not_of(' ');
    lines.push_back(line.substr(first, last - first + 1));
  }
  lines.erase(lines.begin());
  return lines;
}

class Figure10 : public testing::Test {
 protected:
  Figure10() : b("figure10") {
    const int i = b.variable("i", 1), j = b.variable("j", 1);
    b.put(i, 1);
    b.operate(Code::Add, b.use(i), b.use(i), b.literal(1, 1));
    b.operate(Code::Less, {}, b.use(j), b.use(i));
    const int branch = b.begin_if(CodeBuilder::Kind::IfMasked);
    b.put(i, 5);
    b.end_if(branch);
    b.copy(j, i);
    b.code.color = {j};
  }
  CodeBuilder b;
  pfman::Diagnostics diagnostics;
};

using Lines = std::vector<std::string>;

TEST_F(Figure10, Code) {
  EXPECT_EQ(statements(b.code),
            (Lines{"i = 1", "i = i + 1", "K = j < i", "if (K)", "i = 5", "end if", "j = i", "color: j"}));
}

TEST_F(Figure10, SingleAssignment) {
  pfman::to_ssa(b.code, diagnostics);
  EXPECT_EQ(statements(b.code), (Lines{"i1 = 1", "i2 = i1 + 1", "K = j1 < i2", "if (K)", "i3 = 5", "end if",
                                       "j2 = φ(i2,i3)", "color: j2"}));
}

TEST_F(Figure10, Merged) {
  pfman::to_ssa(b.code, diagnostics);
  pfman::merge_phis(b.code);
  EXPECT_EQ(statements(b.code), (Lines{"i1 = 1", "i2_3 = i1 + 1", "K = j1 < i2_3", "if (K)", "i2_3 = 5", "end if",
                                       "j2 = i2_3", "color: j2"}));
}

}  // namespace
}  // namespace pfman_tests
