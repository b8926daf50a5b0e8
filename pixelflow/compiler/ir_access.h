// What instructions read and write, and the editing of code that the passes share.
#pragma once

#include <vector>

#include "pixelflow/compiler/ir.h"

namespace pfman::ir {

enum class Access : std::uint8_t {
  Read,
  Write,   ///< all of the variable
  Update,  ///< a part of it, or all of it after reading
};

/// Bytes that the instruction reads or writes at an operand of pixel memory, from the operand's first byte on.
int extent(const Code& code, const Instruction& instruction, const Operand& operand);

/// How the instruction writes d or an external function its result: Write or Update.
Access access_of_result(const Code& code, const Instruction& instruction, const Operand& result);
/// How an external function accesses an argument. A result in pixel memory is the one behind those of the parameters.
Access access_of_argument(const Code& code, const Instruction& instruction, std::size_t argument);

/// visit(operand, access) for each operand in pixel memory, d last.
template <typename Code_, typename Instruction_, typename Visit>
void each_operand(Code_& code, Instruction_& instruction, Visit&& visit) {
  const auto pixel = [](const Operand& o) { return o.kind == Operand::Kind::Pixel; };
  for (auto* operand : {&instruction.a, &instruction.b, &instruction.condition}) {
    if (pixel(*operand)) visit(*operand, Access::Read);
  }
  for (std::size_t n = 0; n < instruction.arguments.size(); ++n) {
    if (pixel(instruction.arguments[n])) visit(instruction.arguments[n], access_of_argument(code, instruction, n));
  }
  if (pixel(instruction.d)) visit(instruction.d, access_of_result(code, instruction, instruction.d));
}

/// d := a, nothing else: whole single numbers of the same size.
bool is_plain_copy(const Code& code, const Instruction& instruction);

/// visit(a, b) for variables of the instruction that must not share a byte, whatever their lifetimes: the result and an
/// array that is read by an index, what an external function writes and what else it is given.
template <typename Visit>
void keep_apart(const Code& code, const Instruction& instruction, Visit&& visit) {
  using Kind = Operand::Kind;
  const auto pair = [&](const Operand& a, const Operand& b) {
    if (a.kind == Kind::Pixel && b.kind == Kind::Pixel && a.variable != b.variable) visit(a.variable, b.variable);
  };
  const Operand& d = instruction.d;
  if (instruction.a.index >= 0 || d.index >= 0) pair(d, instruction.a);
  if (instruction.b.index >= 0 || d.index >= 0) pair(d, instruction.b);
  for (std::size_t n = 0; n < instruction.arguments.size(); ++n) {
    pair(d, instruction.arguments[n]);
    if (access_of_argument(code, instruction, n) == Access::Read) continue;
    for (const Operand& other : instruction.arguments) pair(instruction.arguments[n], other);
  }
}

/// Variables with addresses that surfaces and lights share: light directions and colours.
bool is_light_variable(const Variable& variable);

/// Variables that somebody uses after the last instruction: a surface's colour, what a light leaves.
std::vector<int> used_at_end(const Code& code);

/// Puts `to[v]` in the place of every variable v: in operands, parameters, colour, mask bytes, φ-functions.
void replace_variables(Code& code, const std::vector<int>& to);
/// Drops variables that nothing mentions any more, and numbers the others anew.
void drop_unmentioned_variables(Code& code);
/// Gives the code mask bytes of its own for the mask bits that the shared byte does not hold.
void add_mask_bytes(Code& code, int bits);
/// Keeps the instructions i with keep[i]; those that go must not be the goal of a match that stays.
void keep_instructions(Code& code, const std::vector<bool>& keep);

}  // namespace pfman::ir
