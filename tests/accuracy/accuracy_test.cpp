// A sample of every exponent and sign of each function, and pairs, against correctly rounded values.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/accuracy/bounds.h"
#include "tests/accuracy/run.h"

namespace {

using pixelflow::native::binary_functions;
using pixelflow::native::BinaryFunction;
using pixelflow::native::unary_functions;
using pixelflow::native::UnaryFunction;

// 2048 arguments an exponent and sign: a prime step, so that low and high bits of the fraction both vary.
constexpr uint64_t kEvery = 4093;

uint64_t seed() {
  static const uint64_t value = [] {
    const char* const text = std::getenv("PIXELFLOW_SEED");
    const uint64_t chosen = text != nullptr ? std::strtoull(text, nullptr, 0) : 20u;
    std::printf("seed %llu (PIXELFLOW_SEED replays it)\n", static_cast<unsigned long long>(chosen));
    return chosen;
  }();
  return value;
}

bool is_fast(std::string_view name) { return name.starts_with("fast_"); }

// What every run of a function must fulfil.
void expect_accurate(std::string_view name, const accuracy::Tally& tally) {
  EXPECT_EQ(tally.special, 0u) << std::hex << tally.worst_x << " " << tally.worst_y;
  if (is_fast(name)) {
    const accuracy::Bound bound = accuracy::bound_of(name);
    EXPECT_LE(tally.max_relative, bound.relative) << std::hex << tally.worst_x << " " << tally.worst_y;
    EXPECT_LE(tally.max_absolute, bound.absolute) << std::hex << tally.worst_x << " " << tally.worst_y;
  } else {
    EXPECT_EQ(tally.further, 0u) << std::hex << tally.worst_x << " " << tally.worst_y;
    EXPECT_LT(tally.max_ulp, 1.0);
  }
}

std::string name_of(const auto& tested) { return std::string(tested.param.name); }

std::vector<UnaryFunction> fast_functions() {
  std::vector<UnaryFunction> fast;
  for (const UnaryFunction& function : unary_functions()) {
    if (is_fast(function.name)) fast.push_back(function);
  }
  return fast;
}

class OneArgument : public testing::TestWithParam<UnaryFunction> {};

TEST_P(OneArgument, IsWithinOneUlpOrTheMethodsError) {
  const accuracy::Tally tally = accuracy::run_arguments(GetParam(), 0, uint64_t{1} << 32, kEvery);
  EXPECT_GT(tally.inputs, 1'000'000u);
  expect_accurate(GetParam().name, tally);
}

TEST_P(OneArgument, IsFiniteWhereTheTruthIs) {
  // Around 128, 128 ln 2, the infinities, zero, and the ends of the domains.
  for (const uint32_t centre : {0x00000000u, 0x3F800000u, 0x42B17218u, 0x43000000u, 0x7F800000u, 0x80000000u,
                                0xBF800000u, 0xC2CFF1B5u, 0xC3160000u, 0xFF800000u}) {
    const uint64_t first = centre < 20'000 ? 0 : centre - 20'000;
    const accuracy::Tally tally = accuracy::run_arguments(GetParam(), first, 40'000, 1);
    EXPECT_EQ(tally.inputs, 40'000u);
    expect_accurate(GetParam().name, tally);
  }
}

class FastOneArgument : public testing::TestWithParam<UnaryFunction> {};

TEST_P(FastOneArgument, KeepsTheOrderOfNeighbours) {
  // Around the joins of the reduced range and where the cubics are flat: powers of two, pi/4, pi/2 and pi, 1/sqrt(2),
  // and small angles, whose cosines lie closest.
  for (const uint32_t centre : {0x33800000u, 0x39CDB94Cu, 0x3AFE1168u, 0x3F000000u, 0x3F3504F3u, 0x3F490FDBu,
                                0x3F800000u, 0x3FC90FDBu, 0x40000000u, 0x40490FDBu, 0x4096CBE4u}) {
    for (const uint32_t sign : {0u, 0x80000000u}) {
      const accuracy::Tally tally = accuracy::run_arguments(GetParam(), (sign | centre) - 20'000, 40'000, 1);
      EXPECT_EQ(tally.disorder, 0u) << std::hex << tally.disorder_x;
      EXPECT_EQ(tally.inputs, 40'000u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Accuracy, OneArgument, testing::ValuesIn(unary_functions().begin(), unary_functions().end()),
                         [](const auto& tested) { return name_of(tested); });

// The exhaustive run judges the order within its chunks of 2^24 arguments; these are the pairs between them.
TEST_P(FastOneArgument, KeepsTheOrderBetweenChunks) {
  uint64_t inputs = 0;
  for (uint64_t first = uint64_t{1} << 24; first < uint64_t{1} << 32; first += uint64_t{1} << 24) {
    const accuracy::Tally tally = accuracy::run_arguments(GetParam(), first - 4, 8, 1);
    EXPECT_EQ(tally.disorder, 0u) << std::hex << tally.disorder_x;
    inputs += tally.inputs;
  }
  EXPECT_EQ(inputs, 255u * 8);
}

INSTANTIATE_TEST_SUITE_P(Accuracy, FastOneArgument, testing::ValuesIn(fast_functions()),
                         [](const auto& tested) { return name_of(tested); });

class TwoArguments : public testing::TestWithParam<BinaryFunction> {};

TEST_P(TwoArguments, HardPairs) {
  const accuracy::Tally tally = accuracy::run_hard_pairs(GetParam());
  EXPECT_GT(tally.inputs, 20'000u);
  expect_accurate(GetParam().name, tally);
}

TEST_P(TwoArguments, RandomPairs) {
  SCOPED_TRACE("PIXELFLOW_SEED=" + std::to_string(seed()));
  const accuracy::Tally tally = accuracy::run_random_pairs(GetParam(), seed(), 0, 1 << 20);
  EXPECT_EQ(tally.inputs, 1u << 20);
  expect_accurate(GetParam().name, tally);
}

INSTANTIATE_TEST_SUITE_P(Accuracy, TwoArguments,
                         testing::ValuesIn(binary_functions().begin(), binary_functions().end()),
                         [](const auto& tested) { return name_of(tested); });

const UnaryFunction& unary(std::string_view name) {
  for (const UnaryFunction& function : unary_functions()) {
    if (function.name == name) return function;
  }
  throw std::invalid_argument(std::string(name));
}

double at(const UnaryFunction& function, double x) {
  const uint32_t bits = std::bit_cast<uint32_t>(static_cast<float>(x));
  uint32_t result = 0;
  function.batch(&bits, &result, 1);
  return static_cast<double>(std::bit_cast<float>(result));
}

struct Join {
  std::string_view function;
  double x;
  double value;  // of the true function, which the cubics meet there
  double slope;
};

class Joins : public testing::TestWithParam<Join> {};

// The slope from either side, extrapolated from two secants so that the curvature falls out.
TEST_P(Joins, MeetValueAndSlope) {
  const Join& join = GetParam();
  const UnaryFunction& function = unary(join.function);
  const double here = at(function, join.x);
  EXPECT_NEAR(here, join.value, 2e-7 * std::max(1.0, std::fabs(join.value)));
  for (const double side : {-1.0, 1.0}) {
    const double step = side / 256;
    const double near = (at(function, join.x + step) - here) / step;
    const double far = (at(function, join.x + 2 * step) - here) / (2 * step);
    EXPECT_NEAR(2 * near - far, join.slope, 1e-3 * std::max(1.0, join.slope)) << "side " << side;
  }
}

INSTANTIATE_TEST_SUITE_P(Accuracy, Joins,
                         testing::Values(Join{"fast_sin", 0, 0, 1}, Join{"fast_sin", M_PI / 2, 1, 0},
                                         Join{"fast_cos", M_PI / 2, 0, -1}, Join{"fast_cos", M_PI, -1, 0},
                                         Join{"fast_tan", 0, 0, 1}, Join{"fast_tan", M_PI / 4, 1, 2},
                                         Join{"fast_asin", 0.5, M_PI / 6, 2 / std::sqrt(3)},
                                         Join{"fast_acos", 0.5, M_PI / 3, -2 / std::sqrt(3)},
                                         Join{"fast_acos", -0.5, 2 * M_PI / 3, -2 / std::sqrt(3)},
                                         Join{"fast_atan", 1, M_PI / 4, 0.5}, Join{"fast_atan", -1, -M_PI / 4, 0.5},
                                         Join{"fast_exp2", 0, 1, M_LN2}, Join{"fast_exp2", 1, 2, 2 * M_LN2},
                                         Join{"fast_exp", 0, 1, 1}, Join{"fast_log2", 1, 0, 1 / M_LN2},
                                         Join{"fast_log2", 2, 1, 0.5 / M_LN2}, Join{"fast_log", 1, 0, 1}));

double fast_atan2(double y, double x) {
  const uint32_t y_bits = std::bit_cast<uint32_t>(static_cast<float>(y));
  const uint32_t x_bits = std::bit_cast<uint32_t>(static_cast<float>(x));
  uint32_t result = 0;
  for (const BinaryFunction& function : binary_functions()) {
    if (function.name == "fast_atan2") function.batch(&y_bits, &x_bits, &result, 1);
  }
  return static_cast<double>(std::bit_cast<float>(result));
}

// The diagonals, where y and x change places in the quotient, and the axes, in eighths of a turn. The points beside a
// join are a 256th of a radian away; across the negative x axis the angle jumps, and either side meets its own value.
class JoinsOfFastAtan2 : public testing::TestWithParam<int> {};

TEST_P(JoinsOfFastAtan2, MeetValueAndSlope) {
  const double angle = GetParam() * (M_PI / 4);
  for (const double radius : {1e-30, 1.0, 3.0, 1e30}) {
    const auto at_angle = [radius](double a) { return fast_atan2(radius * std::sin(a), radius * std::cos(a)); };
    // On the axes the sine or cosine of a rounded angle is not zero, but what it is there changes nothing below 1e-15.
    const double here = at_angle(angle);
    EXPECT_NEAR(here, angle, 2e-7 * std::max(1.0, std::fabs(angle))) << radius;
    for (const double side : {-1.0, 1.0}) {
      const double step = side / 256;
      if (std::fabs(angle + step) > M_PI) continue;
      const double near = (at_angle(angle + step) - here) / step;
      const double far = (at_angle(angle + 2 * step) - here) / (2 * step);
      EXPECT_NEAR(2 * near - far, 1, 1e-3) << "side " << side << " radius " << radius;
      const double close = at_angle(angle + side * 0x1p-22);
      EXPECT_NEAR(close, here, 1e-6) << "side " << side << " radius " << radius;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Accuracy, JoinsOfFastAtan2, testing::Range(-4, 5));

TEST(FastAtan2, NeighboursOfTheDiagonalsAreClose) {
  for (const float y : {1.0F, -1.0F}) {
    for (const float x : {1.0F, -1.0F}) {
      const auto wide = [](float value) { return static_cast<double>(value); };
      const double on = fast_atan2(wide(y), wide(x));
      EXPECT_NEAR(on, std::atan2(wide(y), wide(x)), 5e-7);
      EXPECT_NEAR(fast_atan2(wide(std::nextafter(y, 2 * y)), wide(x)), on, 5e-7);
      EXPECT_NEAR(fast_atan2(wide(y), wide(std::nextafter(x, 2 * x))), on, 5e-7);
    }
  }
}

TEST(Recorded, ErrorsAreThoseOfTheFunctions) {
  std::ifstream file(std::string(VSG_TABLES_DIR) + "/pixelflow_accuracy.json");
  ASSERT_TRUE(file);
  const nlohmann::json recorded = nlohmann::json::parse(file);
  for (const auto& [name, fingerprint] : accuracy::fingerprints()) {
    ASSERT_TRUE(recorded.contains(name)) << name;
    EXPECT_EQ(recorded.at(name).at("fingerprint"), fingerprint)
        << name << " has changed since its errors were recorded: scripts/functions accuracy";
    const double error = recorded.at(name).at("max_error_ulp");
    EXPECT_GE(error, 0.5) << name;
    if (!is_fast(name)) {
      EXPECT_LT(error, 1.0) << name;
    }
  }
  EXPECT_EQ(recorded.size(), accuracy::fingerprints().size() + 1);  // and where they come from
}

TEST(Comparison, InfinityForANumberIsSpecial) {
  const uint32_t x = 0;
  const uint32_t largest = 0x7F7FFFFF;
  const uint32_t infinity = 0x7F800000;
  const uint32_t nan = 0x7FC00000;
  const double below = 0x1.fffffep127;
  const double above = 0x1.ffffffp127;  // rounds to infinity
  EXPECT_EQ(accuracy::compare(&x, nullptr, &infinity, &below, &largest, 1, false).special, 1u);
  EXPECT_EQ(accuracy::compare(&x, nullptr, &nan, &below, &largest, 1, false).special, 1u);
  EXPECT_EQ(accuracy::compare(&x, nullptr, &largest, &above, &infinity, 1, false).special, 1u);
  EXPECT_EQ(accuracy::compare(&x, nullptr, &largest, &below, &largest, 1, false).special, 0u);
}

TEST(Run, PassesOnWhatAChunkThrows) {
  const auto fail = []() -> accuracy::Tally { throw std::runtime_error("no such chunk"); };
  const std::vector<accuracy::Chunk> chunks(8, accuracy::Chunk{"f", "f", 1, fail});
  for (const unsigned threads : {1u, 4u}) EXPECT_THROW(accuracy::run(chunks, "", threads, {}), std::runtime_error);
}

}  // namespace
