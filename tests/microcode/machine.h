// One element that runs operations, and the seed of random cases.
#pragma once

#include <cstdint>
#include <random>

#include "cmodel/pixelflow/pixel_element.h"
#include "pixelflow/microcode/library.h"

namespace pixelflow_test {

/// PIXELFLOW_SEED from the environment, or the default; printed once, so that a failure can be replayed.
std::uint64_t seed();

/// A random number of at most `bits` bits that likes hard values: few bits, ends of the range, runs of ones.
std::uint64_t hard_number(std::mt19937_64& random, int bits);

class Machine {
 public:
  Machine() { element.registers.e = true; }

  void put(int address, int bytes, std::uint64_t value) {
    for (int n = 0; n < bytes; ++n)
      element.memory[static_cast<std::size_t>(address + n)] = static_cast<std::uint8_t>(value >> (8 * n));
  }
  std::uint64_t get(int address, int bytes) const {
    std::uint64_t value = 0;
    for (int n = 0; n < bytes; ++n)
      value |= static_cast<std::uint64_t>(element.memory[static_cast<std::size_t>(address + n)]) << (8 * n);
    return value;
  }
  void run(const pixelflow::Program& program) {
    for (const auto& instruction : program.instructions) element.step(instruction);
  }

  pixelflow::PixelElement element;
};

}  // namespace pixelflow_test
