// The `geometry` of an object in a scene file: its own keys become a mesh.
#pragma once

#include <filesystem>

#include "scanline/mesh.h"
#include "scanline/toml_table.h"

namespace scanline {

/// Reads "geometry" and the keys that belong to it. `folder` is where the scene file stands. What is wrong is noted in
/// the table's mistakes; the mesh is empty then.
Mesh read_geometry(TomlTable& object, const std::filesystem::path& folder);

}  // namespace scanline
