// Registers and memory of a tile of pixel elements, for the files that make up pixel_row.h.
#pragma once

#include "cmodel/pixelflow/pixel_row.h"
#include "cmodel/pixelflow/row_vectors.h"

namespace pixelflow {

struct PixelRow::State {
  using Row = std::uint8_t[kLanes];
  alignas(vectors::kWidth) Row memory[kMemoryBytes];
  Row inbound[kPacketBytes], outbound[kPacketBytes], column, row;
  Row m, x, w[4];
  Row c, z, s, k, e;
  Row scratch;  // an operand, or a result, that needs a row for the length of one instruction
  std::uint8_t immediate[vectors::kWidth];
};

}  // namespace pixelflow
