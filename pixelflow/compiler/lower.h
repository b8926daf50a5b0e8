// From the sized tree to straight code: calls written in place, arrays taken apart into numbers, fixed-point
// expressions into the operations of the microcode library, conditions into masks.
#pragma once

#include "pixelflow/compiler/ir.h"

namespace pfman {

struct LowerOptions {
  /// Conditions go from the comparison to the mask without a byte in between; numbers are read and shifted in place by
  /// whole bytes. Off: every step through memory.
  bool fuse = true;
};

/// One shader. The tree must outlive the code. Errors that only show here: fixed-point steps that no operation can do
/// (E210).
ir::Code lower(const Tree& tree, const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics);

}  // namespace pfman
