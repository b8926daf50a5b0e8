// Texture lookups: pixels send coordinates, the host answers, the stream goes on.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pfman::Instance;
using pfman::ShadingNode;
using pfman::TextureMemory;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;
constexpr int kTexcoordAt = pfman::kParametersAt;

TextureMemory random_textures(std::mt19937_64& random) {
  TextureMemory textures;
  for (const auto& [number, width, height] : {std::array{1, 5, 3}, {2, 1, 1}, {7, 16, 8}}) {
    TextureMemory::Image texture{width, height, {}};
    for (int n = 0; n < width * height * 4; ++n) texture.rgba.push_back(static_cast<std::uint8_t>(random()));
    textures.set(number, std::move(texture));
  }
  return textures;
}

constexpr char kShaders[] = R"(
surface one(
    output varying fixed<8,8> px_shader_color[3],
    varying float px_shader_texcoord[3],
    uniform int id = 1)
{
    fixed<8,8> c[3] = { 0.5, 0.5, 0.5 };
    if (px_shader_texcoord[0] < 0.25) {
        fixed<8,8> seen[3] = texture(id, px_shader_texcoord[1], px_shader_texcoord[0]);
        if (seen[1] > 0.5) c = seen;
        else {
            fixed<8,8> all[4] = texture4(id + 6, px_shader_texcoord[0], px_shader_texcoord[1]);
            c = { all[3], all[0], all[1] };
        }
    }
    px_shader_color = c;
}
surface mirror(
    output varying fixed<8,8> px_shader_color[3],
    varying float px_shader_texcoord[3])
{
    fixed<8,8> sum[3] = { 0, 0, 0 };
    illuminance () { sum = environment(7, px_shader_texcoord); }
    px_shader_color = sum;
}
light lamp() { solar ({ 0, 0, -1 }, 0) { px_light_color = { 1, 1, 1 }; } }
)";

std::array<int, 3> expected_colour(int id, const std::array<float, 3>& p, const TextureMemory& textures) {
  if (id == 2) {
    const auto seen = textures.environment(7, p);
    return {seen[0], seen[1], seen[2]};
  }
  if (!(p[0] < 0.25f)) return {128, 128, 128};
  const auto seen = textures.lookup(1, p[1], p[0]);
  if (seen[1] > 128) return {seen[0], seen[1], seen[2]};
  const auto all = textures.lookup(7, p[0], p[1]);
  return {all[3], all[0], all[1]};
}

TEST(Lookups, AnswerEnabledPixels) {
  const std::uint64_t seed = seed_or(41);
  const auto unit = compiled(kShaders);
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    const TextureMemory textures = random_textures(random);
    std::uniform_real_distribution<float> uniform(-2, 2);
    ShadingNode node({Instance(*unit->find("one"), 1), Instance(*unit->find("mirror"), 2)},
                     {Instance(*unit->find("lamp"), 1), Instance(*unit->find("lamp"), 2)}, &textures);
    for (int round = 0; round < 3; ++round) {
      Region before(kLanes);
      before.fill(random);
      std::vector<std::array<float, 3>> points(kLanes);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        before.put_id(lane, static_cast<int>(random() % 3));
        for (int n = 0; n < 3; ++n) {
          points[lane][static_cast<std::size_t>(n)] = uniform(random);
          before.put_float(lane, kTexcoordAt + 4 * n, points[lane][static_cast<std::size_t>(n)]);
        }
      }
      const Region after = shaded(node, before, *level.array);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const int id = static_cast<int>(before.get(lane, 0, 2));
        if (id == 0) continue;
        const auto expected = expected_colour(id, points[lane], textures);
        for (int c = 0; c < 3; ++c) {
          ASSERT_EQ(after.colour(lane, c), expected[static_cast<std::size_t>(c)])
              << replay(seed) << ", " << level.name << ", lane " << lane << ", shader " << id;
        }
      }
    }
    EXPECT_EQ(node.cycles().lookups, 3u * 4u) << "two in the first surface, one for each light in the second";
  }
}

TEST(Textures, AreBilinearAndRepeat) {
  TextureMemory textures;
  textures.set(5, {2, 1, {0, 0, 0, 255, 200, 100, 40, 255}});
  using Texel = std::array<std::uint8_t, 4>;
  EXPECT_EQ(textures.lookup(5, 0.25f, 0.5f), (Texel{0, 0, 0, 255}));
  EXPECT_EQ(textures.lookup(5, 0.75f, 0.1f), (Texel{200, 100, 40, 255}));
  EXPECT_EQ(textures.lookup(5, 0.5f, 0.5f), (Texel{100, 50, 20, 255}));
  EXPECT_EQ(textures.lookup(5, 0.0f, 0.5f), (Texel{100, 50, 20, 255}));
  EXPECT_EQ(textures.lookup(5, 0.375f, 0.5f), (Texel{50, 25, 10, 255}));
  EXPECT_EQ(textures.lookup(5, -3.625f, 7.0f), (Texel{50, 25, 10, 255}));
  EXPECT_EQ(textures.lookup(5, 0.3125f, 0.5f), (Texel{25, 13, 5, 255})) << "12.5 is rounded up";
  EXPECT_EQ(textures.lookup(6, 0.5f, 0.5f), (Texel{255, 255, 255, 255}));
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(textures.lookup(5, nan, infinity), textures.lookup(5, 0, 0));
  EXPECT_EQ(textures.lookup(5, 3e38f, -1e-45f), textures.lookup(5, 0, 0));
  EXPECT_THROW(textures.set(5, {2, 1, {0, 0, 0}}), std::invalid_argument);
}

TEST(Textures, MapDirectionsToASphere) {
  TextureMemory textures;
  TextureMemory::Image texture{64, 64, {}};
  for (int n = 0; n < 64 * 64; ++n) {
    const auto column = static_cast<std::uint8_t>(n % 64 * 4), row = static_cast<std::uint8_t>(n / 64 * 4);
    texture.rgba.insert(texture.rgba.end(), {column, row, 0, 255});
  }
  textures.set(1, std::move(texture));
  // Towards the eye: the image's middle; to a side: 1 / (2 sqrt 2) from it.
  EXPECT_EQ(textures.environment(1, {0, 0, 2}), textures.lookup(1, 0.5f, 0.5f));
  EXPECT_EQ(textures.environment(1, {3, 0, 0}), textures.lookup(1, 0.853553f, 0.5f));
  EXPECT_EQ(textures.environment(1, {0, -0.5f, 0}), textures.lookup(1, 0.5f, 0.146447f));
  EXPECT_EQ(textures.environment(1, {0, 0, -1}), textures.lookup(1, 0.5f, 0));
  EXPECT_EQ(textures.environment(1, {0, 0, 0}), textures.lookup(1, 0.5f, 0.5f));
}

}  // namespace
}  // namespace pfman_tests
