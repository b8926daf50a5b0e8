// The seed of a random test: PIXELFLOW_SEED where that is set, otherwise the test's own. It is printed where a test
// fails.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

namespace pixelflow_tests {

inline std::uint64_t seed_or(std::uint64_t own) {
  const char* const text = std::getenv("PIXELFLOW_SEED");
  return text != nullptr ? std::stoull(text) : own;
}

inline std::string replay(std::uint64_t seed) { return "seed " + std::to_string(seed) + " (set PIXELFLOW_SEED to it)"; }

}  // namespace pixelflow_tests
