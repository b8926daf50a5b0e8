// Fixed-point operations at the macro level against plain integer arithmetic on 128 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

#include "tests/pixelflow_model/operations.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

constexpr int kLanes = 200;

Number floor_shift(Number value, int shift) { return value >> std::min(shift, 127); }

Number floored(Number a, Number b) {
  const Number quotient = a / b;
  return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

Number root(Number value) {
  Number low = 0, high = Number{1} << 63;
  while (high - low > 1) {
    const Number middle = low + (high - low) / 2;
    (middle * middle <= value ? low : high) = middle;
  }
  return low;
}

Number limited(Number value, int bits, bool is_signed) {
  const Number most = (Number{1} << (is_signed ? bits - 1 : bits)) - 1, least = is_signed ? -most - 1 : 0;
  return std::clamp(value, least, most);
}

using Expectation = std::function<Number(Number a, Number b)>;

class MacroFixed : public testing::Test {
 protected:
  MacroFixed() : seed_(seed_or(20263)), random_(seed_) { std::cout << replay(seed_) << '\n'; }

  Operand operand(std::uint8_t address, int bytes = 0) {
    const auto size = static_cast<std::uint8_t>(bytes != 0 ? bytes : 1 + static_cast<int>(random_() % 8));
    Operand made{.address = address, .bytes = size, .is_signed = (random_() & 1) != 0};
    if (address != kD && random_() % 8 == 0) {
      made.uniform = true;
      made.constant = static_cast<std::uint64_t>(number(hard_numbers(random_, 1, size)[0], size, made.is_signed));
    }
    return made;
  }

  /// Runs the operation on hard numbers, with some elements disabled, and compares d (or K) with what is expected.
  void compare(const Operation& o, const Expectation& expected) {
    Elements elements(kLanes);
    const auto values = [&](const Operand& operand) {
      return operand.uniform ? std::vector<std::uint64_t>(kLanes, operand.constant)
                             : hard_numbers(random_, kLanes, operand.bytes);
    };
    std::vector<std::uint64_t> a = values(o.a), b = values(o.b), old = hard_numbers(random_, kLanes, 8),
                               enable = hard_numbers(random_, kLanes, 1);
    if (o.a.address == o.b.address) b = a;
    elements.put(kD, 8, old);
    if (!o.a.uniform) elements.put(o.a.address, o.a.bytes, a);
    if (!o.b.uniform) elements.put(o.b.address, o.b.bytes, b);
    if (o.d.address != kD) old = elements.get(o.d.address, 8);
    elements.enable(enable);
    elements.run(o);
    const std::vector<std::uint64_t> results = elements.get(o.d.address, 8);
    const bool compares = o.code == Code::Less || o.code == Code::LessEqual || o.code == Code::Equal;
    for (std::size_t n = 0; n < a.size(); ++n) {
      const Number x = number(a[n], o.a.bytes, o.a.is_signed), y = number(b[n], o.b.bytes, o.b.is_signed);
      const std::string where = replay(seed_) + ", code " + std::to_string(static_cast<int>(o.code)) + ", scale " +
                                std::to_string(o.scale) + ", bytes " + std::to_string(o.d.bytes) + " " +
                                std::to_string(o.a.bytes) + (o.a.is_signed ? "s " : "u ") + std::to_string(o.b.bytes) +
                                (o.b.is_signed ? "s" : "u") + ", element " + std::to_string(n) + ": " +
                                std::to_string(a[n]) + ", " + std::to_string(b[n]);
      if (compares) {
        ASSERT_EQ(elements.condition(static_cast<int>(n)), expected(x, y) != 0) << where;
        ASSERT_EQ(results[n], old[n]) << where;
        continue;
      }
      const std::uint64_t mask = low_bytes(-1, o.d.bytes);
      const std::uint64_t written = enable[n] & 1 ? static_cast<std::uint64_t>(expected(x, y)) : old[n];
      ASSERT_EQ(results[n], (old[n] & ~mask) | (written & mask)) << where;
    }
  }

  void compare_all(Code code, int least_scale, int most_scale,
                   const std::function<Number(Number, Number, const Operation&)>& expected) {
    for (int n = 0; n < 400; ++n) {
      Operation o{.code = code, .d = operand(kD), .a = operand(kA), .b = operand(kB)};
      const int scale_limit = code == Code::Divide       ? std::min(most_scale, 15 - o.a.bytes)
                              : code == Code::SquareRoot ? std::min(most_scale, 126 - 8 * o.a.bytes)
                                                         : most_scale;
      o.scale = least_scale + static_cast<int>(random_() % static_cast<std::uint64_t>(scale_limit - least_scale + 1));
      ASSERT_NO_FATAL_FAILURE(compare(o, [&](Number a, Number b) { return expected(a, b, o); }));
    }
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
};

TEST_F(MacroFixed, Sums) {
  compare_all(Code::Copy, 0, 0, [](Number a, Number, const Operation&) { return a; });
  compare_all(Code::Add, 0, 0, [](Number a, Number b, const Operation&) { return a + b; });
  compare_all(Code::Sub, 0, 0, [](Number a, Number b, const Operation&) { return a - b; });
}

TEST_F(MacroFixed, Products) {
  compare_all(Code::Multiply, 0, 16, [](Number a, Number b, const Operation& o) {
    if (a >= 0 && b >= 0) {  // two unsigned numbers fill all 128 bits
      const auto product = static_cast<unsigned __int128>(a) * static_cast<unsigned __int128>(b);
      return o.scale == 16 ? Number{0} : static_cast<Number>(product >> (8 * o.scale));
    }
    return floor_shift(a * b, 8 * o.scale);
  });
}

TEST_F(MacroFixed, Quotients) {
  compare_all(Code::Divide, 0, 15, [](Number a, Number b, const Operation& o) {
    return b == 0 ? Number{0} : floored(a * (Number{1} << (8 * o.scale)), b);
  });
  compare_all(Code::Remainder, 0, 0,
              [](Number a, Number b, const Operation&) { return b == 0 ? Number{0} : a - b * floored(a, b); });
}

TEST_F(MacroFixed, QuotientOfTheLongestDividend) {
  const Operation o{.code = Code::Divide,
                    .d = {.address = kD, .bytes = 8},
                    .a = {.address = kA, .bytes = 8},
                    .b = {.address = kB, .bytes = 8},
                    .scale = 8};
  compare(o, [](Number a, Number b) {
    if (b == 0) return Number{0};
    return static_cast<Number>((static_cast<unsigned __int128>(a) << 64) / static_cast<unsigned __int128>(b));
  });
}

TEST_F(MacroFixed, ShiftsAndRoots) {
  compare_all(Code::ShiftLeft, 0, 64, [](Number a, Number, const Operation& o) {
    return static_cast<Number>(static_cast<unsigned __int128>(a) << o.scale);
  });
  compare_all(Code::ShiftRight, 0, 64, [](Number a, Number, const Operation& o) { return floor_shift(a, o.scale); });
  compare_all(Code::SquareRoot, 0, 118, [](Number a, Number, const Operation& o) {
    return a < 0 ? Number{0} : root(static_cast<Number>(static_cast<unsigned __int128>(a) << o.scale));
  });
}

TEST_F(MacroFixed, Limits) {
  compare_all(Code::Wrap, 1, 64, [](Number a, Number, const Operation& o) {
    const Number modulus = Number{1} << o.scale;
    const Number low = a - modulus * floored(a, modulus);
    return o.d.is_signed && low >= modulus / 2 ? low - modulus : low;
  });
  compare_all(Code::Saturate, 1, 64,
              [](Number a, Number, const Operation& o) { return limited(a, o.scale, o.d.is_signed); });
}

TEST_F(MacroFixed, Comparisons) {
  compare_all(Code::Less, 0, 0, [](Number a, Number b, const Operation&) -> Number { return a < b; });
  compare_all(Code::LessEqual, 0, 0, [](Number a, Number b, const Operation&) -> Number { return a <= b; });
  compare_all(Code::Equal, 0, 0, [](Number a, Number b, const Operation&) -> Number { return a == b; });
}

TEST_F(MacroFixed, ResultInTheOperandsPlace) {
  for (const Code code : {Code::Add, Code::Sub, Code::Multiply}) {
    for (int bytes = 1; bytes <= 8; ++bytes) {
      const Operand same = {.address = kA, .bytes = static_cast<std::uint8_t>(bytes), .is_signed = true};
      compare({.code = code, .d = same, .a = same, .b = same}, [code](Number a, Number b) {
        return code == Code::Add ? a + b : code == Code::Sub ? a - b : a * b;
      });
    }
  }
}

// A float from a fixed-point number: x87's 64 bits of significand hold the number exactly, and one conversion rounds
// it.
TEST_F(MacroFixed, FixedToFloat) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  for (int n = 0; n < 400; ++n) {
    const int scale = static_cast<int>(random_() % 511) - 255;
    Operation o{.code = Code::FixedToFloat,
                .d = operand(kD, 4),
                .a = operand(kA),
                .b = operand(kB),
                .scale = n & 1 ? scale : scale / 8};
    o.flush = (random_() & 1) != 0;
    compare(o, [&](Number a, Number) -> Number {
      const float value = static_cast<float>(std::ldexp(static_cast<long double>(a), -o.scale));
      return std::bit_cast<std::uint32_t>(o.flush && std::fpclassify(value) == FP_SUBNORMAL ? std::copysign(0.0f, value)
                                                                                            : value);
    });
  }
}

}  // namespace
}  // namespace pixelflow_tests
