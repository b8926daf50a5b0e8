// Two's complement words of a chosen width, kept sign extended in 64 bits.
#pragma once

#include <cstdint>

namespace vsg {

/// A fixed-point word: `bits` in all, `fraction` of them after the point.
struct WordFormat {
  int bits = 36;
  int fraction = 18;

  /// What a register of this width holds after `value` was stored.
  std::int64_t wrap(std::int64_t value) const {
    const int unused = 64 - bits;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << unused) >> unused;
  }
  /// The pixel or scan line that the value falls on (rounds down).
  std::int64_t integer(std::int64_t value) const { return value >> fraction; }
  std::int64_t from_integer(std::int64_t value) const {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << fraction);
  }
  std::int64_t greatest() const { return (std::int64_t{1} << (bits - 1)) - 1; }
};

}  // namespace vsg
