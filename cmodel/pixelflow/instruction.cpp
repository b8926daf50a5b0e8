#include "cmodel/pixelflow/instruction.h"

#include <bit>

namespace pixelflow {
namespace {

/// The fields in order from the word's least significant bit, with their widths.
template <typename I, typename F>
void each_field(I& i, F&& field) {
  field(i.imm, 8);
  field(i.addr, 8);
  field(i.down, 1);
  field(i.at, 2);
  field(i.set_s, 1);
  field(i.z, 2);
  field(i.set_c, 1);
  field(i.gate, 2);
  field(i.dest, 3);
  field(i.cin, 2);
  field(i.q, 3);
  field(i.p, 3);
  field(i.fn, 4);
  field(i.kind, 2);
}

}  // namespace

std::uint64_t pack(const Instruction& instruction) {
  std::uint64_t word = 0;
  int at = 0;
  each_field(instruction, [&](const auto& value, int width) {
    word |= (static_cast<std::uint64_t>(value) & ((1u << width) - 1)) << at;
    at += width;
  });
  return word;
}

Instruction unpack(std::uint64_t word) {
  Instruction instruction;
  int at = 0;
  each_field(instruction, [&](auto& value, int width) {
    value = static_cast<std::remove_reference_t<decltype(value)>>(word >> at & ((1u << width) - 1));
    at += width;
  });
  return instruction;
}

unsigned digits(const Instruction& i, int multiplier_bits) {
  const int count = 8 / multiplier_bits;
  if (i.p != static_cast<std::uint8_t>(P::Immediate)) return (1u << count) - 1;
  unsigned set = 0;
  for (int d = 0; d < count; ++d) {
    if (i.imm >> (d * multiplier_bits) & ((1 << multiplier_bits) - 1)) set |= 1u << d;
  }
  return set ? set : 1u;
}

int cycles(const Instruction& i, int multiplier_bits) {
  const bool multiplies = i.kind == Kind::Wide && i.fn == static_cast<std::uint8_t>(Wide::Multiply);
  return multiplies ? std::popcount(digits(i, multiplier_bits)) : 1;
}

bool writes_memory(const Instruction& i) {
  return i.kind == Kind::Alu && i.dest == static_cast<std::uint8_t>(To::Memory);
}

bool reads_memory(const Instruction& i) {
  if (i.kind == Kind::Control || writes_memory(i)) return false;
  if (i.kind == Kind::Wide && i.fn != static_cast<std::uint8_t>(Wide::Multiply)) return false;
  return i.q == static_cast<std::uint8_t>(Q::Memory) || i.q == static_cast<std::uint8_t>(Q::MemoryOrM);
}

}  // namespace pixelflow
