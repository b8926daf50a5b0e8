// Logarithms: cmodel/pixelflow/native/logarithm.h in microcode.
#include "cmodel/pixelflow/native/coefficients.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/logarithm_steps.h"

namespace pixelflow {
namespace functions {
namespace {

/// value := value's top bit up, field less the places.
void write_normalised(Kit& k, const LogarithmPlaces& at) {
  k.normalise(at.value, 6, at.count);
  k.add_byte(at.field, at.field, at.count, true);
}

/// divisor := m + 1, quotient := |m - 1|, normalised, places := its places.
void write_fraction(Kit& k, const LogarithmPlaces& at) {
  Assembler& a = k.a;
  k.k_from(at.significand + 3, 6);  // m >= 3/2: halved, m - 1 negative
  k.keep_flags(at.below_one);
  a.load_m(at.whole);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at.whole, .imm = 0x81, .cin = Carry::K, .c = true});
  a.load_m(at.whole + 1);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at.whole + 1, .imm = 0xFF, .cin = Carry::C});
  a.clear_w();
  for (int n = 0; n < 3; ++n) {
    a.load_m(at.significand + 1 + n);
    a.alu(Alu::NegateIf, To::W, P::M, Q::Immediate, {.at = n, .cin = n ? Carry::C : Carry::K, .c = true});
  }
  a.alu(Alu::And, To::W, P::W, Q::Immediate, {.imm = 0x7F, .at = 2});
  a.set_x(33);
  a.normalize();
  k.store(at.quotient);
  a.alu(Alu::ReverseSub, To::Memory, P::X, Q::Immediate, {.addr = at.places, .imm = 24, .cin = Carry::One});
  k.load(at.significand);
  a.shift_right(0);
  a.alu(Alu::And, To::W, P::W, Q::Immediate, {.imm = 0x3F, .at = 3});
  a.alu(Alu::Or, To::W, P::W, Q::Immediate, {.imm = 0x80, .at = 3});
  a.alu(Alu::AddIf, To::W, P::W, Q::Immediate, {.imm = 0x40, .at = 3});
  k.store(at.divisor);
}

}  // namespace

void write_logarithm_of(Kit& k, const LogarithmPlaces& at, int x) {
  using enum Kit::Finish;
  Assembler& a = k.a;
  k.split(at.significand, at.whole, x);
  write_fraction(k, at);
  k.k_if_number_at_least(at.quotient, at.divisor, 4);
  k.load(at.quotient);
  a.shift_right(0, Fill::Zero, When::K);
  a.load_m(at.places);
  a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = at.places, .imm = 0xFF});
  k.divide_start();
  for (int n = 4; n >= 0; --n) k.divide_byte(at.quotient + n, at.divisor);

  k.shift_right_word(at.w, at.quotient + 1, at.places);
  k.multiply(at.w, in_memory(at.w, 4), in_memory(at.w, 4), 4, 4);
  k.horner(at.p, at.w, native::kLogarithm, "++++");
  k.multiply(at.p, in_memory(at.w, 4), in_memory(at.p, 4), 4, 5, Plus, native::kTwoOverLn2);
  k.multiply(at.value, in_memory(at.quotient, 5), in_memory(at.p, 5), 4, 6);

  // log2 m beside E, in Q8.40.
  const int part = at.quotient;
  k.copy(part, at.value, 6);
  k.add(at.count, at.places, 6);
  k.shift_right_number(part, 6, at.count);
  k.k_from(at.whole + 1, 7);
  a.load_m(at.whole);
  a.alu(Alu::NegateIf, To::Memory, P::M, Q::Immediate, {.addr = at.significand, .cin = Carry::K});
  k.k_if_zero(at.whole, 2);
  k.k_from(at.below_one, Kit::kKeptK, false, FlagOp::And);
  k.k_from(at.whole + 1, 7, false, FlagOp::Or);
  k.keep_flags(at.flags);
  k.k_from(at.below_one, Kit::kKeptK, false, FlagOp::Xor);
  for (int n = 0; n < 6; ++n) {
    if (n < 5) {
      a.set_m(0);
    } else {
      a.load_m(at.significand);
    }
    a.alu(Alu::AddSub, To::M, P::M, Q::Memory, {.addr = part + n, .cin = n ? Carry::C : Carry::K, .c = true});
    a.store(P::M, part + n);
  }
  // E = 0: the product itself.
  a.load_m(at.places);
  a.alu(Alu::ReverseSub, To::Memory, P::M, Q::Immediate, {.addr = at.field, .imm = 128, .cin = Carry::One});
  k.k_if_zero(at.whole, 2, true);
  k.copy(at.value, part, 6, Gate::EAndK);
  a.store_constant(134, at.field, Gate::EAndK);
  write_normalised(k, at);
}

void write_fast_logarithm_of(Kit& k, const LogarithmPlaces& at, int x) {
  using enum Kit::Finish;
  Assembler& a = k.a;
  k.split(at.significand, at.whole, x);
  k.add(at.whole, at.whole, 0x81);
  a.load_m(at.whole + 1);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at.whole + 1, .imm = 0xFF, .cin = Carry::C});
  k.load(at.significand);
  a.shift_left(0);
  k.store(at.significand);
  const auto u = in_memory(at.significand + 1, 3);
  k.multiply(at.p, u, constant(native::kFastLogarithm[2], 5), 3, 5, Minus, native::kFastLogarithm[1]);
  k.multiply(at.p, u, in_memory(at.p, 5), 3, 5, Minus, native::kFastLogarithm[0]);
  k.multiply(at.value, u, in_memory(at.p, 5), 3, 5);
  // E comes above the 39 bits.
  a.alu(Alu::ShiftRight, To::None, P::Zero, Q::Memory, {.addr = at.whole + 1, .c = true});
  a.alu(Alu::ShiftRight, To::M, P::Zero, Q::Memory, {.addr = at.whole, .cin = Carry::C, .c = true});
  a.store(P::M, at.value + 5);
  a.alu(Alu::ShiftLeft, To::M, P::Zero, Q::Memory, {.addr = at.value + 4});
  a.alu(Alu::ShiftRight, To::Memory, P::Zero, Q::M, {.addr = at.value + 4, .cin = Carry::C});
  k.k_from(at.value + 5, 7);
  k.keep_flags(at.flags);
  k.negate_if(at.value, 6);
  a.store_constant(135, at.field);
  write_normalised(k, at);
}

}  // namespace functions

int logarithm_workspace(const Operation&) { return functions::LogarithmPlaces::kBytes; }

void write_logarithm(Assembler& a, const Operation& o) {
  functions::Kit k(a);
  const functions::LogarithmPlaces at(o.work);
  const int x = o.a.address;
  const int result = at.scratch;
  const bool fast = o.code == Code::FastLog || o.code == Code::FastLog2;
  if (fast) {
    functions::write_fast_logarithm_of(k, at, x);
  } else {
    functions::write_logarithm_of(k, at, x);
  }
  const bool natural = o.code == Code::Log || o.code == Code::FastLog;
  if (natural) {
    k.multiply(result, functions::in_memory(at.value + 2, 4), functions::constant(native::kLn2Q32, 4), 4, 4);
    k.load(result);
  } else {
    k.load(at.value + 2);
  }
  a.load_x(at.field);
  a.normalize();
  a.flag_of_memory(Flag::S, at.flags, functions::Kit::kKeptK);
  k.round_normal(result);
  // log 1 = 0; infinity gives infinity; NaN and negative numbers NaN; zeros minus infinity.
  k.k_if_zero(at.value + 5, 1);
  k.put(result, 0, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 0x7F800000u);
  k.put(result, 0x7F800000u, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 0x7F800001u);
  a.flag_of_memory(Flag::K, x + 3, 7, false, FlagOp::Or);
  k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 1);
  a.flag(Flag::K, Bit::K, true);
  k.put(result, 0xFF800000u, 4, Gate::EAndK);
  k.copy(o.d.address, result, 4);
}

}  // namespace pixelflow
