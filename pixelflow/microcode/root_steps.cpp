#include "pixelflow/microcode/root_steps.h"

#include <algorithm>

namespace pixelflow {

void RootSteps::step(int step) {
  const int at = 30 - step, byte = at / 8, b = 1 << at % 8;
  bool low_constant = false;
  if (feeding_) {  // X is in use: Z stays in memory. These are the first bits, all in the top byte
    const int z = z_ + 3;
    a_.divide(false, true, 4);
    a_.alu(Alu::NegateIf, To::M, P::Immediate, Q::Memory, {.addr = z, .imm = 2 * b, .cin = Carry::K});
    a_.store(P::M, t_);
    a_.alu(Alu::NegateIf, To::M, P::Immediate, Q::Memory, {.addr = z, .imm = b, .cin = Carry::K});
    if (--feeding_) {
      a_.alu(Alu::AddSub, To::W, P::W, Q::M, {.at = 3, .cin = Carry::K});
      a_.load_m(t_);
      a_.store(P::M, z);
      a_.flag_of(Flag::K, P::W, 7, true, FlagOp::Move, 3);
      return;
    }
    a_.load_x(t_);
  } else {
    double_v(step);
    if (at % 8 == 7) {  // T's low byte is 0x80 in either sense, and a borrow goes up; Z's bit is in the byte above
      low_constant = true;
      a_.alu(Alu::AddIf, To::M, P::X, Q::Immediate, {.imm = 0xFF});
      a_.alu(Alu::AddSub, To::X, P::X, Q::Immediate, {.imm = 1, .cin = Carry::K});
    } else if (at % 8 == 6) {  // the byte above gets its last borrow, Z's new byte is 0x80 in either sense
      a_.alu(Alu::AddIf, To::Memory, P::X, Q::Immediate, {.addr = z_ + byte + 1, .imm = 0xFF});
      a_.alu(Alu::AddSub, To::M, P::Zero, Q::Immediate, {.imm = b, .cin = Carry::K});
      a_.set_x(0x80);
    } else {
      a_.alu(Alu::AddSub, To::M, P::X, Q::Immediate, {.imm = b, .cin = Carry::K});
      a_.alu(Alu::AddSub, To::X, P::X, Q::Immediate, {.imm = 2 * b, .cin = Carry::K});
    }
  }
  for (int n = byte; n < 4; ++n) {
    AluExtras e{.at = n, .cin = n > byte ? Carry::C : Carry::K, .c = true};
    if (low_constant && n == byte) {
      e.imm = 0x80;
      a_.alu(Alu::AddSub, To::W, P::W, Q::Immediate, e);
    } else if (n == byte + (low_constant ? 1 : 0)) {
      a_.alu(Alu::AddSub, To::W, P::W, Q::M, e);
    } else {
      e.addr = z_ + n;
      a_.alu(Alu::AddSub, To::W, P::W, Q::Memory, e);
    }
  }
  a_.flag_of(Flag::K, P::W, 7, true, FlagOp::Move, 3);
}

/// 2V + 1: a left shift brings a zero where V wants a one, so that V comes to stand for -R - excess instead of -R - 1.
/// That is harmless while the excess is at most the grain of R; before it gets bigger the bits that must be ones are
/// set again.
void RootSteps::double_v(int step) {
  const auto grain = [&](int after) {
    return std::max(0, 30 - std::max(fraction_bits_ - after, after));
  };  // as a bit of W
  a_.shift_left(0);
  excess_ *= 2;
  const bool handed_on = exact_ && step == kMost;
  if (excess_ <= 1ll << grain(step) && !handed_on) return;
  const int bits = grain(step - 1) + 1;
  for (int n = 0; 8 * n < bits; ++n) {
    const int ones = bits - 8 * n >= 8 ? 0xFF : (1 << (bits - 8 * n)) - 1;
    a_.alu(Alu::Or, To::W, P::W, Q::Immediate, {.imm = ones, .at = n});
  }
  excess_ = 1;
}

}  // namespace pixelflow
