// Which level of the pixel processors does the work, as the command line chooses it.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cmodel/pixelflow/pixel_array.h"

namespace program {

struct PixelOptions {
  std::string level;  ///< "rtl", "model" or "macro"
  int multiplier_bits = pixelflow::kMultiplierBits;
};

/// Adds --pe; a program without RTL has the model as its default.
void add_pixel_options(CLI::App& command, PixelOptions& options);

/// Throws scanline::UserError when this program has no RTL and the options ask for it.
std::unique_ptr<pixelflow::PixelArray> make_array(const PixelOptions& options, int lanes);

}  // namespace program
