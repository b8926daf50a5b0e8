#include "tests/blocks/random.h"

#include <cstdlib>
#include <iostream>

namespace blocks {

std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* text = std::getenv("VSG_SEED");
    const std::uint64_t number = text == nullptr ? 1970 : std::strtoull(text, nullptr, 10);
    std::cout << "seed " << number << ", replayed by VSG_SEED=" << number << std::endl;
    return number;
  }();
  return value;
}

std::int64_t Random::word(int bits) {
  const std::int64_t greatest = (std::int64_t{1} << (bits - 1)) - 1;
  switch (between(0, 7)) {
    case 0: return between(-2, 2);
    case 1: return greatest - between(0, 2);
    case 2: return -greatest - 1 + between(0, 2);
    default: break;
  }
  const int used = static_cast<int>(between(2, bits));
  const std::int64_t limit = (std::int64_t{1} << (used - 1)) - 1;
  return between(-limit - 1, limit);
}

}  // namespace blocks
