// Programs of the microcode library on the levels model and macro: the same bytes but for the workspace, the same E,
// the same K after a comparison, the same cycles.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "cmodel/pixelflow/macro.h"
#include "pixelflow/microcode/library.h"
#include "tests/pixelflow_model/operations.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

constexpr int kLanes = 320;
constexpr int kOperandBytes = 16;  // of noise a has three coordinates of 4

class Levels : public testing::Test {
 protected:
  Levels() : seed_(seed_or(20266)), random_(seed_) { std::cout << replay(seed_) << '\n'; }

  int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint64_t>(limit)); }

  Operand operand(std::uint8_t address, bool is_float) {
    Operand made{.address = address, .bytes = static_cast<std::uint8_t>(is_float ? 4 : 1 + below(8))};
    if (!is_float) made.is_signed = below(2) != 0;
    return made;
  }

  int scale_of(const Operation& o) {
    switch (o.code) {
      case Code::Multiply:
      case Code::Divide: return below(9);
      case Code::ShiftLeft:
      case Code::ShiftRight:
      case Code::SquareRoot: return below(65);
      case Code::Wrap:
      case Code::Saturate: return 1 + below(8 * o.d.bytes);
      case Code::FixedToFloat:
      case Code::FloatToFixed: return below(97) - 32;
      case Code::NoiseFixed:
      case Code::NoiseFloat: return 1 + below(3);
      default: return 0;
    }
  }

  Operation operation(Code code) {
    const bool floats = takes_floats(code);
    Operation o{.code = code,
                .d = operand(kD, gives_float(code)),
                .a = operand(kA, floats),
                .b = operand(kB, floats),
                .work = kWork};
    if (code == Code::NoiseFixed) o.a.bytes = o.d.bytes = 2;
    o.scale = scale_of(o);
    if (floats && code < Code::Sin) o.flush = below(2) != 0;
    if (operand_count(code) == 2) {
      const int uniform = below(6);
      Operand* const constant = uniform == 0 ? &o.a : uniform == 1 ? &o.b : nullptr;
      if (constant != nullptr) {
        constant->uniform = true;
        constant->constant = floats ? hard_floats(random_, 1)[0]
                                    : static_cast<std::uint64_t>(number(hard_numbers(random_, 1, constant->bytes)[0],
                                                                        constant->bytes, constant->is_signed));
      }
    }
    return o;
  }

  /// False where the library does not offer the operation in this form.
  static bool make(const Operation& o, Program& program) {
    try {
      append(program, o);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  void compare(const Operation& o, const Program& program) {
    const bool floats = takes_floats(o.code);
    Elements model(kLanes, Level::Model), macro(kLanes, Level::Macro);
    auto enable = hard_numbers(random_, kLanes, 1);
    std::fill(enable.begin() + 64, enable.begin() + 192, 0);
    for (int at = 0; at < kMemoryBytes; at += 4) {
      const auto values = floats && at < kD ? hard_floats(random_, kLanes) : hard_numbers(random_, kLanes, 4);
      for (Elements* elements : {&model, &macro}) elements->put(at, 4, values);
    }
    if (!floats) {
      for (const Operand& operand : {o.a, o.b}) {
        const auto values = hard_numbers(random_, kLanes, operand.bytes);
        for (Elements* elements : {&model, &macro}) elements->put(operand.address, operand.bytes, values);
      }
    }
    const auto a = model.get(kA, 8), b = model.get(kB, 8);
    for (Elements* elements : {&model, &macro}) {
      elements->enable(enable);
      elements->array().run(program);
    }
    const int workspace = program.steps[0].workspace_bytes;
    const auto where = [&](std::size_t n) {
      return replay(seed_) + ", " + name(o.code) + (o.flush ? " flushing" : "") + ", scale " + std::to_string(o.scale) +
             ", bytes " + std::to_string(o.d.bytes) + (o.d.is_signed ? "s " : "u ") + std::to_string(o.a.bytes) +
             (o.a.is_signed ? "s" : "u") + (o.a.uniform ? "= " : " ") + std::to_string(o.b.bytes) +
             (o.b.is_signed ? "s" : "u") + (o.b.uniform ? "=" : "") + ", element " + std::to_string(n) + ": " +
             std::to_string(o.a.uniform ? o.a.constant : a[n]) + ", " +
             std::to_string(o.b.uniform ? o.b.constant : b[n]) + (enable[n] & 1 ? ", enabled" : ", disabled");
    };
    for (int address = 0; address < kMemoryBytes; ++address) {
      if (address >= o.work && address < o.work + workspace) continue;
      const auto of_model = model.get(address, 1), of_macro = macro.get(address, 1);
      for (std::size_t n = 0; n < of_model.size(); ++n) {
        ASSERT_EQ(of_model[n], of_macro[n]) << "byte " << address << " at levels model and macro; " << where(n);
      }
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      const Registers of_model = model.array().registers(lane), of_macro = macro.array().registers(lane);
      ASSERT_EQ(of_model.e, of_macro.e) << where(static_cast<std::size_t>(lane));
      if (is_comparison(o.code) && of_macro.e) {
        ASSERT_EQ(of_model.k, of_macro.k) << where(static_cast<std::size_t>(lane));
      }
    }
    EXPECT_EQ(model.array().counters().cycles, macro.array().counters().cycles);
    EXPECT_EQ(model.array().counters().cycles, program.cycles() + 1);
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
};

TEST_F(Levels, OperationsLeaveTheSameBytes) {
  constexpr int kEach = 40;
  int compared = 0;
  for (int code = 0; code < static_cast<int>(Code::Count); ++code) {
    int made = 0;
    for (int n = 0; n < kEach; ++n) {
      const Operation o = operation(static_cast<Code>(code));
      Program program;
      if (!make(o, program)) continue;
      ASSERT_NO_FATAL_FAILURE(compare(o, program));
      ++made;
    }
    EXPECT_GT(made, kEach / 4) << "code " << code << " is not in the library";
    compared += made;
  }
  std::cout << compared << " operations in " << kLanes << " elements\n";
}

}  // namespace
}  // namespace pixelflow_tests
