// Which level of the pixel processors does the work, as the command line chooses it.
#pragma once

#include <CLI/CLI.hpp>

#include "watkins/machines.h"

namespace program {

using watkins::PixelOptions;

/// Adds --pe; a program without RTL has the model as its default.
void add_pixel_options(CLI::App& command, PixelOptions& options);

}  // namespace program
