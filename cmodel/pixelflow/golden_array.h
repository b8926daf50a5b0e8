// The golden model of the whole array: elements in tiles, a whole program in one tile before the next.
#pragma once

#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "cmodel/pixelflow/pixel_row.h"

namespace pixelflow {

/// Levels model and macro. Cycles are counted from the instructions at both, so that they are the same.
///
/// What is left out: the run of an operation in a tile in which E is clear everywhere, and at the macro level in each
/// group of 64 such elements. Nothing that a program may rely on changes: an operation writes memory only where E is
/// set, and leaves E as it is. Comparisons, whose K is that of the microcode where E is set, are short and never left
/// out; nor are instructions that belong to no operation.
class GoldenArray : public PixelArray {
 public:
  /// Throws std::invalid_argument for Level::Rtl, lanes below 1, or a digit other than 1, 2, 4 or 8 bits.
  GoldenArray(Level level, int lanes, int multiplier_bits);

  int lanes() const override { return lanes_; }
  void cover(int elements) override;
  int covered() const override { return covered_; }
  void write(int address, std::span<const std::uint8_t> bytes) override;
  void read(int address, std::span<std::uint8_t> bytes) const override;
  void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) override;
  void places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const override;
  /// Throws std::invalid_argument, before anything is executed, for steps that do not cover the instructions in order
  /// and for operations that check() refuses.
  void run(const Program& program) override;
  void load(std::span<const std::uint8_t> packets) override;
  void compose(Compose closer_or_repeat, std::span<const std::uint8_t> upstream) override;
  void sent(std::span<std::uint8_t> packets) const override;
  Registers registers(int lane) const override;
  ArrayCounters counters() const override { return counters_; }

 private:
  void check_program(const Program& program) const;
  /// Those that have elements at work; all of them, but for the last one's, are at work.
  std::span<PixelRow> working_tiles();
  void run_tile(const Program& program, const std::vector<std::uint64_t>& step_cycles, std::size_t number);
  /// Runs instructions of a tile and keeps what a Send among them finds.
  void run_instructions(std::span<const Instruction> instructions, std::size_t number);
  void send_packets(PixelRow& tile, std::size_t first);

  Level level_;
  int lanes_, covered_;
  int working_;  ///< the elements of all chips with a covered one
  int multiplier_bits_;
  std::vector<PixelRow> tiles_;
  std::vector<std::uint8_t> sent_;  ///< kPacketBytes an element
  Compose mode_ = Compose::Own;     ///< of the next program with a Send
  std::vector<std::uint8_t> upstream_;
  std::vector<bool> own_won_;  ///< at the last comparison of each element
  ArrayCounters counters_;
};

}  // namespace pixelflow
