// The `geometry` of an object in a scene file: its own keys become a mesh, or what makes one.
#pragma once

#include <filesystem>
#include <memory>

#include "scanline/field.h"
#include "scanline/mesh.h"
#include "scanline/mesh_source.h"
#include "scanline/toml_table.h"

namespace scanline {

/// An object's geometry, as in Object: a mesh, with the field that it stands for where there is one; or a source.
struct Geometry {
  Mesh mesh;
  std::shared_ptr<const MeshSource> source;
  std::shared_ptr<const Field> field;
};

/// Reads "geometry" and the keys that belong to it. `folder` is where the scene file stands. What is wrong is noted in
/// the table's mistakes; the geometry is empty then.
Geometry read_geometry(TomlTable& object, const std::filesystem::path& folder);

}  // namespace scanline
