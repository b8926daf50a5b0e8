// Float operations at the macro level against scalar arithmetic of the host, and functions against their algorithms.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iostream>
#include <string_view>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/pixelflow_model/operations.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

constexpr int kLanes = 1500;  // a full tile and a part of one

float float_of(std::uint64_t bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); }
float flushed(float value) { return std::fpclassify(value) == FP_SUBNORMAL ? std::copysign(0.0f, value) : value; }
std::uint64_t bits_of(float value) { return std::isnan(value) ? 0x7FC00000u : std::bit_cast<std::uint32_t>(value); }

class MacroFloat : public testing::Test {
 protected:
  MacroFloat() : seed_(seed_or(20264)), random_(seed_) { std::cout << replay(seed_) << '\n'; }

  /// Runs the operation on hard floats; `expected` gives the bits of d, or K. Elements of whole groups are disabled
  /// too.
  void compare(const Operation& o, bool is_comparison,
               const std::function<std::uint64_t(std::uint64_t, std::uint64_t)>& expected) {
    Elements elements(kLanes);
    const auto a = hard_floats(random_, kLanes), b = hard_floats(random_, kLanes),
               old = hard_numbers(random_, kLanes, 8);
    auto enable = hard_numbers(random_, kLanes, 1);
    std::fill(enable.begin() + 128, enable.begin() + 320, 0);
    elements.put(kA, 4, a);
    elements.put(kB, 4, b);
    elements.put(kD, 8, old);
    elements.enable(enable);
    elements.run(o);
    const auto results = elements.get(kD, 8);
    for (std::size_t n = 0; n < a.size(); ++n) {
      const std::uint64_t x = o.a.uniform ? o.a.constant : a[n], y = o.b.uniform ? o.b.constant : b[n];
      const std::string where = replay(seed_) + ", code " + std::to_string(static_cast<int>(o.code)) +
                                (o.flush ? ", flush" : "") + ", element " + std::to_string(n) + ": " +
                                std::to_string(x) + ", " + std::to_string(y);
      if (is_comparison) {
        ASSERT_EQ(elements.condition(static_cast<int>(n)), expected(x, y) != 0) << where;
        ASSERT_EQ(results[n], old[n]) << where;
      } else {
        const std::uint64_t mask = low_bytes(-1, o.d.bytes);
        ASSERT_EQ(results[n], (old[n] & ~mask) | ((enable[n] & 1 ? expected(x, y) : old[n]) & mask)) << where;
      }
    }
  }

  void compare_all(Code code, const std::function<float(float, float)>& expected) {
    for (const bool flush : {false, true}) {
      for (int uniform = 0; uniform < 3; ++uniform) {
        Operation o{.code = code, .d = {.address = kD}, .a = {.address = kA}, .b = {.address = kB}, .flush = flush};
        Operand& constant = uniform == 1 ? o.a : o.b;
        if (uniform != 0) constant.uniform = true, constant.constant = hard_floats(random_, 1)[0];
        ASSERT_NO_FATAL_FAILURE(compare(o, false, [&](std::uint64_t x, std::uint64_t y) {
          const float a = flush ? flushed(float_of(x)) : float_of(x), b = flush ? flushed(float_of(y)) : float_of(y);
          const float result = expected(a, b);
          return bits_of(flush ? flushed(result) : result);
        }));
      }
    }
  }

  void compare_all(Code code, const std::function<bool(float, float)>& expected, bool) {
    for (const bool flush : {false, true}) {
      const Operation o{.code = code, .d = {.address = kD}, .a = {.address = kA}, .b = {.address = kB}, .flush = flush};
      ASSERT_NO_FATAL_FAILURE(compare(o, true, [&](std::uint64_t x, std::uint64_t y) -> std::uint64_t {
        return flush ? expected(flushed(float_of(x)), flushed(float_of(y))) : expected(float_of(x), float_of(y));
      }));
    }
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
};

TEST_F(MacroFloat, Arithmetic) {
  compare_all(Code::FloatAdd, [](float a, float b) { return a + b; });
  compare_all(Code::FloatSub, [](float a, float b) { return a - b; });
  compare_all(Code::FloatMultiply, [](float a, float b) { return a * b; });
  compare_all(Code::FloatDivide, [](float a, float b) { return a / b; });
  compare_all(Code::FloatSquareRoot, [](float a, float) { return std::sqrt(a); });
}

TEST_F(MacroFloat, Comparisons) {
  compare_all(
      Code::FloatLess, [](float a, float b) { return a < b; }, true);
  compare_all(
      Code::FloatLessEqual, [](float a, float b) { return a <= b; }, true);
  compare_all(
      Code::FloatEqual, [](float a, float b) { return a == b; }, true);
}

TEST_F(MacroFloat, FloatToFixed) {
  for (int n = 0; n < 200; ++n) {
    const Operation o{.code = Code::FloatToFixed,
                      .d = {.address = kD, .bytes = static_cast<std::uint8_t>(1 + n % 8), .is_signed = (n & 8) != 0},
                      .a = {.address = kA},
                      .b = {},
                      .scale = static_cast<int>(random_() % 511) - 255,
                      .flush = (n & 16) != 0};
    ASSERT_NO_FATAL_FAILURE(compare(o, false, [&](std::uint64_t x, std::uint64_t) -> std::uint64_t {
      if (std::isnan(float_of(x))) return 0;
      const float a = o.flush ? flushed(float_of(x)) : float_of(x);
      const long double value = std::floor(std::ldexp(static_cast<long double>(a), o.scale));
      const int bits = 8 * o.d.bytes;
      const long double most = std::ldexp(1.0L, o.d.is_signed ? bits - 1 : bits) - 1,
                        least = o.d.is_signed ? -most - 1 : 0.0L;
      const long double limited = std::min(std::max(value, least), most);
      return limited < 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(limited))
                         : static_cast<std::uint64_t>(limited);
    }));
  }
}

TEST_F(MacroFloat, FunctionsAreThoseOfTheirNames) {
  constexpr std::pair<Code, std::string_view> kUnary[] = {{Code::Sin, "sin"},
                                                          {Code::Cos, "cos"},
                                                          {Code::Tan, "tan"},
                                                          {Code::Asin, "asin"},
                                                          {Code::Acos, "acos"},
                                                          {Code::Atan, "atan"},
                                                          {Code::Exp, "exp"},
                                                          {Code::Exp2, "exp2"},
                                                          {Code::Log, "log"},
                                                          {Code::Log2, "log2"},
                                                          {Code::InverseSquareRoot, "inversesqrt"},
                                                          {Code::FastSin, "fast_sin"},
                                                          {Code::FastCos, "fast_cos"},
                                                          {Code::FastTan, "fast_tan"},
                                                          {Code::FastAsin, "fast_asin"},
                                                          {Code::FastAcos, "fast_acos"},
                                                          {Code::FastAtan, "fast_atan"},
                                                          {Code::FastExp, "fast_exp"},
                                                          {Code::FastExp2, "fast_exp2"},
                                                          {Code::FastLog, "fast_log"},
                                                          {Code::FastLog2, "fast_log2"}};
  constexpr std::pair<Code, std::string_view> kBinary[] = {
      {Code::Atan2, "atan2"}, {Code::FastAtan2, "fast_atan2"}, {Code::Pow, "pow"}};
  const auto bits = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  for (const auto& [code, name] : kUnary) {
    const auto all = native::unary_functions();
    const auto found = std::find_if(all.begin(), all.end(), [n = name](const auto& f) { return f.name == n; });
    ASSERT_NE(found, all.end()) << name;
    compare({.code = code, .d = {.address = kD}, .a = {.address = kA}, .b = {}}, false,
            [&](std::uint64_t x, std::uint64_t) {
              const std::uint32_t a = bits(x);
              std::uint32_t result;
              found->batch(&a, &result, 1);
              return std::uint64_t{result};
            });
  }
  for (const auto& [code, name] : kBinary) {
    const auto all = native::binary_functions();
    const auto found = std::find_if(all.begin(), all.end(), [n = name](const auto& f) { return f.name == n; });
    ASSERT_NE(found, all.end()) << name;
    compare({.code = code, .d = {.address = kD}, .a = {.address = kA}, .b = {.address = kB}}, false,
            [&](std::uint64_t x, std::uint64_t y) {
              const std::uint32_t a = bits(x), b = bits(y);
              std::uint32_t result;
              found->batch(&a, &b, &result, 1);
              return std::uint64_t{result};
            });
  }
}

}  // namespace
}  // namespace pixelflow_tests
