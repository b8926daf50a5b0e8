// Fixed point to float and back.
#include <algorithm>

#include "pixelflow/microcode/float_parts.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

/// Workspace of a conversion to float: the magnitude (up to 8 bytes), then a byte of bits lost.
struct ToFloat {
  explicit ToFloat(int work) : magnitude(work), lost(work + 8) {}
  int magnitude, lost;
};

/// Workspace of a conversion to fixed: the bytes that the mantissa moves through, three of them below the point, and
/// the parts of the float, which come before.
struct ToFixed {
  explicit ToFixed(const Operation& o) : buffer(o.work + 6), bytes(o.d.bytes + 3) {}
  int buffer, bytes;
};

}  // namespace

int fixed_to_float_workspace(const Operation& o) { return o.a.bytes > 4 ? 9 : o.a.is_signed ? o.a.bytes : 0; }
int float_to_fixed_workspace(const Operation& o) { return 6 + ToFixed(o).bytes; }

void write_fixed_to_float(Assembler& a, const Operation& o) {
  const ToFloat w(o.work);
  FloatParts parts(a, o);
  const int bytes = o.a.bytes;
  int from = o.a.address;
  if (o.a.is_signed) {  // the magnitude
    load_sign(a, Flag::K, o.a);
    from = w.magnitude;
    for (int n = 0; n < bytes; ++n) {
      a.load_m(o.a.address + n);
      a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate,
            {.addr = from + n, .cin = n ? Carry::C : Carry::K, .c = true});
    }
    load_sign(a, Flag::S, o.a);
  } else {
    a.flag(Flag::S, Bit::One, true);
  }
  // Its upper four bytes in W; X is the exponent of W's top bit.
  for (int at = 0; at < 4; ++at) {
    const int n = bytes - 4 + at;
    if (n >= 0) {
      a.load_w(from + n, at);
    } else {
      a.set_w(0, at);
    }
  }
  a.set_x(127 + 8 * bytes - 1 - o.scale);
  // What lies below W moves up byte by byte while W's top byte is empty and the exponent lasts; a byte left behind
  // counts as lost.
  for (int n = bytes - 5; n >= 0; --n) {
    a.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0x100 - 9, .c = true});  // C: X > 8
    a.alu(Alu::Or, To::None, P::W, Q::Immediate, {.at = 3, .z = ZMode::Set});
    a.flag(Flag::K, Bit::Z);
    a.flag(Flag::K, Bit::C, false, FlagOp::And);
    a.shift_left(3, When::Normalize);
    a.alu(Alu::AddIf, To::W, P::W, Q::Memory, {.addr = from + n});
    a.alu(Alu::Select, To::M, P::Zero, Q::Memory, {.addr = from + n});
    if (n < bytes - 5) a.alu(Alu::Or, To::M, P::M, Q::Memory, {.addr = w.lost});
    a.store(P::M, w.lost);
  }
  a.normalize();
  if (bytes > 4) {
    a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = w.lost, .z = ZMode::Set});
    a.flag(Flag::K, Bit::Z, true);
    parts.jam();
  }
  a.flag(Flag::K, Bit::WideZero, true);
  a.alu(Alu::Select, To::X, P::X, Q::Immediate, {.imm = 1});
  a.alu(Alu::Sub, To::X, P::X, Q::Immediate, {.imm = 1, .cin = Carry::One});
  parts.pack();
  if (o.flush) parts.flush_result();
}

void write_float_to_fixed(Assembler& a, const Operation& o) {
  FloatParts parts(a, o);
  const ToFixed w(o);
  const int fa = o.a.address, d = o.d.address, bytes = o.d.bytes;
  const int sign = o.work, nan = o.work + 1, over = o.work + 2;

  // W := the mantissa in its low three bytes; X := exponent, at least 1.
  a.clear_w();
  a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = fa + 2, .c = true});
  a.alu(Alu::ShiftLeft, To::X, P::Zero, Q::Memory, {.addr = fa + 3, .cin = Carry::C});
  a.alu(Alu::ReverseSub, To::None, P::X, Q::Immediate, {.cin = Carry::One, .c = true});
  a.flag(Flag::K, Bit::C);
  a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.cin = Carry::C});
  a.flag(Flag::C, Bit::C, true);
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = fa + 2, .z = ZMode::Set});
  a.alu(Alu::ShiftRight, To::W, P::Zero, Q::M, {.at = 2, .cin = Carry::C});
  a.alu(Alu::Or, To::W, P::Zero, Q::Memory, {.addr = fa + 1, .at = 1, .z = ZMode::And});
  a.alu(Alu::Or, To::W, P::Zero, Q::Memory, {.addr = fa, .at = 0, .z = ZMode::And});
  if (o.flush) {
    for (int n = 0; n < 4; ++n) a.shift_right(3, Fill::Zero, When::K);
  }
  a.load_m(fa + 3);
  a.store(P::M, sign);
  // NaN: exponent 255 and a fraction.
  a.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 1, .c = true});
  a.flag(Flag::C, Bit::Z, true, FlagOp::And);
  a.alu(Alu::Add, To::Memory, P::Zero, Q::Immediate, {.addr = nan, .cin = Carry::C});

  // The mantissa goes to the left by exponent + scale - 126 places, 24 of them below the point. K: a negative distance,
  // then 0.
  const int offset = o.scale - 126;
  a.alu(Alu::Add, To::M, P::X, Q::Immediate, {.imm = offset & 0xFF, .c = true});
  a.alu(Alu::Add, To::X, P::Zero, Q::Immediate, {.imm = offset >> 8 & 0xFF, .cin = Carry::C});
  a.flag_of(Flag::K, P::X, 7);
  a.alu(Alu::Select, To::M, P::Zero, Q::M);
  if (offset <= 0) a.alu(Alu::Select, To::X, P::Zero, Q::Immediate);  // otherwise X counts, and K is never set
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = 8 * bytes + 1, .cin = Carry::One, .c = true});
  a.alu(Alu::Sub, To::None, P::X, Q::Immediate, {.cin = Carry::C, .c = true});
  a.alu(Alu::Add, To::Memory, P::Zero, Q::Immediate, {.addr = over, .cin = Carry::C});  // beyond all of d
  a.alu(Alu::Or, To::X, P::M, Q::Immediate);

  // Bits of a byte in W, whole bytes in the buffer, one binary digit of the distance at a time.
  for (int bit = 2; bit >= 0; --bit) a.shift_left(bit, When::XBit, bit);
  for (int n = 0; n < w.bytes; ++n) {
    if (n < 4) {
      a.store_w(w.buffer + n, n);
    } else {
      a.store_constant(0, w.buffer + n);
    }
  }
  for (int digit = bytes == 8 ? 3 : 2; digit >= 0; --digit) {
    const int step = 1 << digit;
    a.flag_of(Flag::K, P::X, digit + 3);
    for (int n = w.bytes - 1; n >= 0; --n) {
      if (n >= step) {
        a.load_m(w.buffer + n - step);
      } else {
        a.set_m(0);
      }
      a.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = w.buffer + n});
      a.store(P::M, w.buffer + n);
    }
  }

  // The floor: a negative number is -i, or -i - 1 = ~i where bits lie below the point.
  for (int n = 0; n < 3; ++n)
    a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = w.buffer + n, .z = n ? ZMode::And : ZMode::Set});
  a.flag_of_memory(Flag::K, sign, 7);
  a.flag(Flag::C, Bit::K);
  a.flag(Flag::C, Bit::Z, false, FlagOp::And);
  for (int n = 0; n < bytes; ++n) {
    if (o.d.is_signed) {
      a.load_m(w.buffer + 3 + n);
      a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate, {.addr = d + n, .cin = Carry::C, .c = true});
    } else {
      a.alu(Alu::Select, To::M, P::Zero, Q::Memory, {.addr = w.buffer + 3 + n});
      a.store(P::M, d + n);
    }
  }
  a.flag_of_memory(Flag::S, over, 0);
  if (o.d.is_signed) a.flag_of_memory(Flag::S, w.buffer + 2 + bytes, 7, false, FlagOp::Or);
  a.flag(Flag::K, Bit::K, true);
  a.flag(Flag::K, Bit::S, false, FlagOp::And);
  for (int n = 0; n < bytes; ++n) a.store_constant(o.d.is_signed && n == bytes - 1 ? 0x7F : 0xFF, d + n, Gate::EAndK);
  if (o.d.is_signed) {
    a.flag_of_memory(Flag::K, sign, 7);
    a.flag(Flag::K, Bit::S, false, FlagOp::And);
    for (int n = 0; n < bytes; ++n) a.store_constant(n == bytes - 1 ? 0x80 : 0, d + n, Gate::EAndK);
  }
  a.flag_of_memory(Flag::K, nan, 0);
  for (int n = 0; n < bytes; ++n) a.store_constant(0, d + n, Gate::EAndK);
}

}  // namespace pixelflow
