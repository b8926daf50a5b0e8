// The mathematical functions at every level of modelling, on as many arguments as asked for: macro and model, and RTL
// where it is built, must leave the same bytes and count the same cycles.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/microcode/library.h"
#include "tests/accuracy/hard_pairs.h"
#include "tests/levels/array_words.h"
#ifdef PIXELFLOW_HAS_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace {

using namespace pixelflow;
using pixelflow_tests::get_words;
using pixelflow_tests::put_words;

constexpr int kLanes = 8192;
constexpr int kA = 0, kB = 4, kD = 8, kWork = 12;

struct Machine {
  std::string name;
  std::unique_ptr<PixelArray> array;
};

std::vector<Machine> levels(bool rtl) {
  std::vector<Machine> all;
  all.push_back({"macro", make_golden_array(Level::Macro, kLanes)});
  all.push_back({"model", make_golden_array(Level::Model, kLanes)});
#ifdef PIXELFLOW_HAS_RTL
  if (rtl) all.push_back({"RTL", tb::make_rtl_array(kLanes)});
#else
  if (rtl) throw std::runtime_error("this build has no RTL");
#endif
  return all;
}

/// Runs one function on `inputs` pairs; an exception tells the first difference.
void run(Code code, std::vector<Machine>& all, std::uint64_t inputs, std::uint64_t seed) {
  Operation o;
  o.code = code;
  o.a.address = kA;
  o.b.address = kB;
  o.d.address = kD;
  o.work = kWork;
  Program program;
  append_instructions(program, [](Assembler& a) { a.flag(Flag::E, Bit::One); });
  append(program, o);
  const std::string_view kind = code == Code::Pow ? "pow" : "other";
  std::uint64_t done = 0;
  for (; done < inputs; done += kLanes) {
    const accuracy::Pairs pairs = accuracy::random_pairs(kind, seed, done, kLanes);
    std::vector<std::uint32_t> first;
    std::uint64_t cycles = 0;
    for (Machine& level : all) {
      put_words(*level.array, kA, pairs.x);
      put_words(*level.array, kB, pairs.y);
      const std::uint64_t before = level.array->counters().cycles;
      level.array->run(program);
      const std::uint64_t taken = level.array->counters().cycles - before;
      const std::vector<std::uint32_t> words = get_words(*level.array, kD);
      if (&level == &all.front()) {
        first = words;
        cycles = taken;
        continue;
      }
      for (int i = 0; i < kLanes; ++i) {
        if (words[i] == first[i]) continue;
        throw std::runtime_error(fmt::format("{} of {:08X}, {:08X}: {} gives {:08X}, {} gives {:08X} (seed {})",
                                             name(code), pairs.x[i], pairs.y[i], all.front().name, first[i], level.name,
                                             words[i], seed));
      }
      if (taken != cycles) {
        throw std::runtime_error(fmt::format("{}: {} counts {} cycles, {} counts {}", name(code), all.front().name,
                                             cycles, level.name, taken));
      }
    }
  }
  fmt::print("| {} | {} | {} | {} |\n", name(code), done, program.cycles() - 1, workspace_bytes(o));
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t inputs = 10'000'000, seed = 1;
  bool rtl = false;
  CLI::App app(
      "Runs the mathematical functions at the levels macro, model and, where asked for, RTL, and compares results and "
      "cycles.\nExit status: 0 all equal, 1 a difference, 2 wrong usage.");
  app.option_defaults()->always_capture_default();
  app.add_option("--inputs", inputs, "arguments (pairs of them) for each function, rounded up to a full array");
  app.add_option("--seed", seed, "seed of the arguments");
  app.add_flag("--rtl", rtl, "with the verilated chips");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    std::vector<Machine> all = levels(rtl);
    std::string names;
    for (const Machine& level : all) names += (names.empty() ? "" : ", ") + level.name;
    fmt::print("Equal at the levels {}; seed {}.\n\n| function | arguments | cycles | workspace, bytes |\n", names,
               seed);
    fmt::print("|---|---:|---:|---:|\n");
    for (int code = static_cast<int>(Code::Sin); code <= static_cast<int>(Code::Pow); ++code) {
      run(static_cast<Code>(code), all, inputs, seed);
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pixelflow_function_levels: error: {}\n", error.what());
    return 1;
  }
}
