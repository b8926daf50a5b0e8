// Square root of fixed-point numbers, a bit at a time, non-restoring.
//
// The radicand A lies in [0, 1). With P the root so far, the remainder R = 2^i (A - P^2) after bit i obeys R := 2R - T where R is
// not negative, R := 2R + T where it is. Z = 2P + 2 * 2^-i goes along: with b = 2^-i, T is Z + b and the next Z is Z + 2b
// where R is not negative, Z - b and Z - 2b where it is. V = ~R is kept instead of R, so that one flag, K = (R < 0), steers all
// three through AddSub. R has two bits before its point. The first 30 bits of a root run in W, with the byte of Z in work in X;
// what a root needs beyond them runs in memory.
#include <algorithm>

#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

constexpr int kWideSteps = 30;

struct Plan {
  int root_bits;
  int fraction_bits;  ///< of the radicand, below its point
  int leading;        ///< zeros before the radicand's first bit, the two of R's integer part among them
  bool in_wide;       ///< starts in W
  bool in_memory;     ///< ends in memory
  int bytes;          ///< of V and Z
  int z, v, t;        ///< their places in the workspace; t holds a byte of T
  int end;
};

Plan plan(const Operation& o) {
  Plan p{};
  p.root_bits = (8 * o.a.bytes + o.scale + 1) / 2;
  p.fraction_bits = 2 * p.root_bits - o.scale;
  p.leading = 2 + p.fraction_bits - 8 * o.a.bytes;
  p.in_wide = o.a.bytes <= 4 && p.root_bits <= 32;
  p.in_memory = !p.in_wide || p.root_bits > kWideSteps;
  p.bytes = !p.in_memory ? 4 : p.in_wide ? 5 : (std::max(p.root_bits, p.fraction_bits) + 2 + 7) / 8;
  p.z = o.work;
  p.t = p.z + p.bytes;
  p.v = p.t + 1;
  p.end = p.v + (p.in_memory ? p.bytes : 0);
  return p;
}

class Root {
 public:
  Root(Assembler& a, const Operation& o) : a_(a), o_(o), p_(plan(o)) {}

  void write() {
    int step = 1;
    if (p_.in_wide) {
      load_wide();
      a_.flag(Flag::K, Bit::One, true);
      for (; step <= std::min(kWideSteps, p_.root_bits); ++step) wide_step(step);
    }
    if (p_.in_wide && p_.in_memory) {
      for (int n = 0; n < 4; ++n) a_.store_w(p_.v + 1 + n, n);
      a_.store_constant(0xFF, p_.v);
      a_.store(P::X, p_.z + 1);
      a_.store_constant(0, p_.z);
    } else if (p_.in_memory) {
      load_memory();
      a_.flag(Flag::K, Bit::One, true);
    }
    for (; step <= p_.root_bits; ++step) memory_step(step);
    finish();
  }

 private:
  /// W := ~A, two bits before the point.
  void load_wide() {
    const int n = o_.a.bytes;
    for (int at = 3; at >= 0; --at) {
      const int from = n - 4 + at;
      if (from >= 0) {
        a_.alu(Alu::Xor, To::W, P::Immediate, Q::Memory, {.addr = o_.a.address + from, .imm = 0xFF, .at = at});
      } else {
        a_.set_w(0xFF, at);
      }
    }
    a_.flag(Flag::C, Bit::One);
    a_.shift_right(1, Fill::C);
    if (p_.leading == 3) a_.shift_right(0, Fill::C);
    feeding_ = n == 4 ? p_.leading : 0;
    if (feeding_) {  // X: the bits that the shift pushed out, complemented, moved round to the top
      a_.alu(Alu::Xor, To::M, P::Immediate, Q::Memory, {.addr = o_.a.address, .imm = 0xFF});
      for (int bit = 0; bit <= p_.leading; ++bit) {
        a_.alu(Alu::ShiftRight, bit == p_.leading ? To::X : To::M, P::Zero, Q::M, {.cin = Carry::C, .c = true});
      }
      a_.store_constant(0, p_.z + p_.bytes - 1);
    } else {
      a_.set_x(0);
    }
  }

  /// V has a two in front where W has four bytes: the position of bit 2^-step.
  int position(int step, int bytes) const { return 8 * bytes - 2 - step; }

  void wide_step(int step) {
    const int at = position(step, 4), byte = at / 8, b = 1 << at % 8;
    const int z = p_.z + p_.bytes - 4 + byte;
    bool low_constant = false;
    if (feeding_) {  // X is in use: Z stays in memory. These are the first three bits, all in the top byte
      a_.divide(false, true, 4);
      a_.alu(Alu::NegateIf, To::M, P::Immediate, Q::Memory, {.addr = z, .imm = 2 * b, .cin = Carry::K});
      a_.store(P::M, p_.t);
      a_.alu(Alu::NegateIf, To::M, P::Immediate, Q::Memory, {.addr = z, .imm = b, .cin = Carry::K});
      if (--feeding_) {
        // Z := what was put aside, once T has it; the exchange goes through the workspace.
        a_.alu(Alu::AddSub, To::W, P::W, Q::M, {.at = 3, .cin = Carry::K});
        a_.load_m(p_.t);
        a_.store(P::M, z);
        a_.flag_of(Flag::K, P::W, 7, true, FlagOp::Move, 3);
        return;
      }
      a_.load_x(p_.t);
    } else {
      double_v(step);
      if (at % 8 == 7) {  // T's low byte is 0x80 in either sense, and a borrow goes up; Z's bit is in the byte above
        low_constant = true;
        a_.alu(Alu::AddIf, To::M, P::X, Q::Immediate, {.imm = 0xFF});
        a_.alu(Alu::AddSub, To::X, P::X, Q::Immediate, {.imm = 1, .cin = Carry::K});
      } else if (at % 8 == 6) {  // the byte above gets its last borrow, Z's new byte is 0x80 in either sense
        a_.alu(Alu::AddIf, To::Memory, P::X, Q::Immediate, {.addr = z + 1, .imm = 0xFF});
        a_.alu(Alu::AddSub, To::M, P::Zero, Q::Immediate, {.imm = b, .cin = Carry::K});
        a_.set_x(0x80);
      } else {
        a_.alu(Alu::AddSub, To::M, P::X, Q::Immediate, {.imm = b, .cin = Carry::K});
        a_.alu(Alu::AddSub, To::X, P::X, Q::Immediate, {.imm = 2 * b, .cin = Carry::K});
      }
    }
    for (int n = byte; n < 4; ++n) {
      AluExtras e{.at = n, .cin = n > byte ? Carry::C : Carry::K, .c = true};
      const bool from_m = low_constant ? n == byte + 1 : n == byte;
      if (low_constant && n == byte) {
        e.imm = 0x80;
        a_.alu(Alu::AddSub, To::W, P::W, Q::Immediate, e);
      } else if (from_m) {
        a_.alu(Alu::AddSub, To::W, P::W, Q::M, e);
      } else {
        e.addr = p_.z + p_.bytes - 4 + n;
        a_.alu(Alu::AddSub, To::W, P::W, Q::Memory, e);
      }
    }
    a_.flag_of(Flag::K, P::W, 7, true, FlagOp::Move, 3);
  }

  /// 2V + 1: a left shift brings a zero where V wants a one, so that V comes to stand for -R - excess instead of -R - 1. That is
  /// harmless while the excess is at most the grain of R; before it gets bigger the bits that must be ones are set again.
  void double_v(int step) {
    const auto grain = [&](int after) { return std::max(0, 30 - std::max(p_.fraction_bits - after, after)); };  // as a bit of W
    a_.shift_left(0);
    excess_ *= 2;
    const bool handed_on = p_.in_memory && step == kWideSteps;
    if (excess_ <= 1ll << grain(step) && !handed_on) return;
    const int bits = grain(step - 1) + 1;
    for (int n = 0; 8 * n < bits; ++n) {
      const int ones = bits - 8 * n >= 8 ? 0xFF : (1 << (bits - 8 * n)) - 1;
      a_.alu(Alu::Or, To::W, P::W, Q::Immediate, {.imm = ones, .at = n});
    }
    excess_ = 1;
  }

  /// V := ~A in memory, all of it, and Z := 0.
  void load_memory() {
    const int shift = 8 * p_.bytes - 2 - p_.fraction_bits;
    a_.clear_w();
    for (int n = 0; n < p_.bytes; ++n) {
      const int from = n - shift / 8;
      if (from >= 0 && from < o_.a.bytes) a_.multiply_constant(1 << shift % 8, o_.a.address + from);
      a_.alu(Alu::Xor, To::Memory, P::W, Q::Immediate, {.addr = p_.v + n, .imm = 0xFF, .down = true});
      a_.store_constant(0, p_.z + n);
    }
  }

  void memory_step(int step) {
    const int at = position(step, p_.bytes), byte = at / 8, b = 1 << at % 8;
    const bool last = step == p_.root_bits;
    // Below the bit in work V is all ones once the radicand's own bits have passed.
    const int lowest = p_.in_wide ? byte : 0;
    a_.flag(Flag::C, Bit::One);
    for (int n = lowest; n < p_.bytes; ++n) {
      a_.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = p_.v + n, .cin = Carry::C, .c = true});
      a_.store(P::M, p_.v + n);
    }
    const int z = p_.z + byte;
    if (at % 8 == 7) {  // as in wide_step; X: T's byte above, t: the next Z's
      a_.load_x(z + 1);
      a_.alu(Alu::AddSub, To::M, P::X, Q::Immediate, {.imm = 1, .cin = Carry::K});
      a_.store(P::M, z + 1);
      a_.alu(Alu::AddIf, To::Memory, P::X, Q::Immediate, {.addr = p_.t, .imm = 0xFF});
    } else if (at % 8 == 6) {
      a_.load_x(z + 1);
      a_.alu(Alu::AddIf, To::Memory, P::X, Q::Immediate, {.addr = z + 1, .imm = 0xFF});
      a_.alu(Alu::AddSub, To::Memory, P::Zero, Q::Immediate, {.addr = p_.t, .imm = b, .cin = Carry::K});
      a_.store_constant(0x80, z);
    } else {
      a_.load_x(z);
      a_.alu(Alu::AddSub, To::Memory, P::X, Q::Immediate, {.addr = p_.t, .imm = b, .cin = Carry::K});
      a_.alu(Alu::AddSub, To::Memory, P::X, Q::Immediate, {.addr = z, .imm = 2 * b, .cin = Carry::K});
    }
    for (int n = byte; n < p_.bytes; ++n) {
      a_.load_m(p_.v + n);
      AluExtras e{.cin = n > byte ? Carry::C : Carry::K, .c = true, .s = n == p_.bytes - 1};
      const To to = last ? To::None : To::M;
      const bool t = at % 8 == 7 ? n == byte + 1 : n == byte;
      if (at % 8 == 7 && n == byte) {
        e.imm = 0x80;
        a_.alu(Alu::AddSub, To::M, P::M, Q::Immediate, e);
      } else {
        e.addr = t ? p_.t : p_.z + n;
        a_.alu(Alu::AddSub, n == p_.bytes - 1 ? To::M : to, P::M, Q::Memory, e);
      }
      if (!last) a_.store(P::M, p_.v + n);
    }
    a_.flag_of(Flag::K, P::M, 7, true);
  }

  /// d := the bits of Z above the last step's, whose own bit is K's complement.
  void finish() {
    const int shift = 8 * p_.bytes - 1 - p_.root_bits, low = shift / 8, rest = shift % 8;
    const int root_bytes = (p_.root_bits + 7) / 8;
    if (!p_.in_memory && rest != 7) a_.store(P::X, p_.z + low);
    if (o_.a.is_signed) a_.flag_of_memory(Flag::S, o_.a.address + o_.a.bytes - 1, 7);
    if (rest == 7) {
      a_.flag(Flag::C, Bit::K, true);
      for (int n = 0; n < o_.d.bytes; ++n) {
        const int from = low + 1 + n;
        if (from < p_.bytes) {
          a_.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = p_.z + from, .cin = Carry::C, .c = true});
          a_.store(P::M, o_.d.address + n);
        } else {
          a_.store_constant(0, o_.d.address + n);
        }
      }
    } else {
      a_.clear_w();
      const auto take = [&](int from) {
        if (from < p_.bytes) a_.multiply_constant(1 << (8 - rest), p_.z + from);
      };
      if (rest) {
        take(low);
        a_.down();
      }
      for (int n = 0; n < o_.d.bytes; ++n) {
        if (n >= root_bytes) {
          a_.store_constant(0, o_.d.address + n);
          continue;
        }
        if (rest) {
          take(low + 1 + n);
        } else {
          a_.load_w(p_.z + low + n, 0);
        }
        if (n == 0) {
          a_.alu(Alu::AddIf, To::Memory, P::W, Q::Immediate, {.addr = o_.d.address, .imm = 0xFF, .down = true});
        } else {
          a_.store_w_down(o_.d.address + n);
        }
      }
    }
    if (o_.a.is_signed) {
      a_.flag(Flag::K, Bit::S);
      for (int n = 0; n < o_.d.bytes; ++n) a_.store_constant(0, o_.d.address + n, Gate::EAndK);
    }
  }

  Assembler& a_;
  const Operation& o_;
  Plan p_;
  int feeding_ = 0;          ///< bits of the radicand still to come in from X
  long long excess_ = 1;
};

}  // namespace

int square_root_workspace(const Operation& o) { return plan(o).end - o.work; }

void write_square_root(Assembler& a, const Operation& o) { Root(a, o).write(); }

}  // namespace pixelflow
