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

struct TextStyle {
  bool continuation = false;  ///< `\` at the end of a line joins the next one to it
  bool columns = false;       ///< mistakes name the column, too
};

/// Splits text into lines of words; `#` starts a comment, empty lines are skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file, TextStyle style = {})
      : rest_(text), file_(std::move(file)), style_(style) {}

  /// Goes to the next line that has words; false at the end.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  int line() const { return line_; }

  /// Finite number, or whole number from `low` to `high`, at a word of the line. Throw UserError.
  double number(std::size_t word) const;
  long whole(std::size_t word, long low, long high) const;
  /// A mistake at the line, or at one of its words. Throw UserError.
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail(std::size_t word, const std::string& message) const;

 private:
  struct Place {
    int line, column;
  };

  void add_words(std::string_view line);

  std::string_view rest_;
  std::string file_;
  TextStyle style_;
  std::vector<std::string_view> words_;
  std::vector<Place> places_;  ///< of the words, when columns are wanted
  int line_ = 0;
};

}  // namespace scanline
