#include "program/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace program {
namespace {

constexpr auto kBetweenDraws = std::chrono::milliseconds(100);

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(std::string unit, std::int64_t total, bool quiet)
    : unit_(std::move(unit)),
      total_(std::max<std::int64_t>(total, 1)),
      shown_(!quiet && ::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  }
}

void Progress::advance(std::int64_t count) {
  if (!shown_) return;
  const std::int64_t done = done_.fetch_add(count) + count;
  const std::unique_lock lock(mutex_, std::try_to_lock);  // another thread is drawing: this count is in the next bar
  if (!lock) return;
  const Clock::time_point now = Clock::now();
  if (now - last_draw_ < kBetweenDraws) return;
  last_draw_ = now;
  draw(std::min(done, total_), now);
}

void Progress::draw(std::int64_t done, Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0;
  const std::string text =
      fmt::format(" {:3}%  {:.0f} {}/s  {} left", 100 * done / total_, rate, unit_, duration(left));
  const int width = std::clamp(terminal_columns() - static_cast<int>(text.size()) - 3, 0, 60);
  const int filled = static_cast<int>(width * done / total_);
  fmt::print(stderr, "\r[{:#>{}}{:.>{}}]{}\033[K", "", filled, "", width - filled, text);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace program
