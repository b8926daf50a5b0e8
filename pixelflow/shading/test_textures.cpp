#include "pixelflow/shading/test_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pfman {
namespace {

using Color = std::array<double, 3>;

Color mix(const Color& a, const Color& b, double t) {
  t = std::clamp(t, 0.0, 1.0);
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

double smooth(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A number of 0 to 1 for a lattice point.
double hash(int x, int y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343u + static_cast<std::uint32_t>(y) * 0xD8163841u;
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  h = (h ^ h >> 12) * 0x297A2D39u;
  return (h ^ h >> 15) / 4294967295.0;
}

/// Noise that repeats after `period` lattice points.
double noise(double x, double y, int period) {
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const auto at = [&](int column, int row) {
    return hash((column % period + period) % period, (row % period + period) % period);
  };
  const double u = smooth(0, 1, x - i), v = smooth(0, 1, y - j);
  const double low = at(i, j) + (at(i + 1, j) - at(i, j)) * u;
  const double high = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * u;
  return low + (high - low) * v;
}

/// Octaves of noise, each of half the size and weight of the one before.
double fractal(double x, double y, int period, int octaves) {
  double sum = 0, weight = 0.5, total = 0;
  for (int octave = 0; octave < octaves; ++octave, x *= 2, y *= 2, period *= 2, weight /= 2) {
    sum += weight * noise(x, y, period);
    total += weight;
  }
  return sum / total;
}

/// `color` of texture coordinates, of the middle of every texel.
TextureMemory::Image make(int size, const std::function<Color(double, double)>& color) {
  TextureMemory::Image image;
  image.width = image.height = size;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      for (const double component : color((column + 0.5) / size, (row + 0.5) / size))
        image.rgba.push_back(static_cast<std::uint8_t>(std::clamp(component, 0.0, 1.0) * 255 + 0.5));
      image.rgba.push_back(255);
    }
  }
  return image;
}

/// What is seen from the lake in a direction.
Color surroundings(double x, double y, double z) {
  constexpr Color kZenith{0.12, 0.32, 0.70}, kHorizon{0.93, 0.80, 0.66}, kCloud{1.0, 0.98, 0.95},
      kShadow{0.58, 0.62, 0.70};
  constexpr Color kHill{0.20, 0.26, 0.24}, kShore{0.10, 0.12, 0.10}, kSun{1.0, 0.93, 0.74};
  constexpr Color kTowardsSun{0.25, 0.48, 0.84};
  const double up = std::max(y, 0.0);
  Color color = mix(kHorizon, kZenith, smooth(-0.05, 0.55, up));
  const double sun = x * kTowardsSun[0] + y * kTowardsSun[1] + z * kTowardsSun[2];
  // Clouds hang in a plane above, so that they grow smaller towards the horizon.
  if (y > 0.02) {
    const double scale = 3.4 / (y + 0.15);
    const double cloud = fractal(x * scale + 7, z * scale + 3, 1 << 20, 6);
    const Color lit = mix(kCloud, kShadow, smooth(0.55, 0.78, fractal(x * scale + 7.4, z * scale + 3.3, 1 << 20, 5)));
    color = mix(color, lit, smooth(0.48, 0.66, cloud) * smooth(0.02, 0.25, y));
  }
  color = mix(color, kSun, 0.45 * smooth(0.88, 1.0, sun) + smooth(0.9945, 0.997, sun));
  // Hills all around, by the angle about the vertical axis, measured without trigonometry.
  const double flat = std::sqrt(x * x + z * z);
  const double around = flat > 0 ? (x > 0 ? 1 - z / flat : 3 + z / flat) : 0;
  const double ridge = 0.04 + 0.16 * fractal(around * 4, 0.5, 16, 5) + 0.03 * noise(around * 64, 3.5, 256);
  if (y < ridge) color = mix(kHill, kHorizon, 0.35 * smooth(0.0, 0.2, y));
  if (y < 0.03) color = kShore;
  return color;
}

/// OpenGL's sphere map: a mirror ball seen from afar.
Color sphere_map(double s, double t) {
  const double nx = 2 * s - 1, ny = 2 * t - 1, flat = nx * nx + ny * ny;
  const double nz = std::sqrt(std::max(0.0, 1 - flat));
  return surroundings(2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1);
}

Color stone(double s, double t) {
  const double large = fractal(4 * s, 4 * t, 4, 5), fine = fractal(32 * s, 32 * t, 32, 3);
  const double vein = std::fabs(fractal(3 * s + 0.5, 3 * t, 3, 4) - 0.5);
  Color color = mix({0.24, 0.27, 0.33}, {0.58, 0.60, 0.62}, 0.7 * large + 0.3 * fine);
  return mix({0.80, 0.78, 0.74}, color, smooth(0.0, 0.035, vein));
}

/// Cells around scattered points; bright where two are equally near.
Color cells(double s, double t) {
  constexpr int kCells = 6;
  double nearest = 9, second = 9, shade = 0;
  const int column = static_cast<int>(s * kCells), row = static_cast<int>(t * kCells);
  for (int j = row - 2; j <= row + 2; ++j) {
    for (int i = column - 2; i <= column + 2; ++i) {
      const int ci = (i + kCells) % kCells, cj = (j + kCells) % kCells;
      const double dx = i + 0.15 + 0.7 * hash(ci, cj + 100) - s * kCells;
      const double dy = j + 0.15 + 0.7 * hash(ci + 100, cj) - t * kCells;
      const double distance = std::sqrt(dx * dx + dy * dy);
      if (distance < nearest) {
        second = nearest;
        nearest = distance;
        shade = hash(ci + 50, cj + 50);
      } else {
        second = std::min(second, distance);
      }
    }
  }
  const Color body = mix(mix({0.62, 0.16, 0.08}, {0.86, 0.40, 0.12}, shade), {0.98, 0.72, 0.30}, 0.5 - 0.6 * nearest);
  return mix({0.30, 0.05, 0.05}, body, smooth(0.03, 0.16, second - nearest));
}

}  // namespace

TextureMemory test_textures() {
  TextureMemory memory;
  memory.set(1, make(512, sphere_map));
  memory.set(2, make(256, stone));
  memory.set(3, make(256, cells));
  return memory;
}

}  // namespace pfman
