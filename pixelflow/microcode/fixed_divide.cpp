// Quotient and remainder of fixed-point numbers: non-restoring, a bit at a time. The remainder's low four bytes lie in
// W, what is above them in the workspace; X holds the dividend's byte and takes the quotient's.
#include <algorithm>
#include <utility>

#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

constexpr int kWide = 4;  // bytes of W

/// Where the parts of a division lie in the workspace.
struct Layout {
  bool divides = false;    ///< quotient, not remainder
  bool is_signed = false;  ///< operands are made positive first
  int a = 0, b = 0;        ///< operands as the loop reads them
  int quotient = 0;        ///< where the loop puts the quotient
  int high = 0;            ///< remainder above W
  int signs = 0;           ///< bit 0: sign of a, bit 1: sign of b
  int end = 0;
};

Layout layout(const Operation& o) {
  Layout l;
  l.divides = o.code == Code::Divide;
  l.is_signed = o.a.is_signed || o.b.is_signed;
  int next = o.work;
  const auto take = [&](int bytes) { return std::exchange(next, next + bytes); };
  l.a = o.a.address;
  l.b = o.b.address;
  if (o.a.is_signed || o.a.uniform) l.a = take(o.a.bytes);
  if (o.b.is_signed && !o.b.uniform) l.b = take(o.b.bytes);
  const Operand b{.address = static_cast<std::uint8_t>(l.b), .bytes = o.b.bytes, .uniform = o.b.uniform};
  l.quotient = o.d.address;
  if (!l.divides || overlap(o.d, b)) l.quotient = take(l.divides ? o.d.bytes : 0);
  l.high = take(std::max(0, o.b.bytes - kWide));
  l.signs = take(1);
  l.end = next;
  return l;
}

std::uint64_t magnitude(const Operand& o) { return o.is_signed && o.constant >> 63 ? ~o.constant + 1 : o.constant; }

/// to := (K ? ~from : from) + first.
void negate_if(Assembler& a, int from, int to, int bytes, Carry first) {
  for (int n = 0; n < bytes; ++n) {
    a.load_m(from + n);
    a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate, {.addr = to + n, .cin = n ? Carry::C : first, .c = true});
  }
}

/// to := |number|, and the number's sign into K; a uniform number's magnitude is a constant.
void write_magnitude(Assembler& a, const Operand& number, int to) {
  load_sign(a, Flag::K, number);
  if (!number.uniform) negate_if(a, number.address, to, number.bytes, Carry::K);
}

/// The loop's state: how many divisor bytes are in W and above.
struct Divisor {
  int address;
  bool uniform;
  std::uint64_t constant;
  int bytes;
  int low() const { return std::min(bytes, kWide); }
  int high() const { return std::max(0, bytes - kWide); }

  /// One byte of W changed by a byte of the divisor.
  void change(Assembler& a, Alu fn, int n, Carry first) const {
    AluExtras e{.at = n, .cin = n ? Carry::C : first, .c = true};
    if (uniform) {
      e.imm = static_cast<int>(constant >> (8 * n) & 0xFF);
      a.alu(fn, To::W, P::W, Q::Immediate, e);
    } else {
      e.addr = address + n;
      a.alu(fn, To::W, P::W, Q::Memory, e);
    }
  }

  /// The remainder, W and what is above it, plus or minus the divisor.
  void change_all(Assembler& a, Alu fn, Carry first, int above) const {
    for (int n = 0; n < low(); ++n) change(a, fn, n, first);
    for (int n = 0; n < high(); ++n) {
      a.load_m(above + n);
      if (uniform) {
        a.alu(fn, To::M, P::M, Q::Immediate,
              {.imm = static_cast<int>(constant >> (8 * (n + kWide)) & 0xFF), .cin = Carry::C, .c = true});
      } else {
        a.alu(fn, To::M, P::M, Q::Memory, {.addr = address + kWide + n, .cin = Carry::C, .c = true});
      }
      a.store(P::M, above + n);
    }
  }

  /// Moves the remainder's upper bytes to the left by one; S brings W's top bit and takes theirs.
  void shift_high(Assembler& a, int above) const {
    if (high() == 0) return;
    a.flag(Flag::C, Bit::S);
    for (int n = 0; n < high(); ++n) {
      a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = above + n, .cin = Carry::C, .c = true});
      a.store(P::M, above + n);
    }
    a.flag(Flag::S, Bit::C);
  }
};

}  // namespace

int divide_workspace(const Operation& o) { return layout(o).end - o.work; }

void write_divide(Assembler& a, const Operation& o) {
  const Layout l = layout(o);
  const Divisor b{l.b, o.b.uniform, magnitude(o.b), o.b.bytes};
  // Signs, and magnitudes where needed. The byte of signs is made from K through the flag byte, bit by bit.
  const auto remember = [&](int bit, bool first) {  // signs := signs with `bit` from K
    if (first) {
      a.set_m(0);
    } else {
      a.load_m(l.signs);
    }
    a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = l.signs, .imm = 1 << bit});
  };
  bool first_sign = true;
  if (o.a.uniform) {
    const std::uint64_t value = magnitude(o.a);
    for (int n = 0; n < o.a.bytes; ++n) a.store_constant(static_cast<int>(value >> (8 * n) & 0xFF), l.a + n);
  }
  if (o.a.is_signed) {
    write_magnitude(a, o.a, l.a);
    remember(0, std::exchange(first_sign, false));
  }
  if (o.b.is_signed) {
    write_magnitude(a, o.b, l.b);
    remember(1, std::exchange(first_sign, false));
  }

  a.clear_w();
  for (int n = 0; n < b.high(); ++n) a.store_constant(0, l.high + n);
  a.flag(Flag::K, Bit::One);  // the remainder, zero, is not negative
  const int dividend = o.a.bytes + (l.divides ? o.scale : 0);
  for (int n = dividend - 1; n >= 0; --n) {
    const int source = n - (l.divides ? o.scale : 0);
    if (source < 0) {
      a.set_x(0);
    } else {
      a.load_x(l.a + source);
    }
    for (int bit = 0; bit < 8; ++bit) {
      a.divide(bit > 0, true, b.low());
      b.shift_high(a, l.high);
      b.change_all(a, Alu::AddSub, Carry::K, l.high);
    }
    a.divide(true, false, b.low());
    if (l.divides && n < o.d.bytes) a.store(P::X, l.quotient + n);
  }
  for (int n = dividend; l.divides && n < o.d.bytes; ++n) a.store_constant(0, l.quotient + n);

  const bool remainder_wanted = !l.divides || l.is_signed;
  if (remainder_wanted) {  // W := the true remainder
    a.flag(Flag::K, Bit::K, true);
    b.change_all(a, Alu::AddIf, Carry::Zero, l.high);
  }
  const auto zero_remainder = [&](Flag to, bool invert) {
    for (int n = 0; n < b.high(); ++n)
      a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = l.high + n, .z = n ? ZMode::And : ZMode::Set});
    for (int n = 0; n < b.low(); ++n)
      a.alu(Alu::Or, To::None, P::W, Q::Immediate, {.at = n, .z = n || b.high() ? ZMode::And : ZMode::Set});
    a.flag(to, Bit::Z, invert);
  };
  const auto sign_bit = [&](Flag to, int bit, FlagOp op) { a.flag_of_memory(to, l.signs, bit, false, op); };
  const bool sa = o.a.is_signed, sb = o.b.is_signed;

  if (l.divides) {
    if (l.is_signed) {  // unlike signs: the floor of the negative quotient is -q - (remainder != 0)
      zero_remainder(Flag::S, false);
      a.flag(Flag::K, Bit::One, true);
      if (sa) sign_bit(Flag::K, 0, FlagOp::Xor);
      if (sb) sign_bit(Flag::K, 1, FlagOp::Xor);
      a.flag(Flag::C, Bit::S);  // -q is ~q + 1
      a.flag(Flag::C, Bit::K, false, FlagOp::And);
      negate_if(a, l.quotient, l.quotient, o.d.bytes, Carry::C);
    }
  } else {
    // The remainder has b's sign: with r >= 0 of the magnitudes, a < 0 turns it to |b| - r where r != 0, and b < 0
    // negates.
    if (l.is_signed) {
      zero_remainder(Flag::S, true);  // S: r != 0
      a.flag(Flag::K, Bit::One, true);
      if (sa) sign_bit(Flag::K, 0, FlagOp::Xor);
      if (sb) sign_bit(Flag::K, 1, FlagOp::Xor);
      a.flag(Flag::K, Bit::S, false, FlagOp::And);  // unlike signs and r != 0: |b| - r
      for (int n = 0; n < b.low(); ++n) {
        a.alu(Alu::NegateIf, To::W, P::W, Q::Immediate, {.at = n, .cin = n ? Carry::C : Carry::K, .c = true});
      }
      negate_if(a, l.high, l.high, b.high(), Carry::C);
      b.change_all(a, Alu::AddIf, Carry::Zero, l.high);
      if (sb) sign_bit(Flag::K, 1, FlagOp::Move);
    }
  }

  // Division by zero gives zero: S := (b = 0), before d is written over b.
  const bool by_zero = !o.b.uniform || b.constant == 0;
  if (!o.b.uniform) {
    for (int n = 0; n < o.b.bytes; ++n) {
      a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = l.b + n, .z = n ? ZMode::And : ZMode::Set});
    }
    a.flag(Flag::S, Bit::Z);
  } else if (by_zero) {
    a.flag(Flag::S, Bit::One);
  }

  if (!l.divides) {  // d := remainder, negated where K, which holds b's sign
    const bool negates = sb;
    const bool fills = o.d.bytes > o.b.bytes && negates;
    for (int n = 0; n < o.d.bytes; ++n) {
      const AluExtras e{.addr = o.d.address + n, .cin = n ? Carry::C : Carry::K, .c = true};
      if (n < b.low()) {
        AluExtras w = e;
        w.at = n;
        a.alu(negates ? Alu::NegateIf : Alu::Or, To::Memory, P::W, Q::Immediate,
              negates ? w : AluExtras{.addr = e.addr, .at = n});
      } else if (n < o.b.bytes) {
        a.load_m(l.high + n - kWide);
        a.alu(negates ? Alu::NegateIf : Alu::Or, To::Memory, P::M, Q::Immediate,
              negates ? e : AluExtras{.addr = e.addr});
      } else if (fills) {
        a.alu(Alu::NegateIf, To::Memory, P::Zero, Q::Immediate, e);
      } else {
        a.store_constant(0, e.addr);
      }
    }
  } else if (l.quotient != o.d.address) {
    for (int n = 0; n < o.d.bytes; ++n) {
      a.load_m(l.quotient + n);
      a.store(P::M, o.d.address + n);
    }
  }
  if (by_zero) {
    a.flag(Flag::K, Bit::S);
    for (int n = 0; n < o.d.bytes; ++n) a.store_constant(0, o.d.address + n, Gate::EAndK);
  }
}

}  // namespace pixelflow
