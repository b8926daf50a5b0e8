// The kernels of macro.h, a file each, and what they share: how numbers come from the rows of a tile and go back.
#pragma once

#include <bit>
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
constexpr int kGroup = PixelRow::kGroup;

/// The numbers of a group of elements, extended to 64 bits by the operand's sign.
void gather(const Operand& operand, const PixelRow& row, int first_lane, std::uint64_t* values);
/// Writes the low bytes of the numbers to d where E is set.
void scatter(const Operand& d, PixelRow& row, int first_lane, const std::uint64_t* values);

/// Calls work(first lane, true where all are enabled) for each group in which an element is enabled.
template <typename F>
PIXELFLOW_INLINE void each_enabled_group(const PixelRow& row, F&& work) {
  const PixelRow::EnabledGroups groups = row.enabled_groups();
  for (std::uint32_t left = groups.any; left != 0; left &= left - 1) {
    const int group = std::countr_zero(left);
    work(group * kGroup, (groups.all >> group & 1u) != 0);
  }
}

/// Sixty-four elements as four vectors of 32-bit numbers, in an order of its own: what comes from get goes to put.
struct WordGroup {
  vectors::Words part[4];
};

/// Four rows of bytes to numbers, or numbers to rows: the transposition of 4 x 4 bytes, its own inverse.
class Transposition {
 public:
  PIXELFLOW_INLINE Transposition() {
    // From memory and not as constants: the compiler would make them anew for every group.
    low_bytes_ = *reinterpret_cast<const vectors::Halves*>(kLowBytes);
    low_halves_ = *reinterpret_cast<const vectors::Words*>(kLowHalves);
  }

  PIXELFLOW_INLINE WordGroup operator()(const vectors::Words* rows) const {
    using namespace vectors;
    Words halves[4];
    for (int n = 0; n < 4; n += 2) {
      const Halves low = reinterpret_cast<Halves>(rows[n]), high = reinterpret_cast<Halves>(rows[n + 1]);
      halves[n] = reinterpret_cast<Words>((low & low_bytes_) | high << 8);
      halves[n + 1] = reinterpret_cast<Words>(low >> 8 | (high & ~low_bytes_));
    }
    WordGroup words;
    for (int n = 0; n < 2; ++n) {
      words.part[n] = (halves[n] & low_halves_) | halves[n + 2] << 16;
      words.part[n + 2] = halves[n] >> 16 | (halves[n + 2] & ~low_halves_);
    }
    return words;
  }

 private:
  alignas(vectors::kWidth) static const std::uint8_t kLowBytes[kGroup];
  alignas(vectors::kWidth) static const std::uint8_t kLowHalves[kGroup];
  vectors::Halves low_bytes_;
  vectors::Words low_halves_;
};

/// A 32-bit operand: four rows of memory, or a constant.
template <bool Uniform>
class WordReader {
 public:
  WordReader(const Operand& operand, const PixelRow& row)
      : constant_(vectors::fill<vectors::Words>(static_cast<std::uint32_t>(operand.constant))),
        rows_(Uniform ? nullptr : row.memory(operand.address)) {}

  /// The numbers of the group of elements that starts at the lane.
  PIXELFLOW_INLINE WordGroup get(const Transposition& transposed, int first_lane) const {
    using namespace vectors;
    if constexpr (Uniform) return {{constant_, constant_, constant_, constant_}};
    Words rows[4];
    for (int byte = 0; byte < 4; ++byte) {
      rows[byte] = reinterpret_cast<Words>(load(rows_ + byte * PixelRow::kLanes + first_lane));
    }
    return transposed(rows);
  }

 private:
  vectors::Words constant_;
  const std::uint8_t* rows_;
};

/// A 32-bit result.
class WordWriter {
 public:
  WordWriter(const Operand& d, PixelRow& row) : enable_(row.enable()), rows_(row.memory(d.address)) {}

  /// Writes the numbers where E is set.
  PIXELFLOW_INLINE void put(const Transposition& transposed, int first_lane, bool all, const WordGroup& values) const {
    using namespace vectors;
    const WordGroup rows = transposed(values.part);
    if (all) {
      for (int byte = 0; byte < 4; ++byte) {
        store(rows_ + byte * PixelRow::kLanes + first_lane, reinterpret_cast<Bytes>(rows.part[byte]));
      }
      return;
    }
    const Bytes e = load(enable_ + first_lane);
    for (int byte = 0; byte < 4; ++byte) {
      std::uint8_t* const to = rows_ + byte * PixelRow::kLanes + first_lane;
      store(to, select(e, reinterpret_cast<Bytes>(rows.part[byte]), load(to)));
    }
  }

 private:
  const std::uint8_t* enable_;
  std::uint8_t* rows_;
};

/// Calls work(reader of a, reader of b).
template <typename F>
PIXELFLOW_INLINE void with_readers(const Operand& a, const Operand& b, const PixelRow& row, F&& work) {
  if (a.uniform && b.uniform) return work(WordReader<true>(a, row), WordReader<true>(b, row));
  if (a.uniform) return work(WordReader<true>(a, row), WordReader<false>(b, row));
  if (b.uniform) return work(WordReader<false>(a, row), WordReader<true>(b, row));
  work(WordReader<false>(a, row), WordReader<false>(b, row));
}

/// A uniform operand's value as an element would read it: its low bytes, extended by its sign.
inline std::uint64_t constant_of(const Operand& operand) {
  const int unused = 64 - 8 * operand.bytes;
  const std::uint64_t top = operand.constant << unused;
  return operand.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> unused) : top >> unused;
}

}  // namespace pixelflow::macro
