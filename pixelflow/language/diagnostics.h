// Where something stands in a shader's text, and what the compiler says of it.
//
// Nothing here prints. A message reads `brick.pfman:12:5: error: undeclared identifier 'foo' [E110]`; a warning has the
// word `warning` and W601 to W606. Lines that belong to a message follow as `brick.pfman:3:9: note: ...`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pfman {

/// A place in a file; line and column count from 1. File numbers index Diagnostics::files().
struct Location {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  friend bool operator==(const Location&, const Location&) = default;
};

struct Note {
  Location where;
  std::string text;
};

struct Diagnostic {
  int code = 0;  ///< 101 to 599 errors, 601 to 699 warnings: the list in docs/pfman.md
  Location where;
  std::string text;
  std::vector<Note> notes;

  bool is_error() const { return code < 600; }
};

/// Everything that a compilation says, in the order in which it was found.
class Diagnostics {
 public:
  std::uint32_t add_file(const std::string& name);  ///< the same number for the same name
  const std::vector<std::string>& files() const { return files_; }

  /// The same code at the same place with the same text counts once.
  void add(Diagnostic diagnostic);
  void add(int code, Location where, std::string text) { add({code, where, std::move(text), {}}); }

  bool has_errors() const { return errors_ > 0; }
  int errors() const { return errors_; }
  int warnings() const { return static_cast<int>(all_.size()) - errors_; }
  const std::vector<Diagnostic>& all() const { return all_; }

  std::string place(Location where) const;               ///< "brick.pfman:12:5"
  std::string text(const Diagnostic& diagnostic) const;  ///< its lines, without a line feed at the end
  /// All of them by place (file, line, column), one after another, each ended with a line feed.
  std::string text() const;

 private:
  std::vector<std::string> files_;
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

}  // namespace pfman
