// Images for texture memory, from files.
#pragma once

#include <filesystem>
#include <vector>

#include "pixelflow/shading/texture_memory.h"

namespace watkins {

/// The first image of a file that OpenImageIO reads, for TextureMemory::set(): its MIP levels where it has them all in
/// half sizes, otherwise levels down to a single texel made with a box filter. Components are the file's own, 0 to 1 as
/// bytes 0 to 255, without colour conversion: one is grey, two are grey and alpha, of more than four the first four are
/// taken. The file's lowest row is at t = 0. Throws scanline::UserError that names the file where it cannot be read, is
/// no flat image, or has more texels than texture memory.
std::vector<pfman::TextureMemory::Image> read_texture_file(const std::filesystem::path& path);

}  // namespace watkins
