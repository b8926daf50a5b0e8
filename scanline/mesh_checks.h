// Checks of mesh files before the library that reads them sees them.
#pragma once

#include <string>
#include <string_view>

namespace scanline {

/// Throws UserError for a PLY file whose header, data and indices do not fit together.
void check_ply(std::string_view text, const std::string& file);

}  // namespace scanline
