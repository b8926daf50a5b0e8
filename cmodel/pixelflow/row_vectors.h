// Host vectors of 64 bytes for the rows of pixel_row.h: one byte of 64 elements each. The compiler's vector extension
// lowers them to whatever the host has; the bits are the same everywhere. Flags are masks: a byte of 0 or 255 an
// element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pixelflow::vectors {

constexpr int kWidth = 64;  ///< elements of a vector of bytes

typedef std::uint8_t Bytes __attribute__((vector_size(kWidth), may_alias));
typedef std::int8_t SignedBytes __attribute__((vector_size(kWidth), may_alias));
typedef std::uint16_t Halves __attribute__((vector_size(kWidth), may_alias));
typedef std::int16_t SignedHalves __attribute__((vector_size(kWidth), may_alias));
typedef std::uint32_t Words __attribute__((vector_size(kWidth), may_alias));
typedef std::int32_t SignedWords __attribute__((vector_size(kWidth), may_alias));
typedef std::uint64_t LongWords __attribute__((vector_size(kWidth), may_alias));
typedef float Floats __attribute__((vector_size(kWidth), may_alias));

#define PIXELFLOW_INLINE [[gnu::always_inline]] inline

PIXELFLOW_INLINE Bytes load(const std::uint8_t* from) { return *reinterpret_cast<const Bytes*>(from); }
PIXELFLOW_INLINE void store(std::uint8_t* to, Bytes value) { *reinterpret_cast<Bytes*>(to) = value; }

/// A vector of equal elements.
template <typename V, typename T>
PIXELFLOW_INLINE V fill(T value) {
  V vector = {};
  for (std::size_t n = 0; n < sizeof(V) / sizeof(vector[0]); ++n)
    vector[n] = static_cast<std::decay_t<decltype(vector[0])>>(value);
  return vector;
}

/// mask ? a : b, bit by bit.
template <typename V>
PIXELFLOW_INLINE V select(V mask, V a, V b) {
  return (a & mask) | (b & ~mask);
}

/// The mask of every element's bit 7.
PIXELFLOW_INLINE Bytes top_bit(Bytes value) {
  return reinterpret_cast<Bytes>(reinterpret_cast<SignedBytes>(value) < 0);
}
PIXELFLOW_INLINE Bytes is_zero(Bytes value) { return reinterpret_cast<Bytes>(value == 0); }

namespace detail {
template <typename V, typename Index, std::size_t... N>
PIXELFLOW_INLINE V shuffle(V a, V b, Index, std::index_sequence<N...>) {
  return __builtin_shufflevector(a, b, Index::of(N)...);
}
}  // namespace detail

/// Elements of two vectors: element n of the result is number Index::of(n) of a's elements and then b's.
template <typename Index, typename V>
PIXELFLOW_INLINE V shuffle(V a, V b) {
  return detail::shuffle(a, b, Index{}, std::make_index_sequence<sizeof(V) / sizeof(a[0])>());
}

/// Bit 7 holds the carry out of a + b + carry in, given the sum.
PIXELFLOW_INLINE Bytes carry_bit(Bytes a, Bytes b, Bytes sum) { return (a & b) | ((a | b) & ~sum); }

/// Shifts of every byte by 1 to 7 places; bytes have no shift of their own on the hosts.
PIXELFLOW_INLINE Bytes shift_left(Bytes value, int distance) {
  const Halves shifted = reinterpret_cast<Halves>(value) << distance;
  return reinterpret_cast<Bytes>(shifted) & fill<Bytes>(0xFF << distance);
}
PIXELFLOW_INLINE Bytes shift_right(Bytes value, int distance) {
  const Halves shifted = reinterpret_cast<Halves>(value) >> distance;
  return reinterpret_cast<Bytes>(shifted) & fill<Bytes>(0xFF >> distance);
}

}  // namespace pixelflow::vectors
