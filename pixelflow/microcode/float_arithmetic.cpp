// Float addition, multiplication and division.
#include "pixelflow/microcode/float_parts.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

/// Workspace of an addition, which does not take its operands apart as the others do.
struct AddPlaces {
  explicit AddPlaces(int work) : big(work), exponent(work + 3), sign(work + 4), b3(work + 5), constant(work + 6) {}
  int big;       ///< mantissa of the operand that is larger in magnitude, three bytes
  int exponent;  ///< its exponent
  int sign;      ///< its top byte
  int b3;        ///< top byte of b, turned round in a subtraction
  int constant;  ///< four bytes for a uniform operand
  static constexpr int kBytes = 10;
};

/// M := byte of the larger operand where K says that this is b.
void select_big(Assembler& a, int in_a, int in_b) {
  a.load_m(in_b);
  a.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = in_a});
}

/// With the top byte of a number's fraction in M and its exponent in X: X at least 1, and the hidden bit into M.
void hidden_bit_into_m(Assembler& a) {
  a.alu(Alu::ReverseSub, To::None, P::X, Q::Immediate, {.cin = Carry::One, .c = true});  // C: exponent 0
  a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.cin = Carry::C});
  a.flag(Flag::C, Bit::C, true);
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::M);
  a.alu(Alu::ShiftRight, To::M, P::Zero, Q::M, {.cin = Carry::C});
}

}  // namespace

int float_add_workspace(const Operation& o) {
  return o.a.uniform || o.b.uniform ? AddPlaces::kBytes : AddPlaces::kBytes - 4;
}
int float_workspace(const Operation&) { return FloatParts::kBytes; }

void write_float_add(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  const AddPlaces w(o.work);
  const int fa = parts.address(o.a, w.constant), fb = parts.address(o.b, w.constant);
  int b3 = fb + 3;
  if (o.code == Code::FloatSub) {
    a.alu(Alu::Xor, To::M, P::Immediate, Q::Memory, {.addr = b3, .imm = 0x80});
    b3 = w.b3;
    a.store(P::M, b3);
  }

  // K: |a| < |b|.
  for (int n = 0; n < 3; ++n) {
    a.load_m(fa + n);
    a.alu(Alu::Sub, To::None, P::M, Q::Memory, {.addr = fb + n, .cin = n ? Carry::C : Carry::One, .c = true});
  }
  a.alu(Alu::And, To::X, P::Immediate, Q::Memory, {.addr = b3, .imm = 0x7F});
  a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = fa + 3, .imm = 0x7F});
  a.alu(Alu::ReverseSub, To::None, P::X, Q::M, {.cin = Carry::C, .c = true});
  a.flag(Flag::K, Bit::C, true);

  // The larger one: mantissa and exponent aside, its sign with its top byte.
  select_big(a, fa + 3, b3);
  a.store(P::M, w.sign);
  for (int n = 0; n < 2; ++n) {
    select_big(a, fa + n, fb + n);
    a.store(P::M, w.big + n);
  }
  select_big(a, fa + 2, fb + 2);
  a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::M, {.c = true});
  a.alu(Alu::ShiftLeft, To::X, P::Zero, Q::Memory, {.addr = w.sign, .cin = Carry::C});
  hidden_bit_into_m(a);
  a.store(P::M, w.big + 2);
  a.store(P::X, w.exponent);

  // The smaller one into W, eight bits of guard below it, and what their exponents differ by into X.
  a.set_w(0, 0);
  for (int n = 0; n < 2; ++n) {
    a.load_m(fa + n);
    a.alu(Alu::Or, To::W, P::Zero, Q::MemoryOrM, {.addr = fb + n, .at = n + 1});
  }
  select_big(a, fb + 2, fa + 2);
  a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::M, {.c = true});
  a.alu(Alu::Or, To::W, P::M, Q::Immediate, {.at = 3});
  select_big(a, b3, fa + 3);
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::M, {.cin = Carry::C});
  a.alu(Alu::ReverseSub, To::None, P::M, Q::Immediate, {.cin = Carry::One, .c = true});  // C: exponent 0
  if (o.flush) a.flag(Flag::Z, Bit::C);
  a.alu(Alu::Add, To::M, P::M, Q::Immediate, {.cin = Carry::C});
  a.alu(Alu::Sub, To::X, P::X, Q::M, {.cin = Carry::One});
  a.flag(Flag::C, Bit::C, true);
  a.alu(Alu::Or, To::M, P::W, Q::Immediate, {.at = 3});
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::M);
  a.alu(Alu::ShiftRight, To::W, P::Zero, Q::M, {.at = 3, .cin = Carry::C});
  if (o.flush) {  // a subnormal operand is zero
    a.flag(Flag::K, Bit::Z);
    for (int n = 0; n < 4; ++n) a.shift_right(3, Fill::Zero, When::K);
    a.alu(Alu::Xor, To::None, P::Immediate, Q::Memory, {.addr = w.exponent, .imm = 1, .z = ZMode::Set});
    a.alu(Alu::And, To::None, P::Immediate, Q::Memory, {.addr = w.big + 2, .imm = 0x80, .z = ZMode::And});
    a.flag(Flag::K, Bit::Z);
    for (int n = 0; n < 3; ++n) a.store_constant(0, w.big + n, Gate::EAndK);
  }
  parts.limit_count();
  a.align_right(Fill::Jam);

  // Sum or difference, exponent, and Z: signs differ.
  a.flag_of_memory(Flag::Z, fa + 3, 7);
  a.flag_of_memory(Flag::Z, b3, 7, false, FlagOp::Xor);
  a.flag(Flag::K, Bit::Z);
  for (int n = 0; n < 4; ++n) {
    AluExtras e{.at = n, .cin = n ? Carry::C : Carry::K, .c = true};
    if (n) e.addr = w.big + n - 1;
    a.alu(Alu::NegateIf, To::W, P::W, n ? Q::Memory : Q::Immediate, e);
  }
  a.flag(Flag::K, Bit::K, true);
  a.flag(Flag::K, Bit::C, false, FlagOp::And);  // K: the sum has one bit more
  a.shift_right(0, Fill::Jam, When::K);
  a.alu(Alu::AddIf, To::W, P::W, Q::Immediate, {.imm = 0x80, .at = 3});
  a.alu(Alu::Add, To::X, P::Zero, Q::Memory, {.addr = w.exponent, .cin = Carry::K});
  a.normalize();
  a.flag(Flag::Z, Bit::WideZero, false, FlagOp::And);  // a difference of zero is positive
  a.flag(Flag::K, Bit::WideZero, true);
  a.alu(Alu::Select, To::X, P::X, Q::Immediate, {.imm = 1});
  a.alu(Alu::Sub, To::X, P::X, Q::Immediate, {.imm = 1, .cin = Carry::One});
  a.flag_of_memory(Flag::S, w.sign, 7);
  a.flag(Flag::S, Bit::Z, true, FlagOp::And);
  parts.pack();

  // Infinite: an operand's exponent is 255, or the result's.
  a.alu(Alu::Xor, To::None, P::X, Q::Immediate, {.imm = 0xFE, .z = ZMode::Set});
  a.flag(Flag::C, Bit::Z);
  a.alu(Alu::Xor, To::None, P::Immediate, Q::Memory, {.addr = w.exponent, .imm = 0xFF, .z = ZMode::Set});
  a.flag(Flag::K, Bit::Z);
  a.flag(Flag::K, Bit::C, false, FlagOp::Or);
  parts.store_infinity();
  a.flag(Flag::K, Bit::Z);
  // NaN: such an operand with a fraction, or two of unlike signs, whose difference is zero.
  a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = w.big + 2, .z = ZMode::Set});
  for (int n = 0; n < 2; ++n) a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = w.big + n, .z = ZMode::And});
  a.flag(Flag::Z, Bit::WideZero, true, FlagOp::And);
  a.flag(Flag::K, Bit::Z, true, FlagOp::And);
  parts.store_nan();
  if (o.flush) parts.flush_result();
}

namespace {

/// X:M := sum or difference of the operands' exponents, plus a constant.
void combine_exponents(Assembler& a, const FloatParts& parts, Alu fn, int offset) {
  a.load_m(parts.first().exponent);
  a.alu(fn, To::M, P::M, Q::Memory,
        {.addr = parts.second().exponent, .cin = fn == Alu::Sub ? Carry::One : Carry::Zero, .c = true});
  a.load_x(parts.first().exponent + 1);
  a.alu(fn, To::X, P::X, Q::Memory, {.addr = parts.second().exponent + 1, .cin = Carry::C});
  a.alu(Alu::Add, To::M, P::M, Q::Immediate, {.imm = offset & 0xFF, .c = true});
  a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.imm = offset >> 8 & 0xFF, .cin = Carry::C});
}

/// Where W's top bit is clear: W one to the left, X:M one less.
void normalize_by_one(Assembler& a) {
  a.flag_of(Flag::K, P::W, 7, true, FlagOp::Move, 3);
  a.shift_left(0, When::K);
  a.alu(Alu::AddIf, To::M, P::M, Q::Immediate, {.imm = 0xFF, .c = true});
  a.alu(Alu::AddIf, To::X, P::X, Q::Immediate, {.imm = 0xFF, .cin = Carry::C});
}

}  // namespace

void write_float_multiply(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  const int fa = parts.address(o.a, parts.scratch()), fb = parts.address(o.b, parts.scratch());
  const FloatPlace x = parts.first(), y = parts.second();
  parts.unpack(fa, x, true, FlagOp::Move);
  parts.unpack(fb, y, false, FlagOp::Or);

  // The 48-bit product: its upper four bytes in W, what is below them only as a sticky bit.
  const int low = parts.exponent();  // unused until the end: first two bytes' OR, then the third and fourth byte
  a.clear_w();
  for (int column = 0; column < 5; ++column) {
    for (int i = 0; i < 3; ++i) {
      const int j = column - i;
      if (j < 0 || j > 2) continue;
      a.load_x(x.mantissa + i);
      a.multiply(y.mantissa + j);
    }
    if (column == 0) a.store_w_down(low);
    if (column == 1) {
      a.alu(Alu::Or, To::None, P::W, Q::Immediate, {.z = ZMode::Set, .down = true});
      a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = low, .z = ZMode::And});
    }
    if (column == 2) a.alu(Alu::Or, To::M, P::W, Q::Immediate, {.down = true});
    if (column == 3) a.store_w_down(low);
  }
  a.shift_left(3);
  a.shift_left(3);
  a.load_w(low, 1);
  a.alu(Alu::Or, To::W, P::M, Q::Immediate);
  a.flag(Flag::K, Bit::Z, true);
  parts.jam();
  combine_exponents(a, parts, Alu::Add, -127);
  normalize_by_one(a);
  parts.finish(fa + 3, fb + 3, true);
}

void write_float_divide(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  const int constant = parts.scratch() + 4;  // quotient below, a uniform operand above
  const int fa = parts.address(o.a, constant), fb = parts.address(o.b, constant);
  const FloatPlace x = parts.first(), y = parts.second();
  const int special = parts.exponent();  // bit 2: a is infinite or NaN
  parts.unpack(fa, x, true, FlagOp::Move);
  a.alu(Alu::Or, To::Memory, P::Zero, Q::Flags, {.addr = special});
  parts.unpack(fb, y, false, FlagOp::Move);
  // What operands decide, kept through the division. S: b is infinite or NaN.
  a.flag_of_memory(Flag::K, special, 2);
  a.flag(Flag::C, Bit::S);
  a.flag(Flag::C, Bit::K, false, FlagOp::And);  // infinity by infinity
  a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = y.mantissa + 2, .z = ZMode::Set});
  a.flag(Flag::K, Bit::Z, false, FlagOp::Or);  // K: infinite, a is or b is zero
  a.alu(Alu::Add, To::M, P::Zero, Q::Memory, {.addr = parts.nan(), .cin = Carry::C});
  a.store(P::M, parts.nan());
  a.flag(Flag::C, Bit::Z);
  a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = x.mantissa + 2, .z = ZMode::Set});
  a.flag(Flag::C, Bit::Z, false, FlagOp::And);  // zero by zero
  a.alu(Alu::Add, To::M, P::Zero, Q::Memory, {.addr = parts.nan(), .cin = Carry::C});
  a.store(P::M, parts.nan());
  a.flag(Flag::S, Bit::Z, false, FlagOp::Or);  // S: zero, a is or b is infinite
  a.alu(Alu::Or, To::Memory, P::Zero, Q::Flags, {.addr = special});

  // 26 bits of the quotient of the mantissas, one before the point, non-restoring: two bits, then three bytes.
  const int quotient = parts.scratch();
  a.clear_w();
  for (int n = 0; n < 3; ++n) a.load_w(x.mantissa + n, n);
  a.flag(Flag::K, Bit::One);
  a.flag(Flag::S, Bit::One, true);
  for (int byte = 3; byte >= 0; --byte) {
    a.set_x(0);
    for (int bit = 0; bit < (byte == 3 ? 2 : 8); ++bit) {
      if (bit > 0 || byte < 3) a.divide(bit > 0, true, 3);
      for (int n = 0; n < 3; ++n) {
        a.alu(Alu::AddSub, To::W, P::W, Q::Memory,
              {.addr = y.mantissa + n, .at = n, .cin = n ? Carry::C : Carry::K, .c = true});
      }
    }
    a.divide(true, false, 3);
    a.store(P::X, quotient + byte);
  }
  a.flag(Flag::K, Bit::K, true);
  for (int n = 0; n < 3; ++n) {  // the true remainder, for the sticky bit
    a.alu(Alu::AddIf, To::W, P::W, Q::Memory,
          {.addr = y.mantissa + n,
           .at = n,
           .cin = n ? Carry::C : Carry::Zero,
           .c = true,
           .z = n ? ZMode::And : ZMode::Set});
  }
  for (int n = 0; n < 4; ++n) a.load_w(quotient + n, n);
  a.shift_left(2);
  a.shift_left(1);
  a.flag(Flag::K, Bit::Z, true);
  parts.jam();
  a.flag_of_memory(Flag::K, special, 2);  // a zero result
  for (int n = 0; n < 4; ++n) a.shift_right(3, Fill::Zero, When::K);
  combine_exponents(a, parts, Alu::Sub, 126);
  normalize_by_one(a);
  a.flag_of_memory(Flag::S, special, 3);
  parts.finish(fa + 3, fb + 3, false);
}

}  // namespace pixelflow
