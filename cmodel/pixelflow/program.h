// A program for the array: an instruction stream, and the operations that parts of it carry out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cmodel/pixelflow/instruction.h"
#include "cmodel/pixelflow/operation.h"

namespace pixelflow {

/// A run of instructions. With an operation the macro level computes that instead; both leave the same bytes in memory,
/// the workspace apart, the same E, and where E is set the same K of a comparison. All other registers are unspecified
/// after an operation.
struct Step {
  std::optional<Operation> operation;
  std::uint32_t first = 0;  ///< first instruction of the run
  std::uint32_t count = 0;
  std::uint8_t workspace_bytes = 0;  ///< from operation->work on
};

struct Program {
  std::vector<Instruction> instructions;
  std::vector<Step> steps;  ///< cover the instructions in order, without gaps

  /// Cycles of a run, stalls apart; every level charges these.
  std::uint64_t cycles(int multiplier_bits = kMultiplierBits) const;
};

}  // namespace pixelflow
