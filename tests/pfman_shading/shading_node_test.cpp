// The shading node: surfaces and lights over one region, each pixel with what belongs to it alone.
#include <gtest/gtest.h>

#include <cmath>

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
surface stripes(
    output varying fixed<8,8> px_shader_color[3],
    varying fixed<16,8> width_here = 0,
    varying signed fixed<16,14> px_material_normal[3],
    uniform fixed<8,8> base = 0.25,
    uniform int steps = 3)
{
    fixed<16,8> a = width_here;
    uniform int i;
    for (i = 0; i < steps; i++) {
        if (a > 100) break;
        if (a < 10) a = a + 40; else a = a * 2;
    }
    fixed<16,12> sum[3] = { base, base, base };
    illuminance () {
        signed fixed<16,14> facing = dot(px_material_normal, px_light_direction);
        if (facing > 0)
            sum += facing * px_light_color;
    }
    fixed<8,8> shade = a / 256;
    px_shader_color = sat fixed<8,8>(sum * shade);
}
surface plain(
    output varying fixed<8,8> px_shader_color[3],
    varying fixed<8,8> px_material_diffuse[3])
{
    px_shader_color = px_material_diffuse;
}
surface counting(
    output varying fixed<8,8> px_shader_color[3],
    varying fixed<8,0> own = 0)
{
    uniform int lamp_number = 0;
    fixed<8,8> sum[3] = { 0, 0, 0 };
    illuminance () {
        if (own != 0) sum[lamp_number] = 0.25;
        lamp_number++;
    }
    px_shader_color = sum;
}
light lamp(
    uniform signed fixed<16,14> direction[3] = { 0, 0, -1 },
    uniform float rgb[3] = { 1, 0.5, 0.25 })
{
    solar (direction, 0.0) { px_light_color = rgb; }
}
light glow() {
    solar ({ 0, 0, -1 }, 0.0) {
        // some memory of its own
        float p = px_light_ray[2];
        uniform int i;
        for (i = 0; i < 3; i++) p = p * 0.5;
        px_light_color = { -p, 0.0, 0.0 };
    }
}
)";

class ShadingNodes : public testing::Test {
 protected:
  const pfman::CompiledShader& shader(const std::string& name) const { return *unit_->find(name); }

  Instance stripes(int id, double base, double steps) const {
    Instance instance(shader("stripes"), id);
    instance.make_ordinary("width_here");
    instance.set("base", {base});
    instance.set("steps", {steps});
    return instance;
  }
  Instance plain(int id) const { return Instance(shader("plain"), id); }
  Instance lamp(int id, const std::vector<double>& direction) const {
    Instance instance(shader("lamp"), id);
    instance.set("direction", direction);
    return instance;
  }

  /// Random parameters; pixels of the given shaders in random order, background among them.
  Region region(std::mt19937_64& random, const std::vector<int>& ids) const {
    Region result(kLanes);
    result.fill(random);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t chosen = random() % (ids.size() + 1);
      result.put_id(lane, chosen < ids.size() ? ids[chosen] : 0);
    }
    return result;
  }

  std::unique_ptr<pfman::CompiledUnit> unit_ = compiled(kShaders);
};

/// What stripes computes, in the language's arithmetic on integers. `lights`: directions to them, as the communication
/// area has them: normalised, floored.
int stripes_colour(const Region& before, std::size_t lane, int base, int steps,
                   const std::vector<std::array<int, 3>>& lights, int component) {
  const int rgb[3] = {4096, 2048, 1024};
  int a = static_cast<int>(before.get(lane, 2, 2));
  for (int i = 0; i < steps && a <= 100 * 256; ++i) a = (a < 10 * 256 ? a + 40 * 256 : a * 2) & 0xFFFF;
  int sum = base << 4;
  for (const auto& direction : lights) {
    std::int64_t facing = 0;
    for (int n = 0; n < 3; ++n) {
      facing += static_cast<std::int64_t>(static_cast<std::int16_t>(before.get(lane, 4 + 2 * n, 2))) *
                direction[static_cast<std::size_t>(n)];
    }
    facing = static_cast<std::int16_t>(facing >> 14);
    if (facing > 0)
      sum = static_cast<int>((((static_cast<std::int64_t>(sum) << 4) + (facing * rgb[component] >> 10)) >> 4) & 0xFFFF);
  }
  const int shade = a >> 8;
  return std::min(255, static_cast<int>(static_cast<std::int64_t>(sum) * shade >> 12));
}

TEST_F(ShadingNodes, GiveEachPixelItsShader) {
  const std::uint64_t seed = seed_or(11);
  std::mt19937_64 random(seed);
  const std::vector<std::array<int, 3>> directions = {{0, 0, 16384}, {-9831, 0, 13107}};
  for (const LevelArray& level : all_levels()) {
    ShadingNode node({stripes(3, 0.25, 3), plain(0x203), stripes(2, 0.5, 5)},
                     {lamp(1, {0, 0, -1}), lamp(2, {0.6, 0, -0.8})}, nullptr);
    for (int repeat = 0; repeat < 4; ++repeat) {
      const Region before = region(random, {3, 0x203, 2});
      const Region after = shaded(node, before, *level.array);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto id = before.get(lane, pfman::kShaderIdAt, 2);
        ASSERT_EQ(after.get(lane, pfman::kMaskAt, 1), 0u);
        for (int c = 0; c < 3; ++c) {
          int expected = after.colour(lane, c);
          if (id == 0x203) expected = static_cast<int>(before.get(lane, 2 + c, 1));
          if (id == 3) expected = stripes_colour(before, lane, 64, 3, directions, c);
          if (id == 2) expected = stripes_colour(before, lane, 128, 5, directions, c);
          ASSERT_EQ(after.colour(lane, c), expected)
              << replay(seed) << ", " << level.name << ", lane " << lane << ", shader " << id << ", component " << c;
        }
      }
    }
    EXPECT_EQ(node.executions(), 12);
  }
}

TEST_F(ShadingNodes, LeaveTheSameEverywhereAtAllLevels) {
  const std::uint64_t seed = seed_or(12);
  std::mt19937_64 random(seed);
  const Region before = region(random, {3, 4, 2});
  std::unique_ptr<Region> first;
  std::uint64_t cycles = 0;
  for (const LevelArray& level : all_levels()) {
    ShadingNode node({stripes(3, 0.25, 3), plain(4), Instance(shader("counting"), 2)},
                     {lamp(1, {0, 0, -1}), Instance(shader("glow"), 2)}, nullptr);
    const Region after = shaded(node, before, *level.array);
    const auto& c = node.cycles();
    EXPECT_EQ(c.pre + c.illum + c.post + c.lights, level.array->counters().cycles) << level.name;
    if (!first) {
      first = std::make_unique<Region>(after);
      cycles = level.array->counters().cycles;
      continue;
    }
    EXPECT_EQ(level.array->counters().cycles, cycles) << level.name;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (int n = 0; n < 3; ++n)
        ASSERT_EQ(after.colour(lane, n), first->colour(lane, n)) << replay(seed) << level.name;
    }
  }
}

TEST_F(ShadingNodes, KeepUniformValuesFromLightToLight) {
  for (const LevelArray& level : all_levels()) {
    ShadingNode node({Instance(shader("counting"), 1)},
                     {Instance(shader("glow"), 3), Instance(shader("glow"), 1), Instance(shader("glow"), 2)}, nullptr);
    node.surface(0).make_ordinary("own");
    Region before(kLanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      before.put_id(lane, 1);
      before.put(lane, 2, 1, lane & 1);
    }
    const Region after = shaded(node, before, *level.array);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(after.colour(lane, c), lane & 1 ? 64 : 0) << level.name;
    }
  }
}

TEST_F(ShadingNodes, RunLightsInTheOrderOfTheirIds) {
  const auto unit = compiled(R"(
surface last(output varying fixed<8,8> px_shader_color[3]) {
    px_shader_color = { 0, 0, 0 };
    illuminance () { px_shader_color = px_shader_color / 2 + px_light_color / 2; }
}
)");
  Instance first = lamp(1, {0, 0, -1}), second = lamp(2, {0, 0, -1}), third = lamp(3, {0, 0, -1});
  first.set("rgb", {0.5, 0.25, 0});
  second.set("rgb", {0.25, 0.5, 0});
  third.set("rgb", {0, 0.25, 0.5});
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  Region before(kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) before.put_id(lane, 1);
  ShadingNode node({Instance(unit->shaders[0], 1)}, {second, third, first}, nullptr);
  const Region after = shaded(node, before, *array);
  const std::array<int, 3> expected{32, 72, 64};
  for (int c = 0; c < 3; ++c) EXPECT_EQ(after.colour(0, c), expected[static_cast<std::size_t>(c)]);
}

/// A cone of no width holds the light on its axis, and no other.
TEST_F(ShadingNodes, CountLightsOnTheRimOfACone) {
  const auto unit = compiled(R"(
surface cone(output varying fixed<8,8> px_shader_color[3]) {
    px_shader_color = { 0, 0, 0 };
    illuminance (px_shader_position, { 0, 0, 2 }, 0) { px_shader_color += px_light_color / 2; }
}
)");
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  Region before(kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) before.put_id(lane, 1);
  ShadingNode node({Instance(unit->shaders[0], 1)}, {lamp(1, {0, 0, -1}), lamp(2, {0.125, 0, -1})}, nullptr);
  EXPECT_EQ(shaded(node, before, *array).colour(0, 0), 128);
}

TEST_F(ShadingNodes, RunEqualInstancesOnce) {
  std::mt19937_64 random(seed_or(13));
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  const Region before = region(random, {1, 2, 3});
  ShadingNode apart({stripes(1, 0.25, 3), stripes(2, 0.26, 3), stripes(3, 0.25, 4)}, {lamp(1, {0, 0, -1})}, nullptr);
  ShadingNode together({stripes(1, 0.25, 3), stripes(2, 0.25, 3), stripes(3, 0.25, 3)}, {lamp(1, {0, 0, -1})}, nullptr);
  shaded(apart, before, *array);
  const Region after = shaded(together, before, *array);
  EXPECT_EQ(apart.executions(), 3);
  EXPECT_EQ(together.executions(), 1);
  EXPECT_LT(2 * together.cycles().illum, apart.cycles().illum);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (before.get(lane, 0, 2) == 0) continue;
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(after.colour(lane, c), stripes_colour(before, lane, 64, 3, {{0, 0, 16384}}, c));
    }
  }
}

TEST_F(ShadingNodes, LeaveOutShadersWithoutPixels) {
  std::mt19937_64 random(seed_or(14));
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  ShadingNode node({stripes(1, 0.25, 3), plain(2)}, {lamp(1, {0, 0, -1})}, nullptr);
  shaded(node, region(random, {2}), *array);
  EXPECT_EQ(node.executions(), 1);
  EXPECT_EQ(node.cycles().lights, 0u) << "no surface there has an illuminance";
  const Region background = region(random, {});
  EXPECT_TRUE(shaded(node, background, *array) == background);
}

TEST_F(ShadingNodes, MakeStreamsAgainOnlyAfterAChange) {
  std::mt19937_64 random(seed_or(15));
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  ShadingNode node({stripes(1, 0.25, 3), stripes(2, 0.5, 3)}, {lamp(1, {0, 0, -1}), lamp(2, {0.6, 0, -0.8})}, nullptr);
  const Region before = region(random, {1, 2});
  shaded(node, before, *array);
  EXPECT_EQ(node.cache().made(), 4);
  EXPECT_EQ(node.cache().reused(), 0);
  shaded(node, before, *array);
  EXPECT_EQ(node.cache().made(), 4);
  EXPECT_EQ(node.cache().reused(), 4);
  node.surface(0).set("base", {0.75});
  const Region after = shaded(node, before, *array);
  EXPECT_EQ(node.cache().made(), 5);
  node.light(1).set("direction", {0, 0, -1});
  shaded(node, before, *array);
  EXPECT_EQ(node.cache().made(), 6);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (before.get(lane, 0, 2) != 1) continue;
    ASSERT_EQ(after.colour(lane, 0), stripes_colour(before, lane, 192, 3, {{0, 0, 16384}, {-9831, 0, 13107}}, 0));
  }
}

TEST_F(ShadingNodes, LoadBoundParameters) {
  const std::uint64_t seed = seed_or(16);
  std::mt19937_64 random(seed);
  for (const LevelArray& level : all_levels()) {
    const Region before = region(random, {1, 2});
    Instance bound = plain(1);
    bound.set("px_material_diffuse", {0.25, 0.5, 0.75});
    ShadingNode node({bound, plain(2)}, {}, nullptr);
    const Region after = shaded(node, before, *level.array);
    EXPECT_EQ(node.executions(), 2);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto id = before.get(lane, 0, 2);
      for (int c = 0; c < 3; ++c) {
        if (id == 0) continue;
        const int expected = id == 1 ? 64 * (c + 1) : static_cast<int>(before.get(lane, 2 + c, 1));
        ASSERT_EQ(after.colour(lane, c), expected) << replay(seed) << ", " << level.name << ", shader " << id;
      }
    }
  }
}

std::string refusal(std::vector<Instance> surfaces, std::vector<Instance> lights) {
  try {
    ShadingNode(std::move(surfaces), std::move(lights), nullptr);
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return "";
}

TEST_F(ShadingNodes, RefuseWhatDoesNotFit) {
  EXPECT_EQ(refusal({plain(1), plain(1)}, {}), "two surfaces have the shader ID 1");
  EXPECT_EQ(refusal({plain(0)}, {}), "surface 'plain' has the shader ID 0, 1 to 65535 are possible");
  EXPECT_EQ(refusal({lamp(1, {0, 0, 1})}, {}), "'lamp' is no surface");
  EXPECT_EQ(refusal({plain(1)}, {plain(2)}), "'plain' is no light");
  const auto three = compiled(R"(
surface ambient_only(output varying fixed<8,8> px_shader_color[3]) {
    fixed<16,12> sum[3] = { 0, 0, 0 };
    illuminance () { sum += px_light_ambient; }
    px_shader_color = sum;
})");
  EXPECT_EQ(
      refusal({Instance(three->shaders[0], 1)}, {lamp(1, {0, 0, 1})}),
      "surface 'ambient_only' and light 'lamp': the surface reads ambient or specular light, which the light does "
      "not assign");
}

TEST_F(ShadingNodes, RefuseLightsBelowTheHighWaterMark) {
  // 190 bytes are kept over the lights; a light with a square root does not find room above.
  const auto greedy = compiled(R"(
surface greedy(output varying fixed<8,8> px_shader_color[3], varying float px_shader_texcoord[2]) {
    float kept[46];
    uniform int i;
    for (i = 0; i < 46; i++) kept[i] = px_shader_texcoord[0] + i;
    float sum = 0;
    illuminance () { for (i = 0; i < 46; i++) sum += kept[i] * px_light_color[0]; }
    px_shader_color = { sum, sum, sum };
}
light near(uniform float position[3] = { 0, 0, 1 }) {
    illuminate (position) { px_light_color = { 1.0 / px_light_distance, 0.0, 0.0 }; }
})");
  const pfman::CompiledShader &surface = *greedy->find("greedy"), &light = *greedy->find("near");
  ASSERT_GT(surface.map.high_water, light.map.first_free);
  EXPECT_EQ(refusal({Instance(surface, 1)}, {Instance(light, 1)}),
            "surface 'greedy' and light 'near': the light needs memory from byte " +
                std::to_string(light.map.first_free) + " on, the surface keeps what is below byte " +
                std::to_string(surface.map.high_water));
  EXPECT_EQ(refusal({Instance(surface, 1)}, {lamp(1, {0, 0, -1})}), "");
}

}  // namespace
}  // namespace pfman_tests
