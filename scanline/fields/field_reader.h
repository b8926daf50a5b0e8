// Distance fields in scene files: `geometry = "field"` (docs/fields.md).
#pragma once

#include <filesystem>

#include "scanline/scene_shapes.h"
#include "scanline/toml_table.h"

namespace scanline {

/// Reads the keys of an object that is a field, and extracts its polygons. What is wrong is noted; the geometry is
/// empty then.
Geometry read_field_geometry(TomlTable& object, const std::filesystem::path& folder);

}  // namespace scanline
