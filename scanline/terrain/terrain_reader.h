// geometry = "terrain" of a scene file (docs/formats.md).
#pragma once

#include <filesystem>

#include "scanline/scene_shapes.h"
#include "scanline/toml_table.h"

namespace scanline {

/// Reads the keys of a terrain and its file: a mesh when the scene fixes the resolution, otherwise a source. What is
/// wrong is noted in the table's mistakes; the geometry is empty then.
Geometry read_terrain(TomlTable& object, const std::filesystem::path& folder);

}  // namespace scanline
