// Accuracy of the mathematical functions: all 2^32 arguments, or hard and random pairs of them, as a table.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/accuracy/bounds.h"
#include "tests/accuracy/run.h"

namespace {

struct Options {
  std::vector<std::string> functions = {"all"};
  std::string state;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  uint64_t every = 1;
  uint64_t pairs = 100'000'000;
  uint64_t seed = 1;
  std::string record;
};

bool wanted(const Options& options, std::string_view name) {
  return std::ranges::any_of(options.functions, [&](const std::string& f) { return f == "all" || f == name; });
}

void check_names(const Options& options) {
  for (const std::string& name : options.functions) {
    const auto is_named = [&](const auto& function) { return function.name == name; };
    if (name != "all" && std::ranges::none_of(pixelflow::native::unary_functions(), is_named) &&
        std::ranges::none_of(pixelflow::native::binary_functions(), is_named)) {
      throw std::runtime_error("no such function: " + name);
    }
  }
}

accuracy::Progress progress_bar() {
  if (isatty(STDERR_FILENO) == 0) return {};
  const auto start = std::chrono::steady_clock::now();
  return [start](uint64_t done, uint64_t done_now, uint64_t all) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double rate = static_cast<double>(done_now) / seconds;
    const double part = static_cast<double>(done) / static_cast<double>(all);
    const int full = static_cast<int>(part * 30);
    const auto left = static_cast<uint64_t>(static_cast<double>(all - done) / rate);
    fmt::print(stderr, "\r[{:=<{}}{:<{}}] {:5.1f} %  {:.1f} million/s  {}:{:02d}:{:02d} left ", "", full, "", 30 - full,
               part * 100, rate * 1e-6, left / 3600, left / 60 % 60, left % 60);
    if (done == all) fmt::print(stderr, "\n");
    std::fflush(stderr);
  };
}

bool is_pair(std::string_view name) {
  return std::ranges::any_of(pixelflow::native::binary_functions(),
                             [&](const auto& function) { return function.name == name; });
}

void print_exact(const std::vector<std::string>& names, const std::map<std::string, accuracy::Tally>& sums) {
  fmt::print(
      "| function | inputs | correctly rounded | 1 ulp off | more | special values wrong | largest error, ulp | at "
      "|\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---|\n");
  for (const std::string& name : names) {
    const accuracy::Tally& t = sums.at(name);
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.4f} | {:08X}{} |\n", name, t.inputs, t.equal, t.one_off, t.further,
               t.special, t.max_ulp, t.worst_x, is_pair(name) ? fmt::format(", {:08X}", t.worst_y) : "");
  }
}

void print_fast(const std::vector<std::string>& names, const std::map<std::string, accuracy::Tally>& sums) {
  fmt::print(
      "| function | inputs | largest relative error | bound | largest absolute error | bound | largest error, ulp | "
      "special values wrong | neighbours out of order |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::string& name : names) {
    const accuracy::Tally& t = sums.at(name);
    const accuracy::Bound bound = accuracy::bound_of(name);
    fmt::print("| {} | {} | {:.4g} | {:.4g} | {:.4g} | {} | {:.0f} | {} | {} |\n", name, t.inputs, t.max_relative,
               bound.relative, t.max_absolute, std::isinf(bound.absolute) ? "-" : fmt::format("{:.4g}", bound.absolute),
               t.max_ulp, t.special, name == "fast_atan2" ? "-" : std::to_string(t.disorder));
  }
}

/// What the tables of published and measured figures show beside the cycles.
void record(const std::string& path, const std::map<std::string, accuracy::Tally>& sums) {
  nlohmann::ordered_json file;
  file["source"] = "pixelflow_exhaustive --record";
  const std::map<std::string, std::string> fingerprints = accuracy::fingerprints();
  for (const auto& [name, tally] : sums) {
    const bool all = tally.inputs == 1ull << 32;
    file[name] = {{"max_error_ulp", tally.max_ulp},
                  {"inputs", all ? "all 2^32 arguments"
                                 : fmt::format("{} {}", tally.inputs, is_pair(name) ? "pairs" : "arguments")},
                  {"correctly_rounded", tally.equal},
                  {"fingerprint", fingerprints.at(name)}};
  }
  std::ofstream out(path);
  out << file.dump(1) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

int run(const Options& options) {
  check_names(options);
  std::vector<std::string> exact;
  std::vector<std::string> fast;
  std::vector<accuracy::Chunk> chunks;
  const auto take = [&](const auto& function, std::vector<accuracy::Chunk> more) {
    (function.name.starts_with("fast_") ? fast : exact).emplace_back(function.name);
    std::ranges::move(more, std::back_inserter(chunks));
  };
  for (const auto& function : pixelflow::native::unary_functions()) {
    if (wanted(options, function.name)) take(function, accuracy::chunks_of(function, options.every));
  }
  bool pairs = false;
  for (const auto& function : pixelflow::native::binary_functions()) {
    if (!wanted(options, function.name)) continue;
    pairs = true;
    take(function, accuracy::chunks_of(function, options.pairs, options.seed));
  }
  const auto sums = accuracy::run(chunks, options.state, options.threads, progress_bar());
  if (!exact.empty()) print_exact(exact, sums);
  if (!exact.empty() && !fast.empty()) fmt::print("\n");
  if (!fast.empty()) print_fast(fast, sums);
  if (!options.record.empty()) record(options.record, sums);
  if (pairs) fmt::print("\nRandom pairs: seed {}.\n", options.seed);
  const bool right = std::ranges::all_of(exact, [&](const std::string& f) { return sums.at(f).further == 0; }) &&
                     std::ranges::all_of(fast, [&](const std::string& f) {
                       return sums.at(f).special == 0 && sums.at(f).disorder == 0 &&
                              accuracy::is_within(sums.at(f), accuracy::bound_of(f));
                     });
  return right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Compares mathematical functions of the pixel processors with correctly rounded values.\n"
      "Exit status: 0 all within 1 ulp, fast ones in order and within their method's error; 1 not so; 2 wrong usage or "
      "no state file.");
  app.option_defaults()->always_capture_default();
  app.add_option("functions", options.functions, "names, or all");
  app.add_option("--state", options.state, "file of finished chunks: a run that is started again goes on after them");
  app.add_option("--threads", options.threads, "threads")->check(CLI::Range(1, 1024));
  app.add_option("--every", options.every, "only one in so many of the 2^32 arguments")
      ->check(CLI::Range(1u, 1u << 31));
  app.add_option("--pairs", options.pairs, "random pairs for functions of two arguments");
  app.add_option("--seed", options.seed, "seed of the pairs");
  app.add_option("--record", options.record, "file for the largest errors as JSON (tables/pixelflow_accuracy.json)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pixelflow_exhaustive: error: {}\n", error.what());
    return 2;
  }
}
