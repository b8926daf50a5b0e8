// Images for test pictures, made by a procedure.
#pragma once

#include "pixelflow/shading/texture_memory.h"

namespace pfman {

/// Number 1: a sphere map of a lake's surroundings (sky with clouds and a low sun, hills, dark ground), eye space. 2: a
/// rough stone. 3: cells with dark rims. The latter two repeat without a seam.
TextureMemory test_textures();

}  // namespace pfman
