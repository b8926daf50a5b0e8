#include "scanline/frame.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <ostream>
#include <string_view>
#include <type_traits>

namespace scanline {
namespace {

constexpr double kZLimit = 65536;  // |z| < 2^16
constexpr std::size_t kMostErrors = 20;
constexpr int kGreatestSize = (1 << vsg::kCoordinateBits) - 1;

/// Words of one line, with their columns.
class LineParser {
 public:
  explicit LineParser(std::string_view line) : line_(line) {}

  /// The next word, empty at the end; column() is where it begins.
  std::string_view word() {
    while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t' || line_[at_] == '\r')) ++at_;
    begin_ = at_;
    while (at_ < line_.size() && line_[at_] != ' ' && line_[at_] != '\t' && line_[at_] != '\r') ++at_;
    return line_.substr(begin_, at_ - begin_);
  }
  int column() const { return static_cast<int>(begin_) + 1; }

 private:
  std::string_view line_;
  std::size_t at_ = 0, begin_ = 0;
};

template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return false;
  // Beyond the range of doubles: a number all the same, which the checks of the range then refuse, or nearly 0.
  if constexpr (std::is_floating_point_v<Number>) {
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
    return true;
  }
  return error == std::errc();
}

std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += (c >= ' ' && c <= '~') ? c : '?';
  return text + (word.size() > 40 ? "...'" : "'");
}

class FrameReader {
 public:
  FrameReader(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  Frame read() {
    std::string line;
    while (diagnostics_.size() < kMostErrors && std::getline(in_, line)) {
      ++line_number_;
      if (const auto comment = line.find('#'); comment != std::string::npos) line.resize(comment);
      LineParser words(line);
      const std::string_view key = words.word();
      if (key.empty()) continue;
      if (!seen_header_) {
        header(key, words);
      } else if (key == "size") {
        size(words);
      } else if (key == "v" || key == "p") {
        if (frame_.width == 0) fail(words, "'size' must come before vertices and polygons");
        key == "v" ? vertex(words) : polygon(words);
      } else {
        fail(words, "expected 'size', 'v' or 'p', not " + quoted(key));
      }
      if (stop_) break;
    }
    // A polygon may stand before its vertices: their numbers are checked when all are known.
    for (const Later& later : later_) {
      if (later.vertex <= frame_.vertices.size() || stop_ || diagnostics_.size() >= kMostErrors) continue;
      diagnostics_.push_back({name_, later.line, later.column,
                              "there is no vertex " + std::to_string(later.vertex) + ", the frame has " +
                                  std::to_string(frame_.vertices.size())});
    }
    if (in_.bad()) throw UserError({name_, line_number_, 0, "the file could not be read to its end"});
    if (diagnostics_.empty() && !seen_header_) fail_at(0, "not a frame file: 'vsgframe 1' is missing");
    if (diagnostics_.empty() && frame_.width == 0) fail_at(0, "'size' is missing");
    if (!diagnostics_.empty()) throw UserError(diagnostics_);
    return std::move(frame_);
  }

 private:
  void fail_at(int column, std::string message) { diagnostics_.push_back({name_, line_number_, column, std::move(message)}); }
  void fail(const LineParser& words, std::string message) { fail_at(words.column(), std::move(message)); }

  void end_of_line(LineParser& words) {
    if (const auto rest = words.word(); !rest.empty()) fail(words, "unexpected " + quoted(rest));
  }

  void header(std::string_view key, LineParser& words) {
    if (key != "vsgframe") {
      fail(words, "not a frame file: expected 'vsgframe 1', not " + quoted(key));
      stop_ = true;
      return;
    }
    int version = 0;
    if (const auto word = words.word(); !parse(word, version) || version != 1) {
      fail(words, "unknown frame version " + quoted(word) + ", expected 1");
      stop_ = true;
    }
    end_of_line(words);
    seen_header_ = true;
  }

  void size(LineParser& words) {
    if (frame_.width != 0) return fail(words, "'size' appears twice");
    int size[2] = {};
    for (int& s : size) {
      const auto word = words.word();
      if (!parse(word, s) || s < 2 || s > kGreatestSize) {
        fail(words, "a size is a whole number from 2 to " + std::to_string(kGreatestSize) + ", not " + quoted(word));
        stop_ = true;
        return;
      }
    }
    end_of_line(words);
    frame_.width = size[0];
    frame_.height = size[1];
  }

  void vertex(LineParser& words) {
    double value[3] = {};
    const char* const axis[3] = {"x", "y", "z"};
    const double low[3] = {1, 0, -kZLimit};
    const double high[3] = {double(frame_.width), double(frame_.height), kZLimit};
    for (int i = 0; i < 3; ++i) {
      const auto word = words.word();
      if (!parse(word, value[i])) {
        fail(words, word.empty() ? "a vertex has three coordinates" : quoted(word) + " is not a number");
        break;
      }
      const bool inside = (i == 2 ? value[i] > low[i] : value[i] >= low[i]) && value[i] < high[i];
      if (!inside && frame_.width > 0) {
        fail(words, std::string(axis[i]) + " = " + std::string(word) +
                        (i < 2 ? " lies outside the frame (" : " lies outside the number range (") + std::string(axis[i]) +
                        (i == 0 ? " from 1 to below the width)" : i == 1 ? " from 0 to below the height)" : " between -65536 and 65536)"));
      }
    }
    end_of_line(words);
    frame_.vertices.push_back({value[0], value[1], value[2]});
  }

  void polygon(LineParser& words) {
    std::vector<std::uint32_t> polygon;
    const int begin = words.column();
    for (auto word = words.word(); !word.empty(); word = words.word()) {
      std::uint32_t vertex = 0;
      if (!parse(word, vertex) || vertex == 0) {
        fail(words, quoted(word) + " is not the number of a vertex");
        return;
      }
      if (vertex > frame_.vertices.size()) later_.push_back({vertex, line_number_, words.column()});
      polygon.push_back(vertex);
    }
    if (polygon.size() < 3) return fail_at(begin, "a polygon has three vertices or more");
    frame_.polygons.push_back(std::move(polygon));
  }

  /// A vertex number that no vertex before its line has.
  struct Later {
    std::uint32_t vertex;
    int line, column;
  };

  std::istream& in_;
  const std::string& name_;
  Frame frame_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<Later> later_;
  int line_number_ = 0;
  bool seen_header_ = false, stop_ = false;
};

std::string shortest(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace

Frame read_frame(std::istream& in, const std::string& name) { return FrameReader(in, name).read(); }

Frame read_frame_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw UserError({path.string(), 0, 0, "is a folder, not a frame file"});
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UserError({path.string(), 0, 0, "cannot be opened for reading"});
  return read_frame(in, path.string());
}

void write_frame(std::ostream& out, const Frame& frame) {
  out << "vsgframe 1\nsize " << frame.width << ' ' << frame.height << '\n';
  for (const FrameVertex& v : frame.vertices) {
    out << "v " << shortest(v.x) << ' ' << shortest(v.y) << ' ' << shortest(v.z) << '\n';
  }
  for (const auto& polygon : frame.polygons) {
    out << 'p';
    for (const std::uint32_t v : polygon) out << ' ' << v;
    out << '\n';
  }
}

}  // namespace scanline
