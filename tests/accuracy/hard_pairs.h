// Operand pairs for functions of two arguments.
#ifndef VSG_TESTS_ACCURACY_HARD_PAIRS_H_
#define VSG_TESTS_ACCURACY_HARD_PAIRS_H_

#include <cstdint>
#include <string_view>
#include <vector>

namespace accuracy {

struct Pairs {
  std::vector<uint32_t> x;
  std::vector<uint32_t> y;
};

// Zeros, subnormal numbers, powers of two and their neighbours, integers around the limits of parity, infinities,
// NaN...
std::vector<uint32_t> hard_values();
// All of them with all of them.
Pairs hard_pairs();
// Pair numbers first to first + count - 1 of a sequence that the seed fixes: arbitrary bits, operands of like size, and
// for pow also bases near 1 with exponents that keep the result in range.
Pairs random_pairs(std::string_view function, uint64_t seed, uint64_t first, uint64_t count);

}  // namespace accuracy

#endif
