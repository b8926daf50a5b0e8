// Functions of floats at the macro level: the integer algorithms of native/, on the enabled groups of a tile at once.
#include <cstddef>

#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/native/functions.h"

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

}  // namespace pixelflow::macro
