#include "pixelflow/microcode/float_parts.h"

#include "pixelflow/microcode/routines.h"

namespace pixelflow {

int FloatParts::address(const Operand& operand, int place) {
  if (!operand.uniform) return operand.address;
  for (int n = 0; n < 4; ++n) a_.store_constant(constant_byte(operand, n), place + n);
  return place;
}

void FloatParts::unpack(int address, const FloatPlace& to, bool is_first, FlagOp to_s) {
  a_.clear_w();
  a_.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = address + 2, .c = true});
  a_.alu(Alu::ShiftLeft, To::X, P::Zero, Q::Memory, {.addr = address + 3, .cin = Carry::C});
  a_.alu(Alu::ReverseSub, To::None, P::X, Q::Immediate, {.cin = Carry::One, .c = true});  // C: exponent 0
  a_.flag(Flag::K, Bit::C);
  // A subnormal number counts from 33 down while it is normalised, 32 too many.
  a_.alu(Alu::AddIf, To::X, P::X, Q::Immediate, {.imm = 32, .cin = Carry::K});
  a_.flag(Flag::C, Bit::K, true);
  a_.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = address + 2, .z = ZMode::Set});
  a_.alu(Alu::ShiftRight, To::W, P::Zero, Q::M, {.at = 3, .cin = Carry::C});
  a_.alu(Alu::Or, To::W, P::Zero, Q::Memory, {.addr = address + 1, .at = 2, .z = ZMode::And});
  a_.alu(Alu::Or, To::W, P::Zero, Q::Memory, {.addr = address, .at = 1, .z = ZMode::And});
  if (o_.flush) {
    for (int n = 0; n < 4; ++n) a_.shift_right(3, Fill::Zero, When::K);  // subnormal operands are zeros
  } else {
    for (int n = 0; n < 2; ++n) a_.shift_left(3, When::Normalize);
    for (int bit = 2; bit >= 0; --bit) a_.shift_left(bit, When::Normalize);
  }
  a_.alu(Alu::AddIf, To::Memory, P::X, Q::Immediate, {.addr = to.exponent, .imm = 0x100 - 32, .c = true});
  a_.alu(Alu::NegateIf, To::Memory, P::Zero, Q::Immediate, {.addr = to.exponent + 1, .cin = Carry::C});
  for (int n = 0; n < 3; ++n) a_.store_w(to.mantissa + n, n + 1);
  // Exponent 255: infinite, or NaN where the fraction is not zero.
  a_.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 1, .c = true});
  a_.flag(Flag::S, Bit::C, false, to_s);
  a_.flag(Flag::C, Bit::Z, true, FlagOp::And);
  if (is_first) {
    a_.alu(Alu::Add, To::Memory, P::Zero, Q::Immediate, {.addr = nan(), .cin = Carry::C});
  } else {
    a_.alu(Alu::Add, To::M, P::Zero, Q::Memory, {.addr = nan(), .cin = Carry::C});
    a_.store(P::M, nan());
  }
}

void FloatParts::limit_count() {
  a_.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0x100 - 32, .c = true});
  a_.flag(Flag::K, Bit::C, true);
  a_.alu(Alu::Select, To::X, P::X, Q::Immediate, {.imm = 31});
}

void FloatParts::jam() {
  a_.alu(Alu::AddIf, To::M, P::Zero, Q::Immediate, {.imm = 1});
  a_.alu(Alu::Or, To::W, P::W, Q::M);
}

void FloatParts::pack() {
  // Up where the guard byte is over one half, or one half and the last bit odd: + 0x7F + last bit carries.
  a_.flag_of(Flag::C, P::W, 0, false, FlagOp::Move, 1);
  a_.alu(Alu::Add, To::None, P::W, Q::Immediate, {.imm = 0x7F, .cin = Carry::C, .c = true});
  // The mantissa's top bit adds one to the exponent, which is one too small; so does its carry.
  const int d = o_.d.address;
  a_.alu(Alu::Add, To::Memory, P::W, Q::Immediate, {.addr = d, .at = 1, .cin = Carry::C, .c = true});
  a_.alu(Alu::Add, To::Memory, P::W, Q::Immediate, {.addr = d + 1, .at = 2, .cin = Carry::C, .c = true});
  a_.alu(Alu::Add, To::Memory, P::W, Q::ExponentLow, {.addr = d + 2, .at = 3, .cin = Carry::C, .c = true});
  a_.alu(Alu::Add, To::Memory, P::Zero, Q::ExponentHigh, {.addr = d + 3, .cin = Carry::C});
}

void FloatParts::store_infinity() {
  const int d = o_.d.address;
  a_.store_constant(0, d, Gate::EAndK);
  a_.store_constant(0, d + 1, Gate::EAndK);
  a_.store_constant(0x80, d + 2, Gate::EAndK);
  a_.alu(Alu::Or, To::Memory, P::Immediate, Q::ExponentHigh, {.addr = d + 3, .imm = 0x7F, .gate = Gate::EAndK});
}

void FloatParts::store_nan() {
  const int d = o_.d.address;
  a_.store_constant(0, d, Gate::EAndK);
  a_.store_constant(0, d + 1, Gate::EAndK);
  a_.store_constant(0xC0, d + 2, Gate::EAndK);
  a_.store_constant(0x7F, d + 3, Gate::EAndK);
}

void FloatParts::flush_result() {
  const int d = o_.d.address;
  a_.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = d + 2, .imm = 0x80, .z = ZMode::Set});
  a_.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = d + 3, .imm = 0x7F, .z = ZMode::And});
  a_.flag(Flag::K, Bit::Z);
  for (int n = 0; n < 3; ++n) a_.store_constant(0, d + n, Gate::EAndK);
}

void FloatParts::finish(int sign_a, int sign_b, bool zero_is_nan) {
  // Exponent 255 or more: infinite. X:M is two less than that, or more.
  a_.flag_of(Flag::K, P::X, 7);  // below the smallest exponent
  a_.flag(Flag::Z, Bit::S);
  a_.alu(Alu::Add, To::None, P::M, Q::Immediate, {.imm = 2, .c = true});
  a_.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0xFF, .cin = Carry::C, .s = true});
  a_.flag(Flag::Z, Bit::S, true, FlagOp::Or);
  // A subnormal result: W to the right by what the exponent lacks, and exponent zero.
  a_.alu(Alu::Select, To::Memory, P::Zero, Q::M, {.addr = exponent()});
  a_.alu(Alu::Sub, To::X, P::Zero, Q::M, {.cin = Carry::One});
  a_.alu(Alu::Select, To::X, P::X, Q::Immediate);
  limit_count();
  a_.align_right(Fill::Jam);
  a_.load_x(exponent());
  a_.flag(Flag::K, Bit::WideZero, true);
  a_.alu(Alu::Select, To::X, P::X, Q::Immediate);  // zero has exponent zero
  a_.flag_of_memory(Flag::S, sign_a, 7);
  if (sign_b >= 0) a_.flag_of_memory(Flag::S, sign_b, 7, false, FlagOp::Xor);
  pack();
  a_.flag(Flag::K, Bit::Z);
  store_infinity();
  if (o_.flush) {
    a_.flag(Flag::C, Bit::Z);
    flush_result();
    a_.flag(Flag::K, Bit::C);
  }
  if (zero_is_nan) {  // infinity times zero
    a_.flag(Flag::K, Bit::WideZero, false, FlagOp::And);
    a_.flag_of_memory(Flag::K, nan(), 0, false, FlagOp::Or);
    a_.flag_of_memory(Flag::K, nan(), 1, false, FlagOp::Or);
  } else {
    a_.flag_of_memory(Flag::K, nan(), 0);
    a_.flag_of_memory(Flag::K, nan(), 1, false, FlagOp::Or);
  }
  store_nan();
}

}  // namespace pixelflow
