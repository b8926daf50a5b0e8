// The texture memory of a shading node (Olano and Lastra 1998, section 6.3): images with MIP levels, and what lookups
// find in them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace pfman {

/// Of every node (section 6.3).
constexpr std::size_t kTextureMemoryBytes = std::size_t{64} << 20;

/// Whether a MIP level's width or height is half of that of the level before, rounded up or down, at least 1.
bool is_half(int half, int whole);

/// Images that shaders look up, by number. Coordinates repeat; filters are bilinear within a level and linear between
/// two (docs/pfman_library.md, Textures). Results do not depend on the order of the samples.
class TextureMemory {
 public:
  struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a texel, rows from t = 0 up
  };
  using Texel = std::array<std::uint8_t, 4>;  ///< components 0 to 255

  /// An element's part of a lookup. Places are those of the region.
  struct Sample {
    std::uint8_t column = 0, row = 0;
    float s = 0, t = 0;
  };

  /// Takes the place of what had the number. Throws std::invalid_argument for an image without texels or with another
  /// number of bytes than it has texels for, and for one that the memory has no room for.
  void set(std::int64_t number, Image image);
  /// The same with MIP levels, the finest first, each half as wide and high as the one before. There may be fewer than
  /// lead to a single texel.
  void set(std::int64_t number, std::vector<Image> levels);
  /// In use; kTextureMemoryBytes are the most.
  std::size_t bytes() const { return bytes_; }

  /// From the finest level. A number without an image gives opaque white.
  Texel lookup(std::int64_t number, float s, float t) const;
  /// Sphere-mapped along a direction in eye space.
  Texel environment(std::int64_t number, std::array<float, 3> direction) const;
  /// What elements that look up together find: the differences within quads of even and odd columns and rows choose the
  /// level. A place occurs once.
  std::vector<Texel> lookup(std::int64_t number, std::span<const Sample> samples) const;

  /// Where a direction in eye space lies in a sphere map: s, t.
  static std::array<float, 2> on_sphere(std::array<float, 3> direction);

 private:
  std::map<std::int64_t, std::vector<Image>> images_;
  std::size_t bytes_ = 0;
};

}  // namespace pfman
