// Powers: cmodel/pixelflow/native/power.h in microcode.
#include "pixelflow/microcode/functions/exponential_steps.h"
#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/functions/logarithm_steps.h"

namespace pixelflow {
namespace {

using functions::in_memory;
using functions::Kit;

struct Places {
  explicit Places(int work) : log(work) {}
  functions::LogarithmPlaces log;
  int product = log.scratch;  ///< 8 bytes: y log2 |x|, then its lower 5 as the exponent, then the result
  int y = product + 8;        ///< 4: significand
  int field16 = y + 4;        ///< 2: of y
  int places = field16 + 2;   ///< 2: of the product to the right
  int p = places + 2;         ///< 4
  int parity = p + 4;         ///< S: y is odd, K: y is an integer
  int flags = parity + 1;
  int sign = flags + 1;  ///< bit 7: of the result
  int count = sign + 1;
  int infinite = count + 1;    ///< K: the limit is infinite
  int extreme = infinite + 1;  ///< K: the limit counts
  int operand = extreme + 1;   ///< 4: a uniform operand
  static constexpr int kBytes = 35;
};
static_assert(Places::kBytes >= functions::LogarithmPlaces::kBytes);

/// Parity of y.
void write_parity(Kit& k, const Places& at, int y) {
  Assembler& a = k.a;
  k.load_field(y);
  a.store(P::X, at.count);
  a.set_w(0, 0);
  a.load_w(y, 1);
  a.load_w(y + 1, 2);
  a.alu(Alu::Or, To::W, P::Immediate, Q::Memory, {.addr = y + 2, .imm = 0x80, .at = 3});
  a.alu(Alu::ReverseSub, To::X, P::X, Q::Immediate, {.imm = 150, .cin = Carry::One});  // fraction bits
  a.align_right(Fill::Jam);  // the integer's last bit comes to stand in byte 1, what is behind the point in byte 0
  a.alu(Alu::Or, To::None, P::W, Q::Immediate, {.at = 0, .z = ZMode::Set});
  a.flag_of(Flag::S, P::W, 0, false, FlagOp::Move, 1);
  k.k_if_at_least(at.count, 127);
  a.flag(Flag::K, Bit::Z, false, FlagOp::And);
  a.load_m(at.count);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = 151, .cin = Carry::One, .c = true});
  a.flag(Flag::S, Bit::K, false, FlagOp::And);
  a.flag(Flag::S, Bit::C, true, FlagOp::And);
  a.flag(Flag::K, Bit::C, false, FlagOp::Or);
  k.keep_flags(at.parity);
}

constexpr int kKeptS = 2;

/// infinite, extreme := where the result is a limit, and which.
void write_limits(Kit& k, const Places& at, int x, int y) {
  Assembler& a = k.a;
  k.k_if_magnitude_at_least(x, 0x3F800001u);
  k.k_from(y + 3, 7, false, FlagOp::Xor);
  k.keep_flags(at.infinite);
  // y is infinite and |x| is not 1, or x is infinite or zero.
  k.k_if_magnitude_at_least(x, 0x3F800001u);
  k.keep_flags(at.extreme);
  k.k_if_magnitude_at_least(x, 0x3F800000u);
  a.flag(Flag::K, Bit::K, true);
  k.k_from(at.extreme, Kit::kKeptK, false, FlagOp::Or);
  k.keep_flags(at.extreme);
  k.k_if_magnitude_at_least(y, 0x7F800000u);
  k.k_from(at.extreme, Kit::kKeptK, false, FlagOp::And);
  k.keep_flags(at.extreme);
  k.k_if_magnitude_at_least(x, 0x7F800000u);
  k.k_from(at.extreme, Kit::kKeptK, false, FlagOp::Or);
  k.keep_flags(at.extreme);
  k.k_if_magnitude_at_least(x, 1);
  a.flag(Flag::K, Bit::K, true);
  k.k_from(at.extreme, Kit::kKeptK, false, FlagOp::Or);
  k.keep_flags(at.extreme);
}

void write_special(Kit& k, const Places& at, int x, int y, int result) {
  Assembler& a = k.a;
  write_limits(k, at, x, y);
  k.k_from(at.extreme, Kit::kKeptK);
  k.put(result, 0, 3, Gate::EAndK);
  k.copy(result + 3, at.sign, 1, Gate::EAndK);
  k.k_from(at.infinite, Kit::kKeptK, false, FlagOp::And);
  a.store_constant(0x80, result + 2, Gate::EAndK);
  a.load_m(at.sign);
  a.alu(Alu::Or, To::Memory, P::M, Q::Immediate, {.addr = result + 3, .imm = 0x7F, .gate = Gate::EAndK});
  // NaN: a negative x with a y that is no integer, and NaN itself.
  k.k_from(x + 3, 7);
  k.k_from(at.parity, Kit::kKeptK, true, FlagOp::And);
  k.k_from(at.extreme, Kit::kKeptK, true, FlagOp::And);
  k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  for (const int operand : {x, y}) {
    k.k_if_magnitude_at_least(operand, 0x7F800001u);
    k.put(result, 0x7FC00000u, 4, Gate::EAndK);
  }
  // 1: y is zero, or x is 1.
  k.k_if_magnitude_at_least(y, 1);
  a.flag(Flag::K, Bit::K, true);
  k.put(result, 0x3F800000u, 4, Gate::EAndK);
  k.k_if_magnitude_at_least(x, 0x3F800001u);
  k.keep_flags(at.extreme);
  k.k_if_magnitude_at_least(x, 0x3F800000u);
  k.k_from(at.extreme, Kit::kKeptK, true, FlagOp::And);
  k.k_from(x + 3, 7, true, FlagOp::And);
  k.put(result, 0x3F800000u, 4, Gate::EAndK);
}

}  // namespace

int power_workspace(const Operation& o) { return Places::kBytes + (o.a.uniform || o.b.uniform ? 4 : 0); }

void write_power(Assembler& a, const Operation& o) {
  Kit k(a);
  const Places at(o.work);
  const int uniform = o.work + Places::kBytes;
  if (o.a.uniform) k.put(uniform, o.a.constant, 4);
  if (o.b.uniform) k.put(uniform, o.b.constant, 4);
  const int x = o.a.uniform ? uniform : o.a.address;
  const int y = o.b.uniform ? uniform : o.b.address;
  functions::write_logarithm_of(k, at.log, x);
  write_parity(k, at, y);
  k.k_from(at.parity, kKeptS);
  k.k_from(x + 3, 7, false, FlagOp::And);
  a.set_m(0);
  a.alu(Alu::AddIf, To::Memory, P::M, Q::Immediate, {.addr = at.sign, .imm = 0x80});

  k.split(at.y, at.field16, y);
  k.multiply(at.product, in_memory(at.log.value + 1, 5), in_memory(at.y + 1, 3), 0, 8);
  // places := 284 - both fields; below 23 the exponent does not fit.
  constexpr int kPlaces = 30 + 127 + 127;
  a.set_m(kPlaces & 0xFF);
  a.alu(Alu::Sub, To::M, P::M, Q::Memory, {.addr = at.log.field, .cin = Carry::One, .c = true});
  a.store(P::M, at.places);
  a.set_m(kPlaces >> 8);
  a.alu(Alu::Sub, To::Memory, P::M, Q::Immediate, {.addr = at.places + 1, .cin = Carry::C});
  for (int n = 0; n < 2; ++n) {
    a.load_m(at.places + n);
    a.alu(Alu::Sub, To::M, P::M, Q::Memory, {.addr = at.field16 + n, .cin = n ? Carry::C : Carry::One, .c = true});
    a.store(P::M, at.places + n);
  }
  k.shift_right_number(at.product, 8, at.places);
  a.load_m(at.places);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.imm = 23, .cin = Carry::One, .c = true});
  a.load_m(at.places + 1);
  a.alu(Alu::Sub, To::None, P::M, Q::Immediate, {.cin = Carry::C, .s = true});
  k.k_if_zero(at.product + 5, 3, true);
  a.flag(Flag::K, Bit::S, false, FlagOp::Or);
  a.flag(Flag::C, Bit::K);
  k.k_if_zero(at.log.value + 5, 1, true);  // |x| = 1: the product is zero
  a.flag(Flag::K, Bit::C, false, FlagOp::And);
  k.put(at.product, ~std::uint64_t{0}, 5, Gate::EAndK);
  k.k_from(at.log.flags, Kit::kKeptK);
  k.k_from(y + 3, 7, false, FlagOp::Xor);
  functions::write_power_of_two(k, {.exponent = at.product, .p = at.p, .count = at.count, .sign = at.sign}, false);
  write_special(k, at, x, y, at.product);
  k.copy(o.d.address, at.product, 4);
}

}  // namespace pixelflow
