// Element-cycles a second of the array of pixel processors, at each level of modelling, on one core: cycles that the
// machine would spend, times the elements of a region. Counters: `giga`, thousand millions of these a second;
// `of_machine`, the fraction of the real machine's speed; `simulated`, the share of the element-cycles that was not
// left out. The RTL runs one chip, the others a whole region.
#include <benchmark/benchmark.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/microcode/library.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace {

using namespace pixelflow;

constexpr int kRegion = kRegionWidth * kRegionHeight;
constexpr double kMachine = kRegion * kClockMhz * 1e6;  // element-cycles a second
constexpr double kCovered = 0.3;
constexpr std::uint8_t kWork = 160, kCoverage = 255;

/// The numbers of a program lie one after another, four bytes each: d and the operands move on with every operation.
Operation operation(Code code, int number, int bytes = 4, int scale = 0) {
  constexpr int kNumbers = 16;
  const auto at = [&](int n) { return static_cast<std::uint8_t>(16 + 4 * ((number + n) % kNumbers)); };
  const auto size = static_cast<std::uint8_t>(bytes);
  return {.code = code,
          .d = {.address = at(2), .bytes = size},
          .a = {.address = at(0), .bytes = size},
          .b = {.address = at(1), .bytes = size},
          .scale = scale,
          .work = kWork};
}

Program repeated(Code code) {
  Program program;
  for (int n = 0; n < 16; ++n) append(program, operation(code, n));
  return program;
}

/// What a shader does: some fixed point, more float, a condition, a conversion, a function.
Program mixed() {
  Program program;
  int n = 0;
  for (int round = 0; round < 2; ++round) {
    for (const Code code : {Code::Add, Code::Multiply, Code::ShiftRight})
      append(program, operation(code, n++, 2, code == Code::Add ? 0 : 1));
    for (const Code code : {Code::FloatMultiply, Code::FloatAdd, Code::FloatMultiply, Code::FloatAdd, Code::FloatSub,
                            Code::FloatDivide, Code::FloatSquareRoot, Code::FloatLess, Code::FixedToFloat}) {
      append(program, operation(code, n++));
    }
    append_instructions(program, [](Assembler& a) { a.flag(Flag::S, Bit::K); });
    append(program, operation(Code::FloatToFixed, n++, 4, 8));
  }
  append(program, operation(Code::Exp2, n++));
  return program;
}

using MakeArray = std::function<std::unique_ptr<PixelArray>(int lanes)>;

struct Work {
  std::string name;
  Program program;
  double covered = 1;   ///< share of the region's elements that are enabled
  bool disc = true;     ///< they are a disc in its middle, otherwise the lowest rows
  bool packed = false;  ///< the covered elements alone make up the array
};

bool is_covered(int lane, double covered, bool disc) {
  if (!disc) return lane / kRegionWidth >= (1 - covered) * kRegionHeight;
  const double x = lane % kRegionWidth + 0.5 - kRegionWidth / 2.0, y = lane / kRegionWidth + 0.5 - kRegionHeight / 2.0;
  return covered >= 1 || (x * x + y * y) * 3.141592653589793 <= covered * kRegion;
}

void load(PixelArray& array, double covered, bool disc) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(array.lanes()));
  for (int address = 0; address < kMemoryBytes; ++address) {
    // Floats near one: no operation has an easy case.
    for (auto& byte : row) byte = static_cast<std::uint8_t>(address % 4 == 3 ? 0x3E + random() % 3 : random());
    array.write(address, row);
  }
  for (int lane = 0; lane < array.lanes(); ++lane)
    row[static_cast<std::size_t>(lane)] = is_covered(lane, covered, disc) ? 1 : 0;
  array.write(kCoverage, row);
  Program enable;
  append_instructions(enable, [](Assembler& a) { a.flag_of_memory(Flag::E, kCoverage, 0); });
  array.run(enable);
}

void run(benchmark::State& state, const MakeArray& make, int lanes, const Work& work) {
  const auto array = make(work.packed ? static_cast<int>(work.covered * kRegion) : lanes);
  load(*array, work.packed ? 1 : work.covered, work.disc);
  const ArrayCounters before = array->counters();
  for (auto unused : state) array->run(work.program);
  const ArrayCounters after = array->counters();
  const double cycles = static_cast<double>(after.cycles - before.cycles);
  const double simulated = static_cast<double>(after.simulated_element_cycles - before.simulated_element_cycles);
  state.SetItemsProcessed(static_cast<std::int64_t>(cycles * lanes));
  state.counters["giga"] = benchmark::Counter(cycles * lanes / 1e9, benchmark::Counter::kIsRate);
  state.counters["of_machine"] = benchmark::Counter(cycles * lanes / kMachine, benchmark::Counter::kIsRate);
  state.counters["simulated"] = simulated / (cycles * lanes);
  state.counters["cycles"] = static_cast<double>(work.program.cycles());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Work> works = {{"add_32", repeated(Code::Add)},
                                   {"multiply_32", repeated(Code::Multiply)},
                                   {"float_add", repeated(Code::FloatAdd)},
                                   {"float_multiply", repeated(Code::FloatMultiply)},
                                   {"sin", repeated(Code::Sin)},
                                   {"mix", mixed()},
                                   {"mix_disc_of_30_percent", mixed(), kCovered},
                                   {"mix_rows_of_30_percent", mixed(), kCovered, false},
                                   {"mix_packed_30_percent", mixed(), kCovered, true, true}};
  const auto add = [&](const std::string& level, const MakeArray& make, int lanes) {
    for (const Work& work : works) {
      if (lanes < kRegion && work.covered < 1) continue;  // a chip is too small a part of a region for that
      benchmark::RegisterBenchmark((level + "/" + work.name).c_str(), run, make, lanes, work)
          ->Unit(benchmark::kMicrosecond);
    }
  };
  add(
      "model", [](int lanes) { return make_golden_array(Level::Model, lanes); }, kRegion);
  add(
      "macro", [](int lanes) { return make_golden_array(Level::Macro, lanes); }, kRegion);
#ifdef VSG_HAVE_RTL
  add(
      "rtl", [](int lanes) { return tb::make_rtl_array(lanes); }, kElements);
#endif
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
