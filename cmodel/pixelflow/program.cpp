#include "cmodel/pixelflow/program.h"

namespace pixelflow {

std::uint64_t Program::cycles(int multiplier_bits) const {
  std::uint64_t sum = 0;
  for (const Instruction& instruction : instructions)
    sum += static_cast<std::uint64_t>(pixelflow::cycles(instruction, multiplier_bits));
  return sum;
}

}  // namespace pixelflow
