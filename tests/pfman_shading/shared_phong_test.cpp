// Surfaces of the flag shared_phong: one illum stream for all of them, the same bits as each its own, fewer cycles.
#include <gtest/gtest.h>

#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pfman::Instance;
using pfman::ShadingNode;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;

constexpr char kShaders[] = R"(
surface red(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_material_normal[3],
    varying unit float px_shader_view[3],
    uniform float shine = 8)
{
#pragma pfman shared_phong
    px_magic_kd = { 0.8, 0.2, 0.1 };
    px_magic_ks = { 0.5, 0.5, 0.5 };
    px_magic_exp = shine;
    px_shader_color = px_magic_diffuse + px_magic_highlight;
}
surface spots(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_material_normal[3],
    varying float px_shader_texcoord[2],
    varying unit float px_shader_view[3])
{
#pragma pfman shared_phong
    float u = px_shader_texcoord[0] % 0.25;
    px_magic_kd = { u, 0.5, 2 * u };
    if (u < 0.1) px_magic_kd = { 0.9, 0.9, 0.2 };
    px_magic_ks = { u, u, u };
    px_magic_exp = 4 + u;
    float keep = px_shader_texcoord[1];
    fixed<8,8> lit[3] = px_magic_diffuse;
    px_shader_color = lit * 0.5 + 0.5 * px_magic_highlight * keep;
}
surface dull(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_material_normal[3],
    varying unit float px_shader_view[3])
{
#pragma pfman shared_phong
    px_magic_kd = { 0.4, 0.4, 0.4 };
    px_magic_ks = { 0, 0, 0 };
    px_magic_exp = 1;
    px_shader_color = px_magic_diffuse;
}
light lamp(uniform signed fixed<16,14> direction[3] = { 0, 0, -1 }) {
    solar (direction, 0) { px_light_color = { 0.9, 0.7, 0.5 }; }
}
light greedy() {
    float a[30];
    uniform int i;
    for (i = 0; i < 30; i++) a[i] = px_light_color[0];
    solar ({ 0, 0, -1 }, 0) { for (i = 0; i < 30; i++) px_light_color[0] = a[i]; }
}
)";

class SharedPhongs : public testing::Test {
 protected:
  Instance surface(const std::string& name, int id) const { return Instance(*unit_->find(name), id); }
  Instance lamp(int id, const std::vector<double>& direction) const {
    Instance light(*unit_->find("lamp"), id);
    light.set("direction", direction);
    return light;
  }
  std::vector<Instance> lamps() const { return {lamp(1, {0, 0, -1}), lamp(2, {0.6, 0.48, -0.64})}; }

  Region region(std::mt19937_64& random, const std::vector<std::pair<int, std::string>>& surfaces) const {
    Region result(kLanes);
    result.fill(random);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (int n = 0; n < 3; ++n) {
        result.put_float(lane, pfman::kPositionAt + 4 * n, uniform(random) - (n == 2 ? 3.0f : 0.0f));
      }
      const std::size_t chosen = random() % (surfaces.size() + 1);
      result.put_id(lane, chosen < surfaces.size() ? surfaces[chosen].first : 0);
      if (chosen == surfaces.size()) continue;
      for (const auto& entry : pfman::transfer_map(*unit_->find(surfaces[chosen].second)).entries) {
        for (int n = 0; n < entry.type.count(); ++n) result.put_float(lane, entry.address + 4 * n, uniform(random));
      }
    }
    return result;
  }

  std::unique_ptr<pfman::CompiledUnit> unit_ = compiled(kShaders);
};

TEST_F(SharedPhongs, GiveTheSameBitsInFewerCycles) {
  const std::uint64_t seed = seed_or(71);
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    ShadingNode together({surface("red", 1), surface("spots", 2)}, lamps(), nullptr);
    ShadingNode red({surface("red", 1)}, lamps(), nullptr), spots({surface("spots", 2)}, lamps(), nullptr);
    for (int round = 0; round < 3; ++round) {
      const Region before = region(random, {{1, "red"}, {2, "spots"}});
      const Region all = shaded(together, before, *level.array);
      const Region one = shaded(red, before, *level.array), two = shaded(spots, before, *level.array);
      int lit = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto id = before.get(lane, 0, 2);
        for (int c = 0; c < 3 && id != 0; ++c) {
          const int expected = (id == 1 ? one : two).colour(lane, c);
          ASSERT_EQ(all.colour(lane, c), expected) << replay(seed) << ", " << level.name << ", lane " << lane;
          lit += expected > 0;
        }
      }
      EXPECT_GT(lit, kLanes / 4);
    }
    EXPECT_EQ(together.shared(), 6);
    EXPECT_EQ(red.shared() + spots.shared(), 0) << "alone there is nobody to share with";
    const auto total = [](const ShadingNode& node) {
      return node.cycles().pre + node.cycles().illum + node.cycles().post;
    };
    EXPECT_LT(together.cycles().illum, red.cycles().illum * 11 / 10);
    EXPECT_LT(total(together), total(red) + total(spots) - red.cycles().illum * 9 / 10);
  }
}

TEST_F(SharedPhongs, AreLeftAloneWhereMemoryDoesNotSuffice) {
  std::mt19937_64 random(seed_or(72));
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  ShadingNode node({surface("red", 1), surface("spots", 2)}, {lamp(1, {0, 0, -1}), Instance(*unit_->find("greedy"), 2)},
                   nullptr);
  shaded(node, region(random, {{1, "red"}, {2, "spots"}}), *array);
  EXPECT_EQ(node.executions(), 2);
  EXPECT_EQ(node.shared(), 0);
}

/// One that does not use both results has a shorter stream of its own.
TEST_F(SharedPhongs, ServeThoseThatUseAllOfIt) {
  const std::uint64_t seed = seed_or(73);
  std::mt19937_64 random(seed);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  const std::vector<std::pair<int, std::string>> surfaces = {{5, "red"}, {6, "dull"}, {7, "spots"}, {8, "red"}};
  Instance other = surface("red", 8);
  other.set("shine", {3});
  ShadingNode node({surface("red", 5), surface("dull", 6), surface("spots", 7), other}, lamps(), nullptr);
  ShadingNode alone({surface("dull", 6)}, lamps(), nullptr), last({other}, lamps(), nullptr);
  const Region before = region(random, surfaces);
  const Region all = shaded(node, before, *array);
  const Region dull = shaded(alone, before, *array), red = shaded(last, before, *array);
  EXPECT_EQ(node.executions(), 4);
  EXPECT_EQ(node.shared(), 3);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto id = before.get(lane, 0, 2);
    for (int c = 0; c < 3; ++c) {
      if (id == 6) {
        ASSERT_EQ(all.colour(lane, c), dull.colour(lane, c)) << replay(seed);
      } else if (id == 8) {
        ASSERT_EQ(all.colour(lane, c), red.colour(lane, c)) << replay(seed);
      }
    }
  }
}

}  // namespace
}  // namespace pfman_tests
