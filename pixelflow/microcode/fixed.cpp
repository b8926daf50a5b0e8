// Copy, addition, comparison and shifts of fixed-point numbers.
#include <algorithm>

#include "pixelflow/microcode/routines.h"

namespace pixelflow {

int constant_byte(const Operand& operand, int index) {
  if (index < 8) return static_cast<int>(operand.constant >> (8 * index) & 0xFF);
  return operand.is_signed && operand.constant >> 63 ? 0xFF : 0;
}

bool is_sign_fill(const Operand& operand, int index) {
  return !operand.uniform && operand.is_signed && index >= operand.bytes;
}

void load_byte(Assembler& a, const Operand& operand, int index) {
  if (operand.uniform) {
    a.set_m(constant_byte(operand, index));
  } else if (index < operand.bytes) {
    a.load_m(operand.address + index);
  } else if (operand.is_signed) {
    a.alu(Alu::NegateIf, To::M, P::Zero, Q::Immediate);  // all ones where K
  } else {
    a.set_m(0);
  }
}

void load_sign(Assembler& a, Flag flag, const Operand& operand) {
  if (operand.uniform) {
    a.flag(flag, Bit::One, !(operand.is_signed && operand.constant >> 63));
  } else if (operand.is_signed) {
    a.flag_of_memory(flag, operand.address + operand.bytes - 1, 7);
  } else {
    a.flag(flag, Bit::One, true);
  }
}

bool overlap(const Operand& one, const Operand& other) {
  if (one.uniform || other.uniform) return false;
  return one.address < other.address + other.bytes && other.address < one.address + one.bytes;
}

void write_copy(Assembler& a, const Operation& o) {
  if (is_sign_fill(o.a, o.d.bytes - 1)) load_sign(a, Flag::K, o.a);
  for (int n = 0; n < o.d.bytes; ++n) {
    const int to = o.d.address + n;
    if (o.a.uniform || (n >= o.a.bytes && !o.a.is_signed)) {
      a.store_constant(o.a.uniform ? constant_byte(o.a, n) : 0, to);
    } else if (is_sign_fill(o.a, n)) {
      a.alu(Alu::NegateIf, To::Memory, P::Zero, Q::Immediate, {.addr = to});
    } else if (o.a.address + n != to) {
      a.load_m(o.a.address + n);
      a.store(P::M, to);
    }
  }
}

namespace {

/// d := a + b or a - b over d's bytes, or the comparison of both over `bytes` bytes when there is no d.
void add_chain(Assembler& a, const Operation& o, Alu fn, int bytes, bool keep) {
  const bool fill_a = is_sign_fill(o.a, bytes - 1);
  const bool fill_b = is_sign_fill(o.b, bytes - 1);
  if (fill_b) {  // b's fill lies in X, a's comes from K
    load_sign(a, Flag::K, o.b);
    a.alu(Alu::NegateIf, To::X, P::Zero, Q::Immediate);
  }
  if (fill_a) load_sign(a, Flag::K, o.a);
  for (int n = 0; n < bytes; ++n) {
    AluExtras e{.cin = n ? Carry::C : fn == Alu::Sub ? Carry::One : Carry::Zero, .c = true, .s = n == bytes - 1};
    const bool direct_b = !o.b.uniform && n < o.b.bytes;
    if (o.a.uniform && direct_b) {
      e.addr = o.b.address + n;
      e.imm = constant_byte(o.a, n);
      a.alu(fn, keep ? To::M : To::None, P::Immediate, Q::Memory, e);
      if (keep) a.store(P::M, o.d.address + n);
      continue;
    }
    if (!direct_b && is_sign_fill(o.b, n)) {  // the operands change places, which a subtraction has a function for
      load_byte(a, o.a, n);
      e.addr = keep ? o.d.address + n : 0;
      a.alu(fn == Alu::Sub ? Alu::ReverseSub : fn, keep ? To::Memory : To::None, P::X, Q::M, e);
      continue;
    }
    load_byte(a, o.a, n);
    if (direct_b) {
      e.addr = o.b.address + n;
      a.alu(fn, keep ? To::M : To::None, P::M, Q::Memory, e);
      if (keep) a.store(P::M, o.d.address + n);
    } else {
      e.addr = keep ? o.d.address + n : 0;
      e.imm = o.b.uniform ? constant_byte(o.b, n) : 0;
      a.alu(fn, keep ? To::Memory : To::None, P::M, Q::Immediate, e);
    }
  }
}

/// Bytes in which both numbers have room for their sign.
int compared_bytes(const Operation& o) {
  const bool has_sign = o.a.is_signed || o.b.is_signed;
  const auto room = [&](const Operand& x) { return x.bytes + (has_sign && !x.is_signed ? 1 : 0); };
  return std::max(room(o.a), room(o.b));
}

}  // namespace

void write_add(Assembler& a, const Operation& o) {
  add_chain(a, o, o.code == Code::Sub ? Alu::Sub : Alu::Add, o.d.bytes, true);
}

void write_compare(Assembler& a, const Operation& o) {
  const bool has_sign = o.a.is_signed || o.b.is_signed;
  Operation compared = o;
  if (o.code == Code::LessEqual) std::swap(compared.a, compared.b);  // a <= b is not (b < a)
  const int bytes = compared_bytes(compared);
  if (o.code != Code::Equal) {
    add_chain(a, compared, Alu::Sub, bytes, false);
    const bool inverted = o.code == Code::LessEqual;
    a.flag(Flag::K, has_sign ? Bit::S : Bit::C, has_sign ? inverted : !inverted);
    return;
  }
  const bool fill_a = is_sign_fill(o.a, bytes - 1);
  const bool fill_b = is_sign_fill(o.b, bytes - 1);
  if (fill_b) {
    load_sign(a, Flag::K, o.b);
    a.alu(Alu::NegateIf, To::X, P::Zero, Q::Immediate);
  }
  if (fill_a) load_sign(a, Flag::K, o.a);
  for (int n = 0; n < bytes; ++n) {
    const ZMode z = n ? ZMode::And : ZMode::Set;
    const bool direct_b = !o.b.uniform && n < o.b.bytes;
    if (o.a.uniform && direct_b) {
      a.alu(Alu::Xor, To::None, P::Immediate, Q::Memory,
            {.addr = o.b.address + n, .imm = constant_byte(o.a, n), .z = z});
      continue;
    }
    load_byte(a, o.a, n);
    if (direct_b) {
      a.alu(Alu::Xor, To::None, P::M, Q::Memory, {.addr = o.b.address + n, .z = z});
    } else if (is_sign_fill(o.b, n)) {
      a.alu(Alu::Xor, To::None, P::X, Q::M, {.z = z});
    } else {
      a.alu(Alu::Xor, To::None, P::M, Q::Immediate, {.imm = o.b.uniform ? constant_byte(o.b, n) : 0, .z = z});
    }
  }
  a.flag(Flag::K, Bit::Z);
}

void write_shift_left(Assembler& a, const Operation& o) {
  const int whole = o.scale / 8, rest = o.scale % 8;
  if (rest == 0 || (overlap(o.d, o.a) && whole > 0)) {  // whole bytes, from the top, so that a number can move in place
    if (is_sign_fill(o.a, o.d.bytes - 1 - whole)) load_sign(a, Flag::K, o.a);
    for (int n = o.d.bytes - 1; n >= whole; --n) {
      load_byte(a, o.a, n - whole);
      a.store(P::M, o.d.address + n);
    }
    for (int n = std::min<int>(whole, o.d.bytes) - 1; n >= 0; --n) a.store_constant(0, o.d.address + n);
    if (rest == 0) return;
  }
  const bool moved = overlap(o.d, o.a) && whole > 0;
  a.clear_w();
  for (int n = 0; n < o.d.bytes; ++n) {
    const int from = n - whole;
    if (from < 0) {
      if (!moved) a.store_constant(0, o.d.address + n);
      continue;
    }
    if (moved) {
      a.multiply_constant(1 << rest, o.d.address + n);
    } else if (from < o.a.bytes) {
      a.multiply_constant(1 << rest, o.a.address + from, false, o.a.is_signed && from == o.a.bytes - 1);
    }
    a.store_w_down(o.d.address + n);
  }
}

void write_shift_right(Assembler& a, const Operation& o) {
  const int whole = o.scale / 8, rest = o.scale % 8;
  if (rest == 0 || whole >= o.a.bytes) {
    const int top = o.d.bytes - 1 + whole;
    if (is_sign_fill(o.a, top)) load_sign(a, Flag::K, o.a);
    for (int n = 0; n < o.d.bytes; ++n) {
      load_byte(a, o.a, n + whole);
      a.store(P::M, o.d.address + n);
    }
    return;
  }
  // To the left by the rest of a byte, one byte lower.
  a.clear_w();
  const auto take = [&](int from) {
    if (from < o.a.bytes)
      a.multiply_constant(1 << (8 - rest), o.a.address + from, false, o.a.is_signed && from == o.a.bytes - 1);
  };
  take(whole);
  a.down();
  for (int n = 0; n < o.d.bytes; ++n) {
    take(whole + 1 + n);
    a.store_w_down(o.d.address + n);
  }
}

void write_wrap(Assembler& a, const Operation& o) {
  write_copy(a, o);
  const int top = (o.scale - 1) / 8, bits = (o.scale - 1) % 8 + 1;  // the byte of the top bit, and its bits
  if (top >= o.d.bytes) return;
  const int address = o.d.address + top;
  if (o.d.is_signed) a.flag_of_memory(Flag::K, address, bits - 1);
  if (bits < 8) {
    const int mask = (1 << bits) - 1;
    a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = address, .imm = mask});
    if (o.d.is_signed) {
      a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = address, .imm = 0xFF & ~mask});
    } else {
      a.store(P::M, address);
    }
  }
  for (int n = top + 1; n < o.d.bytes; ++n) {
    if (o.d.is_signed) {
      a.alu(Alu::NegateIf, To::Memory, P::Zero, Q::Immediate, {.addr = o.d.address + n});
    } else {
      a.store_constant(0, o.d.address + n);
    }
  }
}

void write_saturate(Assembler& a, const Operation& o) {
  // Limits of the target as constants; the comparisons set K, and gated writes replace d.
  const bool to_signed = o.d.is_signed;
  const std::uint64_t most = to_signed ? (1ull << (o.scale - 1)) - 1 : o.scale == 64 ? ~0ull : (1ull << o.scale) - 1;
  const std::uint64_t least = to_signed ? ~most : 0;
  // d may lie on a: both comparisons come before the first write. S keeps "above", K holds "below".
  const auto limit = [&](std::uint64_t value, bool is_signed) {
    return Operand{0, static_cast<std::uint8_t>((o.scale + 7) / 8), is_signed, true, value};
  };
  Operation compare = o;
  compare.code = Code::Less;
  compare.a = limit(most, to_signed);
  compare.b = o.a;
  write_compare(a, compare);
  const bool can_be_below = o.a.is_signed;
  if (!can_be_below) {
    write_copy(a, o);
    // The copy of an unsigned number uses neither K nor S.
    for (int n = 0; n < o.d.bytes; ++n)
      a.store_constant(static_cast<int>(most >> (8 * n) & 0xFF), o.d.address + n, Gate::EAndK);
    return;
  }
  // A signed number: keep "above" in Z over the copy, whose fill uses K, then ask for "below" through the sign.
  a.flag(Flag::Z, Bit::K);
  compare.a = o.a;
  compare.b = limit(least, true);
  write_compare(a, compare);
  a.flag(Flag::C, Bit::K);
  write_copy(a, o);
  a.flag(Flag::K, Bit::Z);
  for (int n = 0; n < o.d.bytes; ++n)
    a.store_constant(static_cast<int>(most >> (8 * n) & 0xFF), o.d.address + n, Gate::EAndK);
  a.flag(Flag::K, Bit::C);
  for (int n = 0; n < o.d.bytes; ++n)
    a.store_constant(static_cast<int>(least >> (8 * n) & 0xFF), o.d.address + n, Gate::EAndK);
}

}  // namespace pixelflow
