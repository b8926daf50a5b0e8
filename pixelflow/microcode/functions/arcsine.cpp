// Arc sine, arc cosine and the inverse square root: cmodel/pixelflow/native/arcsine.h in microcode.
#include "cmodel/pixelflow/native/coefficients.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/kit.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

using functions::constant;
using functions::in_memory;
using functions::Kit;

struct Places {
  explicit Places(int work) : root(work) {}
  int root;                 ///< 4 bytes: s, then v
  int radicand = root + 4;  ///< 4: then s in Q0.32
  int z = radicand + 4;     ///< 4: s^2, then v in Q2.30
  int p = z + 4;            ///< 4: polynomial, then the result
  int field = p + 4;        ///< of s, then of v
  int count = field + 1;
  int flags = count + 1;  ///< K: |x| >= 1/2
  int more = flags + 1;   ///< workspace of the root
};

/// d := root of a 4-byte radicand in [1/4, 1) of Q0.32; 32 bits.
Operation root_operation(int d, int radicand, int work) {
  Operation o;
  o.code = Code::SquareRoot;
  o.d = {.address = static_cast<std::uint8_t>(d), .bytes = 4};
  o.a = {.address = static_cast<std::uint8_t>(radicand), .bytes = 4};
  o.scale = 32;
  o.work = static_cast<std::uint8_t>(work);
  return o;
}

bool is_fast(Code code) { return code == Code::FastAsin || code == Code::FastAcos; }
bool is_cosine(Code code) { return code == Code::Acos || code == Code::FastAcos; }

/// root, field := s. flags tells the half.
void write_argument(Kit& k, const Places& at, int x) {
  Assembler& a = k.a;
  k.load_field(x);
  a.store(P::X, at.field);
  // 1 - |x| in units of 2^-24, 0 from field 127 on.
  a.clear_w();
  a.load_m(x);
  a.alu(Alu::ReverseSub, To::W, P::M, Q::Immediate, {.at = 0, .cin = Carry::One, .c = true});
  a.load_m(x + 1);
  a.alu(Alu::ReverseSub, To::W, P::M, Q::Immediate, {.at = 1, .cin = Carry::C, .c = true});
  a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = x + 2, .imm = 0x80});
  a.alu(Alu::ReverseSub, To::W, P::M, Q::Immediate, {.at = 2, .cin = Carry::C});
  k.store(at.radicand);
  a.flag_of(Flag::K, P::X, 0);
  k.put(at.radicand, 0, 4, Gate::EAndK);
  k.load(at.radicand);
  a.set_x(33);
  a.normalize();
  a.flag_of(Flag::K, P::X, 0);  // X = 33 - places; the exponent 6 - places is even
  a.shift_right(0, Fill::Zero, When::K);
  k.store(at.radicand);
  a.alu(Alu::Add, To::M, P::X, Q::Immediate, {.imm = 254 - 27, .c = true});
  a.alu(Alu::ShiftRight, To::Memory, P::Zero, Q::M, {.addr = at.count, .cin = Carry::C});
  write_square_root(a, root_operation(at.root, at.radicand, at.more));
  a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = x + 3, .imm = 0x7F});
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = 0x3F, .cin = Carry::One, .c = true});
  a.flag(Flag::K, Bit::C);
  k.keep_flags(at.flags);
  k.copy(at.field, at.count, 1, Gate::EAndK);
  a.flag(Flag::K, Bit::K, true);
  a.store_constant(0, at.root, Gate::EAndK);
  k.copy(at.root + 1, x, 2, Gate::EAndK);
  a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = x + 2, .imm = 0x80});
  a.store(P::M, at.root + 3, Gate::EAndK);
}

/// root, field := v, z := v in Q2.30.
void write_value(Kit& k, const Places& at, bool fast) {
  using enum Kit::Finish;
  Assembler& a = k.a;
  const int s = at.radicand;
  a.load_m(at.field);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.count, .imm = 126, .cin = Carry::One});
  k.shift_right_word(s, at.root, at.count);
  k.multiply(at.z, in_memory(s, 4), in_memory(s, 4), 4, 4);
  if (fast) {
    k.multiply(at.p, in_memory(s, 4), constant(native::kFastArcsine[1], 4), 4, 4, Minus, native::kFastArcsine[0]);
    k.multiply(s, in_memory(at.z, 4), constant(native::kFastArcsine[2], 4), 4, 4);
    for (int n = 0; n < 4; ++n) {
      a.load_m(s + n);
      a.alu(Alu::Add, To::M, P::M, Q::Memory, {.addr = at.p + n, .cin = n ? Carry::C : Carry::Zero, .c = true});
      a.store(P::M, at.p + n);
    }
  } else {
    k.horner(at.p, at.z, native::kArcsine, "+++++++");
  }
  k.multiply(at.z, in_memory(at.root, 4), in_memory(at.p, 4), 4, 4);
  k.load(at.z);
  k.k_from(at.flags, Kit::kKeptK);
  a.load_m(at.field);
  a.alu(Alu::Add, To::X, P::M, Q::Immediate, {.imm = 1, .cin = Carry::K});
  a.normalize();
  k.store(at.root);
  a.store(P::X, at.field);
  a.alu(Alu::ReverseSub, To::Memory, P::X, Q::Immediate, {.addr = at.count, .imm = 128, .cin = Carry::One});
  k.shift_right_word(at.z, at.root, at.count);
}

}  // namespace

int arcsine_workspace(const Operation& o) {
  const Places at(o.work);
  return at.more - o.work + square_root_workspace(root_operation(at.root, at.radicand, at.more));
}

void write_arcsine(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const int x = o.a.address;
  const bool cosine = is_cosine(o.code);
  const int result = at.p;
  write_argument(k, at, x);
  write_value(k, at, is_fast(o.code));
  // p := pi/2 or pi, less or more v.
  k.k_from(at.flags, Kit::kKeptK);
  k.put(at.p, native::kHalfPiQ30, 4);
  if (cosine) {
    k.put(at.p, native::kPiQ30, 4, Gate::EAndK);
    k.k_from(x + 3, 7, true, FlagOp::Xor);  // subtract unless the sign differs from the half
  } else {
    a.flag(Flag::K, Bit::One);
  }
  a.clear_w();
  for (int n = 0; n < 4; ++n) {
    a.load_m(at.p + n);
    a.alu(Alu::AddSub, To::W, P::M, Q::Memory, {.addr = at.z + n, .at = n, .cin = n ? Carry::C : Carry::K, .c = true});
  }
  a.set_x(128);
  a.normalize();
  // v itself: asin of the lower half, acos of the positive upper one.
  k.k_from(at.flags, Kit::kKeptK, !cosine);
  if (cosine) k.k_from(x + 3, 7, true, FlagOp::And);
  a.flag(Flag::K, Bit::K, true);
  for (int n = 0; n < 4; ++n)
    a.alu(Alu::Or, To::Memory, P::W, Q::Immediate, {.addr = at.root + n, .at = n, .gate = Gate::EAndK});
  a.store(P::X, at.field, Gate::EAndK);
  k.load(at.root);
  a.load_x(at.field);
  if (cosine) {
    a.flag(Flag::S, Bit::One, true);
  } else {
    a.flag_of_memory(Flag::S, x + 3, 7);
  }
  k.round_normal(result);
  if (cosine) {
    k.k_if_magnitude_at_least(x, 0x3F800000u);
    k.put(result, 0, 4, Gate::EAndK);  // of 1; that of -1 is right already
    k.k_from(x + 3, 7, false, FlagOp::And);
    k.put(result, 0x40490FDBu, 4, Gate::EAndK);
  } else {
    k.k_if_magnitude_at_least(x, 0x33800000u);
    a.flag(Flag::K, Bit::K, true);
    k.copy(result, x, 4, Gate::EAndK);
  }
  k.k_if_magnitude_at_least(x, 0x3F800001u);
  k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  k.copy(o.d.address, result, 4);
}

int inverse_square_root_workspace(const Operation& o) {
  const Places at(o.work);
  return at.more - o.work + square_root_workspace(root_operation(at.root, at.radicand, at.more));
}

void write_inverse_square_root(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const int x = o.a.address;
  const int field16 = at.field;  // and at.count
  const int result = at.p;
  k.split(at.radicand, field16, x);
  // The exponent e = field - 127 is even where the field is odd; the root's is floor(e / 2), the inverse's -1 - floor(e
  // / 2): its field is 126 - floor((field - 127) / 2) = 190 - ceil(field / 2) for odd fields, and so for even ones.
  k.k_from(field16, 0);
  k.load(at.radicand);
  a.shift_right(0, Fill::Zero, When::K);
  k.store(at.radicand);
  a.alu(Alu::ShiftRight, To::None, P::Zero, Q::Memory, {.addr = field16 + 1, .c = true});
  a.alu(Alu::ShiftRight, To::M, P::Zero, Q::Memory, {.addr = field16, .cin = Carry::C});
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.flags, .imm = 190, .cin = Carry::One});
  a.load_m(at.flags);
  a.flag(Flag::K, Bit::K, true);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at.flags, .imm = 0xFF, .cin = Carry::K});
  a.load_m(at.flags);
  write_square_root(a, root_operation(at.root, at.radicand, at.more));
  for (int n = 0; n < 4; ++n) a.set_w(n < 3 ? 0xFF : 0x7F, n);
  k.divide_start();
  for (int n = 3; n >= 0; --n) k.divide_byte(at.p + n, at.root);
  k.load(at.p);
  a.load_x(at.flags);
  a.normalize();
  a.flag(Flag::S, Bit::One, true);
  k.round_normal(result);
  // Infinity gives 0; NaN and negative numbers NaN; zeros infinity of their sign.
  k.k_if_magnitude_at_least(x, 0x7F800000u);
  k.put(result, 0, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 0x7F800001u);
  a.flag_of_memory(Flag::K, x + 3, 7, false, FlagOp::Or);
  k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 1);
  a.flag(Flag::K, Bit::K, true);
  k.put(result, 0x7F800000u, 3, Gate::EAndK);
  a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = x + 3, .imm = 0x7F});
  a.store(P::M, result + 3, Gate::EAndK);
  k.copy(o.d.address, result, 4);
}

}  // namespace pixelflow
