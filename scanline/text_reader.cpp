#include "scanline/text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

namespace scanline {
namespace {

constexpr std::string_view kBlank = " \t\r\f\v";

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  // Devices and pipes are refused too: they may never end.
  if (!std::filesystem::exists(status)) throw UserError({path.string(), 0, 0, "no such file"});
  if (!std::filesystem::is_regular_file(status)) throw UserError({path.string(), 0, 0, "not a regular file"});
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw UserError({path.string(), 0, 0, "cannot be read"});
  return text;
}

bool TextLines::next() {
  words_.clear();
  places_.clear();
  while (!rest_.empty()) {
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++line_;
    // A comment ends with its line, whatever its last character is (paths end with a backslash at times).
    const std::size_t comment = line.find('#');
    line = line.substr(0, comment);
    bool goes_on = false;
    if (style_.continuation && comment == std::string_view::npos) {
      if (line.ends_with('\r')) line.remove_suffix(1);
      goes_on = line.ends_with('\\');
      if (goes_on) line.remove_suffix(1);
    }
    add_words(line);
    if (!goes_on && !words_.empty()) return true;
  }
  return !words_.empty();
}

void TextLines::add_words(std::string_view line) {
  const char* const first = line.data();
  for (std::size_t begin; (begin = line.find_first_not_of(kBlank)) != std::string_view::npos;) {
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(kBlank), line.size());
    words_.push_back(line.substr(0, end));
    if (style_.columns) places_.push_back({line_, static_cast<int>(line.data() - first) + 1});
    line.remove_prefix(end);
  }
}

double TextLines::number(std::size_t word) const {
  std::string_view text = words_.at(word);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(word, "'" + std::string(words_[word]) + "' is not a finite number");
  }
  return value;
}

long TextLines::whole(std::size_t word, long low, long high) const {
  const std::string_view text = words_.at(word);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) {
    fail(word, "'" + std::string(text) + "' is not a whole number from " + std::to_string(low) + " to " +
                   std::to_string(high));
  }
  return value;
}

void TextLines::fail(const std::string& message) const { throw UserError({file_, line_, 0, message}); }

void TextLines::fail(std::size_t word, const std::string& message) const {
  if (!style_.columns) fail(message);
  throw UserError({file_, places_.at(word).line, places_.at(word).column, message});
}

}  // namespace scanline
