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
/// On vectors of 32-bit integers, where that is enough and there is a kernel: otherwise nothing is done and false
/// returned.
bool words(const Operation& operation, PixelRow& row);
/// On integers of 64 and 128 bits: Multiply to Saturate.
void fixed(const Operation& operation, PixelRow& row);
/// In the host's floats.
void float_arithmetic(const Operation& operation, PixelRow& row);
void float_compare(const Operation& operation, PixelRow& row);
/// Between fixed point and float, on integers.
void convert(const Operation& operation, PixelRow& row);
/// Functions of floats; noise.
void function(const Operation& operation, PixelRow& row);
void noise(const Operation& operation, PixelRow& row);

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

/// Shuffles within each sixteen bytes of two vectors of elements of `Size` bytes: the lower (Half 0) or upper halves of
/// both, alternating. The hosts have these as single instructions.
template <int Size, int Half>
struct Interleaved {
  static constexpr int of(std::size_t n) {
    constexpr std::size_t kBlock = 16 / Size, kAll = kGroup / Size;
    return static_cast<int>(n % 2 * kAll + n / kBlock * kBlock + Half * kBlock / 2 + n % kBlock / 2);
  }
};

/// Of two vectors of 32-bit numbers, within each sixteen bytes: byte First of all eight numbers, then byte First + 1.
template <int First>
struct PairOfBytes {
  static constexpr int of(std::size_t n) {
    const std::size_t block = n / 16 * 16, number = n % 8, byte = First + n % 16 / 8;
    return static_cast<int>(number / 4 * kGroup + block + number % 4 * 4 + byte);
  }
};

/// Four rows of bytes to numbers.
PIXELFLOW_INLINE WordGroup words_of_rows(const vectors::Bytes* rows) {
  using namespace vectors;
  const auto words = [](Bytes low, Bytes high, Words* to) {
    const Halves l = reinterpret_cast<Halves>(low), h = reinterpret_cast<Halves>(high);
    to[0] = reinterpret_cast<Words>(shuffle<Interleaved<2, 0>>(l, h));
    to[1] = reinterpret_cast<Words>(shuffle<Interleaved<2, 1>>(l, h));
  };
  WordGroup group;
  words(shuffle<Interleaved<1, 0>>(rows[0], rows[1]), shuffle<Interleaved<1, 0>>(rows[2], rows[3]), group.part);
  words(shuffle<Interleaved<1, 1>>(rows[0], rows[1]), shuffle<Interleaved<1, 1>>(rows[2], rows[3]), group.part + 2);
  return group;
}

/// And back.
PIXELFLOW_INLINE void rows_of_words(const WordGroup& group, vectors::Bytes* rows) {
  using namespace vectors;
  Bytes words[4];
  for (int n = 0; n < 4; ++n) words[n] = reinterpret_cast<Bytes>(group.part[n]);
  const auto two_rows = [](Bytes first, Bytes second, Bytes* to) {
    const LongWords f = reinterpret_cast<LongWords>(first), s = reinterpret_cast<LongWords>(second);
    to[0] = reinterpret_cast<Bytes>(shuffle<Interleaved<8, 0>>(f, s));
    to[1] = reinterpret_cast<Bytes>(shuffle<Interleaved<8, 1>>(f, s));
  };
  two_rows(shuffle<PairOfBytes<0>>(words[0], words[1]), shuffle<PairOfBytes<0>>(words[2], words[3]), rows);
  two_rows(shuffle<PairOfBytes<2>>(words[0], words[1]), shuffle<PairOfBytes<2>>(words[2], words[3]), rows + 2);
}

/// A 32-bit operand: four rows of memory, or a constant.
template <bool Uniform>
class WordReader {
 public:
  WordReader(const Operand& operand, const PixelRow& row)
      : constant_(vectors::fill<vectors::Words>(static_cast<std::uint32_t>(operand.constant))),
        rows_(Uniform ? nullptr : row.memory(operand.address)) {}

  /// The numbers of the group of elements that starts at the lane.
  PIXELFLOW_INLINE WordGroup get(int first_lane) const {
    using namespace vectors;
    if constexpr (Uniform) return {{constant_, constant_, constant_, constant_}};
    Bytes rows[4];
    for (int byte = 0; byte < 4; ++byte) rows[byte] = load(rows_ + byte * PixelRow::kLanes + first_lane);
    return words_of_rows(rows);
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
  PIXELFLOW_INLINE void put(int first_lane, bool all, const WordGroup& values) const {
    using namespace vectors;
    Bytes rows[4];
    rows_of_words(values, rows);
    if (all) {
      for (int byte = 0; byte < 4; ++byte) {
        store(rows_ + byte * PixelRow::kLanes + first_lane, rows[byte]);
      }
      return;
    }
    const Bytes e = load(enable_ + first_lane);
    for (int byte = 0; byte < 4; ++byte) {
      std::uint8_t* const to = rows_ + byte * PixelRow::kLanes + first_lane;
      store(to, select(e, rows[byte], load(to)));
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
