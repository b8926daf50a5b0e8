// Functions of floats at the macro level: the integer algorithms of native/, on the enabled groups of a tile at once.
#include <cstddef>

#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/native/functions.h"

namespace pixelflow::macro {
namespace {

/// Operands and results of the groups of elements that are enabled, one behind another.
struct Batch {
  alignas(64) WordGroup a[PixelRow::kLanes / kGroup], b[PixelRow::kLanes / kGroup], d[PixelRow::kLanes / kGroup];
  int groups[PixelRow::kLanes / kGroup];
  std::size_t count = 0;

  static std::uint32_t* words(WordGroup* first) { return reinterpret_cast<std::uint32_t*>(first); }
};

bool is_binary(Code code) { return code == Code::Atan2 || code == Code::FastAtan2 || code == Code::Pow; }

}  // namespace

void function(const Operation& o, PixelRow& row) {
  Batch batch;
  for (int at = 0; at < row.padded_lanes(); at += kGroup) {
    if (!any_enabled(row, at)) continue;
    batch.a[batch.count] = read_words(o.a, row, at);
    if (is_binary(o.code)) batch.b[batch.count] = read_words(o.b, row, at);
    batch.groups[batch.count++] = at;
  }
  const std::size_t elements = batch.count * kGroup;
  if (is_binary(o.code)) {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Atan2);
    native::binary_functions()[which].batch(Batch::words(batch.a), Batch::words(batch.b), Batch::words(batch.d),
                                            elements);
  } else {
    const auto which = static_cast<std::size_t>(o.code) - static_cast<std::size_t>(Code::Sin);
    native::unary_functions()[which].batch(Batch::words(batch.a), Batch::words(batch.d), elements);
  }
  for (std::size_t n = 0; n < batch.count; ++n) write_words(o.d, row, batch.groups[n], batch.d[n]);
}

}  // namespace pixelflow::macro
