// Random pixels of several rendering nodes, and shaders whose colours are known.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "pixelflow/shading/region.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"

namespace region_tests {

// IDs of the shaders below.
constexpr int kPlain = 1, kWide = 0x203, kWhere = 3, kRed = 4, kSpots = 5, kSecondRed = 6, kForgetful = 7;

inline constexpr char kShaders[] = R"(
surface plain(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> px_material_diffuse[3]) {
    px_shader_color = px_material_diffuse;
}
surface wide(output varying fixed<8,8> px_shader_color[3],
             varying float before[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, varying fixed<8,8> data[3] = { 0, 0, 0 }) {
    px_shader_color = data;
}
surface where(output varying fixed<8,8> px_shader_color[3], varying float px_shader_position[3]) {
    px_shader_color = { sat fixed<8,8>(px_shader_position[0]), sat fixed<8,8>(px_shader_position[1]),
                        sat fixed<8,8>(-px_shader_position[2]) };
}
surface red(output varying fixed<8,8> px_shader_color[3], varying unit float px_material_normal[3],
            varying unit float px_shader_view[3], uniform float shine = 8) {
#pragma pfman shared_phong
    px_magic_kd = { 0.8, 0.2, 0.1 };
    px_magic_ks = { 0.5, 0.5, 0.5 };
    px_magic_exp = shine;
    px_shader_color = px_magic_diffuse + px_magic_highlight;
}
surface spots(output varying fixed<8,8> px_shader_color[3], varying unit float px_material_normal[3],
              varying fixed<8,8> own = 0, varying unit float px_shader_view[3]) {
#pragma pfman shared_phong
    px_magic_kd = { own, 0.5, 0.25 };
    px_magic_ks = { 0, own, own };
    px_magic_exp = 4;
    px_shader_color = px_magic_diffuse * 0.5 + 0.5 * px_magic_highlight;
}
surface forgetful(output varying fixed<8,8> px_shader_color[3], varying fixed<8,8> px_material_diffuse[3]) {
    fixed<8,8> never[100];
    fixed<8,8> a = 0;
    uniform int i;
    for (i = 0; i < 100; i++) a += never[i] * 0.5;
    px_shader_color = { a, never[3], px_material_diffuse[2] };
}
light lamp(uniform signed fixed<16,14> direction[3] = { 0, 0, -1 }) {
    solar (direction, 0) { px_light_color = { 0.9, 0.7, 0.5 }; }
}
)";

inline const pfman::CompiledUnit& shaders() {
  static const auto unit = pfman_tests::compiled(kShaders);
  return *unit;
}

inline pfman::Instance instance(const std::string& shader, int id, const std::vector<std::string>& ordinary = {}) {
  pfman::Instance made(*shaders().find(shader), id);
  for (const std::string& name : ordinary) made.make_ordinary(name);
  return made;
}

inline std::vector<pfman::Instance> surfaces() {
  return {instance("plain", kPlain),        instance("wide", kWide, {"before", "data"}),
          instance("where", kWhere),        instance("red", kRed),
          instance("red", kSecondRed),      instance("spots", kSpots, {"own"}),
          instance("forgetful", kForgetful)};
}

inline std::vector<pfman::Instance> lamps() {
  std::vector<pfman::Instance> both{instance("lamp", 1), instance("lamp", 2)};
  both[1].set("direction", {0.6, 0, -0.8});
  return both;
}

/// Pixels of these shaders in about so many of 256 places, with random parameters. Few depths, so that some are equal.
inline pfman::RegionPixels random_pixels(std::mt19937_64& random, const std::vector<int>& ids, unsigned of_256,
                                         int packets = 2) {
  pfman::RegionPixels pixels;
  pixels.packets = packets;
  for (int place = 0; place < pixelflow::kRegionWidth * pixelflow::kRegionHeight; ++place) {
    if (random() % 256 >= of_256) continue;
    pixels.columns.push_back(static_cast<std::uint8_t>(place % pixelflow::kRegionWidth));
    pixels.rows.push_back(static_cast<std::uint8_t>(place / pixelflow::kRegionWidth));
    pixels.depth.push_back(static_cast<std::uint32_t>(random() % 8) * 0x2424'2424u);
    const int id = ids[random() % ids.size()];
    pixels.payload.push_back(static_cast<std::uint8_t>(id));
    pixels.payload.push_back(static_cast<std::uint8_t>(id >> 8));
    for (int n = pfman::kShaderIdBytes; n < packets * pfman::kPacketPayload; ++n) {
      // No exponents of floats that make a sum infinite.
      pixels.payload.push_back(static_cast<std::uint8_t>(random() % 0x40));
    }
  }
  return pixels;
}

/// x and y 0 to 1 over the first 640 x 480 samples, the near plane at 0.25 and the far one at 0.75.
inline pfman::EyeSpace unit_view() { return {false, 0.25, 0.75, 0, 1.0 / 640, 1, -1.0 / 480}; }

/// A frame of all surfaces, and a node for regions of up to so many pixels.
struct Scene {
  explicit Scene(std::unique_ptr<pixelflow::PixelArray> array) : node(std::move(array)) {}

  pfman::RegionNode::Result work(std::span<const pfman::RegionPixels> sources, int column = 0, int row = 0) {
    return node.work(frame, column, row, sources);
  }

  pfman::StreamCache cache;
  pfman::FrameShading frame{surfaces(), lamps(), nullptr, unit_view(), cache};
  pfman::RegionNode node;
};

}  // namespace region_tests
