// Tables 1 and 4 of the PixelFlow paper (Olano and Lastra 1998): cycles and memory of whole shaders, ours under the
// published names.
#pragma once

#include <filesystem>
#include <string>

#include "cmodel/pixelflow/pixel_array.h"
#include "program/table.h"

namespace program {

/// Bytes of a pixel that are left over by a surface, a light and what they share; cycles that a region takes with one
/// light, the light's included, from the counters of `array`. Behind the published rows, what our shaders consist of:
/// operations by kind, and their cycles stage by stage. `data`: the folder with shaders/ and tables/. Throws
/// scanline::UserError for a file that is missing or wrong.
Table pixelflow1(pixelflow::PixelArray& array, const std::filesystem::path& data);

/// Bytes of uniform and varying variables together, of the varying ones if each had its own place, and as allocated.
/// The share that allocation saves stands in a fourth column, for the paper computed from its figures.
Table pixelflow4(const std::filesystem::path& data);

/// For people: published cells one a line, then everything measured, a column for each of our shaders.
std::string shader_table_text(const Table& table);

}  // namespace program
