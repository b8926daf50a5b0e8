// Square root of a float.
#include "pixelflow/microcode/float_parts.h"
#include "pixelflow/microcode/root_steps.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {

void write_float_square_root(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  const int fa = parts.address(o.a, parts.scratch() + 4);
  const FloatPlace x = parts.first();
  constexpr int kBits = 25;  // the mantissa and one bit to round by
  parts.unpack(fa, x, true, FlagOp::Move);
  a.flag(Flag::Z, Bit::S);

  // The mantissa as a fraction in [1/4, 1): one bit lower where the exponent, less its bias, is even. W := its
  // complement.
  a.set_w(0xFF, 0);
  for (int n = 0; n < 3; ++n) {
    a.alu(Alu::Xor, To::W, P::Immediate, Q::Memory, {.addr = x.mantissa + n, .imm = 0xFF, .at = n + 1});
  }
  a.flag(Flag::C, Bit::One);
  a.shift_right(1, Fill::C);
  a.flag_of_memory(Flag::K, x.exponent, 0);
  a.shift_right(0, Fill::C, When::K);
  a.set_x(0);
  a.flag(Flag::K, Bit::One, true);
  const int z = parts.scratch();
  RootSteps steps(a, z, parts.exponent(), kBits, 0, false);
  for (int step = 1; step <= kBits; ++step) steps.step(step);

  // W := the root, its first bit on top. A root of 24 bits or fewer has a clear rounding bit, any other lies off the
  // halves: so the sticky bit may always be set.
  a.flag(Flag::K, Bit::K, true);
  a.alu(Alu::Or, To::W, P::X, Q::Immediate);
  for (int n = 1; n < 4; ++n) a.load_w(z + n, n);
  a.alu(Alu::And, To::W, P::W, Q::Immediate, {.imm = 0x80});
  a.alu(Alu::AddIf, To::W, P::W, Q::Immediate, {.imm = 0x40});
  a.shift_left(0);
  a.alu(Alu::Or, To::W, P::W, Q::Immediate, {.imm = 1});

  // Half the exponent: (e + 125) / 2 is one less than the biased one.
  a.alu(Alu::Add, To::M, P::Immediate, Q::Memory, {.addr = x.exponent, .imm = 125, .c = true});
  a.alu(Alu::Add, To::X, P::Zero, Q::Memory, {.addr = x.exponent + 1, .cin = Carry::C});
  a.flag_of(Flag::C, P::X, 0);
  a.alu(Alu::ShiftRight, To::X, P::Zero, Q::M, {.cin = Carry::C});
  a.flag_of_memory(Flag::S, fa + 3, 7);
  parts.pack();

  a.flag(Flag::K, Bit::Z);
  parts.store_infinity();
  a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = x.mantissa + 2, .z = ZMode::Set});
  a.flag(Flag::K, Bit::Z);  // zero: with its sign
  a.set_x(0);
  for (int n = 0; n < 3; ++n) a.store_constant(0, o.d.address + n, Gate::EAndK);
  a.alu(Alu::Or, To::Memory, P::Zero, Q::ExponentHigh, {.addr = o.d.address + 3, .gate = Gate::EAndK});
  a.flag(Flag::K, Bit::K, true);
  a.flag(Flag::K, Bit::S, false, FlagOp::And);  // below zero
  a.flag_of_memory(Flag::K, parts.nan(), 0, false, FlagOp::Or);
  parts.store_nan();
}

}  // namespace pixelflow
