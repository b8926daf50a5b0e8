// An instruction of the pixel processors as a reader of a listing sees it.
#pragma once

#include <string>

#include "cmodel/pixelflow/instruction.h"
#include "cmodel/pixelflow/operation.h"

namespace pfman {

/// "memory[e7] := 03 where E & K", "E := E and bit 0 of memory[2a]".
std::string instruction_text(const pixelflow::Instruction& instruction);

/// Whether the operation's scale means something, so that a dump shows it: bytes, places, bits or dimensions.
bool takes_scale(pixelflow::Code code);

}  // namespace pfman
