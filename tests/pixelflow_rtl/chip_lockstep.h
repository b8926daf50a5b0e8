// A chip of the RTL and the golden elements in lock-step.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_row.h"
#include "tb/pixelflow/pixel_chip.h"

namespace pixelflow_tests {

/// What differs: cycle, instruction, lane, field and both values.
class Mismatch : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LockstepOptions {
  bool every = false;  ///< compare registers and what was written after each instruction, not only at the end
  bool ports = false;  ///< packets come and go, with gaps in every stream of words and packets
  int length = 400;    ///< instructions of a program
};

class ChipLockstep {
 public:
  explicit ChipLockstep(tb::PixelChip& chip);

  /// One random program from a random state, all of it made from the seed. Throws Mismatch, and std::runtime_error when
  /// the chip waits in vain.
  void run(std::uint64_t seed, const LockstepOptions& options);

  std::uint64_t instructions() const { return instructions_; }  ///< compared so far, in all lanes
  std::uint64_t cycles() const { return cycles_; }
  std::uint64_t packets() const { return packets_; }  ///< compared at the composition port

 private:
  class Ports;

  void randomise(std::mt19937_64& random);
  void after_cycle(const pixelflow::Instruction& instruction, int digit, std::uint64_t cycle, bool compare,
                   Ports* ports);
  void step(const pixelflow::Instruction& instruction, Ports* ports);
  void compare_registers(const std::string& where);
  void compare_rows(const std::string& where);
  void compare_row(tb::ChipRow row, int index, const char* name, const std::uint8_t* expected,
                   const std::string& where);
  std::string place() const;

  tb::PixelChip& chip_;
  pixelflow::PixelRow golden_;
  std::vector<pixelflow::Instruction> stream_;
  std::size_t at_ = 0;    ///< the instruction that is executed
  unsigned pending_ = 0;  ///< its digits that are still to come
  std::uint64_t cycle_ = 0;
  std::uint64_t instructions_ = 0, cycles_ = 0, packets_ = 0;
};

}  // namespace pixelflow_tests
