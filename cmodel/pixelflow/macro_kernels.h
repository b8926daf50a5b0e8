// The kernels of macro.h, a file each, and what they share: how numbers come from the rows of a tile and go back.
#pragma once

#include <cstdint>

#include "cmodel/pixelflow/operation.h"
#include "cmodel/pixelflow/pixel_row.h"
#include "cmodel/pixelflow/row_vectors.h"

namespace pixelflow::macro {

/// Byte by byte, as the microcode does: Copy, Add, Sub; Less, LessEqual, Equal.
void add(const Operation& operation, PixelRow& row);
void compare(const Operation& operation, PixelRow& row);
/// On integers of 64 and 128 bits: Multiply to Saturate.
void fixed(const Operation& operation, PixelRow& row);
/// In the host's floats.
void float_arithmetic(const Operation& operation, PixelRow& row);
void float_compare(const Operation& operation, PixelRow& row);
/// Between fixed point and float, on integers.
void convert(const Operation& operation, PixelRow& row);
/// Functions and noise.
void function(const Operation& operation, PixelRow& row);

/// Elements that a kernel works on at a time: those of one vector of bytes.
constexpr int kGroup = vectors::kWidth;

/// The numbers of a group of elements, extended to 64 bits by the operand's sign.
void gather(const Operand& operand, const PixelRow& row, int first_lane, std::uint64_t* values);
/// Writes the low bytes of the numbers to d where E is set.
void scatter(const Operand& d, PixelRow& row, int first_lane, const std::uint64_t* values);

/// True where E is set in an element of the group that starts at the lane.
PIXELFLOW_INLINE bool any_enabled(const PixelRow& row, int first_lane) {
  const std::uint8_t* const e = row.enable() + first_lane;
  std::uint64_t any = 0;
  for (int n = 0; n < kGroup; n += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, e + n, sizeof eight);
    any |= eight;
  }
  return any != 0;
}

/// Sixty-four elements as four vectors of 32-bit numbers, in an order of its own: what comes from read_words goes to
/// write_words.
struct WordGroup {
  vectors::Words part[4];
};

/// Four rows of bytes to numbers, or numbers to rows: the transposition of 4 x 4 bytes, its own inverse.
PIXELFLOW_INLINE WordGroup transpose(const vectors::Words* rows) {
  using namespace vectors;
  const auto bytes = [](Words low, Words high, WordGroup& to, int at) {
    const Halves l = reinterpret_cast<Halves>(low), h = reinterpret_cast<Halves>(high);
    to.part[at] = reinterpret_cast<Words>((l & std::uint16_t{0x00FF}) | h << 8);
    to.part[at + 1] = reinterpret_cast<Words>(l >> 8 | (h & std::uint16_t{0xFF00}));
  };
  WordGroup halves, words;
  bytes(rows[0], rows[1], halves, 0);
  bytes(rows[2], rows[3], halves, 2);
  for (int n = 0; n < 2; ++n) {
    const Words low = halves.part[n], high = halves.part[n + 2];
    words.part[n] = (low & 0x0000FFFFu) | high << 16;
    words.part[n + 2] = low >> 16 | (high & 0xFFFF0000u);
  }
  return words;
}

/// A 32-bit operand of the group of elements that starts at the lane.
PIXELFLOW_INLINE WordGroup read_words(const Operand& operand, const PixelRow& row, int first_lane) {
  using namespace vectors;
  if (operand.uniform) {
    const Words value = fill<Words>(static_cast<std::uint32_t>(operand.constant));
    return {{value, value, value, value}};
  }
  Words rows[4];
  for (int byte = 0; byte < 4; ++byte) {
    rows[byte] = reinterpret_cast<Words>(load(row.memory(operand.address + byte) + first_lane));
  }
  return transpose(rows);
}

/// Writes 32-bit numbers to d where E is set.
PIXELFLOW_INLINE void write_words(const Operand& d, PixelRow& row, int first_lane, const WordGroup& values) {
  using namespace vectors;
  const WordGroup rows = transpose(values.part);
  const Bytes e = load(row.enable() + first_lane);
  for (int byte = 0; byte < 4; ++byte) {
    std::uint8_t* const to = row.memory(d.address + byte) + first_lane;
    store(to, select(e, reinterpret_cast<Bytes>(rows.part[byte]), load(to)));
  }
}

/// A uniform operand's value as an element would read it: its low bytes, extended by its sign.
inline std::uint64_t constant_of(const Operand& operand) {
  const int unused = 64 - 8 * operand.bytes;
  const std::uint64_t top = operand.constant << unused;
  return operand.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> unused) : top >> unused;
}

}  // namespace pixelflow::macro
