// Meshes from files. OFF is read here, with line numbers; OBJ, PLY, STL and glTF come through Assimp. Polygons stay
// polygons; vertices of equal position are joined; normals, texture coordinates and colours become corner attributes
// "normal" (3), "uv" (2 or 3) and "color" (4).
#pragma once

#include <filesystem>

#include "scanline/mesh.h"

namespace scanline {

/// Throws UserError naming the file (and the line where it is known) for what cannot be read, indices out of range,
/// coordinates that are not finite, points and lines, and files without any polygon.
Mesh read_mesh_file(const std::filesystem::path& path);

/// OFF and COFF text: vertices with optional colours (COFF), polygons of any number of sides.
Mesh read_off(std::string_view text, const std::string& file);

}  // namespace scanline
