// The array of pixel processors as a program sees it, at any level of modelling.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cmodel/pixelflow/pixel_element.h"
#include "cmodel/pixelflow/program.h"

namespace pixelflow {

/// rtl: the verilated chips. model: every instruction, on vectors. macro: every operation natively, its cycles still
/// charged.
enum class Level { Rtl, Model, Macro };

struct ArrayCounters {
  std::uint64_t cycles = 0;  ///< executed by the array, stalls apart
  std::uint64_t instructions = 0;
  std::uint64_t element_cycles = 0;  ///< cycles times the elements of the array, simulated or left out
  std::uint64_t simulated_element_cycles =
      0;  ///< of these, really simulated: the rest had nothing enabled or nothing covering

  friend bool operator==(const ArrayCounters&, const ArrayCounters&) = default;
};

class PixelArray {
 public:
  virtual ~PixelArray() = default;

  virtual int lanes() const = 0;
  /// One byte of memory of every element: `bytes` holds lanes() of them. Throws std::invalid_argument for a wrong size
  /// or address.
  virtual void write(int address, std::span<const std::uint8_t> bytes) = 0;
  virtual void read(int address, std::span<std::uint8_t> bytes) const = 0;
  /// Column and row of every element; at first its place in the region, counted row by row.
  virtual void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) = 0;
  /// Executes the program in every element, from the registers as they are. E is clear after construction.
  virtual void run(const Program& program) = 0;
  // The communication buffers: kPacketBytes bytes an element, one element after another.
  /// Packets that the next program with a WaitInbound finds.
  virtual void load(std::span<const std::uint8_t> packets) = 0;
  /// Packets as the last Send found them; zero before the first.
  virtual void sent(std::span<std::uint8_t> packets) const = 0;
  virtual Registers registers(int lane) const = 0;
  virtual ArrayCounters counters() const = 0;
};

/// The golden model, of 1 to as many elements as a region has. Throws std::invalid_argument for other numbers, and for
/// Level::Rtl, which lives with the verilated machine.
std::unique_ptr<PixelArray> make_golden_array(Level level, int lanes, int multiplier_bits = kMultiplierBits);

}  // namespace pixelflow
