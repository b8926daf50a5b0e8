// Powers of two and of e: cmodel/pixelflow/native/exponential.h in microcode.
#include "cmodel/pixelflow/native/coefficients.h"
#include "pixelflow/microcode/functions/exponential_steps.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/kit.h"

namespace pixelflow {

using functions::constant;
using functions::in_memory;
using functions::Kit;

namespace functions {

void write_power_of_two(Kit& k, const PowerOfTwo& at, bool fast) {
  Assembler& a = k.a;
  k.negate_if(at.exponent, 5, at.exponent + 5);
  const int field16 = at.exponent + 4;
  k.add(field16, field16, 127);
  a.load_m(field16 + 1);
  a.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = field16 + 1, .cin = Carry::C});
  if (fast) {
    k.horner(at.p, at.exponent, native::kFastExponential, "+++");
  } else {
    k.horner(at.p, at.exponent, native::kExponential, "+++++++");
  }
  k.round_any(at.exponent, at.p, field16, at.count, at.sign);
}

}  // namespace functions

namespace {

struct Places {
  explicit Places(int work) : exponent(work) {}
  int exponent;          ///< 6 bytes: Q8.32, then the result and its field
  int p = exponent + 6;  ///< 4
  int m = p + 4;         ///< 3: significand; then a byte of workspace and the sign
  int count = m + 3;
  static constexpr int kBytes = 14;
};

}  // namespace

int exponential_workspace(const Operation&) { return Places::kBytes; }

void write_exponential(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const int x = o.a.address;
  const bool natural = o.code == Code::Exp || o.code == Code::FastExp;
  const bool fast = o.code == Code::FastExp || o.code == Code::FastExp2;
  const int limit = natural ? 134 : 135;  // the field from which on nothing can be held
  const int m = natural ? at.m : at.exponent + 2;
  k.copy(m, x, 2);
  a.alu(Alu::Or, To::M, P::Immediate, Q::Memory, {.addr = x + 2, .imm = 0x80});
  a.store(P::M, m + 2);
  if (natural) {
    k.multiply(at.exponent, in_memory(m, 3), constant(native::kLog2EQ39, 5), 3, 5);
  } else {
    k.put(at.exponent, 0, 2);
  }
  k.load_field(x);
  a.alu(Alu::ReverseSub, To::Memory, P::X, Q::Immediate, {.addr = at.count, .imm = limit - 1, .cin = Carry::One});
  k.shift_right_number(at.exponent, 5, at.count);
  k.load_field(x);
  a.alu(Alu::Sub, To::None, P::X, Q::Immediate, {.imm = limit, .cin = Carry::One, .c = true});
  a.flag(Flag::K, Bit::C);
  k.put(at.exponent, ~std::uint64_t{0}, 5, Gate::EAndK);
  a.store_constant(0, at.m);
  k.k_from(x + 3, 7);
  functions::write_power_of_two(k, {.exponent = at.exponent, .p = at.p, .count = at.count, .sign = at.m}, fast);
  k.k_if_magnitude_at_least(x, 0x7F800001u);
  k.put(at.exponent, 0x7FC00000u, 4, Gate::EAndK);
  k.copy(o.d.address, at.exponent, 4);
}

}  // namespace pixelflow
