// Arc tangents: cmodel/pixelflow/native/arctangent.h in microcode.
#include "cmodel/pixelflow/native/coefficients.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/kit.h"

namespace pixelflow {
namespace {

using functions::in_memory;
using functions::Kit;

struct Places {
  explicit Places(int work) : small(work) {}
  int small;                       ///< 4 bytes: lesser magnitude, its significand, then v
  int large = small + 4;           ///< 4: greater magnitude, its significand, then v in Q2.30
  int small_field = large + 4;     ///< 2: then of v
  int distance = small_field + 2;  ///< 2: field of the greater; then places of q before its first bit, at most 200
  int quotient = distance + 2;     ///< 4
  int z = quotient + 4;            ///< 4: q in Q0.32, then its square
  int p = z + 4;                   ///< 4: polynomial, then the result
  int flat = p + 4;                ///< K: |y| <= |x|
  int zero = flat + 1;             ///< K: q counts as 0
  int count = zero + 1;
  int uniform = count + 1;  ///< 4: an operand that is a constant
};

constexpr int kFurthest = 200;  // the result is zero, or does not see v any more, long before

bool is_fast(Code code) { return code == Code::FastAtan || code == Code::FastAtan2; }
bool has_uniform(const Operation& o) {
  return o.code == Code::Atan || o.code == Code::FastAtan || o.a.uniform || o.b.uniform;
}

/// small, large := the magnitudes in order, flat and zero.
void write_order(Kit& k, const Places& at, int y, int x) {
  Assembler& a = k.a;
  for (const auto& [to, from] : {std::pair{at.small, y}, std::pair{at.large, x}}) {
    k.copy(to, from, 3);
    a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = from + 3, .imm = 0x7F});
    a.store(P::M, to + 3);
  }
  k.k_if_number_at_least(at.large, at.small, 4);
  k.keep_flags(at.flat);
  a.flag(Flag::K, Bit::K, true);
  k.copy(at.quotient, at.small, 4);
  k.copy(at.small, at.large, 4, Gate::EAndK);
  k.copy(at.large, at.quotient, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(at.small, 0x7F800000u);
  k.keep_flags(at.zero);
  k.k_if_magnitude_at_least(at.large, 0x7F800000u);
  k.k_from(at.zero, Kit::kKeptK, true, FlagOp::And);
  a.flag(Flag::C, Bit::K);
  k.k_if_zero(at.small, 4);
  a.flag(Flag::K, Bit::C, false, FlagOp::Or);
  k.keep_flags(at.zero);
}

/// quotient, distance := small / large.
void write_quotient(Kit& k, const Places& at) {
  Assembler& a = k.a;
  k.split(at.small, at.small_field, at.small);
  k.split(at.large, at.distance, at.large);
  for (int n = 0; n < 4; ++n) {
    a.load_m(at.small + n);
    a.alu(Alu::Sub, To::Memory, P::M, Q::Immediate,
          {.addr = at.small + n, .imm = n ? 0 : 1, .cin = n ? Carry::C : Carry::One, .c = true});
  }
  k.k_if_number_at_least(at.small, at.large, 4);
  a.flag(Flag::C, Bit::K, true);  // one place less where the dividend is halved
  for (int n = 0; n < 2; ++n) {
    a.load_m(at.distance + n);
    a.alu(Alu::Sub, To::M, P::M, Q::Memory, {.addr = at.small_field + n, .cin = Carry::C, .c = true});
    a.store(P::M, at.distance + n);
  }
  k.load(at.small);
  a.shift_right(0, Fill::Zero, When::K);
  k.k_if_at_least(at.distance, kFurthest);
  a.flag(Flag::C, Bit::K);
  k.k_if_zero(at.distance + 1, 1, true);
  a.flag(Flag::K, Bit::C, false, FlagOp::Or);
  a.store_constant(kFurthest, at.distance, Gate::EAndK);
  k.divide_start();
  for (int n = 3; n >= 0; --n) k.divide_byte(at.quotient + n, at.large);
}

/// small, small_field := v, large := v in Q2.30.
void write_value(Kit& k, const Places& at, bool fast) {
  Assembler& a = k.a;
  k.shift_right_word(at.z, at.quotient, at.distance);
  if (fast) {
    k.horner(at.p, at.z, native::kFastArctangent, "-+");
  } else {
    k.multiply(at.z, in_memory(at.z, 4), in_memory(at.z, 4), 4, 4);
    k.horner(at.p, at.z, native::kArctangent, "------------");
  }
  k.multiply(at.small, in_memory(at.quotient, 4), in_memory(at.p, 4), 4, 4);
  k.load(at.small);
  a.set_x(33);
  a.normalize();
  k.store(at.small);
  a.alu(Alu::Add, To::M, P::X, Q::Immediate, {.imm = 126 - 33});
  a.alu(Alu::Sub, To::M, P::M, Q::Memory, {.addr = at.distance, .cin = Carry::One, .c = true});
  a.store(P::M, at.small_field);
  a.alu(Alu::Sub, To::Memory, P::Zero, Q::Immediate, {.addr = at.small_field + 1, .cin = Carry::C});
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.count, .imm = 128, .cin = Carry::One});
  k.shift_right_word(at.large, at.small, at.count);
  k.k_from(at.zero, Kit::kKeptK);
  k.put(at.large, 0, 4, Gate::EAndK);
}

}  // namespace

int arctangent_workspace(const Operation& o) {
  const Places at(o.work);
  return at.uniform - o.work + (has_uniform(o) ? 4 : 0);
}

void write_arctangent(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const bool two = o.code == Code::Atan2 || o.code == Code::FastAtan2;
  if (!two) {
    k.put(at.uniform, 0x3F800000u, 4);
  } else if (o.a.uniform || o.b.uniform) {
    k.put(at.uniform, o.a.uniform ? o.a.constant : o.b.constant, 4);
  }
  const int y = o.a.uniform ? at.uniform : o.a.address;
  const int x = !two || o.b.uniform ? at.uniform : o.b.address;
  const int result = at.p;
  write_order(k, at, y, x);
  write_quotient(k, at);
  write_value(k, at, is_fast(o.code));
  // W, X := pi/2 or pi, less or (steep and x negative) more v.
  k.put(at.p, native::kHalfPiQ30, 4);
  k.k_from(at.flat, Kit::kKeptK);
  k.put(at.p, native::kPiQ30, 4, Gate::EAndK);
  k.k_from(x + 3, 7, true, FlagOp::Or);
  a.clear_w();
  for (int n = 0; n < 4; ++n) {
    a.load_m(at.p + n);
    a.alu(Alu::AddSub, To::W, P::M, Q::Memory,
          {.addr = at.large + n, .at = n, .cin = n ? Carry::C : Carry::K, .c = true});
  }
  a.set_x(128);
  a.normalize();
  k.k_from(at.flat, Kit::kKeptK, true);
  k.k_from(x + 3, 7, false, FlagOp::Or);
  for (int n = 0; n < 4; ++n)
    a.alu(Alu::Or, To::Memory, P::W, Q::Immediate, {.addr = at.small + n, .at = n, .gate = Gate::EAndK});
  a.store(P::X, at.small_field, Gate::EAndK);
  a.store_constant(0, at.small_field + 1, Gate::EAndK);
  k.round_any(result, at.small, at.small_field, at.count, y + 3);
  // q = 0 on the positive side: zero with the sign of y.
  k.k_from(at.zero, Kit::kKeptK);
  k.k_from(at.flat, Kit::kKeptK, false, FlagOp::And);
  k.k_from(x + 3, 7, true, FlagOp::And);
  k.put(result, 0, 3, Gate::EAndK);
  a.alu(Alu::And, To::M, P::Immediate, Q::Memory, {.addr = y + 3, .imm = 0x80});
  a.store(P::M, result + 3, Gate::EAndK);
  for (const int operand : {y, x}) {
    k.k_if_magnitude_at_least(operand, 0x7F800001u);
    k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  }
  k.copy(o.d.address, result, 4);
}

}  // namespace pixelflow
