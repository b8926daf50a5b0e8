// One processing element of the array, golden model: the registers and what one instruction does to them. The scalar
// form, written to be read; pixel_row.h runs many elements at once. Mirrors rtl/pixelflow/pixel_element.sv.
#pragma once

#include <array>
#include <cstdint>

#include "cmodel/pixelflow/instruction.h"

namespace pixelflow {

/// An element's registers (pixelflow_pkg::registers_t).
struct Registers {
  bool e = false;       ///< enable: gates memory and port writes, nothing else
  bool k = false;       ///< condition
  bool s = false;       ///< sign
  bool z = false;       ///< zero
  bool c = false;       ///< carry
  std::uint8_t m = 0;   ///< latch
  std::uint8_t x = 0;   ///< multiplier, exponent, shift count, quotient
  std::uint32_t w = 0;  ///< accumulator

  friend bool operator==(const Registers&, const Registers&) = default;
};

class PixelElement {
 public:
  Registers registers;
  std::array<std::uint8_t, kMemoryBytes> memory{};
  std::array<std::uint8_t, kPacketBytes> inbound{};   ///< the packet that has arrived
  std::array<std::uint8_t, kPacketBytes> outbound{};  ///< the packet to be sent
  std::uint8_t x_position = 0;                        ///< column of the region
  std::uint8_t y_position = 0;                        ///< row of the region

  /// Executes one instruction; a control instruction does nothing here. Addresses beyond the memory read zero and are
  /// not written.
  void step(const Instruction& instruction);

 private:
  std::uint8_t operand_p(const Instruction& i) const;
  std::uint8_t operand_q(const Instruction& i) const;
  void step_alu(const Instruction& i);
  void step_wide(const Instruction& i);
  void step_flag(const Instruction& i);
};

}  // namespace pixelflow
