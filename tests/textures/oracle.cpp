#include "tests/textures/oracle.h"

#include <algorithm>
#include <cmath>

namespace texture_tests {
namespace {

/// Weight of texel `n` of a row or column for a coordinate: a tent of one texel's radius around its middle, in all
/// copies of the image that reach it.
long double tent(float coordinate, int n, int texels) {
  const long double c = std::isfinite(coordinate) ? coordinate : 0;
  const long double position = (c - std::floor(c)) * texels;
  long double weight = 0;
  for (int copy = -1; copy <= 1; ++copy) {
    weight += std::max(0.0L, 1 - std::fabs(position - (n + 0.5L + static_cast<long double>(copy) * texels)));
  }
  return weight;
}

Exact sampled(const Image& image, const Sample& sample) {
  Exact sum{};
  for (int y = 0; y < image.height; ++y) {
    const long double row = tent(sample.t, y, image.height);
    for (int x = 0; x < image.width && row != 0; ++x) {
      const long double weight = row * tent(sample.s, x, image.width);
      for (std::size_t c = 0; c < sum.size(); ++c) {
        sum[c] += weight * image.rgba[static_cast<std::size_t>(y * image.width + x) * 4 + c];
      }
    }
  }
  return sum;
}

const Sample* find(std::span<const Sample> samples, int column, int row) {
  for (const Sample& sample : samples) {
    const bool is_number = std::isfinite(sample.s) && std::isfinite(sample.t);
    if (sample.column == column && sample.row == row && is_number) return &sample;
  }
  return nullptr;
}

/// Length of the step between two places in texels, negative where one of them has no sample.
long double distance(const Sample* a, const Sample* b, const Image& image) {
  if (a == nullptr || b == nullptr) return -1;
  return std::hypot((static_cast<long double>(a->s) - b->s) * image.width,
                    (static_cast<long double>(a->t) - b->t) * image.height);
}

long double footprint(std::span<const Sample> samples, const Sample& sample, const Image& image) {
  const int column = sample.column, row = sample.row;
  const int next_column = column % 2 == 0 ? column + 1 : column - 1, next_row = row % 2 == 0 ? row + 1 : row - 1;
  long double across = distance(find(samples, column, row), find(samples, next_column, row), image);
  if (across < 0) across = distance(find(samples, column, next_row), find(samples, next_column, next_row), image);
  long double down = distance(find(samples, column, row), find(samples, column, next_row), image);
  if (down < 0) down = distance(find(samples, next_column, row), find(samples, next_column, next_row), image);
  return std::max({across, down, 0.0L});
}

}  // namespace

Exact exact_texel(const std::vector<Image>& levels, std::span<const Sample> samples, std::size_t number) {
  const Sample& sample = samples[number];
  long double step = footprint(samples, sample, levels[0]);
  std::size_t level = 0;
  while (step >= 2 && level + 1 < levels.size()) {
    step /= 2;
    ++level;
  }
  Exact fine = sampled(levels[level], sample);
  if (step <= 1 || level + 1 == levels.size()) return fine;
  const Exact coarse = sampled(levels[level + 1], sample);
  for (std::size_t c = 0; c < fine.size(); ++c) fine[c] += (coarse[c] - fine[c]) * (step - 1);
  return fine;
}

int wrong_texels(const std::vector<Image>& levels, std::span<const Sample> samples, std::span<const Texel> texels) {
  // Halves may fall to either side in double precision.
  constexpr long double kRounding = 0.5L + 1e-9L;
  int wrong = 0;
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const Exact exact = exact_texel(levels, samples, n);
    bool right = true;
    for (std::size_t c = 0; c < exact.size(); ++c) right = right && std::fabs(texels[n][c] - exact[c]) <= kRounding;
    wrong += !right;
  }
  return wrong;
}

}  // namespace texture_tests
