// Runs a surface through the compiler and the macro level of the pixel processors, and through the reference
// interpreter, and compares all bits of px_shader_color in its declared type.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/reference/number.h"

namespace lower_tests {

using Random = std::mt19937_64;

struct Agreement {
  enum class Kind {
    Agrees,
    Refused,   // by both, with the same error
    TooLarge,  // for pixel memory
    Differs,
  };
  Kind kind = Kind::Agrees;
  std::string text;  ///< of Differs
};

/// A text with a `surface s`, with its operations fused and not. Parameters get hard and random values.
Agreement compare(const std::string& text, std::uint64_t seed);
/// The same, as a test's assertion: true where it ran and agreed.
bool agrees(const std::string& text, std::uint64_t seed);

/// `surface s` whose three components are these expressions, or statements before them, of parameters declared in
/// `parameters` ("varying float a, uniform int n = 3").
std::string surface(const std::string& result, const std::string& parameters, const std::vector<std::string>& results,
                    const std::string& before = "", const std::string& functions = "");

/// Fixed-point types: any, and those at the limits.
reference::Number random_fixed(Random& random, int most_bits = 64);
std::string declared(const reference::Number& number);
int between(Random& random, int first, int last);
template <typename T>
const T& one_of(Random& random, const std::vector<T>& all) {
  return all[static_cast<std::size_t>(between(random, 0, static_cast<int>(all.size()) - 1))];
}

}  // namespace lower_tests
