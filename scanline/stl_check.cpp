// Looks over an ASCII STL file before the library reads it: that reader skips what it does not expect.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "scanline/mesh_checks.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

/// A binary file has a header of 80 bytes, the number of triangles in 4, and 50 bytes for each.
bool is_binary(std::string_view text) {
  if (text.size() < 84) return false;
  std::uint64_t triangles = 0;
  for (std::size_t k = 84; k-- > 80;) triangles = triangles << 8 | static_cast<unsigned char>(text[k]);
  return text.size() == 84 + 50 * triangles;
}

class StlCheck {
 public:
  StlCheck(std::string_view text, const std::string& file)
      : lines_(text, file, {.continuation = false, .columns = true}) {}

  void run() {
    if (!lines_.next() || lines_.words()[0] != "solid") {
      lines_.fail("an STL file begins with 'solid', or is binary and as long as its number of triangles wants");
    }
    do {
      if (lines_.words()[0] != "solid") lines_.fail(0, unexpected(0, "'solid' or the end of the file"));
      check_solid();
    } while (lines_.next());
  }

 private:
  std::string unexpected(std::size_t word, const std::string& expected) const {
    return expected + " expected, not '" + std::string(lines_.words()[word].substr(0, 40)) + "'";
  }

  void next_line(const std::string& expected) {
    if (!lines_.next()) lines_.fail("the file ends too early: " + expected + " expected");
  }

  /// The line has exactly these words and `values` more.
  void expect(std::initializer_list<std::string_view> words, std::size_t values) {
    std::size_t k = 0;
    for (const std::string_view word : words) {
      const std::string expected = "'" + std::string(word) + "'";
      if (k == lines_.words().size()) lines_.fail(k - 1, expected + " expected after this");
      if (lines_.words()[k] != word) lines_.fail(k, unexpected(k, expected));
      ++k;
    }
    if (lines_.words().size() < k + values) lines_.fail(k - 1, std::to_string(values) + " numbers expected after this");
    if (lines_.words().size() > k + values) lines_.fail(k + values, unexpected(k + values, "the end of the line"));
  }

  void next_line(std::initializer_list<std::string_view> words, std::size_t values = 0) {
    next_line("'" + std::string(*words.begin()) + "'");
    expect(words, values);
  }

  void check_solid() {
    for (;;) {
      next_line("'facet' or 'endsolid'");
      if (lines_.words()[0] == "endsolid") return;  // its name may follow
      if (lines_.words()[0] != "facet") lines_.fail(0, unexpected(0, "'facet' or 'endsolid'"));
      check_facet();
    }
  }

  void check_facet() {
    expect({"facet", "normal"}, 3);
    for (std::size_t k = 2; k < 5; ++k) {
      // Normals that are no numbers are common and harmless: they count as none.
      std::string_view word = lines_.words()[k];
      if (word.starts_with('-')) word.remove_prefix(1);
      if (word != "nan" && word != "inf") lines_.number(k);
    }
    next_line({"outer", "loop"});
    for (int vertex = 0; vertex < 3; ++vertex) {
      next_line({"vertex"}, 3);
      for (std::size_t k = 1; k < 4; ++k) {
        // The library keeps single precision.
        if (std::abs(lines_.number(k)) <= std::numeric_limits<float>::max()) continue;
        lines_.fail(k, "'" + std::string(lines_.words()[k]) + "' lies outside the range of numbers (3.4e38)");
      }
    }
    next_line({"endloop"});
    next_line({"endfacet"});
  }

  TextLines lines_;
};

}  // namespace

void check_stl(std::string_view text, const std::string& file) {
  if (!is_binary(text)) StlCheck(text, file).run();
}

}  // namespace scanline
