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

/// What a composition port passes on (pixelflow_pkg::compose_e).
enum class Compose { Own, Closer, Upstream, Repeat };

class PixelArray {
 public:
  virtual ~PixelArray() = default;

  virtual int lanes() const = 0;
  /// From now on the first `elements` elements work alone, and rows and packets below are those of these. The chips
  /// that none of them belongs to do nothing and keep what they have; the others work as a whole, with zeros for
  /// packets that are not given. At first all elements work. Packets to be loaded or composed are given afterwards.
  /// Throws std::invalid_argument for numbers below 1 or above lanes().
  virtual void cover(int elements) = 0;
  virtual int covered() const = 0;
  /// One byte of memory of every element: `bytes` holds covered() of them. Throws std::invalid_argument for a wrong
  /// size or address.
  virtual void write(int address, std::span<const std::uint8_t> bytes) = 0;
  virtual void read(int address, std::span<std::uint8_t> bytes) const = 0;
  /// Column and row of every element; at first its place in the region, counted row by row.
  virtual void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) = 0;
  virtual void places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const = 0;
  /// Executes the program in every element, from the registers as they are. E is clear after construction.
  virtual void run(const Program& program) = 0;
  // The communication buffers: kPacketBytes bytes an element, one element after another.
  /// Packets that the next program with a WaitInbound finds.
  virtual void load(std::span<const std::uint8_t> packets) = 0;
  /// The packets of the next program with a Send meet those of the node before: the closer one of each element leaves
  /// (depth in the first kDepthBytes bytes, equal depths go to upstream), or the same one as the last time. Throws
  /// std::invalid_argument for Own and Upstream, which compare nothing. That program has one Send, otherwise run()
  /// throws std::invalid_argument.
  virtual void compose(Compose closer_or_repeat, std::span<const std::uint8_t> upstream) = 0;
  /// Packets as the last Send found them, or as they left the composition port; zero before the first.
  virtual void sent(std::span<std::uint8_t> packets) const = 0;
  virtual Registers registers(int lane) const = 0;
  virtual ArrayCounters counters() const = 0;
};

/// The golden model, of 1 to as many elements as a region has. Throws std::invalid_argument for other numbers, and for
/// Level::Rtl, which lives with the verilated machine.
std::unique_ptr<PixelArray> make_golden_array(Level level, int lanes, int multiplier_bits = kMultiplierBits);

}  // namespace pixelflow
