// Square root of fixed-point numbers (root_steps.h): the first 30 bits in W, what a root needs beyond them in memory.
#include <algorithm>

#include "pixelflow/microcode/root_steps.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

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
  p.in_memory = !p.in_wide || p.root_bits > RootSteps::kMost;
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
      RootSteps steps(a_, p_.z + p_.bytes - 4, p_.t, p_.fraction_bits, feeding(), p_.in_memory);
      for (; step <= std::min(RootSteps::kMost, p_.root_bits); ++step) steps.step(step);
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
  /// Bits of the radicand that W has no room for at first.
  int feeding() const { return o_.a.bytes == 4 ? p_.leading : 0; }

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
    if (feeding()) {  // X: the bits that the shift pushed out, complemented, moved round to the top
      a_.alu(Alu::Xor, To::M, P::Immediate, Q::Memory, {.addr = o_.a.address, .imm = 0xFF});
      for (int bit = 0; bit <= p_.leading; ++bit) {
        a_.alu(Alu::ShiftRight, bit == p_.leading ? To::X : To::M, P::Zero, Q::M, {.cin = Carry::C, .c = true});
      }
      a_.store_constant(0, p_.z + p_.bytes - 1);
    } else {
      a_.set_x(0);
    }
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
    const int at = 8 * p_.bytes - 2 - step, byte = at / 8, b = 1 << at % 8;
    const bool last = step == p_.root_bits;
    // Below the bit in work V is all ones once the radicand's own bits have passed.
    const int lowest = p_.in_wide ? byte : 0;
    a_.flag(Flag::C, Bit::One);
    for (int n = lowest; n < p_.bytes; ++n) {
      a_.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = p_.v + n, .cin = Carry::C, .c = true});
      a_.store(P::M, p_.v + n);
    }
    const int z = p_.z + byte;
    if (at % 8 == 7) {  // as in RootSteps; X: T's byte above, t: the next Z's
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
};

}  // namespace

int square_root_workspace(const Operation& o) { return plan(o).end - o.work; }

void write_square_root(Assembler& a, const Operation& o) { Root(a, o).write(); }

}  // namespace pixelflow
