#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pixelflow/shading/shading_node.h"

namespace pfman {
namespace {

/// The part of a coordinate that counts where textures repeat: 0 up to 1, 0 for what is no number.
double repeated(double coordinate) {
  if (!std::isfinite(coordinate)) return 0;
  return coordinate - std::floor(coordinate);
}

/// Two neighbouring texels, and how far the sample lies from the first to the second.
struct Between {
  int first, second;
  double part;
};

Between between(double coordinate, int texels) {
  const double at = repeated(coordinate) * texels - 0.5;
  const int below = static_cast<int>(std::floor(at));
  return {(below + texels) % texels, (below + 1) % texels, at - below};
}

}  // namespace

void TextureMemory::set(std::int64_t number, Texture texture) {
  if (texture.width < 1 || texture.height < 1 ||
      texture.rgba.size() != static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height) * 4) {
    throw std::invalid_argument("a texture has 4 bytes for each of its texels");
  }
  textures_[number] = std::move(texture);
}

std::array<std::uint8_t, 4> TextureMemory::lookup(std::int64_t number, float s, float t) const {
  const auto found = textures_.find(number);
  if (found == textures_.end()) return {255, 255, 255, 255};
  const Texture& texture = found->second;
  const Between x = between(s, texture.width), y = between(t, texture.height);
  const auto texel = [&](int column, int row, std::size_t component) {
    return static_cast<double>(texture.rgba[static_cast<std::size_t>(row * texture.width + column) * 4 + component]);
  };
  std::array<std::uint8_t, 4> result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const double below = texel(x.first, y.first, c) * (1 - x.part) + texel(x.second, y.first, c) * x.part;
    const double above = texel(x.first, y.second, c) * (1 - x.part) + texel(x.second, y.second, c) * x.part;
    result[c] = static_cast<std::uint8_t>(std::floor(below * (1 - y.part) + above * y.part + 0.5));
  }
  return result;
}

std::array<std::uint8_t, 4> TextureMemory::environment(std::int64_t number, std::array<float, 3> direction) const {
  const double x = direction[0], y = direction[1], z = direction[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  // A direction straight away from the eye lies on the rim of the sphere's image, everywhere: the lowest point is
  // taken.
  if (!(length > 0) || !std::isfinite(length)) return lookup(number, 0.5f, 0.5f);
  const double m = 2 * std::sqrt(std::max(0.0, 2 + 2 * z / length));
  if (!(m > 0)) return lookup(number, 0.5f, 0);
  return lookup(number, static_cast<float>(x / length / m + 0.5), static_cast<float>(y / length / m + 0.5));
}

}  // namespace pfman
