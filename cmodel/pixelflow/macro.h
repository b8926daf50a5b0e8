// The macro level: an operation computed natively in every element of a tile, to the same bytes as its microcode
// (Olano and Lastra 1998, sections 6.1.3 and 6.1.4: the library's operations). Cycles are the caller's business.
#pragma once

#include "cmodel/pixelflow/operation.h"
#include "cmodel/pixelflow/pixel_row.h"

namespace pixelflow {

/// Greatest power of two, either way, between a fixed-point number and a float that it is converted to or from.
constexpr int kMostBinaryScale = 255;

/// Comparisons write K in every element, enabled or not; all other operations write d, where E is set, and nothing
/// else.
bool is_comparison(Code code);

/// The operands that an operation reads (1: a alone) and whether they are floats or raw integers.
int operand_count(Code code);
bool takes_floats(Code code);
bool gives_float(Code code);

/// Throws std::invalid_argument, saying which operand, unless all numbers lie in the memory, d overlaps no operand but
/// one that it equals, the workspace overlaps none, and sizes and scale are those that the operation takes.
void check(const Operation& operation, int workspace_bytes);

/// Throws std::runtime_error where the host's float arithmetic is not set to IEEE single, nearest even, with
/// subnormals.
void check_host_arithmetic();

/// Computes a checked operation in the elements of the tile. Groups of elements in which E is clear are left out.
void compute(const Operation& operation, PixelRow& row);

}  // namespace pixelflow
