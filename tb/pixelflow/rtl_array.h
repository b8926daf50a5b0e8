// The array of pixel processors at RTL level: as many verilated chips as it has elements for, one after another.
#pragma once

#include <memory>

#include "cmodel/pixelflow/pixel_array.h"

namespace tb {

/// `lanes`: a multiple of the chip's 256 elements, up to a region's; throws std::invalid_argument for another number. A
/// program runs in every chip; cycles are those that the chips count, and a chip that counts others than the first is a
/// std::logic_error.
std::unique_ptr<pixelflow::PixelArray> make_rtl_array(int lanes);

}  // namespace tb
