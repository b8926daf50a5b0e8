// An instruction of the pixel processors as a reader of a listing sees it.
#pragma once

#include <string>

#include "cmodel/pixelflow/instruction.h"

namespace pfman {

/// "memory[e7] := 03 where E & K", "E := E and bit 0 of memory[2a]".
std::string instruction_text(const pixelflow::Instruction& instruction);

}  // namespace pfman
