#include "cmodel/pixelflow/native/noise.h"

#include <algorithm>
#include <bit>

namespace pixelflow::native {
namespace {

constexpr int kFraction = 28;  ///< fraction bits of the float form inside

/// One of the gradients, as a product with the offset from the lattice point: two of its coordinates, each with a sign.
std::int32_t corner(unsigned hash, const std::int32_t offset[3]) {
  const unsigned q = hash & 15;
  const std::int32_t u = q < 8 ? offset[0] : offset[1];
  const std::int32_t v = q < 4 ? offset[1] : q == 12 || q == 14 ? offset[0] : offset[2];
  return (q & 1 ? -u : u) + (q & 2 ? -v : v);
}

/// The corners' values, x running fastest: interpolated along x, then y, then z.
template <typename Mix>
std::int32_t gradient_noise(int dimensions, const unsigned cell[3], const std::int32_t fraction[3], std::int32_t one, Mix&& mix) {
  std::int32_t value[8];
  const int corners = 1 << dimensions;
  for (int n = 0; n < corners; ++n) {
    std::int32_t offset[3];
    unsigned index[3];
    for (int axis = 0; axis < 3; ++axis) {
      const int far = n >> axis & 1;
      offset[axis] = fraction[axis] - (far ? one : 0);
      index[axis] = cell[axis] + static_cast<unsigned>(far);
    }
    value[n] = corner(noise_hash(index[0], index[1], index[2]), offset);
  }
  for (int axis = 0; axis < dimensions; ++axis) {
    for (int n = 0; n < corners >> (axis + 1); ++n) value[n] = mix(axis, value[2 * n], value[2 * n + 1]);
  }
  return value[0];
}

std::uint16_t fixed_one(int dimensions, const std::uint16_t c[3]) {
  unsigned cell[3] = {}, weight[3] = {};
  std::int32_t fraction[3] = {};
  for (int axis = 0; axis < dimensions; ++axis) {
    const std::uint32_t f = c[axis] & 0xFF;
    cell[axis] = c[axis] >> 8;
    fraction[axis] = static_cast<std::int32_t>(f);
    weight[axis] = f * f * (768 - 2 * f) >> 16;
  }
  // Corner values have 8 fraction bits, interpolated ones 16.
  const std::int32_t g = gradient_noise(dimensions, cell, fraction, 256, [&](int axis, std::int32_t a, std::int32_t b) {
    const auto w = static_cast<std::int32_t>(weight[axis]);
    return axis == 0 ? a * 256 + (b - a) * w : a + ((b - a) * w >> 8);
  });
  return static_cast<std::uint16_t>(std::clamp((g + 65536) >> 1, 0, 65535));
}

/// floor(x 2^24) modulo 2^32 of a finite float.
std::uint32_t coordinate(std::uint32_t x) {
  const int exponent = std::max<int>(x >> 23 & 0xFF, 1);
  const std::uint32_t magnitude = (x & 0x7FFFFF) | (x >> 23 & 0xFF ? 0x800000 : 0);
  const std::uint32_t value = x >> 31 ? 0u - magnitude : magnitude;
  const int left = exponent - 126;
  if (left >= 0) return left < 32 ? value << left : 0;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> std::min(-left, 31));
}

/// n 2^-29 for n up to 2^29, rounded to nearest even.
std::uint32_t to_float(std::uint32_t n) {
  if (n == 0) return 0;
  const int top = 31 - std::countl_zero(n);
  std::uint32_t mantissa = top >= 23 ? n >> (top - 23) : n << (23 - top);
  if (top > 23) {
    const std::uint32_t rest = n & ((1u << (top - 23)) - 1), half = 1u << (top - 24);
    if (rest > half || (rest == half && (mantissa & 1))) ++mantissa;
  }
  return (static_cast<std::uint32_t>(127 + top - 29 - 1) << 23) + mantissa;
}

std::uint32_t float_one(int dimensions, const std::uint32_t x[3]) {
  unsigned cell[3] = {};
  std::uint32_t weight[3] = {};
  std::int32_t fraction[3] = {};
  for (int axis = 0; axis < dimensions; ++axis) {
    if ((x[axis] & 0x7F800000) == 0x7F800000) return 0x7FC00000;
    const std::uint32_t c = coordinate(x[axis]);
    const std::uint64_t t = c & 0xFFFFFF;
    cell[axis] = c >> 24;
    fraction[axis] = static_cast<std::int32_t>(t << (kFraction - 24));
    const std::uint64_t square = t * t >> 16;
    weight[axis] = static_cast<std::uint32_t>(square * ((3u << 24) - 2 * t) >> 24);
  }
  const std::int32_t one = 1 << kFraction;
  const std::int32_t g = gradient_noise(dimensions, cell, fraction, one, [&](int axis, std::int32_t a, std::int32_t b) {
    return a + static_cast<std::int32_t>(static_cast<std::int64_t>(b - a) * weight[axis] >> 32);
  });
  return to_float(static_cast<std::uint32_t>(std::clamp(one + g, 0, 2 * one)));
}

}  // namespace

std::uint8_t noise_hash(unsigned i, unsigned j, unsigned k) {
  auto x = static_cast<std::uint16_t>((i & 0xFF) * 0x9E37u + (j & 0xFF) * 0x79B9u + (k & 0xFF) * 0x85EBu);
  x ^= x >> 8;
  x = static_cast<std::uint16_t>(x * 0x6A35u);
  x ^= x >> 7;
  x = static_cast<std::uint16_t>(x * 0xB4D3u);
  return static_cast<std::uint8_t>(x >> 8);
}

void noise_fixed(int dimensions, const std::uint16_t* const* coordinates, std::uint16_t* d, std::size_t n) {
  for (std::size_t at = 0; at < n; ++at) {
    std::uint16_t c[3] = {};
    for (int axis = 0; axis < dimensions; ++axis) c[axis] = coordinates[axis][at];
    d[at] = fixed_one(dimensions, c);
  }
}

void noise_float(int dimensions, const std::uint32_t* const* coordinates, std::uint32_t* d, std::size_t n) {
  for (std::size_t at = 0; at < n; ++at) {
    std::uint32_t x[3] = {};
    for (int axis = 0; axis < dimensions; ++axis) x[axis] = coordinates[axis][at];
    d[at] = float_one(dimensions, x);
  }
}

}  // namespace pixelflow::native
