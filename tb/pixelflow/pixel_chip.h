// The verilated chip of pixel processors (rtl/pixelflow/pixel_chip.sv) behind an interface that knows nothing of
// Verilator.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "cmodel/pixelflow/pixel_array.h"

namespace tb {

using Packet = std::array<std::uint8_t, pixelflow::kPacketBytes>;

/// What the chip counts from a start to the End that follows (instruction_sequencer.sv), in cycles but for the last.
struct ChipCounters {
  std::uint64_t executed = 0;       ///< End included
  std::uint64_t stream_waits = 0;   ///< the stream buffer was empty
  std::uint64_t inbound_waits = 0;  ///< packets had not arrived
  std::uint64_t send_waits = 0;     ///< the last outbound packets were still being sent
  std::uint64_t instructions = 0;   ///< taken from the stream, End included
  std::uint64_t clocks = 0;         ///< from the start until the chip was done, counted outside of it
};

/// A row of the elements' state: a byte an element, flags 0 or 1.
enum class ChipRow { Memory, Inbound, Outbound, Column, Row, M, X, E, K, S, Z, C };

using pixelflow::Compose;

/// What lies around a chip while it runs. Everything may be left out: the stream is then offered in every cycle, no
/// packets come, and every packet that goes out is taken.
struct ChipSurroundings {
  std::function<bool()> stream_offered;  ///< is the stream's next word offered in this cycle?
  std::function<const Packet*()> load;   ///< the next inbound packet, null for none in this cycle
  std::function<void()> loaded;          ///< the chip took it
  std::function<const Packet*()> upstream;
  std::function<void()> upstream_taken;
  std::function<bool()> receiver_ready;
  std::function<void(const Packet&)> received;
  /// After every cycle in which the elements did something: instruction, digit of the multiplier, cycle since the
  /// start.
  std::function<void(const pixelflow::Instruction&, int, std::uint64_t)> executed;
};

class PixelChip {
 public:
  virtual ~PixelChip() = default;

  virtual int lanes() const = 0;
  virtual int multiplier_bits() const = 0;

  /// Registers are cleared, and every element stands where the chip's number puts it; memory keeps what it has.
  virtual void reset(int chip = 0) = 0;
  /// Column and row of one element, through the chip's port.
  virtual void place(int lane, std::uint8_t column, std::uint8_t row) = 0;

  /// The state itself, to be read and written while no program runs or from `executed`. `index`: address of a memory or
  /// packet byte, otherwise 0. Throws std::invalid_argument for an index outside.
  virtual std::span<std::uint8_t> row(ChipRow which, int index = 0) = 0;
  virtual std::span<std::uint32_t> wide() = 0;

  virtual void set_compose(Compose mode) = 0;

  /// Runs a stream whose only End is its last instruction, and goes on until packets to be sent have left, too. Throws
  /// std::invalid_argument for another stream, and std::runtime_error when the chip does nothing for kPatience cycles.
  virtual ChipCounters run(std::span<const pixelflow::Instruction> stream, const ChipSurroundings& around = {}) = 0;

  static constexpr std::uint64_t kPatience = 100'000;
};

/// A chip of the sizes that were verilated: 256 elements with 2 multiplier bits a cycle, or 16 elements with 1, 4 or 8.
/// Throws std::invalid_argument for others. `trace`: FST file, empty for none.
std::unique_ptr<PixelChip> make_pixel_chip(int lanes = pixelflow::kElements,
                                           int multiplier_bits = pixelflow::kMultiplierBits,
                                           const std::filesystem::path& trace = {});

}  // namespace tb
