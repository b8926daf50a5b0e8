// Texture lookups of the elements of an array, answered by its node's host.
#pragma once

#include <span>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/shared_texture.h"
#include "pixelflow/shading/texture_memory.h"

namespace pfman {

/// The enabled elements have sent coordinates: loads their answers. They are the ones that look up together.
void look_up(const Lookup& lookup, const TextureMemory& textures, pixelflow::PixelArray& array);

/// A shared lookup from coordinates to texels in memory: one for all users, of which each has its texture, and whose
/// elements are the ones that look up together, as if each had looked up alone.
void look_up_shared(std::span<const TextureUser> users, const TextureMemory& textures, pixelflow::PixelArray& array);

}  // namespace pfman
