// Texture memory: levels of detail, filters, and what fits.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/pixelflow_model/seed.h"
#include "tests/textures/oracle.h"

namespace texture_tests {
namespace {

using pfman::TextureMemory;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

Image random_image(std::mt19937_64& random, int width, int height) {
  Image image{width, height, {}};
  for (int n = 0; n < width * height * 4; ++n) image.rgba.push_back(static_cast<std::uint8_t>(random()));
  return image;
}

/// Levels that have nothing to do with each other, so that the wrong one shows.
std::vector<Image> random_levels(std::mt19937_64& random, int width, int height, bool up, int most) {
  std::vector<Image> levels = {random_image(random, width, height)};
  while (static_cast<int>(levels.size()) < most && (width > 1 || height > 1)) {
    width = std::max(1, (width + up) / 2);
    height = std::max(1, (height + up) / 2);
    levels.push_back(random_image(random, width, height));
  }
  return levels;
}

/// A plane of coordinates over a patch of the region, at a scale of its own, with holes.
std::vector<Sample> random_samples(std::mt19937_64& random, double largest_step) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double scale = std::exp2(5 * uniform(random)) * largest_step / 32;
  const double a = scale * uniform(random), b = scale * uniform(random), c = scale * uniform(random),
               d = scale * uniform(random), s = 4 * uniform(random), t = 4 * uniform(random);
  const auto left = static_cast<int>(random() % 100), top = static_cast<int>(random() % 50);
  const auto holes = random() % 3;
  std::vector<Sample> samples;
  for (int row = top; row < top + 7; ++row) {
    for (int column = left; column < left + 9; ++column) {
      if (random() % 4 < holes) continue;
      samples.push_back({static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row),
                         static_cast<float>(s + a * column + b * row + 0.1 * scale * uniform(random)),
                         static_cast<float>(t + c * column + d * row + 0.1 * scale * uniform(random))});
    }
  }
  std::shuffle(samples.begin(), samples.end(), random);
  return samples;
}

TEST(TextureMemory, ChoosesLevelsByDifferencesWithinQuads) {
  const std::uint64_t seed = seed_or(91);
  std::mt19937_64 random(seed);
  int moved = 0, all = 0;
  for (const auto& [width, height, most] :
       {std::array{32, 32, 9}, {64, 8, 9}, {1, 16, 9}, {13, 7, 9}, {16, 16, 3}, {5, 3, 1}, {1, 1, 1}}) {
    for (int round = 0; round < 12; ++round) {
      const std::vector<Image> levels = random_levels(random, width, height, round % 2 == 1, most);
      TextureMemory memory;
      memory.set(3, levels);
      std::vector<Sample> samples = random_samples(random, round < 6 ? 0.1 : 2);
      ASSERT_EQ(wrong_texels(levels, samples, memory.lookup(3, samples)), 0)
          << width << " x " << height << ", " << replay(seed);
      // A mistake that the oracle has to see: quads that begin in odd columns.
      std::vector<Sample> beside = samples;
      for (Sample& sample : beside) ++sample.column;
      moved += wrong_texels(levels, samples, memory.lookup(3, beside));
      all += static_cast<int>(samples.size());
    }
  }
  EXPECT_GT(moved, all / 20);
}

TEST(TextureMemory, MixesTwoLevels) {
  TextureMemory memory;
  const Image fine{4, 4, std::vector<std::uint8_t>(64, 100)}, middle{2, 2, std::vector<std::uint8_t>(16, 200)},
      coarse{1, 1, std::vector<std::uint8_t>(4, 40)};
  memory.set(1, {fine, middle, coarse});
  const auto of_step = [&](float texels) {
    const std::vector<Sample> samples = {{0, 0, 0, 0}, {1, 0, texels / 4, 0}};
    const std::vector<Texel> found = memory.lookup(1, samples);
    EXPECT_EQ(found[0], found[1]);
    return static_cast<int>(found[0][0]);
  };
  EXPECT_EQ(of_step(0), 100);
  EXPECT_EQ(of_step(1), 100);
  EXPECT_EQ(of_step(-1.5f), 150);
  EXPECT_EQ(of_step(2), 200);
  EXPECT_EQ(of_step(2.5f), 160);
  EXPECT_EQ(of_step(3), 120);
  EXPECT_EQ(of_step(4), 40);
  EXPECT_EQ(of_step(-4000), 40);
}

TEST(TextureMemory, TakesWhatNeighboursThereAre) {
  TextureMemory memory;
  std::vector<Image> levels;
  for (int size = 16, grey = 10; size >= 1; size /= 2, grey += 50) {
    levels.push_back(
        {size, size,
         std::vector<std::uint8_t>(static_cast<std::size_t>(4 * size * size), static_cast<std::uint8_t>(grey))});
  }
  memory.set(1, levels);
  const auto first = [&](const std::vector<Sample>& samples) {
    return static_cast<int>(memory.lookup(1, samples)[0][0]);
  };
  const float two = 2.0f / 16, four = 4.0f / 16, nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(first({{4, 4, 0, 0}}), 10) << "alone";
  EXPECT_EQ(first({{4, 4, 0, 0}, {3, 4, four, 0}, {4, 3, four, 0}}), 10) << "of other quads";
  EXPECT_EQ(first({{4, 4, 0, 0}, {5, 4, two, 0}}), 60);
  EXPECT_EQ(first({{4, 4, 0, 0}, {5, 4, two, 0}, {4, 5, 0, four}}), 110) << "the longer one";
  EXPECT_EQ(first({{4, 4, 0, 0}, {4, 5, 0, two}, {5, 5, four, two}}), 110) << "the other row's difference";
  EXPECT_EQ(first({{4, 4, 0, 0}, {5, 5, four, four}}), 10) << "no difference along a row or column";
  EXPECT_EQ(first({{4, 4, nan, 0}, {5, 4, two, 0}}), 10);
  EXPECT_EQ(first({{4, 4, 0, 0}, {5, 4, std::numeric_limits<float>::infinity(), 0}, {4, 5, two, 0}}), 60);
  EXPECT_EQ(first({{4, 4, -3e38f, 3e38f}, {5, 4, 3e38f, -3e38f}}), 210);
  EXPECT_EQ(first({{254, 254, 0, 0}, {255, 254, two, 0}}), 60);
  EXPECT_TRUE(memory.lookup(1, std::vector<Sample>{}).empty());
}

TEST(TextureMemory, HasRoomForSoMuch) {
  TextureMemory memory;
  const auto image = [](int width, int height) {
    return Image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 4)};
  };
  memory.set(1, image(4096, 2048));
  memory.set(2, image(2048, 2048));
  EXPECT_EQ(memory.bytes(), 3u << 24);
  EXPECT_THROW(memory.set(3, image(2048, 2049)), std::invalid_argument);
  EXPECT_EQ(memory.bytes(), 3u << 24) << "what does not fit leaves all as it was";
  memory.set(1, image(1, 1));
  memory.set(3, image(2048, 2049));
  EXPECT_EQ(memory.bytes(), (std::size_t{2048} * (2048 + 2049) + 1) * 4);
  memory.set(3, {image(4, 3), image(2, 1), image(1, 1)});
  EXPECT_EQ(memory.bytes(), (std::size_t{2048} * 2048 + 1 + 12 + 2 + 1) * 4);
}

TEST(TextureMemory, RefusesWhatIsNoImage) {
  TextureMemory memory;
  const Image right{4, 4, std::vector<std::uint8_t>(64)}, half{2, 2, std::vector<std::uint8_t>(16)};
  EXPECT_THROW(memory.set(1, std::vector<Image>{}), std::invalid_argument);
  EXPECT_THROW(memory.set(1, Image{4, 4, std::vector<std::uint8_t>(63)}), std::invalid_argument);
  EXPECT_THROW(memory.set(1, Image{0, 4, {}}), std::invalid_argument);
  EXPECT_THROW(memory.set(1, Image{-2, -2, std::vector<std::uint8_t>(16)}), std::invalid_argument);
  EXPECT_THROW(memory.set(1, {right, right}), std::invalid_argument);
  EXPECT_THROW(memory.set(1, {half, right}), std::invalid_argument);
  EXPECT_EQ(memory.bytes(), 0u);
  memory.set(1, {right, half});
  EXPECT_EQ(memory.bytes(), 80u);
}

}  // namespace
}  // namespace texture_tests
