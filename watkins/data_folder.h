// Where the project's own shaders, tables and scenes lie.
#pragma once

#include <filesystem>

namespace watkins {

/// The folder that holds `shaders/`, `tables/` and `scenes/`: $VSG_DATA where that is set; otherwise what was installed
/// with the program or library that runs, share/watkins beside its own folder; otherwise the sources.
std::filesystem::path data_folder();

}  // namespace watkins
