#include "program/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fstream>
#include <mutex>
#include <string>
#include <utility>

#include "program/refuse.h"

namespace program {
namespace {

namespace fs = std::filesystem;

// Names of unfinished files. A signal handler may only unlink: so they are plain strings in a fixed table.
constexpr int kSlots = 1024;
std::array<std::atomic<const char*>, kSlots> g_partial_files{};

// Keeps a name for the rest of the run: a signal handler might be reading it whenever it comes.
const char* keep(const fs::path& path) {
  static std::mutex mutex;
  static auto& names = *new std::deque<std::string>;
  const std::lock_guard lock(mutex);
  return names.emplace_back(path.string()).c_str();
}

int remember(const fs::path& path) {
  const char* name = keep(path);
  for (int i = 0; i < kSlots; ++i) {
    const char* free = nullptr;
    if (g_partial_files[i].compare_exchange_strong(free, name)) return i;
  }
  return -1;  // more files at once than slots: this one is left behind by a signal
}

void forget(int slot) {
  if (slot >= 0) g_partial_files[slot].store(nullptr);
}

extern "C" void remove_partial_files(int signal) {
  for (auto& name : g_partial_files) {
    if (const char* path = name.load()) ::unlink(path);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

OutputFile::OutputFile(fs::path place) : place_(std::move(place)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(place_, ignored);
  if (place_.empty() || !place_.has_filename() || fs::is_directory(status)) fail("is a folder, not a file");
  replace_ = !fs::is_symlink(place_, ignored) && (!fs::exists(status) || fs::is_regular_file(status));
  if (!replace_ && fs::exists(status) && ::access(place_.c_str(), W_OK) != 0) fail(std::strerror(errno));
  const fs::path folder = replace_ ? place_.parent_path() : fs::temp_directory_path();
  // The number makes the name unique: several runs may write the same place.
  for (int attempt = 0; attempt < 1000; ++attempt) {
    partial_ = folder / fmt::format(".{}.partial-{}-{}{}", place_.stem().string(), ::getpid(), attempt,
                                    place_.extension().string());
    slot_ = remember(partial_);  // before it is there, so that no signal comes between
    const int file = ::open(partial_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      return;
    }
    const int error = errno;
    forget(slot_);
    if (error != EEXIST) fail(std::strerror(error));
  }
  fail("no free name for the file in the making");
}

OutputFile::~OutputFile() {
  if (!committed_) ::unlink(partial_.c_str());
  forget(slot_);
}

void OutputFile::fail(const std::string& why) const { refuse("cannot write: " + why, place_.string()); }

void OutputFile::write(std::string_view content) {
  std::ofstream out(partial_, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) fail(std::strerror(errno));
}

void OutputFile::commit() {
  if (!replace_) {
    std::ifstream in(partial_, std::ios::binary);
    std::ofstream out(place_, std::ios::binary);
    // An empty file has nothing to copy, which the stream would call a failure.
    if (in.peek() != std::ifstream::traits_type::eof()) out << in.rdbuf();
    out.close();
    if (!out) fail(std::strerror(errno));
    return;  // the destructor removes the copy's source
  }
  std::error_code error;
  fs::rename(partial_, place_, error);
  if (error) fail(error.message());
  committed_ = true;
}

void refuse_same_file(const std::vector<fs::path>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (paths[i].empty() || paths[j].empty()) continue;
      std::error_code ignored;
      if (fs::weakly_canonical(paths[i], ignored) == fs::weakly_canonical(paths[j], ignored)) {
        refuse("this file is named twice, to be read or written as different things", paths[i].string());
      }
    }
  }
}

void write_standard_output(std::string_view content) {
  std::fwrite(content.data(), 1, content.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    refuse(std::string("cannot write: ") + std::strerror(errno), "standard output");
  }
}

void remove_partial_files_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A signal that the caller ignores (nohup) stays ignored.
    if (std::signal(signal, remove_partial_files) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

}  // namespace program
