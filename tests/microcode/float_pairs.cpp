// Float arithmetic of the microcode against MPFR, on every pair of hard values and as many random pairs as asked for:
// at model level, and with --rtl in the verilated chips as well.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <bit>
#include <chrono>
#include <cmath>
#include <exception>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "cmodel/pixelflow/macro.h"
#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/microcode/library.h"
#include "tests/levels/array_words.h"
#include "tests/microcode/float_oracle.h"
#ifdef PIXELFLOW_HAS_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace {

using namespace pixelflow;
using pixelflow_test::FloatOracle;
using pixelflow_tests::get_words;
using pixelflow_tests::put_words;

constexpr int kLanes = 1024;
constexpr int kA = 0, kB = 4, kD = 8, kWork = 12;

using Words = std::vector<std::uint32_t>;

/// One operation on an array, its results checked; the pairs come in full arrays.
class Check {
 public:
  Check(PixelArray& array, Code code, bool flush) : array_(array), code_(code), flush_(flush) {
    Operation o;
    o.code = code;
    o.flush = flush;
    o.a.address = kA;
    o.b.address = kB;
    o.d.address = kD;
    o.work = kWork;
    append_instructions(program_, [](Assembler& a) { a.flag(Flag::E, Bit::One); });
    append(program_, o);
    if (is_comparison(code)) {  // K as a number
      append_instructions(
          program_, [](Assembler& a) { a.alu(Alu::AddIf, To::Memory, P::Zero, Q::Immediate, {.addr = kD, .imm = 1}); });
    }
  }

  void add(std::uint32_t a, std::uint32_t b) {
    a_.push_back(a);
    b_.push_back(b);
    if (a_.size() == static_cast<std::size_t>(array_.lanes())) flush();
  }

  void flush() {
    const std::size_t count = a_.size();
    if (count == 0) return;
    a_.resize(static_cast<std::size_t>(array_.lanes()));
    b_.resize(static_cast<std::size_t>(array_.lanes()));
    put_words(array_, kA, a_);
    put_words(array_, kB, b_);
    array_.run(program_);
    const Words d = get_words(array_, kD);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_flag = is_comparison(code_);
      const std::uint32_t got = is_flag ? d[i] & 0xFF : d[i];
      const std::uint32_t want =
          is_flag ? oracle_.compares(code_, a_[i], b_[i], flush_) : oracle_.rounded(code_, a_[i], b_[i], flush_);
      if (got != want) {
        throw std::runtime_error(fmt::format("{}{} of {:08X}, {:08X} gives {:08X}, correctly rounded {:08X}",
                                             name(code_), flush_ ? " flushing" : "", a_[i], b_[i], got, want));
      }
    }
    checked_ += count;
    a_.clear();
    b_.clear();
  }

  std::uint64_t checked() const { return checked_; }

 private:
  PixelArray& array_;
  Code code_;
  bool flush_;
  Program program_;
  FloatOracle oracle_;
  Words a_, b_;
  std::uint64_t checked_ = 0;
};

void run(PixelArray& array, Code code, bool flush, std::uint64_t pairs, std::uint64_t seed) {
  Check check(array, code, flush);
  for (const std::uint32_t a : pixelflow_test::hard_floats()) {
    for (const std::uint32_t b : pixelflow_test::hard_floats()) check.add(a, b);
  }
  check.flush();
  const std::uint64_t hard = check.checked();
  std::mt19937_64 random(seed + static_cast<unsigned>(code));
  for (std::uint64_t n = 0; n < pairs; ++n) {
    const auto [a, b] = pixelflow_test::random_floats(random);
    check.add(a, b);
  }
  check.flush();
  fmt::print("| {}{} | {} | {} |\n", name(code), flush ? ", flushing" : "", hard, check.checked() - hard);
}

/// The square root of every float, against the host's, which IEEE 754 wants correctly rounded as well.
void run_all_roots(PixelArray& array) {
  Operation o;
  o.code = Code::FloatSquareRoot;
  o.a.address = kA;
  o.d.address = kD;
  o.work = kWork;
  Program program;
  append_instructions(program, [](Assembler& a) { a.flag(Flag::E, Bit::One); });
  append(program, o);
  const bool shows = isatty(STDERR_FILENO) != 0;
  const auto start = std::chrono::steady_clock::now();
  Words a(kLanes);
  for (std::uint64_t first = 0; first < 1ull << 32; first += kLanes) {
    std::iota(a.begin(), a.end(), static_cast<std::uint32_t>(first));
    put_words(array, kA, a);
    array.run(program);
    const Words d = get_words(array, kD);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const float root = std::sqrt(std::bit_cast<float>(a[i]));
      const std::uint32_t want = std::isnan(root) ? 0x7FC00000 : std::bit_cast<std::uint32_t>(root);
      if (d[i] == want) continue;
      throw std::runtime_error(fmt::format("float_sqrt of {:08X} gives {:08X}, the host {:08X}", a[i], d[i], want));
    }
    if (shows && first % (1ull << 26) == 0) {
      const double part = static_cast<double>(first + kLanes) / 0x1p32;
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      fmt::print(stderr, "\r[{:<30}] {:5.1f} %  {:.1f} million/s  {:.0f} s left ",
                 std::string(static_cast<std::size_t>(part * 30), '='), part * 100, part * 0x1p32 / seconds * 1e-6,
                 seconds / part - seconds);
    }
  }
  if (shows) fmt::print(stderr, "\n");
  fmt::print("float_sqrt: all 2^32 arguments equal to the host's correctly rounded root.\n");
}

std::unique_ptr<PixelArray> make_array(bool rtl) {
  if (!rtl) return make_golden_array(Level::Model, kLanes);
#ifdef PIXELFLOW_HAS_RTL
  return tb::make_rtl_array(kLanes);
#else
  throw std::runtime_error("this build has no RTL");
#endif
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t pairs = 10'000'000, seed = 1;
  bool rtl = false, all_roots = false;
  CLI::App app(
      "Compares float arithmetic of the pixel processors with MPFR.\nExit status: 0 all equal, 1 a difference, 2 wrong "
      "usage.");
  app.option_defaults()->always_capture_default();
  app.add_option("--pairs", pairs, "random pairs for each operation, beside every pair of hard values");
  app.add_option("--seed", seed, "seed of the random pairs");
  app.add_flag("--rtl", rtl, "in the verilated chips");
  app.add_flag("--all-roots", all_roots, "instead: the square root of all 2^32 floats");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const auto array = make_array(rtl);
    if (all_roots) {
      run_all_roots(*array);
      return 0;
    }
    fmt::print("Equal to MPFR, {}; seed {}.\n\n| operation | hard pairs | random pairs |\n|---|---:|---:|\n",
               rtl ? "in the RTL" : "at model level", seed);
    for (const bool flush : {false, true}) {
      for (const Code code : {Code::FloatAdd, Code::FloatSub, Code::FloatMultiply, Code::FloatDivide,
                              Code::FloatSquareRoot, Code::FloatLess, Code::FloatLessEqual, Code::FloatEqual}) {
        run(*array, code, flush, pairs, seed);
      }
    }
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pixelflow_float_pairs: error: {} (seed {})\n", error.what(), seed);
    return 1;
  }
}
