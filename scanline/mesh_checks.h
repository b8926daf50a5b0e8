// Checks of mesh files before the library that reads them sees them.
#pragma once

#include <string>
#include <string_view>

namespace scanline {

/// Throws UserError for a PLY file whose header, data and indices do not fit together.
void check_ply(std::string_view text, const std::string& file);

/// Throws UserError with line and column for an OBJ file with an unknown keyword, a wrong number of values, a malformed
/// corner or an index out of range, and for points and lines. Returns what a mesh needs of it (v, vt, vn, f), a
/// statement a line: the library takes some of the other statements for points.
std::string check_obj(std::string_view text, const std::string& file);

/// Throws UserError with line and column for an ASCII STL file whose solids, facets, loops and vertices are not nested
/// as they should be. Passes binary files, which are known by their length.
void check_stl(std::string_view text, const std::string& file);

}  // namespace scanline
