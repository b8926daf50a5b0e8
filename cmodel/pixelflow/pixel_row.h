// Many processing elements at once, golden model: a tile of the array on the host's vectors. The same bits as
// PixelElement for every instruction word. Memory lies as rows, one byte of all elements each; the accumulator as four
// rows.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cmodel/pixelflow/pixel_element.h"

namespace pixelflow {

class PixelRow {
 public:
  /// Elements of a full tile. The rows that a program touches should stay in the host's first-level cache.
  static constexpr int kLanes = 1024;

  /// A tile of 1 to kLanes elements; throws std::invalid_argument for another number. Registers and memory are zero.
  explicit PixelRow(int lanes = kLanes);
  PixelRow(PixelRow&&) noexcept;
  PixelRow& operator=(PixelRow&&) noexcept;
  ~PixelRow();

  int lanes() const { return lanes_; }
  /// From now on the tile has `lanes` elements; the others keep what they have. Throws std::invalid_argument as the
  /// constructor does, and where the number is neither a multiple of kGroup nor the one that the tile was made for.
  void resize(int lanes);
  /// Elements that are really computed: lanes() rounded up to whole vectors of the host. All rows hold this many bytes
  /// at least.
  int padded_lanes() const;

  /// Executes one instruction in every element; a multiplication as a whole. A control instruction does nothing here.
  void step(const Instruction& instruction);
  void run(std::span<const Instruction> instructions);

  Registers registers(int lane) const;
  void set_registers(int lane, const Registers& registers);

  /// Rows, aligned to 64 bytes: memory byte `address`, byte `index` of the packets, columns and rows of the elements'
  /// places.
  std::uint8_t* memory(int address);
  const std::uint8_t* memory(int address) const;
  std::uint8_t* inbound(int index);
  const std::uint8_t* outbound(int index) const;
  std::uint8_t* outbound(int index);
  std::uint8_t* columns();
  const std::uint8_t* columns() const;
  std::uint8_t* rows();
  const std::uint8_t* rows() const;

  /// Flags as rows of masks, 0 or 255 an element. Enable is only written by instructions, and by set_registers.
  const std::uint8_t* enable() const;
  std::uint8_t* condition();

  /// Groups of kGroup elements, lowest bit first: those in which E is set in an element, and those in which it is set
  /// in all.
  static constexpr int kGroup = 64;
  struct EnabledGroups {
    std::uint32_t any, all;
  };
  static_assert(kLanes <= 32 * kGroup);
  const EnabledGroups& enabled_groups() const;

 private:
  struct State;
  /// An operand: 64 elements at row[0], the next 64 at row[stride]. A constant has stride 0.
  struct Source {
    const std::uint8_t* row;
    std::ptrdiff_t stride;
  };

  std::uint8_t* wide(int byte) const;
  Source p_source(const Instruction& i) const;
  Source q_source(const Instruction& i) const;
  void step_alu(const Instruction& i);
  void step_wide(const Instruction& i);
  void step_flag(const Instruction& i);
  void multiply(const Instruction& i);
  void shift(const Instruction& i);
  void divide(const Instruction& i);
  void move_down();

  void enable_changed() { enabled_known_ = false; }

  std::unique_ptr<State> state_;
  mutable EnabledGroups enabled_{};
  mutable bool enabled_known_ = false;
  int made_lanes_, lanes_;
  int vectors_;         ///< of 64 elements, that hold lanes_
  int wide_first_ = 0;  ///< which of the four rows is W's lowest byte: a shift by eight bits turns the rows
};

}  // namespace pixelflow
