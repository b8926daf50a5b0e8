// Surfaces of the flag shared_texture: one lookup a region for all of them, the same bits as if each had called
// texture4.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace {

using pfman::Instance;
using pfman::ShadingNode;
using pfman::TextureMemory;
using pfman_tests::all_levels;
using pfman_tests::LevelArray;
using pfman_tests::Region;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;
constexpr int kColumns = 128;

/// FLAG, LOOK, ID, AT and TEXEL stand for the flag and its variables, or for a call of texture4 and variables of the
/// shader's own.
constexpr char kSurfaces[] = R"(
surface plain(
    output varying fixed<8,8> px_shader_color[3],
    varying float px_shader_texcoord[3],
    uniform int image = 1)
{
    FLAG
    ID = image;
    AT = { px_shader_texcoord[0], px_shader_texcoord[1] };
    if (px_shader_texcoord[2] < 0) AT[1] = px_shader_texcoord[0];
    float kept[20];
    uniform int i;
    for (i = 0; i < 20; i++) kept[i] = px_shader_texcoord[i % 3] * px_shader_texcoord[1] - i;
    LOOK
    fixed<8,8> c[3] = { TEXEL[0], TEXEL[1], TEXEL[2] };
    for (i = 0; i < 20; i++) {
        if (TEXEL[3] < 0.5) {
            if (kept[i] > 0.2 - i) c[0] = 1 - c[0];
            c[1] += sat fixed<8,8>(abs(kept[i]) - i);
        }
    }
    px_shader_color = c;
}
surface own_lookups(
    output varying fixed<8,8> px_shader_color[3],
    varying float px_shader_texcoord[3],
    uniform int image = 2)
{
    FLAG
    ID = image + 1;
    fixed<8,8> before[3] = { 0, 0, 0 };
    if (px_shader_texcoord[2] > 0) before = texture(image, px_shader_texcoord[0], px_shader_texcoord[2]);
    AT = { px_shader_texcoord[0], before[1] + px_shader_texcoord[1] };
    LOOK
    fixed<8,8> behind[3] = environment(image, { TEXEL[0], TEXEL[1], px_shader_texcoord[2] });
    px_shader_color = { before[0], TEXEL[3], behind[2] };
}
surface lit(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_shader_texcoord[3],
    uniform int image = 2)
{
    FLAG
    ID = image;
    AT = { px_shader_texcoord[0], px_shader_texcoord[1] };
    LOOK
    float sum[3] = { 0, 0, 0 };
    illuminance () { if (px_shader_texcoord[2] > 0) sum += dot(px_shader_texcoord, px_light_direction) * px_light_color; }
    px_shader_color = { sat fixed<8,8>(sum[0] * TEXEL[0]), sat fixed<8,8>(sum[1] * TEXEL[2]), TEXEL[3] };
}
surface tinted(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_material_normal[3],
    varying unit float px_shader_view[3],
    varying float px_shader_texcoord[2],
    uniform int image = 1)
{
    FLAG
#pragma pfman shared_phong
    ID = image;
    AT = px_shader_texcoord;
    LOOK
    px_magic_kd = { TEXEL[0], TEXEL[1], TEXEL[2] };
    if (TEXEL[3] > 0.7) px_magic_kd = { 1, 1, 1 };
    px_magic_ks = { 0.2, 0.2, 0.2 };
    px_magic_exp = 9;
    px_shader_color = px_magic_diffuse + px_magic_highlight;
}
surface bare(
    output varying fixed<8,8> px_shader_color[3],
    varying float px_shader_texcoord[3],
    uniform int image = 1)
{
    px_shader_color = texture(image, px_shader_texcoord[1], px_shader_texcoord[2]);
}
)";

constexpr char kLights[] = R"(
light lamp(uniform signed fixed<16,14> direction[3] = { 0, 0, -1 }) {
    solar (direction, 0) { px_light_color = { 0.9, 0.7, 0.5 }; }
}
light greedy() {
    float a[40];
    uniform int i;
    for (i = 0; i < 40; i++) a[i] = px_light_color[0];
    solar ({ 0, 0, -1 }, 0) { for (i = 0; i < 40; i++) px_light_color[0] = a[i]; }
}
)";

std::string surfaces(bool shared) {
  const std::pair<std::string, std::string> as_flag[] = {{"FLAG", "\n#pragma pfman shared_texture\n"},
                                                         {"LOOK", ""},
                                                         {"ID", "px_magic_texid"},
                                                         {"AT", "px_magic_texcoord"},
                                                         {"TEXEL", "px_magic_texel"}};
  const std::pair<std::string, std::string> as_call[] = {{"FLAG", "uniform int id; float at[2]; fixed<8,8> texel[4];"},
                                                         {"LOOK", "texel = texture4(id, at[0], at[1]);"},
                                                         {"ID", "id"},
                                                         {"AT", "at"},
                                                         {"TEXEL", "texel"}};
  std::string text = kSurfaces;
  for (int n = 0; n < 5; ++n) {
    const auto& [from, to] = shared ? as_flag[n] : as_call[n];
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  }
  return text + kLights;
}

TextureMemory random_textures(std::mt19937_64& random) {
  TextureMemory memory;
  for (int number = 1; number <= 3; ++number) {
    std::vector<TextureMemory::Image> levels;
    for (int size = 8 << number; size >= 1; size /= 2) {
      TextureMemory::Image image{size, size, {}};
      for (int n = 0; n < size * size * 4; ++n) image.rgba.push_back(static_cast<std::uint8_t>(random()));
      levels.push_back(std::move(image));
    }
    memory.set(number, std::move(levels));
  }
  return memory;
}

struct Pixels {
  int id = 0;
  std::string surface;
  int image = 1;
};

class SharedLookups : public testing::Test {
 protected:
  static std::vector<Instance> instances(const pfman::CompiledUnit& unit, const std::vector<Pixels>& all) {
    std::vector<Instance> made;
    for (const Pixels& one : all) {
      made.emplace_back(*unit.find(one.surface), one.id).set("image", {static_cast<double>(one.image)});
    }
    return made;
  }
  std::vector<Instance> lamps(const pfman::CompiledUnit& unit) const {
    std::vector<Instance> all = {Instance(*unit.find("lamp"), 1), Instance(*unit.find("lamp"), 2)};
    all[1].set("direction", {0.6, 0.48, -0.64});
    return all;
  }

  /// Surfaces in patches and scattered, so that quads hold one of them or several.
  Region region(std::mt19937_64& random, const std::vector<Pixels>& all) const {
    Region result(kLanes);
    result.fill(random);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      for (int n = 0; n < 3; ++n) {
        result.put_float(lane, pfman::kPositionAt + 4 * n, uniform(random) - (n == 2 ? 3.0f : 0.0f));
      }
      const std::size_t patch = lane % kColumns / 8 * 7;
      const std::size_t chosen = (random() % 4 == 0 ? random() : patch) % (all.size() + 1);
      result.put_id(lane, chosen < all.size() ? all[chosen].id : 0);
      if (chosen == all.size()) continue;
      const float step = 0.005f * static_cast<float>(1 + lane % kColumns / 16);
      for (const auto& entry : pfman::transfer_map(*called_->find(all[chosen].surface)).entries) {
        for (int n = 0; n < entry.type.count(); ++n) {
          const bool smooth = entry.name == "px_shader_texcoord";
          result.put_float(
              lane, entry.address + 4 * n,
              smooth ? step * static_cast<float>(lane % kColumns) + 0.3f * uniform(random) * step : uniform(random));
        }
      }
    }
    return result;
  }

  std::unique_ptr<pfman::CompiledUnit> shared_ = pfman_tests::compiled(surfaces(true));
  std::unique_ptr<pfman::CompiledUnit> called_ = pfman_tests::compiled(surfaces(false));
};

int differences(const Region& a, const Region& b) {
  int count = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (a.get(lane, 0, 2) == 0) continue;
    for (int c = 0; c < 3; ++c) count += a.colour(lane, c) != b.colour(lane, c);
  }
  return count;
}

TEST_F(SharedLookups, GiveTheSameBitsWithOneLookupForAll) {
  const std::uint64_t seed = seed_or(101);
  const std::vector<Pixels> all = {{1, "plain", 1}, {2, "own_lookups", 1}, {3, "lit", 2},   {4, "tinted", 3},
                                   {5, "bare", 1},  {6, "plain", 3},       {7, "plain", 1}, {300, "tinted", 2}};
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    const TextureMemory textures = random_textures(random);
    ShadingNode together(instances(*shared_, all), lamps(*shared_), &textures);
    ShadingNode apart(instances(*called_, all), lamps(*called_), &textures);
    std::vector<Pixels> swapped = all;
    std::swap(swapped[0].image, swapped[5].image);
    ShadingNode other(instances(*shared_, swapped), lamps(*shared_), &textures);
    for (int round = 0; round < 3; ++round) {
      const Region before = region(random, all);
      const Region one = shaded(together, before, *level.array), two = shaded(apart, before, *level.array);
      ASSERT_EQ(differences(one, two), 0) << replay(seed) << ", " << level.name;
      EXPECT_GT(differences(one, shaded(other, before, *level.array)), 10) << "another image";
    }
    EXPECT_EQ(together.executions(), 3 * 7);
    EXPECT_EQ(together.cycles().lookups, 3u * (1 + 2 + 1)) << "besides it two of own_lookups' own and one of bare's";
    EXPECT_EQ(apart.cycles().lookups, 3u * (6 + 2 + 1));
  }
}

/// Neighbours that show another instance have no part in the level of detail.
TEST_F(SharedLookups, AreEachSurfacesOwn) {
  const std::uint64_t seed = seed_or(102);
  std::mt19937_64 random(seed);
  const TextureMemory textures = random_textures(random);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  const std::vector<Pixels> all = {{1, "plain", 3}, {2, "plain", 2}};
  ShadingNode together(instances(*shared_, all), {}, &textures);
  const Region before = region(random, all);
  const Region both = shaded(together, before, *array);
  for (const Pixels& one : all) {
    ShadingNode alone(instances(*shared_, {one}), {}, &textures);
    const Region after = shaded(alone, before, *array);
    EXPECT_EQ(alone.cycles().lookups, 1u);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (before.get(lane, 0, 2) != static_cast<std::uint64_t>(one.id)) continue;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(both.colour(lane, c), after.colour(lane, c)) << replay(seed);
    }
  }
}

/// Covered pixels are packed into the first elements: levels of detail go by their places.
TEST_F(SharedLookups, GoByPlacesNotByElements) {
  const std::uint64_t seed = seed_or(104);
  const std::vector<Pixels> all = {{1, "plain", 3}, {2, "own_lookups", 1}, {3, "lit", 2}, {4, "bare", 3}};
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    const TextureMemory textures = random_textures(random);
    ShadingNode node(instances(*shared_, all), lamps(*shared_), &textures);
    const Region before = region(random, all);
    const Region in_place = shaded(node, before, *level.array);
    std::vector<std::size_t> element_of(kLanes);
    std::iota(element_of.begin(), element_of.end(), std::size_t{0});
    std::shuffle(element_of.begin(), element_of.end(), random);
    std::vector<std::uint8_t> columns(kLanes), rows(kLanes), row(kLanes), moved(kLanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      columns[element_of[lane]] = static_cast<std::uint8_t>(lane % kColumns);
      rows[element_of[lane]] = static_cast<std::uint8_t>(lane / kColumns);
    }
    const auto shade_moved = [&] {
      before.write(*level.array);
      for (int address = 0; address < pixelflow::kMemoryBytes; ++address) {
        level.array->read(address, row);
        for (std::size_t lane = 0; lane < kLanes; ++lane) moved[element_of[lane]] = row[lane];
        level.array->write(address, moved);
      }
      node.shade(*level.array);
      Region after(kLanes);
      after.read(*level.array);
      return after;
    };
    const Region beside = shade_moved();
    int wrong = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (before.get(lane, 0, 2) != 0) wrong += beside.colour(element_of[lane], 0) != in_place.colour(lane, 0);
    }
    EXPECT_GT(wrong, 20) << "places as the elements lie";

    level.array->place(columns, rows);
    const Region packed = shade_moved();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (before.get(lane, 0, 2) == 0) continue;
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(packed.colour(element_of[lane], c), in_place.colour(lane, c))
            << replay(seed) << ", " << level.name << ", lane " << lane;
      }
    }
  }
}

/// A surface without illuminance keeps its values while lights run: not where a light needs their place.
TEST_F(SharedLookups, AreMadeAloneWhereMemoryDoesNotSuffice) {
  const std::uint64_t seed = seed_or(103);
  std::mt19937_64 random(seed);
  const TextureMemory textures = random_textures(random);
  const std::vector<Pixels> all = {{1, "plain", 1}, {2, "own_lookups", 1}, {3, "lit", 2}};
  for (const LevelArray& level : all_levels()) {
    const auto lights = [](const pfman::CompiledUnit& unit) { return std::vector{Instance(*unit.find("greedy"), 1)}; };
    const int free = shared_->find("greedy")->map.first_free;
    ASSERT_LT(free, shared_->find("plain")->map.lookup_water);
    ASSERT_GE(free, shared_->find("own_lookups")->map.lookup_water);
    ShadingNode together(instances(*shared_, all), lights(*shared_), &textures);
    ShadingNode apart(instances(*called_, all), lights(*called_), &textures);
    const Region before = region(random, all);
    const Region one = shaded(together, before, *level.array), two = shaded(apart, before, *level.array);
    EXPECT_EQ(differences(one, two), 0) << replay(seed) << ", " << level.name;
    EXPECT_EQ(together.cycles().lookups, 2u + 2u) << "that of plain, and one for the other two";
    EXPECT_EQ(apart.cycles().lookups, 3u + 2u);
  }
}

TEST_F(SharedLookups, AreDoneBeforeTheIlluminance) {
  const auto unit = pfman_tests::compiled(R"(
#pragma pfman shared_texture
surface s(output varying fixed<8,8> px_shader_color[3], varying float px_shader_texcoord[2])
{
    px_magic_texid = 1;
    px_magic_texcoord = px_shader_texcoord;
    fixed<8,8> sum[3] = { 0, 0, 0 };
    illuminance () { sum = px_light_color; }
    px_magic_texid = 2;
    px_shader_color = { px_magic_texel[0], px_magic_texel[1], px_magic_texel[2] };
}
light lamp() { solar ({ 0, 0, -1 }, 0) { px_light_color = { 1, 1, 1 }; } }
)");
  std::mt19937_64 random(1);
  TextureMemory textures;
  textures.set(1, {1, 1, {10, 20, 30, 40}});
  textures.set(2, {1, 1, {50, 60, 70, 80}});
  ShadingNode node({Instance(*unit->find("s"), 1)}, {Instance(*unit->find("lamp"), 1)}, &textures);
  Region before(kLanes);
  before.fill(random);
  for (std::size_t lane = 0; lane < kLanes; ++lane) before.put_id(lane, 1);
  const Region after = shaded(node, before, *pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes));
  EXPECT_EQ(after.colour(7, 0), 10);
  EXPECT_EQ(after.colour(7, 2), 30);
  EXPECT_EQ(node.cycles().lookups, 1u);
}

}  // namespace
