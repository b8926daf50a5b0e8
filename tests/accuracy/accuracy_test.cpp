// A sample of every exponent and sign of each function, and pairs, against correctly rounded values.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/accuracy/run.h"

namespace {

using pixelflow::native::binary_functions;
using pixelflow::native::BinaryFunction;
using pixelflow::native::unary_functions;
using pixelflow::native::UnaryFunction;

// 2048 arguments an exponent and sign: a prime step, so that low and high bits of the fraction both vary.
constexpr uint64_t kEvery = 4093;
constexpr uint64_t kSeed = 20;

std::string name_of(const auto& tested) { return std::string(tested.param.name); }

std::vector<UnaryFunction> fast_functions() {
  std::vector<UnaryFunction> fast;
  for (const UnaryFunction& function : unary_functions()) {
    if (function.name.starts_with("fast_")) fast.push_back(function);
  }
  return fast;
}

class OneArgument : public testing::TestWithParam<UnaryFunction> {};

TEST_P(OneArgument, IsWithinOneUlpOrInOrder) {
  const UnaryFunction& function = GetParam();
  const accuracy::Tally tally = accuracy::run_arguments(function, 0, uint64_t{1} << 32, kEvery);
  EXPECT_GT(tally.inputs, 1'000'000u);
  EXPECT_EQ(tally.special, 0u);
  if (!function.name.starts_with("fast_")) {
    EXPECT_EQ(tally.further, 0u) << std::hex << tally.worst_x;
    EXPECT_LT(tally.max_ulp, 1.0);
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
  EXPECT_EQ(tally.special, 0u) << std::hex << tally.worst_x << " " << tally.worst_y;
  if (!GetParam().name.starts_with("fast_")) {
    EXPECT_EQ(tally.further, 0u) << std::hex << tally.worst_x << " " << tally.worst_y;
  }
}

TEST_P(TwoArguments, RandomPairs) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const accuracy::Tally tally = accuracy::run_random_pairs(GetParam(), kSeed, 0, 1 << 20);
  EXPECT_EQ(tally.inputs, 1u << 20);
  EXPECT_EQ(tally.special, 0u);
  if (!GetParam().name.starts_with("fast_")) {
    EXPECT_EQ(tally.further, 0u) << std::hex << tally.worst_x << " " << tally.worst_y;
  }
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

}  // namespace
