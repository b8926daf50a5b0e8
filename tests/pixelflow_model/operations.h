// What the tests of the macro level share: numbers in an array of elements, one operation run on them, the results.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"

namespace pixelflow_tests {

/// Where the tests keep operands and result, and the byte whose bit 0 enables an element.
constexpr std::uint8_t kA = 16, kB = 32, kD = 48, kWork = 64, kEnable = 200;

/// A signed or unsigned number of 64 bits at most.
using Number = __int128;

/// The low bytes of a number, and the number that bytes stand for.
std::uint64_t low_bytes(Number value, int bytes);
Number number(std::uint64_t raw, int bytes, bool is_signed);

/// Random raw values of that many bytes, every other one near zero, a power of two or the greatest and least number.
std::vector<std::uint64_t> hard_numbers(std::mt19937_64& random, int count, int bytes);
/// Bit patterns of floats, uniform in all fields, near each other, and special.
std::vector<std::uint64_t> hard_floats(std::mt19937_64& random, int count);

/// An array at the macro level.
class Elements {
 public:
  explicit Elements(int lanes, pixelflow::Level level = pixelflow::Level::Macro);

  pixelflow::PixelArray& array() { return *array_; }
  void put(int address, int bytes, const std::vector<std::uint64_t>& values);
  std::vector<std::uint64_t> get(int address, int bytes) const;
  /// Sets E from bit 0 of the values.
  void enable(const std::vector<std::uint64_t>& values);
  void enable_all();
  /// Runs the operation with no instructions of its own.
  void run(const pixelflow::Operation& operation);
  bool condition(int lane) const { return array_->registers(lane).k; }

 private:
  std::unique_ptr<pixelflow::PixelArray> array_;
};

}  // namespace pixelflow_tests
