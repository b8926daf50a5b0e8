#include "pixelflow/shading/texture_memory.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace pfman {
namespace {

using Image = TextureMemory::Image;
using Sample = TextureMemory::Sample;
using Texel = TextureMemory::Texel;
using Components = std::array<double, 4>;

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

double mixed(double a, double b, double part) { return a * (1 - part) + b * part; }

Components bilinear(const Image& image, float s, float t) {
  const Between x = between(s, image.width), y = between(t, image.height);
  const auto texel = [&](int column, int row, std::size_t component) {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width);
    return static_cast<double>(image.rgba[(at + static_cast<std::size_t>(column)) * 4 + component]);
  };
  Components result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = mixed(mixed(texel(x.first, y.first, c), texel(x.second, y.first, c), x.part),
                      mixed(texel(x.first, y.second, c), texel(x.second, y.second, c), x.part), y.part);
  }
  return result;
}

Texel rounded(const Components& components) {
  Texel result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = static_cast<std::uint8_t>(std::floor(components[c] + 0.5));
  }
  return result;
}

/// A level of detail: between a level and the next coarser one.
struct Detail {
  std::size_t level = 0;
  double part = 0;
};

/// Of a step of so many texels of the finest level from one element to the next. 2^k (1 + f) texels are level k + f:
/// that is within 0.09 of the logarithm, equal to it at whole levels, and takes no operation that hosts round
/// differently.
Detail detail_of(double texels, std::size_t levels) {
  if (!(texels > 1)) return {};
  int exponent = 0;
  const double mantissa = std::frexp(texels, &exponent);  // 1/2 up to 1
  const auto level = static_cast<std::size_t>(exponent - 1);
  if (level >= levels - 1) return {levels - 1, 0};
  return {level, 2 * mantissa - 1};
}

Texel trilinear(const std::vector<Image>& levels, const Sample& sample, const Detail& detail) {
  const Components fine = bilinear(levels[detail.level], sample.s, sample.t);
  if (detail.part == 0) return rounded(fine);
  const Components coarse = bilinear(levels[detail.level + 1], sample.s, sample.t);
  Components result{};
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = mixed(fine[c], coarse[c], detail.part);
  return rounded(result);
}

/// The samples of quads: 2 x 2 elements from an even column and row on.
class Quads {
 public:
  explicit Quads(std::span<const Sample> samples) {
    std::size_t rows = 0;
    for (const Sample& sample : samples) {
      columns_ = std::max(columns_, (sample.column / 2 + 1) * std::size_t{2});
      rows = std::max(rows, (sample.row / 2 + 1) * std::size_t{2});
    }
    at_.assign(columns_ * rows, nullptr);
    for (const Sample& sample : samples) {
      // What is no number is no place to measure a difference from.
      if (std::isfinite(sample.s) && std::isfinite(sample.t)) at_[sample.row * columns_ + sample.column] = &sample;
    }
  }

  /// Texels from an element to its neighbour: the longer one of the steps along the row and along the column. Where one
  /// of the two is missing, that of the quad's other row or column stands for it; where both rows lack it, only the
  /// other direction counts.
  double step(const Sample& sample, const Image& image) const {
    const std::size_t left = sample.column & ~1u, top = sample.row & ~1u, column = sample.column, row = sample.row;
    const auto length = [&](std::optional<double> own, std::optional<double> other) {
      return own ? *own : other.value_or(0);
    };
    const auto along_row = [&](std::size_t r) { return square(at(left, r), at(left + 1, r), image); };
    const auto along_column = [&](std::size_t c) { return square(at(c, top), at(c, top + 1), image); };
    return std::sqrt(
        std::max(length(along_row(row), along_row(row ^ 1)), length(along_column(column), along_column(column ^ 1))));
  }

 private:
  const Sample* at(std::size_t column, std::size_t row) const { return at_[row * columns_ + column]; }

  static std::optional<double> square(const Sample* a, const Sample* b, const Image& image) {
    if (!a || !b) return std::nullopt;
    const double x = (static_cast<double>(b->s) - a->s) * image.width;
    const double y = (static_cast<double>(b->t) - a->t) * image.height;
    return x * x + y * y;
  }

  std::size_t columns_ = 0;
  std::vector<const Sample*> at_;
};

std::size_t bytes_of(const std::vector<Image>& levels) {
  std::size_t bytes = 0;
  for (const Image& level : levels) bytes += level.rgba.size();
  return bytes;
}

void check(const std::vector<Image>& levels) {
  if (levels.empty()) throw std::invalid_argument("an image has one level at least");
  for (const Image& level : levels) {
    if (level.width < 1 || level.height < 1 ||
        level.rgba.size() != static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) * 4) {
      throw std::invalid_argument("an image has 4 bytes for each of its texels");
    }
  }
  for (std::size_t n = 1; n < levels.size(); ++n) {
    if (!is_half(levels[n].width, levels[n - 1].width) || !is_half(levels[n].height, levels[n - 1].height)) {
      throw std::invalid_argument("a MIP level has half the size of the one before");
    }
  }
}

}  // namespace

bool is_half(int half, int whole) { return half == std::max(1, whole / 2) || half == whole / 2 + whole % 2; }

void TextureMemory::set(std::int64_t number, Image image) {
  std::vector<Image> levels;
  levels.push_back(std::move(image));
  set(number, std::move(levels));
}

void TextureMemory::set(std::int64_t number, std::vector<Image> levels) {
  check(levels);
  const auto before = images_.find(number);
  const std::size_t others = bytes_ - (before == images_.end() ? 0 : bytes_of(before->second));
  const std::size_t own = bytes_of(levels);
  if (own > kTextureMemoryBytes - others) {
    throw std::invalid_argument("the image takes " + std::to_string(own) + " bytes with its MIP levels, and of the " +
                                std::to_string(kTextureMemoryBytes) + " bytes of texture memory " +
                                std::to_string(kTextureMemoryBytes - others) + " are left");
  }
  images_[number] = std::move(levels);
  bytes_ = others + own;
}

TextureMemory::Texel TextureMemory::lookup(std::int64_t number, float s, float t) const {
  const Sample sample{0, 0, s, t};
  return lookup(number, std::span(&sample, 1)).front();
}

TextureMemory::Texel TextureMemory::environment(std::int64_t number, std::array<float, 3> direction) const {
  const std::array<float, 2> at = on_sphere(direction);
  return lookup(number, at[0], at[1]);
}

std::vector<TextureMemory::Texel> TextureMemory::lookup(std::int64_t number, std::span<const Sample> samples) const {
  std::vector<Texel> texels(samples.size(), Texel{255, 255, 255, 255});
  const auto found = images_.find(number);
  if (found == images_.end()) return texels;
  const std::vector<Image>& levels = found->second;
  if (levels.size() == 1) {
    for (std::size_t n = 0; n < samples.size(); ++n) texels[n] = trilinear(levels, samples[n], {});
    return texels;
  }
  const Quads quads(samples);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    texels[n] = trilinear(levels, samples[n], detail_of(quads.step(samples[n], levels[0]), levels.size()));
  }
  return texels;
}

std::array<float, 2> TextureMemory::on_sphere(std::array<float, 3> direction) {
  const double x = direction[0], y = direction[1], z = direction[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0) || !std::isfinite(length)) return {0.5f, 0.5f};
  const double m = 2 * std::sqrt(std::max(0.0, 2 + 2 * z / length));
  // A direction straight away from the eye lies on the rim of the sphere's image, everywhere: the lowest point is
  // taken.
  if (!(m > 0)) return {0.5f, 0};
  return {static_cast<float>(x / length / m + 0.5), static_cast<float>(y / length / m + 0.5)};
}

}  // namespace pfman
