// Correctly rounded single precision by MPFR, and the values that float arithmetic is tried on.
#pragma once

#include <mpfr.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "cmodel/pixelflow/operation.h"

namespace pixelflow_test {

/// Zeros, subnormal numbers, ends of ranges, infinities, NaNs, powers of two and their neighbours: about 200.
const std::vector<std::uint32_t>& hard_floats();

/// Two numbers that meet often: of near exponents, of nearly cancelling values, at the ends of the range.
std::pair<std::uint32_t, std::uint32_t> random_floats(std::mt19937_64& random);

class FloatOracle {
 public:
  FloatOracle();
  ~FloatOracle();
  FloatOracle(const FloatOracle&) = delete;
  FloatOracle& operator=(const FloatOracle&) = delete;

  std::uint32_t rounded(pixelflow::Code code, std::uint32_t a, std::uint32_t b, bool flush);
  bool compares(pixelflow::Code code, std::uint32_t a, std::uint32_t b, bool flush);
  std::uint32_t from_fixed(std::uint64_t raw, const pixelflow::Operand& type, int scale);
  std::uint64_t to_fixed(std::uint32_t a, const pixelflow::Operand& type, int scale);

 private:
  std::uint32_t bits(int inexact);
  mpfr_t x_, y_, r_, wide_;
};

}  // namespace pixelflow_test
