// Positions that the array rebuilds from depth and place, against exact ones of the same depth.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "pixelflow/shading/region_programs.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pixelflow_model/seed.h"

namespace region_tests {
namespace {

using pfman::EyeSpace;
using pfman::kFarthest;
using pfman_tests::all_levels;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

using Position = std::array<double, 3>;

struct Pixels {
  std::vector<std::uint8_t> columns, rows;
  std::vector<std::uint32_t> depth;
};

std::vector<Position> positions(pixelflow::PixelArray& array, const EyeSpace& eye, int first_column, int first_row,
                                const Pixels& pixels) {
  array.cover(static_cast<int>(pixels.depth.size()));
  array.place(pixels.columns, pixels.rows);
  std::vector<std::uint8_t> row(pixels.depth.size());
  for (int byte = 0; byte < 4; ++byte) {
    for (std::size_t n = 0; n < row.size(); ++n) row[n] = static_cast<std::uint8_t>(pixels.depth[n] >> 8 * byte);
    array.write(pfman::kDepthAt + byte, row);
  }
  array.run(pfman::pre_shade(eye, first_column, first_row));
  std::vector<Position> result(row.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::uint32_t> bits(row.size());
    for (int byte = 0; byte < 4; ++byte) {
      array.read(pfman::kPositionAt + static_cast<int>(4 * axis) + byte, row);
      for (std::size_t n = 0; n < row.size(); ++n) bits[n] |= static_cast<std::uint32_t>(row[n]) << 8 * byte;
    }
    for (std::size_t n = 0; n < row.size(); ++n) result[n][axis] = std::bit_cast<float>(bits[n]);
  }
  return result;
}

/// In long doubles: in the near plane at depth 0, in the far plane at kFarthest, 1 / distance linear between them.
Position exact(const EyeSpace& eye, int column, int row, std::uint32_t depth) {
  const long double part = static_cast<long double>(depth) / kFarthest;
  const long double x = eye.x0 + static_cast<long double>(eye.dx) * column;
  const long double y = eye.y0 + static_cast<long double>(eye.dy) * row;
  if (!eye.perspective) {
    return {static_cast<double>(x), static_cast<double>(y),
            static_cast<double>(-(eye.near + part * (static_cast<long double>(eye.far) - eye.near)))};
  }
  const long double inverse = (1 - part) / eye.near + part / eye.far;
  return {static_cast<double>(x / inverse), static_cast<double>(y / inverse), static_cast<double>(-1 / inverse)};
}

double length(const Position& p) { return std::hypot(p[0], p[1], p[2]); }
double distance(const Position& a, const Position& b) { return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

/// A view of so many samples and of a height of `tangent` at distance 1, or in all.
EyeSpace view(bool perspective, double near, double far, int width, int height, double tangent) {
  const double step = tangent / height;
  return {perspective, near, far, -(width - 1) * step / 2, step, (height - 1) * step / 2, -step};
}

/// Depths of every magnitude, from both ends.
Pixels random_pixels(std::mt19937_64& random, int count) {
  Pixels pixels;
  for (int n = 0; n < count; ++n) {
    pixels.columns.push_back(static_cast<std::uint8_t>(random() % pixelflow::kRegionWidth));
    pixels.rows.push_back(static_cast<std::uint8_t>(random() % pixelflow::kRegionHeight));
    const std::uint32_t depth = static_cast<std::uint32_t>(random()) >> random() % 32;
    pixels.depth.push_back(random() % 2 ? depth : kFarthest - depth);
  }
  pixels.depth[0] = 0;
  pixels.depth[1] = kFarthest;
  return pixels;
}

TEST(PreShade, RebuildsPositionsOfPerspectiveViews) {
  constexpr int kPixels = 2048, kWidth = 1280, kHeight = 1024;
  const std::uint64_t seed = seed_or(73);
  std::mt19937_64 random(seed);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kPixels);
  double worst = 0;
  for (const double near : {1e-3, 0.1, 1.0, 1e3}) {
    for (const double ratio : {1.001, 2.0, 1e2, 1e3, 1e6, 1e9}) {
      for (const double tangent : {0.02, 1.0, 20.0, 400.0}) {
        const EyeSpace eye = view(true, near, near * ratio, kWidth, kHeight, tangent);
        const int first_column = 128 * static_cast<int>(random() % 10),
                  first_row = 64 * static_cast<int>(random() % 16);
        const Pixels pixels = random_pixels(random, kPixels);
        const std::vector<Position> found = positions(*array, eye, first_column, first_row, pixels);
        for (std::size_t n = 0; n < found.size(); ++n) {
          const Position at = exact(eye, first_column + pixels.columns[n], first_row + pixels.rows[n], pixels.depth[n]);
          const double error = distance(found[n], at) / length(at);
          ASSERT_LT(error, pfman::kPositionError)
              << replay(seed) << ", near " << near << ", ratio " << ratio << ", depth " << pixels.depth[n];
          worst = std::max(worst, error);
        }
      }
    }
  }
  RecordProperty("largest_relative_error", std::to_string(worst * 1e9) + "e-9");
}

TEST(PreShade, RebuildsPositionsOfOrthographicViews) {
  constexpr int kPixels = 2048;
  const std::uint64_t seed = seed_or(74);
  std::mt19937_64 random(seed);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kPixels);
  for (const double near : {-50.0, 0.0, 0.1, 1e3}) {
    for (const double depth : {1e-3, 1.0, 1e6}) {
      for (const double height : {1e-3, 10.0, 1e5}) {
        const EyeSpace eye = view(false, near, near + depth, 640, 480, height);
        const Pixels pixels = random_pixels(random, kPixels);
        const std::vector<Position> found = positions(*array, eye, 512, 384, pixels);
        const double largest = length({height * 640 / 480 / 2, height / 2, std::max(std::abs(near), near + depth)});
        for (std::size_t n = 0; n < found.size(); ++n) {
          const Position at = exact(eye, 512 + pixels.columns[n], 384 + pixels.rows[n], pixels.depth[n]);
          ASSERT_LT(distance(found[n], at), pfman::kPositionError * largest)
              << replay(seed) << ", near " << near << ", depth " << depth << ", height " << height;
        }
      }
    }
  }
}

TEST(PreShade, HasTheSameBitsAtAllLevels) {
  const std::uint64_t seed = seed_or(75);
  std::mt19937_64 random(seed);
  const Pixels pixels = random_pixels(random, 2 * pixelflow::kElements);
  for (const bool perspective : {true, false}) {
    const EyeSpace eye = view(perspective, 0.3, 700, 300, 200, 0.8);
    std::vector<std::vector<Position>> found;
    std::vector<std::uint64_t> cycles;
    for (const auto& level : all_levels(2 * pixelflow::kElements)) {
      found.push_back(positions(*level.array, eye, 128, 64, pixels));
      cycles.push_back(level.array->counters().cycles);
      EXPECT_EQ(found.back(), found.front()) << replay(seed) << ", " << level.name;
      EXPECT_EQ(cycles.back(), cycles.front()) << level.name;
    }
  }
}

/// Views that no sensible camera has.
TEST(PreShade, StaysWithinTheWordForNumbersOfEverySize) {
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, 2);
  const Pixels pixels{{0, 127}, {0, 63}, {0, kFarthest - 1}};
  for (const double size : {0.0, 1e-30, 1e-12, 1e12, 1e30}) {
    for (const Position& p : positions(*array, {true, 1e-30, 1e30, size, size, -size, -size}, 0, 0, pixels)) {
      EXPECT_TRUE(std::isfinite(p[2])) << size;
      EXPECT_FALSE(std::isnan(p[0]) || std::isnan(p[1])) << size;
    }
  }
}

}  // namespace
}  // namespace region_tests
