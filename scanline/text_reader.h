// Words of a text file with their lines, for the small formats that this library reads itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanline/error.h"

namespace scanline {

/// The whole of a regular file. Throws UserError when it is missing or cannot be read.
std::string read_text_file(const std::filesystem::path& path);

/// Splits text into lines of words; `#` starts a comment, empty lines are skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  /// Goes to the next line that has words; false at the end.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  int line() const { return line_; }

  /// Finite number, or whole number from `low` to `high`, at a word of the line. Throw UserError.
  double number(std::size_t word) const;
  long whole(std::size_t word, long low, long high) const;
  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string_view rest_;
  std::string file_;
  std::vector<std::string_view> words_;
  int line_ = 0;
};

}  // namespace scanline
