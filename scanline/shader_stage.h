// Shading as the picture sees it: one stage that can be replaced. It is given spans, and answers with colours.
#pragma once

#include <cstdint>
#include <span>

#include "scanline/spans.h"

namespace scanline {

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb8&) const = default;
};

class ShaderStage {
 public:
  virtual ~ShaderStage() = default;

  /// Colours the pixels of a band: band.width * band.rows of them, row by row. Several threads may call it for
  /// different bands at once; a pixel's colour does not depend on how the picture is cut into bands.
  virtual void shade(const SpanBand& band, std::span<Rgb8> pixels) const = 0;
};

}  // namespace scanline
