// Comparison of floats: false where one is NaN, zeros of either sign are equal.
#include <utility>

#include "pixelflow/microcode/float_parts.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

/// Z := Z and |number| = 0, or without the old Z; in the flushing form also where the number is subnormal.
void test_zero(Assembler& a, int address, bool flush, bool is_first) {
  a.alu(Alu::And, To::None, P::Immediate, Q::Memory,
        {.addr = address + 3, .imm = 0x7F, .z = is_first ? ZMode::Set : ZMode::And});
  if (flush) {
    a.alu(Alu::And, To::None, P::Immediate, Q::Memory, {.addr = address + 2, .imm = 0x80, .z = ZMode::And});
    return;
  }
  for (int n = 0; n < 3; ++n) a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = address + n, .z = ZMode::And});
}

/// C := the number is not NaN.
void test_number(Assembler& a, int address) {
  for (int n = 0; n < 3; ++n) {
    a.alu(Alu::Sub, To::None, P::Immediate, Q::Memory,
          {.addr = address + n, .imm = n == 2 ? 0x80 : 0, .cin = n ? Carry::C : Carry::One, .c = true});
  }
  a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = address + 3, .imm = 0x7F});
  a.alu(Alu::Sub, To::None, P::Immediate, Q::M, {.imm = 0x7F, .cin = Carry::C, .c = true});
}

}  // namespace

int float_compare_workspace(const Operation& o) { return o.a.uniform || o.b.uniform ? 4 : 0; }

void write_float_compare(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  int fa = parts.address(o.a, o.work), fb = parts.address(o.b, o.work);
  const bool equals = o.code == Code::FloatEqual, less = o.code == Code::FloatLess;
  // C: |a| >= |b|; Z: |a| = |b|.
  for (int n = 0; n < 3; ++n) {
    a.load_m(fa + n);
    a.alu(Alu::Sub, To::None, P::M, Q::Memory,
          {.addr = fb + n, .cin = n ? Carry::C : Carry::One, .c = true, .z = n ? ZMode::And : ZMode::Set});
  }
  a.alu(Alu::And, To::X, P::Immediate, Q::Memory, {.addr = fb + 3, .imm = 0x7F});
  a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = fa + 3, .imm = 0x7F});
  a.alu(Alu::ReverseSub, To::None, P::X, Q::M, {.cin = Carry::C, .c = true, .z = ZMode::And});
  a.flag_of_memory(Flag::S, fa + 3, 7);
  if (equals) {
    a.flag_of_memory(Flag::S, fb + 3, 7, false, FlagOp::Xor);
    a.flag(Flag::K, Bit::Z);
    a.flag(Flag::K, Bit::S, true, FlagOp::And);
  } else {
    // Of equal signs: both positive, |a| < |b| (or equal); both negative, |a| > |b| (or equal). K and C.
    a.flag(Flag::K, Bit::C);
    if (less) a.flag(Flag::K, Bit::Z, true, FlagOp::And);
    a.flag(Flag::C, Bit::C, true);
    if (!less) a.flag(Flag::C, Bit::Z, false, FlagOp::Or);
    a.flag(Flag::K, Bit::S, false, FlagOp::And);
    a.flag(Flag::C, Bit::S, true, FlagOp::And);
    a.flag(Flag::K, Bit::C, false, FlagOp::Or);
    // Of unlike signs: the negative one is less.
    a.flag_of_memory(Flag::C, fb + 3, 7);
    a.flag(Flag::C, Bit::S, false, FlagOp::Xor);
    a.flag(Flag::K, Bit::C, true, FlagOp::And);
    a.flag(Flag::C, Bit::S, false, FlagOp::And);
    a.flag(Flag::K, Bit::C, false, FlagOp::Or);
  }
  test_zero(a, fa, o.flush, true);
  test_zero(a, fb, o.flush, false);
  if (less) {
    a.flag(Flag::K, Bit::Z, true, FlagOp::And);
  } else {
    a.flag(Flag::K, Bit::Z, false, FlagOp::Or);
  }
  for (const int number : {fa, fb}) {
    test_number(a, number);
    a.flag(Flag::K, Bit::C, false, FlagOp::And);
  }
}

}  // namespace pixelflow
