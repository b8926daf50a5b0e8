// Tables 2 and 3 of the PixelFlow paper (Olano and Lastra 1998): cycles of arithmetic and of functions on the pixel
// processors.
#pragma once

#include <filesystem>
#include <string>

#include "cmodel/pixelflow/pixel_array.h"
#include "program/table.h"

namespace program {

/// Runs each operation on `array`, on random numbers, and takes the cycles from its counters. `tables`: the folder with
/// pixelflow.json and pixelflow_accuracy.json, the errors over all arguments. Errors are in ulp of the result against
/// exact or extended arithmetic on the host; a function's is the greater of what all arguments gave and what this run
/// gives. Throws scanline::UserError for a table file that is missing or malformed.
Table pixelflow2(pixelflow::PixelArray& array, const std::filesystem::path& tables);
Table pixelflow3(pixelflow::PixelArray& array, const std::filesystem::path& tables);

/// For people: one line a cell, workspace and error beside it.
std::string pixelflow_text(const Table& table);

}  // namespace program
