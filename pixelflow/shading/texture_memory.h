// The texture memory of a shading node (Olano and Lastra 1998, section 6.3).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace pfman {

/// Images that shaders look up, by number. Lookups are bilinear, repeat, and give 8-bit components.
class TextureMemory {
 public:
  struct Texture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a texel, rows from t = 0 up
  };
  void set(std::int64_t number, Texture texture);
  /// Components 0 to 255; a number without a texture gives opaque white.
  std::array<std::uint8_t, 4> lookup(std::int64_t number, float s, float t) const;
  /// Sphere-mapped along a direction in eye space.
  std::array<std::uint8_t, 4> environment(std::int64_t number, std::array<float, 3> direction) const;

 private:
  std::map<std::int64_t, Texture> textures_;
};

}  // namespace pfman
