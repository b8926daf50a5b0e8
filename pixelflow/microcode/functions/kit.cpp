#include "pixelflow/microcode/functions/kit.h"

#include <algorithm>

namespace pixelflow::functions {
namespace {

int byte_of(std::uint64_t value, int n) { return n < 8 ? static_cast<int>(value >> (8 * n) & 0xFF) : 0; }

}  // namespace

void Kit::put(int to, std::uint64_t value, int n, Gate gate) {
  for (int i = 0; i < n; ++i) a.store_constant(byte_of(value, i), to + i, gate);
}

void Kit::copy(int to, int from, int n, Gate gate) {
  for (int i = 0; i < n; ++i) {
    a.load_m(from + i);
    a.store(P::M, to + i, gate);
  }
}

void Kit::load(int from, int n) {
  if (n < 4) a.clear_w();
  for (int i = 0; i < n; ++i) a.load_w(from + i, i);
}

void Kit::store(int to) {
  for (int i = 0; i < 4; ++i) a.store_w(to + i, i);
}

void Kit::add(int to, int from, int value) {
  a.load_m(from);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = to, .imm = value & 0xFF, .c = true});
}

void Kit::add_byte(int to, int from, int other, bool subtract) {
  a.load_m(from);
  a.alu(subtract ? Alu::Sub : Alu::Add, To::M, P::M, Q::Memory,
        {.addr = other, .cin = subtract ? Carry::One : Carry::Zero, .c = true});
  a.store(P::M, to);
}

void Kit::negate_if(int number, int n, int top) {
  for (int i = 0; i < n; ++i) {
    a.load_m(number + i);
    a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate,
          {.addr = number + i, .cin = i ? Carry::C : Carry::K, .c = true});
  }
  if (top >= 0) a.alu(Alu::NegateIf, To::Memory, P::Zero, Q::Immediate, {.addr = top, .cin = Carry::C});
}

void Kit::subtract_from(int to, std::uint64_t value, int n, int number) {
  for (int i = 0; i < n; ++i) {
    a.load_m(number + i);
    a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate,
          {.addr = to + i, .imm = byte_of(value, i), .cin = i ? Carry::C : Carry::One, .c = true});
  }
}

void Kit::k_if_zero(int from, int n, bool invert) {
  for (int i = 0; i < n; ++i) {
    a.alu(Alu::Or, To::None, P::Zero, Q::Memory, {.addr = from + i, .z = i ? ZMode::And : ZMode::Set});
  }
  a.flag(Flag::K, Bit::Z, invert);
}

void Kit::k_if_at_least(int byte, int value) {
  a.load_m(byte);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = value, .cin = Carry::One, .c = true});
  a.flag(Flag::K, Bit::C);
}

void Kit::k_if_magnitude_at_least(int x, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) {
    if (i < 3) {
      a.load_m(x + i);
    } else {
      a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = x + i, .imm = 0x7F});
    }
    a.alu(Alu::Sub, To::None, P::M, Q::Immediate,
          {.imm = byte_of(value, i), .cin = i ? Carry::C : Carry::One, .c = true});
  }
  a.flag(Flag::K, Bit::C);
}

void Kit::k_if_number_at_least(int one, int other, int n) {
  for (int i = 0; i < n; ++i) {
    a.load_m(one + i);
    a.alu(Alu::Sub, To::None, P::M, Q::Memory, {.addr = other + i, .cin = i ? Carry::C : Carry::One, .c = true});
  }
  a.flag(Flag::K, Bit::C);
}

void Kit::multiply(int to, Factor x, Factor y, int drop, int keep, Finish finish, std::uint64_t value) {
  if (x.uniform) std::swap(x, y);
  a.clear_w();
  for (int column = 0; column < drop + keep; ++column) {
    for (int i = std::max(0, column - y.bytes + 1); i <= std::min(x.bytes - 1, column); ++i) {
      const int j = column - i;
      if (!y.uniform) {
        a.load_x(x.address + i);
        a.multiply(y.address + j);
      } else if (byte_of(y.constant, j) != 0) {
        a.multiply_constant(byte_of(y.constant, j), x.address + i);
      }
    }
    if (column < drop) {
      a.down();
      continue;
    }
    const int n = column - drop;
    if (finish == Finish::None) {
      a.store_w_down(to + n);
    } else {
      const bool plus = finish == Finish::Plus;
      const Carry first = plus ? Carry::Zero : Carry::One;
      a.alu(plus ? Alu::Add : Alu::ReverseSub, To::Memory, P::W, Q::Immediate,
            {.addr = to + n, .imm = byte_of(value, n), .cin = n ? Carry::C : first, .c = true, .down = true});
    }
  }
}

void Kit::horner(int p, int z, std::span<const std::uint32_t> c, const char* signs) {
  const auto finish = [&](std::size_t i) { return signs[i] == '-' ? Finish::Minus : Finish::Plus; };
  std::size_t i = c.size() - 2;
  multiply(p, in_memory(z, 4), constant(c[i + 1], 4), 4, 4, finish(i), c[i]);
  while (i-- > 0) multiply(p, in_memory(z, 4), in_memory(p, 4), 4, 4, finish(i), c[i]);
}

void Kit::shift_right_word(int to, int from, int count) {
  a.load_x(count);
  load(from);
  a.align_right(Fill::Zero);
  store(to);
  k_if_at_least(count, 32);
  put(to, 0, 4, Gate::EAndK);
}

void Kit::shift_right_number(int number, int n, int count) {
  for (int bit = 7; bit >= 3; --bit) {
    const int bytes = 1 << (bit - 3);
    k_from(count, bit);
    for (int i = 0; i < n; ++i) {
      if (i + bytes < n) {
        copy(number + i, number + i + bytes, 1, Gate::EAndK);
      } else {
        a.store_constant(0, number + i, Gate::EAndK);
      }
    }
  }
  a.load_x(count);
  for (int first = 0; first < n; first += 3) {
    const int used = std::min(4, n - first);
    load(number + first, used);
    for (int bit = 0; bit < 3; ++bit) a.shift_right(bit, Fill::Zero, When::XBit, bit);
    for (int i = 0; i < std::min(used, 3); ++i) a.store_w(number + first + i, i);
    if (used == 4 && first + 4 == n) {
      a.store_w(number + first + 3, 3);
      break;
    }
  }
}

void Kit::shift_left_small(int number, int n) {
  for (int top = n; top > 0; top -= 3) {  // W's upper bytes are the number's bytes below `top`
    const int used = std::min(4, top);
    if (used < 4) a.clear_w();
    for (int i = 0; i < used; ++i) a.load_w(number + top - 1 - i, 3 - i);
    for (int bit = 0; bit < 3; ++bit) a.shift_left(bit, When::XBit, bit);
    const int kept = top == 4 ? 4 : std::min(used, 3);
    for (int i = 0; i < kept; ++i) a.store_w(number + top - 1 - i, 3 - i);
    if (top == 4) break;
  }
}

void Kit::normalise(int number, int n, int count) {
  if (n == 4) {
    load(number);
    a.set_x(33);
    a.normalize();
    store(number);
    a.alu(Alu::ReverseSub, To::Memory, P::X, Q::Immediate, {.addr = count, .imm = 33, .cin = Carry::One});
    return;
  }
  a.store_constant(0, count);
  for (int bytes = 4; bytes > 0; bytes /= 2) {
    k_if_zero(number + n - bytes, bytes);
    for (int i = n - 1; i >= 0; --i) {
      if (i >= bytes) {
        copy(number + i, number + i - bytes, 1, Gate::EAndK);
      } else {
        a.store_constant(0, number + i, Gate::EAndK);
      }
    }
    a.load_m(count);
    a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = count, .imm = 8 * bytes});
  }
  // The places left over, of the top byte alone.
  a.clear_w();
  a.load_w(number + n - 1, 3);
  a.set_x(33);
  for (int bit = 2; bit >= 0; --bit) a.shift_left(bit, When::Normalize);
  a.alu(Alu::ReverseSub, To::X, P::X, Q::Immediate, {.imm = 33, .cin = Carry::One});
  a.alu(Alu::Add, To::M, P::X, Q::Memory, {.addr = count});
  a.store(P::M, count);
  shift_left_small(number, n);
}

void Kit::load_field(int x) {
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = x + 2, .c = true});
  a.alu(Alu::ShiftLeft, To::X, P::Zero, Q::Memory, {.addr = x + 3, .cin = Carry::C});
}

void Kit::significand(int to, int x) {
  a.store_constant(0, to);
  copy(to + 1, x, 2);
  a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = x + 2, .imm = 0x80});
  a.store(P::M, to + 3);
}

void Kit::split(int to, int field16, int x) {
  load_field(x);
  a.alu(Alu::Or, To::None, P::X, Q::Immediate, {.z = ZMode::Set});
  a.flag(Flag::K, Bit::Z);  // zero or subnormal: no hidden bit, and the exponent is that of field 1
  a.alu(Alu::Add, To::Memory, P::X, Q::Immediate, {.addr = field16, .cin = Carry::K});
  a.set_m(0);
  a.alu(Alu::NegateIf, To::M, P::M, Q::Immediate, {});  // K ? 0xFF : 0
  a.alu(Alu::And, To::M, P::M, Q::Immediate, {.imm = 0x80});
  a.alu(Alu::Xor, To::M, P::M, Q::Immediate, {.imm = 0x80});  // the hidden bit
  a.set_w(0, 0);
  a.load_w(x, 1);
  a.load_w(x + 1, 2);
  a.load_w(x + 2, 3);
  a.alu(Alu::And, To::W, P::W, Q::Immediate, {.imm = 0x7F, .at = 3});
  a.alu(Alu::Or, To::W, P::W, Q::M, {.at = 3});
  a.set_x(33);
  a.normalize();
  store(to);
  a.alu(Alu::Sub, To::X, P::X, Q::Immediate, {.imm = 33, .cin = Carry::One});  // minus the places
  a.alu(Alu::Add, To::M, P::X, Q::Memory, {.addr = field16, .c = true});
  a.store(P::M, field16);
  // The high byte: the sign of (places' complement) plus the carry.
  a.alu(Alu::Or, To::None, P::X, Q::Immediate, {.s = true});
  a.flag(Flag::K, Bit::S);
  a.set_m(0);
  a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = field16 + 1, .imm = 0xFF, .cin = Carry::C});
}

void Kit::divide_byte(int quotient, int divisor) {
  a.set_x(0);
  for (int bit = 0; bit < 8; ++bit) {
    a.divide(bit > 0, true, 4);
    for (int n = 0; n < 4; ++n) {
      a.alu(Alu::AddSub, To::W, P::W, Q::Memory,
            {.addr = divisor + n, .at = n, .cin = n ? Carry::C : Carry::K, .c = true});
    }
  }
  a.divide(true, false, 4);
  a.store(P::X, quotient);
}

void Kit::pack(int result) {
  a.store_w(result, 1);
  a.store_w(result + 1, 2);
  a.alu(Alu::And, To::M, P::W, Q::Immediate, {.imm = 0x7F, .at = 3});
  a.alu(Alu::Or, To::Memory, P::M, Q::ExponentLow, {.addr = result + 2});
  a.alu(Alu::Or, To::Memory, P::Zero, Q::ExponentHigh, {.addr = result + 3});
}

void Kit::round_normal(int result) {
  a.flag_of(Flag::C, P::W, 0, false, FlagOp::Move, 1);
  a.alu(Alu::Add, To::W, P::W, Q::Immediate, {.imm = 127, .at = 0, .cin = Carry::C, .c = true});
  for (int n = 1; n < 4; ++n) a.alu(Alu::Add, To::W, P::W, Q::Immediate, {.at = n, .cin = Carry::C, .c = true});
  a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.cin = Carry::C});
  pack(result);
}

void Kit::round_any(int result, int number, int field16, int count, int sign) {
  // count := 1 - field where that is positive (at most 31), otherwise 0.
  a.load_m(field16);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = count, .imm = 1, .cin = Carry::One, .c = true});
  a.load_m(field16 + 1);
  a.alu(Alu::ReverseSub, To::M, P::M, Q::Immediate, {.cin = Carry::C, .s = true});
  a.flag(Flag::K, Bit::S);
  a.store_constant(0, count, Gate::EAndK);
  k_if_at_least(count, 32);
  a.store_constant(31, count, Gate::EAndK);
  load(number);
  a.load_x(count);
  a.align_right(Fill::Jam);
  // X := the field, 0 for subnormals.
  k_if_zero(count, 1, true);
  a.load_x(field16);
  a.alu(Alu::NegateIf, To::M, P::Zero, Q::Immediate, {});  // K ? 0xFF : 0
  a.alu(Alu::AndNot, To::X, P::X, Q::M, {});
  // Rounding; a subnormal number may become the smallest normal one.
  a.flag_of(Flag::C, P::W, 0, false, FlagOp::Move, 1);
  a.alu(Alu::Add, To::W, P::W, Q::Immediate, {.imm = 127, .at = 0, .cin = Carry::C, .c = true});
  for (int n = 1; n < 4; ++n) a.alu(Alu::Add, To::W, P::W, Q::Immediate, {.at = n, .cin = Carry::C, .c = true});
  a.flag_of(Flag::K, P::W, 7, false, FlagOp::And, 3);
  a.flag(Flag::C, Bit::K, false, FlagOp::Or);
  a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.cin = Carry::C});
  a.flag_of_memory(Flag::S, sign, 7);
  pack(result);
  // Infinity from field 255 on.
  a.load_m(field16);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = 255, .cin = Carry::One, .c = true});
  a.load_m(field16 + 1);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.cin = Carry::C, .s = true});
  a.flag(Flag::K, Bit::S, true);
  put(result, 0, 2, Gate::EAndK);
  a.store_constant(0x80, result + 2, Gate::EAndK);
  a.load_m(result + 3);
  a.alu(Alu::Or, To::Memory, P::M, Q::Immediate, {.addr = result + 3, .imm = 0x7F, .gate = Gate::EAndK});
}

}  // namespace pixelflow::functions
