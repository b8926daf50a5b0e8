#include "tests/microcode/machine.h"

#include <cstdio>
#include <cstdlib>

namespace pixelflow_test {

std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* text = std::getenv("PIXELFLOW_SEED");
    const std::uint64_t chosen = text ? std::strtoull(text, nullptr, 0) : 20001998u;
    std::printf("seed %llu (PIXELFLOW_SEED replays it)\n", static_cast<unsigned long long>(chosen));
    return chosen;
  }();
  return value;
}

std::uint64_t hard_number(std::mt19937_64& random, int bits) {
  const std::uint64_t mask = bits >= 64 ? ~0ull : (1ull << bits) - 1;
  std::uint64_t value = random();
  switch (random() % 6) {
    case 0: value = random() % 3; break;
    case 1: value = ~(random() % 3); break;
    case 2: value = 1ull << random() % static_cast<unsigned>(bits); break;
    case 3: value = (1ull << random() % static_cast<unsigned>(bits)) - 1; break;
    case 4: value = value >> random() % static_cast<unsigned>(bits); break;
    default: break;
  }
  return value & mask;
}

}  // namespace pixelflow_test
