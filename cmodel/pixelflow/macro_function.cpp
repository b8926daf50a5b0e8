// Functions of floats, and noise, at the macro level: the integer algorithms of native/ on the enabled groups of a
// tile.
#include <cstddef>

#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/native/functions.h"
#include "cmodel/pixelflow/native/noise.h"

namespace pixelflow::macro {
namespace {

/// Operands and results of the groups of elements that are enabled, one behind another.
struct Batch {
  alignas(64) WordGroup a[PixelRow::kLanes / kGroup], b[PixelRow::kLanes / kGroup], d[PixelRow::kLanes / kGroup];
  std::size_t count = 0;

  static std::uint32_t* words(WordGroup* first) { return reinterpret_cast<std::uint32_t*>(first); }
};

bool is_binary(Code code) { return code == Code::Atan2 || code == Code::FastAtan2 || code == Code::Pow; }

}  // namespace

void function(const Operation& o, PixelRow& row) {
  Batch batch;
  const bool binary = is_binary(o.code);
  with_readers(o.a, binary ? o.b : o.a, row, [&](const auto& a, const auto& b) {
    each_enabled_group(row, [&](int at, bool) {
      batch.a[batch.count] = a.get(at);
      if (binary) batch.b[batch.count] = b.get(at);
      ++batch.count;
    });
  });
  const std::size_t elements = batch.count * kGroup;
  if (binary) {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Atan2);
    native::binary_functions()[which].batch(Batch::words(batch.a), Batch::words(batch.b), Batch::words(batch.d),
                                            elements);
  } else {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Sin);
    native::unary_functions()[which].batch(Batch::words(batch.a), Batch::words(batch.d), elements);
  }
  const WordWriter writer(o.d, row);
  std::size_t n = 0;
  each_enabled_group(row, [&](int at, bool all) { writer.put(at, all, batch.d[n++]); });
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
