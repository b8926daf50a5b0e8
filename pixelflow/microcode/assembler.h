// Writes instructions for the pixel processors, one call an instruction; the idioms that the routines share.
// The instruction set is described in docs/pixel_processor.md.
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/pixelflow/instruction.h"
#include "cmodel/pixelflow/operation.h"

namespace pixelflow {

/// What an ALU instruction has besides function, destination and operands.
struct AluExtras {
  int addr = 0;
  int imm = 0;
  int at = 0;
  Carry cin = Carry::Zero;
  bool c = false;  ///< set C
  ZMode z = ZMode::Keep;
  bool s = false;  ///< set S
  Gate gate = Gate::E;
  bool down = false;
};

class Assembler {
 public:
  explicit Assembler(std::vector<Instruction>& stream) : stream_(stream) {}

  void alu(Alu fn, To to, P p, Q q, const AluExtras& extras = {});

  // Moves.
  void load_m(int address) { alu(Alu::Or, To::M, P::Zero, Q::Memory, {.addr = address}); }
  void load_x(int address) { alu(Alu::Or, To::X, P::Zero, Q::Memory, {.addr = address}); }
  void load_w(int address, int at) { alu(Alu::Or, To::W, P::Zero, Q::Memory, {.addr = address, .at = at}); }
  void set_m(int value) { alu(Alu::Or, To::M, P::Zero, Q::Immediate, {.imm = value}); }
  void set_x(int value) { alu(Alu::Or, To::X, P::Zero, Q::Immediate, {.imm = value}); }
  void set_w(int value, int at) { alu(Alu::Or, To::W, P::Zero, Q::Immediate, {.imm = value, .at = at}); }
  void store(P from, int address, Gate gate = Gate::E) {
    alu(Alu::Or, To::Memory, from, Q::Immediate, {.addr = address, .gate = gate});
  }
  void store_w(int address, int at) { alu(Alu::Or, To::Memory, P::W, Q::Immediate, {.addr = address, .at = at}); }
  void store_constant(int value, int address, Gate gate = Gate::E) {
    alu(Alu::Or, To::Memory, P::Zero, Q::Immediate, {.addr = address, .imm = value, .gate = gate});
  }
  /// Writes W's low byte and moves W down by a byte; down() drops it.
  void store_w_down(int address) { alu(Alu::Or, To::Memory, P::W, Q::Immediate, {.addr = address, .down = true}); }
  void down() { alu(Alu::Or, To::None, P::Zero, Q::Immediate, {.down = true}); }

  // Wide instructions.
  void clear_w() { wide(Wide::Clear); }
  /// W := W + X * memory[address], and with a uniform factor in X's place.
  void multiply(int address, bool signed_x = false, bool signed_memory = false);
  void multiply_constant(int factor, int address, bool signed_factor = false, bool signed_memory = false);
  void multiply_m_constant(int factor);  ///< W := W + factor * M; nothing for a factor of 0
  void multiply_x_constant(int factor);  ///< W := W + X * factor; nothing for a factor of 0
  void shift_right(int log_distance, Fill fill = Fill::Zero, When when = When::Always, int x_bit = 0);
  void shift_left(int log_distance, When when = When::Always, int x_bit = 0);
  void divide(bool take_quotient, bool shift_in, int bytes);

  // Flags.
  void flag(Flag to, Bit source, bool invert = false, FlagOp op = FlagOp::Move);
  /// A bit of M, X, or of byte `at` of W.
  void flag_of(Flag to, P p, int bit, bool invert = false, FlagOp op = FlagOp::Move, int at = 0);
  void flag_of_memory(Flag to, int address, int bit, bool invert = false, FlagOp op = FlagOp::Move);

  void control(Control what);

  // Idioms.
  /// W := W >> X for counts of X below 32, bit by bit of the count: 6 cycles.
  void align_right(Fill fill);
  /// Moves W left until its top bit is set or X has come down to 1, X counting along: 6 cycles, up to 31 places.
  void normalize();

  std::vector<Instruction>& stream() { return stream_; }

 private:
  void wide(Wide fn, const Instruction& rest = {});
  std::vector<Instruction>& stream_;
};

}  // namespace pixelflow
