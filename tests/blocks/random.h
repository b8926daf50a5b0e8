// Constrained random stimuli. The same numbers in every run, unless VSG_SEED asks for others.
#pragma once

#include <cstdint>
#include <random>

namespace blocks {

/// VSG_SEED of the environment, 1970 without it. Printed once, with how to replay it.
std::uint64_t seed();

class Random {
 public:
  /// `stream` keeps the tests apart: each takes another.
  explicit Random(std::uint64_t stream) : engine_(seed() * 1000003 + stream) {}

  /// From `low` to `high`, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// True once in `n`.
  bool once_in(int n) { return engine_() % static_cast<std::uint64_t>(n) == 0; }
  bool coin() { return once_in(2); }
  /// A signed word of `bits` bits; often near zero or at the ends of the range.
  std::int64_t word(int bits);

 private:
  std::mt19937_64 engine_;
};

}  // namespace blocks
