#include "scanline/picture.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scanline {

Picture::Picture(int width, int height)
    : width_(width), height_(height), colors_(3 * static_cast<std::size_t>(width) * height) {}

Picture::Picture(int width, int height, std::vector<float> colors)
    : width_(width), height_(height), colors_(std::move(colors)) {
  if (colors_.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("a picture has three colours a pixel");
}

void Picture::shade_rows(const ShaderStage& stage, const SpanList& spans, int samples, int first_row, int rows) {
  std::vector<Rgb8> shaded(static_cast<std::size_t>(spans.width()) * samples * rows);
  stage.shade(spans.band(first_row * samples, rows * samples), shaded);
  set_rows(shaded, samples, first_row, rows);
}

void Picture::set_rows(std::span<const Rgb8> values, int samples, int first_row, int rows) {
  const std::size_t sample_width = static_cast<std::size_t>(width_) * samples;
  const auto count = static_cast<float>(samples * samples);
  for (int row = 0; row < rows; ++row) {
    float* out = &colors_[3 * static_cast<std::size_t>(first_row + row) * width_];
    for (int column = 0; column < width_; ++column) {
      std::uint32_t r = 0, g = 0, b = 0;
      for (int j = 0; j < samples; ++j) {
        const Rgb8* sample = &values[(static_cast<std::size_t>(row) * samples + j) * sample_width + column * samples];
        for (int i = 0; i < samples; ++i) {
          r += sample[i].r;
          g += sample[i].g;
          b += sample[i].b;
        }
      }
      *out++ = static_cast<float>(r) / count;
      *out++ = static_cast<float>(g) / count;
      *out++ = static_cast<float>(b) / count;
    }
  }
}

std::vector<std::string> shader_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) {
    if (std::find(names.begin(), names.end(), object.shader.name) == names.end()) names.push_back(object.shader.name);
  }
  return names;
}

}  // namespace scanline
