// A progress bar with rate and time left, on standard error when that is a terminal and never in a pipe.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace program {

class Progress {
 public:
  /// `unit` is what is counted ("lines"). A quiet one, or one without a terminal, shows nothing.
  Progress(std::string unit, std::int64_t total, bool quiet);
  /// Clears the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// May be called by several threads.
  void advance(std::int64_t count = 1);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::int64_t done, Clock::time_point now);

  const std::string unit_;
  const std::int64_t total_;
  const bool shown_;
  const Clock::time_point begin_ = Clock::now();
  std::atomic<std::int64_t> done_{0};
  std::mutex mutex_;
  Clock::time_point last_draw_ = begin_;  // what is done at once shows no bar
  bool drawn_ = false;
};

}  // namespace program
