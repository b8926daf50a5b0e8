#include "tests/microcode/noise_oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pixelflow_test {
namespace {

unsigned hash_of(const unsigned index[3]) {
  constexpr unsigned kFactors[3] = {0x9E37, 0x79B9, 0x85EB};
  unsigned x = 0;
  for (int axis = 0; axis < 3; ++axis) x += index[axis] % 256 * kFactors[axis];
  x %= 65536;
  x ^= x / 256;
  x = x * 0x6A35 % 65536;
  x ^= x / 128;
  x = x * 0xB4D3 % 65536;
  return x / 256;
}

// The sixteen gradients, written out.
constexpr int kGradients[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                   {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                   {1, 1, 0},  {0, -1, 1},  {-1, 1, 0}, {0, -1, -1}};

// The weight of the second: off by the weight's own error, times how far the two lie apart.
Bounded mix(const Bounded& first, const Bounded& second, double t, const NoiseFormat& format, double rounding) {
  const double weight = t * t * (3 - 2 * t);
  const double weight_error = 1.5 * format.coordinate + format.weight;  // 3/2: the weight's largest slope
  const double apart = std::fabs(second.value - first.value) + first.error + second.error;
  return {first.value + (second.value - first.value) * weight,
          std::max(first.error, second.error) + apart * weight_error + rounding};
}

}  // namespace

Bounded noise_by_definition(int dimensions, const double* point, const NoiseFormat& format) {
  unsigned cell[3] = {};
  double t[3] = {};
  for (int axis = 0; axis < dimensions; ++axis) {
    const double whole = std::floor(point[axis]);
    t[axis] = point[axis] - whole;
    cell[axis] = static_cast<unsigned>(whole - 256 * std::floor(whole / 256));
  }
  Bounded values[8];
  const int corners = 1 << dimensions;
  for (int corner = 0; corner < corners; ++corner) {
    const int far[3] = {corner & 1, corner >> 1 & 1, corner >> 2 & 1};
    unsigned index[3];
    for (int axis = 0; axis < 3; ++axis) index[axis] = cell[axis] + static_cast<unsigned>(far[axis]);
    const int* gradient = kGradients[hash_of(index) % 16];
    values[corner] = {0, 0};
    for (int axis = 0; axis < dimensions; ++axis) {
      values[corner].value += gradient[axis] * (t[axis] - far[axis]);
      values[corner].error += std::abs(gradient[axis]) * format.coordinate;
    }
  }
  for (int axis = 0; axis < dimensions; ++axis) {
    const double rounding = axis == 0 ? format.first_mix : format.mix;
    for (int n = 0; n < corners >> (axis + 1); ++n) {
      values[n] = mix(values[2 * n], values[2 * n + 1], t[axis], format, rounding);
    }
  }
  const double noise = std::clamp((values[0].value + 1) / 2, 0.0, 1.0);
  return {noise, values[0].error / 2 + format.result};
}

}  // namespace pixelflow_test
