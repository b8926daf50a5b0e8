// Pictures as files, by OpenImageIO; the suffix decides the format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scanline/picture.h"

namespace program {

/// Throws scanline::UserError when no format has the suffix, or when it cannot hold the extra channels.
void check_image_format(const std::filesystem::path& path, bool with_channels);

/// Colours go to EXR as n / 255 in 32-bit floats, without colour conversion, and to other formats as the byte n.
/// The same picture gives the same bytes. Throws scanline::UserError.
void write_image(const std::filesystem::path& path, const scanline::Picture& picture,
                 const std::vector<std::string>& shader_names);

}  // namespace program
