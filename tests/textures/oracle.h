// What a lookup should find, sample by sample, as a sum over all texels.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pixelflow/shading/texture_memory.h"

namespace texture_tests {

using Image = pfman::TextureMemory::Image;
using Sample = pfman::TextureMemory::Sample;
using Texel = pfman::TextureMemory::Texel;

/// Components before they are rounded, 0 to 255.
using Exact = std::array<long double, 4>;

/// Of sample `number` among those that look up together, in images from the finest level on.
Exact exact_texel(const std::vector<Image>& levels, std::span<const Sample> samples, std::size_t number);

/// How many of the texels are not the exact ones, rounded.
int wrong_texels(const std::vector<Image>& levels, std::span<const Sample> samples, std::span<const Texel> texels);

}  // namespace texture_tests
