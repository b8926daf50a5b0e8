// An output file is written beside its place and renamed when complete: a failed run leaves none.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace program {

/// A file in the making. The constructor finds out at once whether the place can be written.
class OutputFile {
 public:
  /// Creates an empty file beside `place`, with the same suffix. Throws scanline::UserError.
  explicit OutputFile(std::filesystem::path place);
  /// Removes what was not committed.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& place() const { return place_; }
  /// Where to write until the file is complete.
  const std::filesystem::path& partial() const { return partial_; }

  /// Replaces the content. Throws scanline::UserError.
  void write(std::string_view content);
  /// The file takes its place; one that was there is replaced.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& why) const;

  std::filesystem::path place_, partial_;
  int slot_ = -1;  // in the table of files that a signal removes
  // A device, a pipe or a link cannot be renamed over without being lost: it gets a copy of the complete file.
  bool replace_ = true;
  bool committed_ = false;
};

/// Refuses when two of these are one file: what is read must not be overwritten by what is written. Empty names are
/// left out. Throws scanline::UserError.
void refuse_same_file(const std::vector<std::filesystem::path>& paths);

/// Writes to standard output and makes sure that all of it has arrived. Throws scanline::UserError.
void write_standard_output(std::string_view content);

/// SIGINT, SIGTERM and SIGHUP remove the unfinished files before they end the program.
void remove_partial_files_on_signals();

}  // namespace program
