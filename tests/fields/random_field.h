// Random solids made of solids, twice: as a distance field, and as the question whether a point is inside, which shares
// nothing with it.
#pragma once

#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "scanline/fields/primitives.h"

namespace fields_tests {

inline std::uint64_t seed_or(std::uint64_t own) {
  const char* const text = std::getenv("FIELDS_SEED");
  return text != nullptr ? std::stoull(text) : own;
}
inline std::string replay(std::uint64_t seed) { return "seed " + std::to_string(seed) + " (set FIELDS_SEED to it)"; }

using Random = std::mt19937_64;
double between(Random& random, double low, double high);
glm::dvec3 vector_between(Random& random, double low, double high);

struct RandomField {
  scanline::FieldPointer field;
  std::function<bool(const glm::dvec3&)> is_inside;  ///< empty for a blend, whose surface nothing else defines
  std::string text;
};

/// `depth`: how many levels of operations; bounded unless `with_planes`.
RandomField random_field(Random& random, int depth, bool with_planes);

}  // namespace fields_tests
