// Noise microcode against the definition, one to three dimensions.
#include "cmodel/pixelflow/native/noise.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/microcode/machine.h"
#include "tests/microcode/noise_oracle.h"

using namespace pixelflow;
using namespace pixelflow_test;

namespace {

Operation noise(bool is_float, int dimensions) {
  Operation o;
  o.code = is_float ? Code::NoiseFloat : Code::NoiseFixed;
  o.d = {20, static_cast<std::uint8_t>(is_float ? 4 : 2), false, false, 0};
  o.a = {40, static_cast<std::uint8_t>(is_float ? 4 : 2), !is_float, false, 0};
  o.scale = dimensions;
  o.work = 100;
  return o;
}

double coordinate_of(std::uint16_t bits) { return static_cast<std::int16_t>(bits) / 256.0; }
double coordinate_of(std::uint32_t bits) { return static_cast<double>(std::bit_cast<float>(bits)); }
double result_of(std::uint16_t bits) { return bits / 65536.0; }
double result_of(std::uint32_t bits) { return static_cast<double>(std::bit_cast<float>(bits)); }

// A coordinate near the lattice's cells in three of four cases, anything in the fourth.
std::uint32_t float_coordinate(std::mt19937_64& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  if (random() % 4 == 0) return bits;
  return (bits & 0x807FFFFF) | static_cast<std::uint32_t>(100 + random() % 70) << 23;
}

// `got` within its format's bound of the definition; false where a coordinate is no number, whose noise is NaN.
template <typename Word>
bool expect_defined(int dimensions, const Word* c, Word got, const NoiseFormat& format) {
  double point[3] = {};
  bool finite = true;
  for (int n = 0; n < dimensions; ++n) {
    point[n] = coordinate_of(c[n]);
    finite &= std::isfinite(point[n]);
  }
  if (!finite) {
    EXPECT_TRUE(std::isnan(result_of(got)));
    return false;
  }
  const Bounded noise = noise_by_definition(dimensions, point, format);
  EXPECT_NEAR(result_of(got), noise.value, noise.error) << point[0] << " " << point[1] << " " << point[2];
  return true;
}

class NoiseOf : public testing::TestWithParam<int> {};

TEST_P(NoiseOf, FixedPoints) {
  std::mt19937_64 random(seed());
  const int dimensions = GetParam();
  Program program;
  append(program, noise(false, dimensions));
  for (int round = 0; round < 20000; ++round) {
    Machine machine;
    std::uint16_t c[3], want;
    const std::uint16_t* at[3];
    for (int n = 0; n < 3; ++n) {
      c[n] = static_cast<std::uint16_t>(hard_number(random, 16));
      at[n] = &c[n];
      if (n < dimensions) machine.put(40 + 2 * n, 2, c[n]);
    }
    native::noise_fixed(dimensions, at, &want, 1);
    machine.run(program);
    ASSERT_EQ(machine.get(20, 2), want) << std::hex << c[0] << " " << c[1] << " " << c[2];
    expect_defined(dimensions, c, static_cast<std::uint16_t>(machine.get(20, 2)), kFixedNoise);
    if (HasFailure()) return;
  }
}

TEST_P(NoiseOf, FloatPoints) {
  std::mt19937_64 random(seed());
  const int dimensions = GetParam();
  Program program;
  append(program, noise(true, dimensions));
  for (int round = 0; round < 20000; ++round) {
    Machine machine;
    std::uint32_t c[3], want;
    const std::uint32_t* at[3];
    for (int n = 0; n < 3; ++n) {
      c[n] = float_coordinate(random);
      at[n] = &c[n];
      if (n < dimensions) machine.put(40 + 4 * n, 4, c[n]);
    }
    native::noise_float(dimensions, at, &want, 1);
    machine.run(program);
    ASSERT_EQ(machine.get(20, 4), want) << std::hex << c[0] << " " << c[1] << " " << c[2];
    expect_defined(dimensions, c, static_cast<std::uint32_t>(machine.get(20, 4)), kFloatNoise);
    if (HasFailure()) return;
  }
}

TEST_P(NoiseOf, FixedPointsByDefinition) {
  std::mt19937_64 random(seed());
  for (int round = 0; round < 500000; ++round) {
    std::uint16_t c[3], got;
    const std::uint16_t* at[3] = {&c[0], &c[1], &c[2]};
    for (std::uint16_t& one : c) one = static_cast<std::uint16_t>(random());
    native::noise_fixed(GetParam(), at, &got, 1);
    expect_defined(GetParam(), c, got, kFixedNoise);
    if (HasFailure()) return;
  }
}

TEST_P(NoiseOf, FloatPointsByDefinition) {
  std::mt19937_64 random(seed());
  int finite = 0;
  for (int round = 0; round < 500000; ++round) {
    std::uint32_t c[3], got;
    const std::uint32_t* at[3] = {&c[0], &c[1], &c[2]};
    for (std::uint32_t& one : c) one = float_coordinate(random);
    native::noise_float(GetParam(), at, &got, 1);
    finite += expect_defined(GetParam(), c, got, kFloatNoise) ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(finite, 490000);
}

INSTANTIATE_TEST_SUITE_P(Microcode, NoiseOf, testing::Values(1, 2, 3));

/// Values published with the algorithm: hashes, and gradients within what 24 fraction bits of a coordinate allow.
TEST(NoiseDefinition, HashAndValues) {
  EXPECT_EQ(native::noise_hash(0, 0, 0), 0);
  EXPECT_EQ(native::noise_hash(1, 0, 0), 17);
  EXPECT_EQ(native::noise_hash(0, 1, 0), 142);
  EXPECT_EQ(native::noise_hash(0, 0, 1), 220);
  EXPECT_EQ(native::noise_hash(1, 2, 3), 25);
  EXPECT_EQ(native::noise_hash(255, 255, 255), 5);
  EXPECT_EQ(native::noise_hash(10, 20, 30), 100);
  const float points[4][3] = {{.5f, .5f, .5f}, {1.25f, 2.5f, 3.75f}, {10.1f, 20.2f, 30.3f}, {-.3f, .4f, 7.9f}};
  const double values[4] = {0.5, 0.094604492, 0.191722086, 0.319813248};
  for (int p = 0; p < 4; ++p) {
    std::uint32_t c[3], result;
    const std::uint32_t* at[3];
    for (int n = 0; n < 3; ++n) {
      c[n] = std::bit_cast<std::uint32_t>(points[p][n]);
      at[n] = &c[n];
    }
    native::noise_float(3, at, &result, 1);
    EXPECT_NEAR(2.0 * std::bit_cast<float>(result) - 1.0, values[p],
                4e-6);  // the points are floats here, decimals there
  }
}

}  // namespace
