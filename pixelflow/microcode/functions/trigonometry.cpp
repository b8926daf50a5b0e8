// Sine, cosine and tangent: cmodel/pixelflow/native/trigonometry.h in microcode.
#include "cmodel/pixelflow/native/coefficients.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/kit.h"

namespace pixelflow {
namespace {

using functions::constant;
using functions::in_memory;
using functions::Kit;

/// The workspace. The window of 2/pi takes 28 bytes while it is chosen; its lower 9 then become the angle in quadrants.
struct Places {
  explicit Places(int work) : fraction(work) {}
  int fraction;                 ///< 8 bytes, Q0.64
  int quadrant = fraction + 8;  ///< modulo 4 in its low bits
  int m = fraction + 28;        ///< 4 bytes: the significand, shifted
  int z = fraction + 9;         ///< 4: square of t, then the divisor of the tangent
  int p = z + 4;                ///< 4: polynomial
  int t = p + 4;                ///< 4: value, then quotient
  int count = t + 4;
  int field = count + 1;
  int flags = field + 1;
  int result = m;  ///< 4
  static constexpr int kBytes = 32;
};

/// Byte number n of 2/pi behind its point, 1 being the first.
int two_over_pi(int n) {
  return n < 1 || n > static_cast<int>(native::kTwoOverPiBytes.size()) ? 0 : native::kTwoOverPiBytes[n - 1];
}

/// fraction and quadrant := |x| 2/pi. The window of 13 bytes is chosen by five bits of the distance, the first of them
/// between constants, the others in place; the element's address of a byte is the same for all.
void write_reduction(Kit& k, const Places& at, int x) {
  Assembler& a = k.a;
  k.load_field(x);
  a.alu(Alu::Sub, To::X, P::X, Q::Immediate, {.imm = 102, .cin = Carry::One});  // the distance: 8q + shift
  a.load_w(x, 0);
  a.load_w(x + 1, 1);
  a.alu(Alu::Or, To::W, P::Immediate, Q::Memory, {.addr = x + 2, .imm = 0x80, .at = 2});
  a.set_w(0, 3);
  for (int bit = 0; bit < 3; ++bit) a.shift_left(bit, When::XBit, bit);
  k.store(at.m);
  const auto byte = [&](int n) { return at.fraction + n; };
  constexpr int kNewest = 6;  // the window's lowest byte, for q = 0, is this byte of 2/pi
  const int bytes = 13 + 15;  // of the window and the lower four bits of q
  a.flag_of(Flag::K, P::X, 7);
  for (int n = 0; n < bytes; ++n) {
    const int low = two_over_pi(kNewest + 15 - n);
    a.store_constant(low, byte(n));
    const int high = two_over_pi(kNewest + 15 - n + 16);
    if (high != low && kNewest + 15 - n + 16 <= kNewest + 19) a.store_constant(high, byte(n), Gate::EAndK);
  }
  // Lowest byte first: byte n is number kNewest + 15 - n; a q of 15 wants the lowest 13, a q of 0 the highest.
  for (int bit = 3; bit >= 0; --bit) {
    const int places = 1 << bit;
    a.flag_of(Flag::K, P::X, 3 + bit, true);
    for (int n = 0; n < 13 + places - 1; ++n) k.copy(byte(n), byte(n + places), 1, Gate::EAndK);
  }
  k.multiply(at.fraction, in_memory(at.m, 4), in_memory(at.fraction, 13), 4, 9);
}

/// t := K ? 1 - t : t, as bits.
void write_complement(Kit& k, const Places& at) {
  for (int n = 0; n < 8; ++n) {
    k.a.load_m(at.fraction + n);
    k.a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate, {.addr = at.fraction + n});
  }
}

/// W := the normalised top of t (4 bytes at at.t) and the field of its value 2^-1 at at.field.
void write_factor(Kit& k, const Places& at) {
  Assembler& a = k.a;
  k.normalise(at.fraction, 8, at.count);
  a.load_m(at.count);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.field, .imm = 126, .cin = Carry::One});
}

void write_square(Kit& k, const Places& at) {
  k.multiply(at.z, in_memory(at.fraction + 4, 4), in_memory(at.fraction + 4, 4), 4, 4);
}

/// W, X := sine of t quarters.
void write_sine(Kit& k, const Places& at) {
  Assembler& a = k.a;
  write_square(k, at);
  k.horner(at.p, at.z, native::kSine, "-----");
  write_factor(k, at);
  k.multiply(at.t, in_memory(at.fraction + 4, 4), in_memory(at.p, 4), 4, 4);
  k.load(at.t);
  a.load_m(at.field);
  a.alu(Alu::Add, To::X, P::M, Q::Immediate, {.imm = 1});
  a.normalize();
}

void write_fast_sine(Kit& k, const Places& at) {
  Assembler& a = k.a;
  const int fold = at.flags;
  const auto& c = native::kFastSine;
  k.k_from(at.fraction + 7, 7);
  k.keep_flags(fold);
  write_complement(k, at);
  // p := d - c y or b + c y.
  k.multiply(at.z, in_memory(at.fraction + 4, 4), constant(c[2], 4), 4, 4);
  k.put(at.p, c[1], 4);
  k.put(at.p, c[3], 4, Gate::EAndK);
  for (int n = 0; n < 4; ++n) {
    a.load_m(at.p + n);
    a.alu(Alu::AddSub, To::M, P::M, Q::Memory, {.addr = at.z + n, .cin = n ? Carry::C : Carry::K, .c = true});
    a.store(P::M, at.p + n);
  }
  k.normalise(at.fraction, 8, at.count);
  const auto factor = in_memory(at.fraction + 4, 4);
  k.multiply(at.t, factor, in_memory(at.p, 4), 4, 4);
  k.shift_right_word(at.z, at.t, at.count);
  k.subtract_from(at.p, c[0], 4, at.z);
  k.k_from(fold, Kit::kKeptK);
  k.copy(at.p, at.t, 4, Gate::EAndK);
  k.multiply(at.t, factor, in_memory(at.p, 4), 4, 4);
  // From the far end: 1 less that, twice as far down.
  a.load_m(at.count);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.field, .imm = 127, .cin = Carry::One});
  a.alu(Alu::ShiftLeft, To::Memory, P::Zero, Q::M, {.addr = at.count});
  k.shift_right_word(at.z, at.t, at.count);
  k.subtract_from(at.z, 0x80000000u, 4, at.z);
  k.k_from(fold, Kit::kKeptK);
  k.copy(at.t, at.z, 4, Gate::EAndK);
  a.store_constant(127, at.field, Gate::EAndK);
  k.load(at.t);
  a.load_x(at.field);
  a.normalize();
}

/// W, X := tangent of t quarters, or its inverse where bit 0 of at.flags is set. t is at most 1/2.
void write_tangent(Kit& k, const Places& at, bool fast) {
  using enum Kit::Finish;
  Assembler& a = k.a;
  const int numerator = at.t;
  if (fast) {
    a.alu(Alu::ShiftLeft, To::None, P::Zero, Q::Memory, {.addr = at.fraction + 3, .c = true});
    for (int n = 0; n < 4; ++n) {
      a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = at.fraction + 4 + n, .cin = Carry::C, .c = true});
      a.store(P::M, at.z + n);
    }
    k.multiply(at.p, in_memory(at.z, 4), constant(native::kFastTangent[1], 4), 4, 4, Minus, native::kFastTangent[0]);
    k.multiply(at.t, in_memory(at.z, 4), in_memory(at.z, 4), 4, 4);
    k.multiply(at.t, in_memory(at.t, 4), constant(native::kFastTangent[2], 4), 4, 4);
    for (int n = 0; n < 4; ++n) {
      a.load_m(at.t + n);
      a.alu(Alu::Add, To::M, P::M, Q::Memory, {.addr = at.p + n, .cin = n ? Carry::C : Carry::Zero, .c = true});
      a.store(P::M, at.p + n);
    }
  } else {
    write_square(k, at);
    k.horner(at.p, at.z, native::kTangent, "-+++");
  }
  write_factor(k, at);
  k.multiply(numerator, in_memory(at.fraction + 4, 4), in_memory(at.p, 4), 4, 4);
  k.load(numerator);
  a.load_m(at.field);
  a.alu(Alu::Add, To::X, P::M, Q::Immediate, {.imm = 1});
  a.normalize();
  k.store(numerator);
  a.store(P::X, at.field);
  // Divisor: 1 - t^2, or 1.
  for (int n = 0; n < 4; ++n) {
    if (fast) {
      a.store_constant(0xFF, at.z + n);
    } else {
      a.alu(Alu::Xor, To::M, P::Immediate, Q::Memory, {.addr = at.z + n, .imm = 0xFF});
      a.store(P::M, at.z + n);
    }
  }
  // Inverted: exchange them through the polynomial's bytes; the field is 252 - field.
  k.k_from(at.flags, 0);
  k.copy(at.p, numerator, 4);
  k.copy(numerator, at.z, 4, Gate::EAndK);
  k.copy(at.z, at.p, 4, Gate::EAndK);
  a.load_m(at.field);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate,
        {.addr = at.field, .imm = 252, .cin = Carry::One, .gate = Gate::EAndK});
  k.k_if_number_at_least(numerator, at.z, 4);
  k.load(numerator);
  a.shift_right(0, Fill::Zero, When::K);
  a.load_m(at.field);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at.field, .cin = Carry::K});
  k.divide_start();
  for (int n = 3; n >= 0; --n) k.divide_byte(at.p + n, at.z);
  k.load(at.p);
  a.load_x(at.field);
}

bool is_tangent(Code code) { return code == Code::Tan || code == Code::FastTan; }
bool is_fast(Code code) { return code == Code::FastSin || code == Code::FastCos || code == Code::FastTan; }

}  // namespace

int trigonometric_workspace(const Operation&) { return Places::kBytes; }

void write_trigonometric(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const int x = o.a.address;
  const bool cosine = o.code == Code::Cos || o.code == Code::FastCos;
  write_reduction(k, at, x);
  if (is_tangent(o.code)) {
    k.k_from(at.fraction + 7, 7);  // fold
    a.flag(Flag::C, Bit::K);
    a.flag_of_memory(Flag::C, at.quadrant, 0, false, FlagOp::Xor);
    k.keep_flags(at.flags);  // bit 0: inverted
  } else {
    k.k_from(at.quadrant, 0, cosine);
  }
  write_complement(k, at);
  if (is_tangent(o.code)) {
    write_tangent(k, at, is_fast(o.code));
  } else if (is_fast(o.code)) {
    write_fast_sine(k, at);
  } else {
    write_sine(k, at);
  }
  // The sign: of sin by the quadrant's bit 1, of cos one quadrant on, of tan by bit 0; sin and tan with that of x.
  a.flag_of_memory(Flag::S, at.quadrant, is_tangent(o.code) ? 0 : 1);
  if (cosine) {
    a.flag_of_memory(Flag::S, at.quadrant, 0, false, FlagOp::Xor);
  } else {
    a.flag_of_memory(Flag::S, x + 3, 7, false, FlagOp::Xor);
  }
  k.round_normal(at.result);
  k.k_if_magnitude_at_least(x, 0x33800000u);
  a.flag(Flag::K, Bit::K, true);
  if (cosine) {
    k.put(at.result, 0x3F800000u, 4, Gate::EAndK);
  } else {
    k.copy(at.result, x, 4, Gate::EAndK);
  }
  k.k_if_magnitude_at_least(x, 0x7F800000u);
  k.put(at.result, 0x7FC00000u, 4, Gate::EAndK);
  k.copy(o.d.address, at.result, 4);
}

}  // namespace pixelflow
