#include "tests/truth/random_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace truth {
namespace {

class Maker {
 public:
  Maker(std::uint64_t seed, int size) : random_(seed), size_(size) { frame_.width = frame_.height = size; }

  // Not std::uniform_real_distribution: its numbers differ between libraries.
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  std::uint32_t vertex(double x, double y, double z) {
    const double most = size_ - 1.5;
    frame_.vertices.push_back({std::clamp(x, 1.5, most), std::clamp(y, 0.5, most), z});
    return static_cast<std::uint32_t>(frame_.vertices.size());
  }

  void triangle() {
    const double reach = size_ * std::pow(2.0, uniform(-4, 0)), depth = uniform(10, 200);
    const double x = uniform(0, size_), y = uniform(0, size_), z = uniform(100, 1000);
    std::vector<std::uint32_t> corners;
    for (int i = 0; i < 3; ++i) {
      corners.push_back(vertex(x + uniform(-reach, reach), y + uniform(-reach, reach), z + uniform(-depth, depth)));
    }
    frame_.polygons.push_back(corners);
  }

  void box() {
    const double a = uniform(0, 6.28), b = uniform(-1.2, 1.2);
    const double middle[3] = {uniform(0.35, 0.65) * size_, uniform(0.35, 0.65) * size_, uniform(0.4, 0.6) * size_};
    const double half[3] = {uniform(0.06, 0.2) * size_, uniform(0.06, 0.2) * size_, uniform(0.06, 0.2) * size_};
    std::uint32_t corner[8];
    for (int i = 0; i < 8; ++i) {
      double p[3];
      for (int k = 0; k < 3; ++k) p[k] = (i >> k & 1 ? 1 : -1) * half[k];
      const double x = std::cos(a) * p[0] - std::sin(a) * p[1], y0 = std::sin(a) * p[0] + std::cos(a) * p[1];
      const double y = std::cos(b) * y0 - std::sin(b) * p[2], z = std::sin(b) * y0 + std::cos(b) * p[2];
      corner[i] = vertex(middle[0] + x, middle[1] + y, middle[2] + z);
    }
    // Depth grows away from the viewer, so that the outside shows where a face runs clockwise on the screen.
    static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                                         {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    for (const auto& face : kFaces)
      frame_.polygons.push_back({corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]]});
  }

  void sheet(int cells) {
    const double tilt_x = uniform(-0.4, 0.4), tilt_y = uniform(-0.4, 0.4), wave = uniform(4, 30), turns = uniform(4, 9);
    const double skew = uniform(-0.15, 0.15) * size_;
    std::vector<std::uint32_t> ids;
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
        const double x = size_ * (0.12 + 0.76 * u) + skew * (v - 0.5), y = size_ * (0.12 + 0.76 * v) + skew * (0.5 - u);
        ids.push_back(vertex(x, y, 500 + tilt_x * x + tilt_y * y + wave * std::sin(turns * u) * std::cos(turns * v)));
      }
    }
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const auto* at = &ids[static_cast<std::size_t>(j * (cells + 1) + i)];
        frame_.polygons.push_back({at[0], at[cells + 1], at[cells + 2]});
        frame_.polygons.push_back({at[0], at[cells + 2], at[1]});
      }
    }
  }

  void star() {
    const int points = 3 + static_cast<int>(random_() % 6);
    const double x = uniform(0.25, 0.75) * size_, y = uniform(0.25, 0.75) * size_, z = uniform(100, 600);
    const double outer = uniform(0.1, 0.3) * size_, inner = outer * uniform(0.25, 0.7), turn = uniform(0, 6.28);
    const double slant_x = uniform(-1, 1), slant_y = uniform(-1, 1);
    std::vector<std::uint32_t> corners;
    for (int i = 0; i < 2 * points; ++i) {
      const double radius = i % 2 ? inner : outer, angle = turn + std::numbers::pi * i / points;
      const double dx = radius * std::cos(angle), dy = radius * std::sin(angle);
      corners.push_back(vertex(x + dx, y + dy, z + slant_x * dx + slant_y * dy));
    }
    frame_.polygons.push_back(corners);
  }

  scanline::Frame take() { return std::move(frame_); }

 private:
  std::mt19937_64 random_;
  int size_;
  scanline::Frame frame_;
};

}  // namespace

scanline::Frame random_frame(FrameKind kind, std::uint64_t seed, int size, int polygons) {
  Maker maker(seed, size);
  switch (kind) {
    case FrameKind::kTriangles:
      for (int i = 0; i < polygons; ++i) maker.triangle();
      break;
    case FrameKind::kBoxes:
      for (int i = 0; i < polygons; i += 6) maker.box();
      break;
    case FrameKind::kSheets:
      for (int i = 0; i < 2; ++i) maker.sheet(std::max(2, static_cast<int>(std::sqrt(polygons / 4))));
      break;
    case FrameKind::kStars:
      for (int i = 0; i < polygons; ++i) maker.star();
      break;
  }
  return maker.take();
}

}  // namespace truth
