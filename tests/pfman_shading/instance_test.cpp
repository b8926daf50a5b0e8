// Instances, transfer maps, colours in all types, mistakes of uniform code.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pfman::Instance;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;

constexpr char kShader[] = R"(
const float half = 0.5;
surface s(
    output varying fixed<8,8> px_shader_color[3],
    varying unit float px_shader_view[3],
    varying signed fixed<16,14> px_material_normal[3],
    uniform float width = half,
    varying fixed<12,4> wide = 3,
    varying float px_shader_position[3],
    varying float px_shader_texcoord[2],
    uniform fixed<8,8> tint[2] = { 0.25, half })
{
    float sum = px_shader_view[0] + px_material_normal[1] + width + wide + px_shader_position[2] + px_shader_texcoord[1];
    px_shader_color = { sum, tint[0], tint[1] };
})";

TEST(TransferMaps, HoldWhatTravels) {
  const auto unit = compiled(kShader);
  const pfman::TransferMap map = pfman::transfer_map(unit->shaders[0]);
  ASSERT_EQ(map.entries.size(), 3u);
  EXPECT_EQ(map.entries[0].name, "px_material_normal");
  EXPECT_EQ(map.entries[0].address, 2);
  EXPECT_EQ(map.entries[1].name, "wide");
  EXPECT_EQ(map.entries[1].address, 8);
  EXPECT_EQ(map.entries[2].name, "px_shader_texcoord");
  EXPECT_EQ(map.entries[2].address, 10);
  EXPECT_EQ(map.bytes, 18);
  EXPECT_EQ(map.packets, 1);
}

TEST(TransferMaps, NeedAPacketForEvery28Bytes) {
  const auto unit = compiled(R"(
surface a(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> px_material_diffuse[3],
          varying fixed<8,8> x[23] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }) {
    px_shader_color = { x[0], x[1], x[2] };
}
surface b(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> px_material_diffuse[3],
          varying fixed<8,8> x[24] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }) {
    px_shader_color = { x[0], x[1], x[2] };
})");
  EXPECT_EQ(pfman::transfer_map(unit->shaders[0]).bytes, 28);
  EXPECT_EQ(pfman::transfer_map(unit->shaders[0]).packets, 1);
  EXPECT_EQ(pfman::transfer_map(unit->shaders[1]).bytes, 29);
  EXPECT_EQ(pfman::transfer_map(unit->shaders[1]).packets, 2);
}

std::string refusal(Instance instance, const std::string& name, const std::vector<double>& values) {
  try {
    instance.set(name, values);
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return "";
}

TEST(Instances, HoldValues) {
  const auto unit = compiled(kShader);
  Instance instance(unit->shaders[0], 1);
  EXPECT_EQ(instance.uniforms().at("width"), pfman::Raw{0x3F000000});
  EXPECT_EQ(instance.uniforms().at("tint"), (pfman::Raw{64, 128}));
  EXPECT_EQ(instance.bound().at("wide"), pfman::Raw{48});
  EXPECT_FALSE(instance.is_ordinary("wide"));
  EXPECT_TRUE(instance.is_ordinary("px_material_normal"));
  instance.set("px_material_normal", {1, -1, 0.5});
  EXPECT_FALSE(instance.is_ordinary("px_material_normal"));
  EXPECT_EQ(instance.bound().at("px_material_normal"), (pfman::Raw{16384, std::uint64_t(-16384), 8192}));
  instance.make_ordinary("px_material_normal");
  instance.make_ordinary("wide");
  EXPECT_TRUE(instance.is_ordinary("px_material_normal"));
  EXPECT_TRUE(instance.is_ordinary("wide"));
  EXPECT_TRUE(instance.bound().empty());
}

TEST(Instances, RefuseWhatTheShaderDoesNotHave) {
  const auto unit = compiled(kShader);
  const Instance instance(unit->shaders[0], 1);
  EXPECT_EQ(refusal(instance, "height", {1}), "'s' has no parameter 'height'");
  EXPECT_EQ(refusal(instance, "px_shader_color", {1, 1, 1}), "'s' has no parameter 'px_shader_color'");
  EXPECT_EQ(refusal(instance, "tint", {1}), "parameter 'tint' has 2 numbers, not 1");
  EXPECT_EQ(refusal(instance, "px_shader_position", {1, 1, 1}), "'px_shader_position' is found on the shading node");
  EXPECT_THROW(Instance(instance).make_ordinary("width"), std::invalid_argument);
}

/// Colours in any type: floor(value 256), limited to 0 to 255.
TEST(PictureColours, AreFlooredAndLimited) {
  const std::uint64_t seed = seed_or(51);
  std::mt19937_64 random(seed);
  const auto levels = all_levels();
  std::vector<pfman::Scalar> types = {pfman::Scalar::floating()};
  for (const int size : {1, 2, 7, 8, 9, 16, 21, 40, 64}) {
    for (const int exponent : {-64, -9, -1, 0, 1, 5, 7, 8, 9, 13, 16, 24, 33, 64, 90}) {
      types.push_back(pfman::Scalar::fixed(false, size, exponent));
      if (size > 1) types.push_back(pfman::Scalar::fixed(true, size, exponent));
    }
  }
  for (const pfman::Scalar& type : types) {
    const std::string name = pfman::spelling(type);
    const auto unit = compiled("surface s(output varying " + name + " px_shader_color[3], varying " + name +
                               " px_material_diffuse[3]) { px_shader_color = px_material_diffuse; }");
    Region before(kLanes);
    before.fill(random);
    std::vector<std::array<int, 3>> expected(kLanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      before.put_id(lane, 1);
      for (int c = 0; c < 3; ++c) {
        // All magnitudes, and the ends of the range.
        const std::uint64_t bits = random() >> random() % 64;
        std::uint64_t raw = lane == 0 ? ~std::uint64_t{0} : lane == 1 ? std::uint64_t{1} << (type.size - 1) : bits;
        double value = 0;
        if (type.is_float) {
          const float number = std::ldexp(static_cast<float>(static_cast<std::int32_t>(bits)), -36);
          raw = lane == 0 ? 0x7FC00000 : std::bit_cast<std::uint32_t>(number);
          value = lane == 0 ? 0 : number;
        } else {
          raw = pfman::convert(raw, pfman::Scalar::fixed(type.is_signed, 64, 0),
                               pfman::Scalar::fixed(type.is_signed, type.size, 0));
          value = std::ldexp(
              type.is_signed ? static_cast<double>(static_cast<std::int64_t>(raw)) : static_cast<double>(raw),
              -type.exponent);
        }
        before.put(lane, pfman::kParametersAt + c * type.bytes(), type.bytes(), raw);
        expected[lane][static_cast<std::size_t>(c)] = static_cast<int>(std::clamp(std::floor(value * 256), 0.0, 255.0));
      }
    }
    for (const LevelArray& level : levels) {
      pfman::ShadingNode node({Instance(unit->shaders[0], 1)}, {}, nullptr);
      const Region after = shaded(node, before, *level.array);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        for (int c = 0; c < 3; ++c) {
          ASSERT_EQ(after.colour(lane, c), expected[lane][static_cast<std::size_t>(c)])
              << replay(seed) << ", " << level.name << ", " << name << ", raw "
              << before.get(lane, pfman::kParametersAt + c * type.bytes(), type.bytes());
        }
      }
    }
  }
}

/// A colour that is the light's direction or colour as it lies in the shared area, where the picture's colour goes.
TEST(PictureColours, ComeFromTheSharedArea) {
  const auto unit = compiled(R"(
surface direction(output varying signed fixed<16,14> px_shader_color[3]) {
    px_shader_color = { 0, 0, 0 };
    illuminance () { px_shader_color = px_light_direction; }
}
light lamp() { solar ({ 0, -0.6, -0.8 }, 0) { px_light_color = { 0.25, 0.5, 0.75 }; } })");
  for (const LevelArray& level : all_levels()) {
    pfman::ShadingNode node({Instance(unit->shaders[0], 1)}, {Instance(unit->shaders[1], 1)}, nullptr);
    Region before(kLanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane) before.put_id(lane, 1);
    const Region after = shaded(node, before, *level.array);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      EXPECT_EQ(after.colour(lane, 0), 0);
      EXPECT_EQ(after.colour(lane, 1), 153);
      EXPECT_EQ(after.colour(lane, 2), 204);
    }
  }
}

/// Whatever of the input changes, the streams are others; another user does not displace them.
TEST(StreamCaches, KeepStreamsOfEqualInputsAlone) {
  const auto unit = compiled(R"(
surface s(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> shade = 0.5, uniform fixed<8,8> weight = 0.25) {
    fixed<8,8> sum = shade;
    illuminance () { sum += px_light_color[0] * weight; }
    px_shader_color = { sum, sum, sum };
})");
  const pfman::CompiledShader& shader = unit->shaders[0];
  const pfman::GenerateInput plain{.uniforms = {}, .bound_varying = {}, .shader_ids = {1}, .lights = 1};
  std::vector<pfman::GenerateInput> inputs(5, plain);
  inputs[1].uniforms["weight"] = {128};
  inputs[2].bound_varying["shade"] = {77};
  inputs[3].shader_ids = {1, 2};
  inputs[4].lights = 0;
  pfman::StreamCache cache;
  for (std::size_t n = 0; n < inputs.size(); ++n) {
    for (const std::size_t input : {std::size_t{0}, n}) {
      const pfman::Streams& streams = cache.streams(shader, inputs[input]);
      const pfman::Streams expected = pfman::generate(shader, inputs[input]);
      EXPECT_EQ(streams.pre.cycles(), expected.pre.cycles()) << n;
      EXPECT_EQ(streams.illum.size(), expected.illum.size()) << n;
      EXPECT_EQ(streams.cycles_by_line, expected.cycles_by_line) << n;
    }
  }
  // The first input, twice in its first turn, then each of the others and it again.
  EXPECT_EQ(cache.made(), 1 + 4 + 3);
  EXPECT_EQ(cache.reused(), 2);
  cache.streams(shader, plain, 5);
  cache.streams(shader, inputs[4]);
  EXPECT_EQ(cache.made(), 9) << "for another user";
  EXPECT_EQ(cache.reused(), 3);
}

std::string uniform_mistake(const std::string& body) {
  const auto unit = compiled("surface s(output varying fixed<8,8> px_shader_color[3], uniform int n = 7) {\n" + body +
                             "\npx_shader_color = { 0, 0, 0 };\n}");
  try {
    pfman::generate(unit->shaders[0], {});
  } catch (const pfman::UniformError& mistake) {
    return std::to_string(mistake.where.line) + ":" + std::to_string(mistake.where.column) + ": " + mistake.what();
  }
  return "";
}

TEST(Streams, ReportMistakesOfUniformCode) {
  EXPECT_EQ(uniform_mistake("float a[4] = { 0, 1, 2, 3 };\na[n] = 1;"),
            "3:3: index 7 is outside of the array's 0 to 3");
  EXPECT_EQ(uniform_mistake("float a[4] = { 0, 1, 2, 3 };\na[n - 5] = 1;"), "");
  EXPECT_EQ(uniform_mistake("uniform int i = 0;\nwhile (i < n) { }"),
            "3:1: the loop has not ended after 65536 iterations");
  EXPECT_EQ(uniform_mistake("uniform int i;\nfor (i = 0; i < 65536; i++) { }"), "");
  EXPECT_EQ(uniform_mistake("uniform int i;\nfor (i = 0; i < 65537; i++) { }"),
            "3:1: the loop has not ended after 65536 iterations");
  EXPECT_EQ(uniform_mistake("uniform int i = 1 << (n * 10);"), "2:25: a shift by 70 places; 0 to 64 are possible");
}

}  // namespace
}  // namespace pfman_tests
