// An instruction in words, for messages.
#pragma once

#include <string>

#include "cmodel/pixelflow/instruction.h"

namespace pixelflow_tests {

/// "Alu AddSub P=M Q=Memory cin=C to=M addr=12 set_c z=2": fields that are zero and have no name are left out.
std::string text(const pixelflow::Instruction& instruction);

}  // namespace pixelflow_tests
