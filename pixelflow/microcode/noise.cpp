// Noise (cmodel/pixelflow/native/noise.h has the definition): hash, gradients, and interpolation of the corners of a
// lattice cell, depth first, so that few values wait.
#include <utility>

#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

constexpr int kHash[3] = {0x9E37, 0x79B9, 0x85EB};
constexpr int kMix1 = 0x6A35, kMix2 = 0xB4D3;

Operand place(int address, int bytes, bool is_signed = false) {
  return {static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(bytes), is_signed, false, 0};
}

Operand constant(std::uint64_t value, int bytes) { return {0, static_cast<std::uint8_t>(bytes), false, true, value}; }

Operation operation(Code code, const Operand& d, const Operand& a, const Operand& b, int scale, int work) {
  Operation o;
  o.code = code;
  o.d = d;
  o.a = a;
  o.b = b;
  o.scale = scale;
  o.work = static_cast<std::uint8_t>(work);
  return o;
}

struct Axis {
  int hash[2];  ///< two bytes each: the index times its factor, near and far lattice point
  int offset;   ///< from the near lattice point, `corner_bytes`, signed
  int far_top;  ///< top byte of the offset from the far one; the others are the same
  int weight;
};

class Noise {
 public:
  explicit Noise(const Operation& o) : o_(o), is_float_(o.code == Code::NoiseFloat), dimensions_(o.scale) {
    int next = o.work;
    const auto take = [&](int bytes) { return std::exchange(next, next + bytes); };
    corner_bytes_ = is_float_ ? 4 : 2;
    value_bytes_ = is_float_ ? 4 : 3;
    for (int n = 0; n < dimensions_; ++n) {
      Axis& axis = axes_[n];
      axis.hash[0] = take(2);
      axis.hash[1] = take(2);
      axis.offset = take(corner_bytes_);
      axis.far_top = take(1);
      axis.weight = take(is_float_ ? 4 : 1);
    }
    for (int n = 0; n <= dimensions_; ++n) values_[n] = take(value_bytes_);
    x_ = take(2);
    q_ = take(1);
    nan_ = take(is_float_ ? 1 : 0);
    temporary_ = take(kTemporary);
    end_ = next;
  }

  int bytes() const { return end_ - o_.work; }

  void write(Assembler& a) {
    for (int n = 0; n < dimensions_; ++n) is_float_ ? write_float_axis(a, n) : write_fixed_axis(a, n);
    write_value(a, dimensions_, 0, 0);
    is_float_ ? write_float_result(a) : write_fixed_result(a);
  }

 private:
  static constexpr int kTemporary = 20;

  void write_hash_factors(Assembler& a, int n, int cell) {
    const Axis& axis = axes_[n];
    const int next = temporary_ + 8;
    a.alu(Alu::Add, To::M, P::Immediate, Q::Memory, {.addr = cell, .imm = 1});
    a.store(P::M, next);
    write_multiply(
        a, operation(Code::Multiply, place(axis.hash[0], 2), place(cell, 1), constant(kHash[n], 2), 0, temporary_));
    write_multiply(
        a, operation(Code::Multiply, place(axis.hash[1], 2), place(next, 1), constant(kHash[n], 2), 0, temporary_));
  }

  void write_fixed_axis(Assembler& a, int n) {
    const Axis& axis = axes_[n];
    const int fraction = o_.a.address + 2 * n;
    write_hash_factors(a, n, fraction + 1);
    a.load_m(fraction);
    a.store(P::M, axis.offset);
    a.store_constant(0, axis.offset + 1);
    a.store_constant(0xFF, axis.far_top);
    // 3 t^2 - 2 t^3 = t^2 (3 - 2 t)
    const int square = temporary_, rest = temporary_ + 2;
    write_multiply(
        a, operation(Code::Multiply, place(square, 2), place(fraction, 1), place(fraction, 1), 0, temporary_ + 4));
    write_shift_left(a, operation(Code::ShiftLeft, place(rest, 2), place(fraction, 1), {}, 1, 0));
    write_add(a, operation(Code::Sub, place(rest, 2), constant(3 * 256, 2), place(rest, 2), 0, 0));
    write_multiply(
        a, operation(Code::Multiply, place(axis.weight, 1), place(square, 2), place(rest, 2), 2, temporary_ + 4));
  }

  void write_float_axis(Assembler& a, int n) {
    const Axis& axis = axes_[n];
    const int c = temporary_;
    write_coordinate(a, o_.a.address + 4 * n, c, n == 0);
    write_hash_factors(a, n, c + 3);
    write_shift_left(a, operation(Code::ShiftLeft, place(axis.offset, 4), place(c, 3), {}, 4, 0));
    a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = axis.offset + 3, .imm = 0xF0});
    a.store(P::M, axis.far_top);
    const int square = temporary_ + 4, rest = temporary_ + 8;
    write_multiply(a, operation(Code::Multiply, place(square, 4), place(c, 3), place(c, 3), 2, temporary_ + 12));
    write_shift_left(a, operation(Code::ShiftLeft, place(rest, 4), place(c, 3), {}, 1, 0));
    write_add(a, operation(Code::Sub, place(rest, 4), constant(3u << 24, 4), place(rest, 4), 0, 0));
    write_multiply(
        a, operation(Code::Multiply, place(axis.weight, 4), place(square, 4), place(rest, 4), 3, temporary_ + 12));
  }

  /// to := floor(x 2^24) modulo 2^32; bit 0 of nan_: a coordinate is infinite or NaN.
  void write_coordinate(Assembler& a, int x, int to, bool is_first) {
    a.clear_w();
    a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = x + 2, .c = true});
    a.alu(Alu::ShiftLeft, To::X, P::Zero, Q::Memory, {.addr = x + 3, .cin = Carry::C});
    a.alu(Alu::Xor, To::None, P::X, Q::Immediate, {.imm = 0xFF, .z = ZMode::Set});
    a.flag(Flag::K, Bit::Z);
    if (!is_first) a.flag_of_memory(Flag::K, nan_, 0, false, FlagOp::Or);
    a.alu(Alu::AddIf, To::Memory, P::Zero, Q::Immediate, {.addr = nan_, .imm = 1});
    a.alu(Alu::ReverseSub, To::None, P::X, Q::Immediate, {.cin = Carry::One, .c = true});  // C: exponent 0
    a.alu(Alu::Add, To::X, P::X, Q::Immediate, {.cin = Carry::C});
    a.flag(Flag::C, Bit::C, true);
    a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = x + 2});
    a.alu(Alu::ShiftRight, To::W, P::Zero, Q::M, {.at = 2, .cin = Carry::C});
    a.load_w(x + 1, 1);
    a.load_w(x, 0);
    a.flag_of_memory(Flag::K, x + 3, 7);
    for (int n = 0; n < 4; ++n)
      a.alu(Alu::NegateIf, To::W, P::W, Q::Immediate, {.at = n, .cin = n ? Carry::C : Carry::K, .c = true});
    // 2^(exponent - 126), to the left or to the right; an arithmetic right shift of the negated number is its floor.
    a.alu(Alu::Sub, To::X, P::X, Q::Immediate, {.imm = 126, .cin = Carry::One, .c = true});  // C: to the left
    a.flag(Flag::K, Bit::C);
    a.flag(Flag::S, Bit::C);
    a.alu(Alu::Or, To::M, P::X, Q::Immediate);
    a.alu(Alu::Sub, To::X, P::Zero, Q::M, {.cin = Carry::One});
    a.flag(Flag::K, Bit::K, true);
    a.alu(Alu::Select, To::X, P::X, Q::Immediate);
    a.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0x100 - 32, .c = true});
    a.flag(Flag::K, Bit::C, true);
    a.alu(Alu::Select, To::X, P::X, Q::Immediate, {.imm = 31});
    a.align_right(Fill::Sign);
    a.flag(Flag::K, Bit::S);
    a.alu(Alu::AddIf, To::X, P::Zero, Q::M);
    for (int bit = 0; bit < 5; ++bit) {
      if (bit < 4) {
        a.shift_left(bit, When::XBit, bit);
      } else {
        for (int twice = 0; twice < 2; ++twice) a.shift_left(3, When::XBit, bit);
      }
    }
    a.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0x100 - 32, .c = true});  // C: out of W altogether
    a.flag(Flag::K, Bit::C, true);
    for (int n = 0; n < 4; ++n) a.alu(Alu::Select, To::Memory, P::W, Q::Immediate, {.addr = to + n, .at = n});
  }

  /// values_[depth] := the noise of the sub-lattice of `level` dimensions at the corner whose upper axes are chosen by
  /// `far`.
  void write_value(Assembler& a, int level, int far, int depth) {
    if (level == 0) {
      write_corner(a, far, values_[depth]);
      return;
    }
    write_value(a, level - 1, far, depth);
    write_value(a, level - 1, far | 1 << (level - 1), depth + 1);
    const Axis& axis = axes_[level - 1];
    const int from = values_[depth], to = values_[depth + 1];
    if (is_float_) {
      write_float_mix(a, from, to, axis.weight);
    } else {
      write_fixed_mix(a, from, to, axis.weight, level == 1);
    }
  }

  /// from := from + (to - from) weight. Corner values have 8 fraction bits in two bytes, mixed ones 16 in three.
  void write_fixed_mix(Assembler& a, int from, int to, int weight, bool corners) {
    const int bytes = corners ? 2 : 3, difference = temporary_;
    write_add(a, operation(Code::Sub, place(difference, bytes), place(to, bytes), place(from, bytes), 0, 0));
    a.clear_w();
    a.load_x(weight);
    a.multiply(difference);
    if (corners) {
      a.store_w_down(temporary_ + 3);
      a.multiply(difference + 1, false, true);
      for (int n = 0; n < 2; ++n) {
        a.alu(Alu::Add, To::W, P::W, Q::Memory,
              {.addr = from + n, .at = n, .cin = n ? Carry::C : Carry::Zero, .c = true});
      }
      a.load_m(temporary_ + 3);
      a.store(P::M, from);
      for (int n = 0; n < 2; ++n) a.store_w(from + 1 + n, n);
      return;
    }
    a.down();
    for (int n = 0; n < 3; ++n) {
      if (n < 2) a.multiply(difference + n + 1, false, n == 1);
      a.alu(Alu::Add, To::M, P::W, Q::Memory,
            {.addr = from + n, .cin = n ? Carry::C : Carry::Zero, .c = true, .down = true});
      a.store(P::M, from + n);
    }
  }

  void write_float_mix(Assembler& a, int from, int to, int weight) {
    const int difference = temporary_, product = temporary_ + 4;
    write_add(a, operation(Code::Sub, place(difference, 4), place(to, 4), place(from, 4), 0, 0));
    write_multiply(a, operation(Code::Multiply, place(product, 4), place(difference, 4, true), place(weight, 4), 4,
                                temporary_ + 8));
    write_add(a, operation(Code::Add, place(from, 4), place(from, 4), place(product, 4), 0, 0));
  }

  int offset(int n, int far, int byte) const {
    const Axis& axis = axes_[n];
    return far >> n & 1 && byte == corner_bytes_ - 1 ? axis.far_top : axis.offset + byte;
  }

  void write_corner(Assembler& a, int far, int to) {
    write_hash(a, far);
    dimensions_ == 1 ? write_gradient_1(a, far, to) : write_gradient(a, far, to);
  }

  /// q_ := the hash's low four bits.
  void write_hash(Assembler& a, int far) {
    int x = axes_[0].hash[far & 1];
    for (int n = 1; n < dimensions_; ++n) {
      write_add(a, operation(Code::Add, place(x_, 2), place(x, 2), place(axes_[n].hash[far >> n & 1], 2), 0, 0));
      x = x_;
    }
    // x ^= x >> 8; the result's low byte may replace x only where x is ours.
    a.load_m(x);
    a.alu(Alu::Xor, To::M, P::M, Q::Memory, {.addr = x + 1});
    a.store(P::M, q_);
    a.clear_w();
    a.multiply_constant(kMix1 & 0xFF, q_);
    a.alu(Alu::Or, To::X, P::W, Q::Immediate, {.down = true});
    a.multiply_constant(kMix1 >> 8, q_);
    a.multiply_constant(kMix1 & 0xFF, x + 1);
    a.store_w(x_ + 1, 0);
    a.store(P::X, x_);
    // x ^= x >> 7
    a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = x_, .c = true});
    a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = x_ + 1, .cin = Carry::C, .c = true});
    a.alu(Alu::Xor, To::M, P::X, Q::M);
    a.store(P::M, x_);
    a.alu(Alu::Add, To::X, P::Zero, Q::Immediate, {.cin = Carry::C});
    a.alu(Alu::Xor, To::M, P::X, Q::Memory, {.addr = x_ + 1});
    a.store(P::M, x_ + 1);
    a.clear_w();
    a.multiply_constant(kMix2 & 0xFF, x_);
    a.down();
    a.multiply_constant(kMix2 >> 8, x_);
    a.multiply_constant(kMix2 & 0xFF, x_ + 1);
    a.store_w(q_, 0);
  }

  void bit_of_q(Assembler& a, Flag to, int bit, bool invert = false, FlagOp op = FlagOp::Move) {
    a.flag_of_memory(to, q_, bit, invert, op);
  }

  /// One dimension: x with q0's sign where q < 8, x with q1's sign where q is 12 or 14, otherwise zero.
  void write_gradient_1(Assembler& a, int far, int to) {
    bit_of_q(a, Flag::K, 0);
    bit_of_q(a, Flag::K, 3, true, FlagOp::And);
    bit_of_q(a, Flag::C, 1);
    bit_of_q(a, Flag::C, 3, false, FlagOp::And);
    a.flag(Flag::K, Bit::C, false, FlagOp::Or);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.load_m(offset(0, far, n));
      a.alu(Alu::NegateIf, To::W, P::M, Q::Immediate, {.at = n, .cin = n ? Carry::C : Carry::K, .c = true});
    }
    bit_of_q(a, Flag::K, 2);
    bit_of_q(a, Flag::K, 0, true, FlagOp::And);
    bit_of_q(a, Flag::K, 3, true, FlagOp::Or);
    for (int n = 0; n < corner_bytes_; ++n)
      a.alu(Alu::Select, To::Memory, P::W, Q::Immediate, {.addr = to + n, .at = n});
  }

  void write_gradient(Assembler& a, int far, int to) {
    const int u = temporary_, v = temporary_ + 4;
    bit_of_q(a, Flag::K, 3);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.load_m(offset(1, far, n));
      a.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = offset(0, far, n)});
      a.store(P::M, u + n);
    }
    bit_of_q(a, Flag::K, 3);
    bit_of_q(a, Flag::K, 2, false, FlagOp::And);
    bit_of_q(a, Flag::K, 0, true, FlagOp::And);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.load_m(offset(0, far, n));
      if (dimensions_ == 3) {
        a.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = offset(2, far, n)});
        a.store(P::M, v + n);
      } else {
        a.alu(Alu::AddIf, To::Memory, P::Zero, Q::M, {.addr = v + n});
      }
    }
    bit_of_q(a, Flag::K, 3, true);
    bit_of_q(a, Flag::K, 2, true, FlagOp::And);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.load_m(offset(1, far, n));
      a.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = v + n});
      a.store(P::M, v + n);
    }
    bit_of_q(a, Flag::K, 0);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.load_m(u + n);
      a.alu(Alu::NegateIf, To::W, P::M, Q::Immediate, {.at = n, .cin = n ? Carry::C : Carry::K, .c = true});
    }
    bit_of_q(a, Flag::K, 1);
    for (int n = 0; n < corner_bytes_; ++n) {
      a.alu(Alu::AddSub, To::W, P::W, Q::Memory, {.addr = v + n, .at = n, .cin = n ? Carry::C : Carry::K, .c = true});
    }
    for (int n = 0; n < corner_bytes_; ++n) a.store_w(to + n, n);
  }

  /// d := (1 + g) / 2, floored, from 0 to 65535.
  void write_fixed_result(Assembler& a) {
    const int g = values_[0], d = o_.d.address;
    a.alu(Alu::Add, To::X, P::Immediate, Q::Memory, {.addr = g + 2, .imm = 1, .s = true});
    a.flag_of(Flag::C, P::X, 0);
    a.alu(Alu::ShiftRight, To::M, P::Zero, Q::Memory, {.addr = g + 1, .cin = Carry::C, .c = true});
    a.store(P::M, d + 1);
    a.alu(Alu::ShiftRight, To::M, P::Zero, Q::Memory, {.addr = g, .cin = Carry::C});
    a.store(P::M, d);
    a.alu(Alu::Add, To::None, P::X, Q::Immediate, {.imm = 0xFE, .c = true});  // C: 2 or more, or negative
    a.flag(Flag::K, Bit::C);
    a.flag(Flag::K, Bit::S, true, FlagOp::And);
    for (int n = 0; n < 2; ++n) a.store_constant(0xFF, d + n, Gate::EAndK);
    a.flag(Flag::K, Bit::S);
    for (int n = 0; n < 2; ++n) a.store_constant(0, d + n, Gate::EAndK);
  }

  /// d := (1 + g) / 2 as a float, from 0 to 1.
  void write_float_result(Assembler& a) {
    const int g = values_[0], top = g + 3;
    a.alu(Alu::Add, To::M, P::Immediate, Q::Memory, {.addr = top, .imm = 0x10});
    a.store(P::M, top);
    a.flag_of(Flag::K, P::M, 7);
    for (int n = 0; n < 4; ++n) a.store_constant(0, g + n, Gate::EAndK);
    a.alu(Alu::Add, To::None, P::M, Q::Immediate, {.imm = 0x100 - 0x20, .c = true});
    a.flag(Flag::K, Bit::K, true);
    a.flag(Flag::K, Bit::C, false, FlagOp::And);
    for (int n = 0; n < 4; ++n) a.store_constant(n == 3 ? 0x20 : 0, g + n, Gate::EAndK);
    write_fixed_to_float(a, operation(Code::FixedToFloat, o_.d, place(g, 4), {}, 29, temporary_));
    a.flag_of_memory(Flag::K, nan_, 0);
    const int nan[4] = {0, 0, 0xC0, 0x7F};
    for (int n = 0; n < 4; ++n) a.store_constant(nan[n], o_.d.address + n, Gate::EAndK);
  }

  const Operation& o_;
  bool is_float_;
  int dimensions_;
  int corner_bytes_, value_bytes_;
  Axis axes_[3] = {};
  int values_[4] = {};
  int x_, q_, nan_, temporary_, end_;
};

}  // namespace

int noise_workspace(const Operation& o) { return Noise(o).bytes(); }

void write_noise(Assembler& a, const Operation& o) { Noise(o).write(a); }

}  // namespace pixelflow
