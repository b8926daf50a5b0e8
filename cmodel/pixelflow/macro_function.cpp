// Functions of floats, and noise, at the macro level: the integer algorithms of native/ on the enabled groups of a
// tile.
#include <cstddef>

#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/native/functions.h"
#include "cmodel/pixelflow/native/noise.h"

namespace pixelflow::macro {
namespace {

/// Operands and results of the enabled elements of a tile, one behind another.
struct Batch {
  std::uint32_t a[PixelRow::kLanes], b[PixelRow::kLanes], d[PixelRow::kLanes];
  std::uint16_t places[PixelRow::kLanes];  ///< where the result goes among the words of all enabled groups
  std::size_t count = 0;

  void take(const WordGroup& a_words, const WordGroup& b_words, const WordGroup& enabled, std::size_t group) {
    for (std::size_t n = 0; n < kGroup; ++n) {
      a[count] = a_words.part[n / 16][n % 16];
      b[count] = b_words.part[n / 16][n % 16];
      places[count] = static_cast<std::uint16_t>(group * kGroup + n);
      count += enabled.part[n / 16][n % 16] & 1u;
    }
  }

  void take_all(const WordGroup& a_words, const WordGroup& b_words, std::size_t group) {
    std::memcpy(a + count, &a_words, sizeof a_words);
    std::memcpy(b + count, &b_words, sizeof b_words);
    for (std::size_t n = 0; n < kGroup; ++n) places[count + n] = static_cast<std::uint16_t>(group * kGroup + n);
    count += kGroup;
  }
};

bool is_binary(Code code) { return code == Code::Atan2 || code == Code::FastAtan2 || code == Code::Pow; }

}  // namespace

void function(const Operation& o, PixelRow& row) {
  Batch batch;
  const bool binary = is_binary(o.code);
  std::size_t groups = 0;
  with_readers(o.a, binary ? o.b : o.a, row, [&](const auto& a, const auto& b) {
    each_enabled_group(row, [&](int at, bool all) {
      if (all) return batch.take_all(a.get(at), b.get(at), groups++);
      const vectors::Bytes e = vectors::load(row.enable() + at), rows[] = {e, e, e, e};
      batch.take(a.get(at), b.get(at), words_of_rows(rows), groups++);
    });
  });
  if (binary) {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Atan2);
    native::binary_functions()[which].batch(batch.a, batch.b, batch.d, batch.count);
  } else {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Sin);
    native::unary_functions()[which].batch(batch.a, batch.d, batch.count);
  }
  alignas(64) std::uint32_t results[PixelRow::kLanes] = {};
  for (std::size_t n = 0; n < batch.count; ++n) results[batch.places[n]] = batch.d[n];
  const WordWriter writer(o.d, row);
  groups = 0;
  each_enabled_group(row, [&](int at, bool all) {
    WordGroup values;
    std::memcpy(&values, results + kGroup * groups++, sizeof values);
    writer.put(at, all, values);
  });
}

void noise(const Operation& o, PixelRow& row) {
  constexpr int kMostCoordinates = 3;
  const int dimensions = o.scale;
  alignas(64) std::uint64_t values[kGroup];
  std::uint32_t floats[kMostCoordinates][kGroup], float_noise[kGroup];
  std::uint16_t fixed[kMostCoordinates][kGroup], fixed_noise[kGroup];
  const std::uint32_t* const float_point[] = {floats[0], floats[1], floats[2]};
  const std::uint16_t* const fixed_point[] = {fixed[0], fixed[1], fixed[2]};
  each_enabled_group(row, [&](int at, bool) {
    Operand coordinate = o.a;
    for (int axis = 0; axis < dimensions;
         ++axis, coordinate.address = static_cast<std::uint8_t>(coordinate.address + o.a.bytes)) {
      gather(coordinate, row, at, values);
      for (int n = 0; n < kGroup; ++n) floats[axis][n] = static_cast<std::uint32_t>(values[n]);
      for (int n = 0; n < kGroup; ++n) fixed[axis][n] = static_cast<std::uint16_t>(values[n]);
    }
    if (o.code == Code::NoiseFloat) {
      native::noise_float(dimensions, float_point, float_noise, kGroup);
      for (int n = 0; n < kGroup; ++n) values[n] = float_noise[n];
    } else {
      native::noise_fixed(dimensions, fixed_point, fixed_noise, kGroup);
      for (int n = 0; n < kGroup; ++n) values[n] = fixed_noise[n];
    }
    scatter(o.d, row, at, values);
  });
}

}  // namespace pixelflow::macro
