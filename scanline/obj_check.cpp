// Looks over an OBJ file before the library reads it: that reader skips what it does not know, fills up missing numbers
// and names no line.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "scanline/mesh_checks.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

/// Statements that say nothing about polygons: names, materials, display, curves and surfaces.
constexpr std::string_view kOtherKeywords[] = {
    "o",          "g",         "s",     "mg",    "usemtl",   "mtllib",   "usemap", "maplib", "lod",  "bevel",
    "shadow_obj", "call",      "csh",   "vp",    "c_interp", "d_interp", "cstype", "deg",    "bmat", "step",
    "curv",       "trace_obj", "surf",  "curv2", "parm",     "trim",     "hole",   "scrv",   "sp",   "end",
    "con",        "ctech",     "stech", "bsp",   "bzp",      "cdc",      "cdp",    "res"};

class ObjCheck {
 public:
  ObjCheck(std::string_view text, const std::string& file) : text_(text), file_(file), lines_(start()) {}

  std::string run() {
    count_all();
    lines_ = start();
    while (lines_.next()) check_statement();
    return std::move(kept_);
  }

 private:
  /// A kind of data that corners refer to.
  struct Data {
    const char* name;
    long all = 0;   ///< in the whole file: a corner may name what follows
    long seen = 0;  ///< so far: what negative indices count back from
  };

  TextLines start() const { return {text_, file_, {.continuation = true, .columns = true}}; }

  void count_all() {
    while (lines_.next()) {
      const std::string_view keyword = lines_.words()[0];
      if (keyword == "v") ++data_[0].all;
      if (keyword == "vt") ++data_[1].all;
      if (keyword == "vn") ++data_[2].all;
    }
  }

  void check_statement() {
    const std::string_view keyword = lines_.words()[0];
    if (keyword == "v") {
      check_vertex();
    } else if (keyword == "vt") {
      check_numbers(1, 3, "1 to 3 numbers expected after 'vt'");
      ++data_[1].seen;
    } else if (keyword == "vn") {
      check_numbers(3, 3, "3 numbers expected after 'vn'");
      ++data_[2].seen;
    } else if (keyword == "f") {
      check_polygon();
    } else if (keyword == "l" || keyword == "p") {
      lines_.fail(0, "a polygon needs at least three vertices; points or lines are not shown");
    } else if (std::ranges::find(kOtherKeywords, keyword) == std::end(kOtherKeywords)) {
      lines_.fail(0,
                  "'" + std::string(keyword.substr(0, 40)) + "' is no keyword of an OBJ file (such as v, vt, vn, f)");
    } else {
      return;
    }
    for (const std::string_view word : lines_.words()) {
      if (word[0] == '.') kept_ += '0';  // the library takes no word for a number that begins with its point
      kept_.append(word) += ' ';
    }
    kept_.back() = '\n';
  }

  void check_numbers(std::size_t least, std::size_t most, const char* expected) {
    const std::size_t count = lines_.words().size() - 1;
    if (count < least) lines_.fail(0, expected);
    if (count > most) lines_.fail(most + 1, expected);
    for (std::size_t k = 1; k <= count; ++k) {
      // The library keeps single precision.
      if (std::abs(lines_.number(k)) <= std::numeric_limits<float>::max()) continue;
      lines_.fail(k, "'" + std::string(lines_.words()[k]) + "' lies outside the range of numbers (3.4e38)");
    }
  }

  void check_vertex() {
    constexpr const char* kExpected = "3 numbers expected after 'v', 4 with a weight or 6 with a colour";
    check_numbers(3, 6, kExpected);
    const std::size_t count = lines_.words().size() - 1;
    if (count == 5) lines_.fail(5, kExpected);
    if (count == 4 && static_cast<float>(lines_.number(4)) == 0) lines_.fail(4, "the weight of a vertex must not be 0");
    ++data_[0].seen;
  }

  void check_polygon() {
    const std::size_t corners = lines_.words().size() - 1;
    if (corners < 3) lines_.fail(0, "a polygon needs at least three vertices");
    unsigned form = 0;
    for (std::size_t k = 1; k <= corners; ++k) {
      const unsigned parts = check_corner(k);
      if (k == 1) form = parts;
      if (parts == form) continue;
      lines_.fail(k, "'" + std::string(lines_.words()[k]) + "' is not of the form of the polygon's first corner '" +
                         std::string(lines_.words()[1]) + "'");
    }
  }

  /// Which of its three parts a corner has: v, v/vt, v//vn or v/vt/vn.
  unsigned check_corner(std::size_t word) {
    std::string_view rest = lines_.words()[word];
    unsigned parts = 0;
    std::size_t part = 0;
    for (;; ++part) {
      const std::size_t slash = rest.find('/');
      const std::string_view index = rest.substr(0, slash);
      if (part > 2) malformed(word);
      if (!index.empty()) {
        check_index(word, index, data_[part]);
        parts |= 1u << part;
      } else if (part != 1 || slash == std::string_view::npos) {
        malformed(word);
      }
      if (slash == std::string_view::npos) return parts;
      rest.remove_prefix(slash + 1);
    }
  }

  [[noreturn]] void malformed(std::size_t word) const {
    lines_.fail(word, "'" + std::string(lines_.words()[word].substr(0, 40)) +
                          "' is no corner: v, v/vt, v//vn or v/vt/vn expected");
  }

  void check_index(std::size_t word, std::string_view text, const Data& data) const {
    long index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) malformed(word);
    if (error == std::errc() && index != 0 && index <= data.all && index >= -data.seen) return;
    std::string message = "'" + std::string(text) + "' names no " + data.name + ": ";
    if (data.all == 0) {
      message += "the file has none";
    } else {
      message += "1 to " + std::to_string(data.all);
      if (data.seen > 0) message += " or " + std::to_string(-data.seen) + " to -1";
      message += " expected";
    }
    lines_.fail(word, message);
  }

  std::string_view text_;
  std::string file_;
  TextLines lines_;
  std::array<Data, 3> data_{{{"vertex"}, {"texture coordinate"}, {"normal"}}};
  std::string kept_;
};

}  // namespace

std::string check_obj(std::string_view text, const std::string& file) { return ObjCheck(text, file).run(); }

}  // namespace scanline
