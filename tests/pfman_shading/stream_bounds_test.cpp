// Nested loops that would not end, or fill the memory with instructions.
#include <gtest/gtest.h>

#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"

namespace pfman_tests {
namespace {

std::string mistake_of(const std::string& text) {
  const auto unit = compiled(text);
  try {
    pfman::generate(unit->shaders[0], {});
  } catch (const pfman::UniformError& mistake) {
    return std::to_string(mistake.where.line) + ": " + mistake.what();
  }
  return "";
}

std::string nested(const std::string& count, const std::string& body) {
  return "surface s(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> x = 0.5) {\n"
         "fixed<8,8> y = x;\nuniform int i;\nuniform int j;\nuniform int n;\n"
         "for (i = 0; i < " +
         count + "; i++)\nfor (j = 0; j < " + count + "; j++)\n" + body + "px_shader_color = { y, y, y };\n}";
}

TEST(StreamBounds, EndNestedUniformLoops) {
  const std::string mistake = mistake_of(nested("65536", "n += j;\n"));
  EXPECT_NE(mistake.find("uniform code has not ended after 67108864 operations"), std::string::npos) << mistake;
  EXPECT_EQ(mistake_of(nested("256", "n += j;\n")), "");
}

TEST(StreamBounds, CountWhatArraysTake) {
  const std::string mistake = mistake_of(
      "surface s(output varying fixed<8,8> px_shader_color[3]) {\nuniform float a[65536];\nuniform int i;\n"
      "for (i = 0; i < 65536; i++)\na = a * a;\npx_shader_color = { a[0], 0, 0 };\n}");
  EXPECT_EQ(mistake, "5: uniform code has not ended after 67108864 operations");
}

TEST(StreamBounds, EndStreams) {
  EXPECT_EQ(mistake_of(nested("65536", "y *= x;\n")), "8: the stream has more than 4194304 instructions");
  EXPECT_EQ(mistake_of(nested("100", "y *= x;\n")), "");
}

}  // namespace
}  // namespace pfman_tests
