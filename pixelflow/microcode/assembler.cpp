#include "pixelflow/microcode/assembler.h"

namespace pixelflow {
namespace {

template <typename Enum>
std::uint8_t number(Enum value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace

void Assembler::alu(Alu fn, To to, P p, Q q, const AluExtras& e) {
  Instruction i;
  i.kind = Kind::Alu;
  i.fn = number(fn);
  i.p = number(p);
  i.q = number(q);
  i.cin = number(e.cin);
  i.dest = number(to);
  i.gate = number(e.gate);
  i.set_c = e.c;
  i.z = number(e.z);
  i.set_s = e.s;
  i.at = static_cast<std::uint8_t>(e.at);
  i.down = e.down;
  i.addr = static_cast<std::uint8_t>(e.addr);
  i.imm = static_cast<std::uint8_t>(e.imm);
  stream_.push_back(i);
}

void Assembler::wide(Wide fn, const Instruction& rest) {
  Instruction i = rest;
  i.kind = Kind::Wide;
  i.fn = number(fn);
  stream_.push_back(i);
}

void Assembler::multiply(int address, bool signed_x, bool signed_memory) {
  wide(Wide::Multiply, {.p = number(P::X),
                        .q = number(Q::Memory),
                        .set_c = signed_x,
                        .set_s = signed_memory,
                        .addr = static_cast<std::uint8_t>(address)});
}

void Assembler::multiply_constant(int factor, int address, bool signed_factor, bool signed_memory) {
  wide(Wide::Multiply, {.p = number(P::Immediate),
                        .q = number(Q::Memory),
                        .set_c = signed_factor,
                        .set_s = signed_memory,
                        .addr = static_cast<std::uint8_t>(address),
                        .imm = static_cast<std::uint8_t>(factor)});
}

void Assembler::multiply_m_constant(int factor) {
  if (factor == 0) return;
  wide(Wide::Multiply, {.p = number(P::Immediate), .q = number(Q::M), .imm = static_cast<std::uint8_t>(factor)});
}

void Assembler::multiply_x_constant(int factor) {
  if (factor == 0) return;
  wide(Wide::Multiply, {.p = number(P::X), .q = number(Q::Immediate), .imm = static_cast<std::uint8_t>(factor)});
}

void Assembler::shift_right(int log_distance, Fill fill, When when, int x_bit) {
  wide(Wide::ShiftRight, {.p = number(when),
                          .cin = number(fill),
                          .at = static_cast<std::uint8_t>(log_distance),
                          .imm = static_cast<std::uint8_t>(x_bit)});
}

void Assembler::shift_left(int log_distance, When when, int x_bit) {
  wide(Wide::ShiftLeft,
       {.p = number(when), .at = static_cast<std::uint8_t>(log_distance), .imm = static_cast<std::uint8_t>(x_bit)});
}

void Assembler::divide(bool take_quotient, bool shift_in, int bytes) {
  wide(Wide::Divide, {.set_c = take_quotient, .set_s = shift_in, .at = static_cast<std::uint8_t>(bytes - 1)});
}

void Assembler::flag(Flag to, Bit source, bool invert, FlagOp op) {
  stream_.push_back({.kind = Kind::Flag, .fn = number(source), .cin = number(op), .dest = number(to), .set_c = invert});
}

void Assembler::flag_of(Flag to, P p, int bit, bool invert, FlagOp op, int at) {
  stream_.push_back({.kind = Kind::Flag,
                     .fn = number(Bit::OfP),
                     .p = number(p),
                     .cin = number(op),
                     .dest = number(to),
                     .set_c = invert,
                     .at = static_cast<std::uint8_t>(at),
                     .imm = static_cast<std::uint8_t>(bit)});
}

void Assembler::flag_of_memory(Flag to, int address, int bit, bool invert, FlagOp op) {
  stream_.push_back({.kind = Kind::Flag,
                     .fn = number(Bit::OfQ),
                     .q = number(Q::Memory),
                     .cin = number(op),
                     .dest = number(to),
                     .set_c = invert,
                     .addr = static_cast<std::uint8_t>(address),
                     .imm = static_cast<std::uint8_t>(bit)});
}

void Assembler::control(Control what) { stream_.push_back({.kind = Kind::Control, .fn = number(what)}); }

void Assembler::align_right(Fill fill) {
  shift_right(3, fill, When::XBit, 4);
  shift_right(3, fill, When::XBit, 4);
  for (int bit = 3; bit >= 0; --bit) shift_right(bit, fill, When::XBit, bit);
}

void Assembler::normalize() {
  for (int n = 0; n < 3; ++n) shift_left(3, When::Normalize);
  for (int bit = 2; bit >= 0; --bit) shift_left(bit, When::Normalize);
}

}  // namespace pixelflow
