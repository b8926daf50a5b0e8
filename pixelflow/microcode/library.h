// The microcode library: every operation as a stream of instructions (Olano and Lastra 1998, sections 6.1.3 and 6.1.4).
//
// Operands may be the same number; otherwise d must not overlap a or b, and nothing may overlap the workspace. Every
// routine leaves E as it was, writes nothing but d and the workspace, and those only where E is set.
#pragma once

#include "cmodel/pixelflow/program.h"
#include "pixelflow/microcode/assembler.h"

namespace pixelflow {

/// Appends the instructions of one operation to the program, as one step. Throws std::invalid_argument for operands
/// that overlap, leave the memory, or that the operation does not take.
void append(Program& program, const Operation& operation);

/// Appends one step of bare instructions: `write(Assembler&)`.
template <typename Writer>
void append_instructions(Program& program, Writer&& write) {
  const auto first = static_cast<std::uint32_t>(program.instructions.size());
  Assembler assembler(program.instructions);
  write(assembler);
  program.steps.push_back({{}, first, static_cast<std::uint32_t>(program.instructions.size()) - first, 0});
}

/// Appends d := a x + b y + c modulo 2^(8 bytes), of the elements' own column x and row y: a plane in screen space. All
/// are two's complement. Throws std::invalid_argument for a place that leaves the memory.
void append_plane(Program& program, int d, int bytes, std::int64_t a, std::int64_t b, std::int64_t c);

/// Bytes that the operation needs from operation.work on.
int workspace_bytes(const Operation& operation);

/// The operation's name in the language's words, "float_multiply".
const char* name(Code code);

}  // namespace pixelflow
