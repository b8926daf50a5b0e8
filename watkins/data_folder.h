// Where the project's own shaders and images lie.
#pragma once

#include <filesystem>

namespace watkins {

/// The folder that holds `shaders/`.
std::filesystem::path data_folder();

}  // namespace watkins
