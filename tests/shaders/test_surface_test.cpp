// Test surfaces: where their points lie, what reaches pixel memory, and how parameters are transformed.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "pixelflow/compiler/memory_layout.h"
#include "tests/shaders/region.h"

namespace shader_tests {
namespace {

using pfman::TestShape;
using pfman::TestSurface;
using pfman::TestView;
using pfman::Vector;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST(TestSurfaces, APlaneFillsThePictureWithItsTextureCoordinates) {
  const TestSurface scene({.width = 64, .height = 64});
  for (const auto& [column, row] : {std::pair(0, 0), {63, 0}, {10, 40}, {63, 63}}) {
    const auto point = scene.at(column, row);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->shape.texcoord[0], (column + 0.5) / 64, 1e-12);
    EXPECT_NEAR(point->shape.texcoord[1], 1 - (row + 0.5) / 64, 1e-12);
    EXPECT_NEAR(point->normal[2], 1, 1e-12);
  }
  EXPECT_FALSE(TestSurface({.width = 64, .height = 64, .distance = 1.1}).at(0, 0));
}

TEST(TestSurfaces, PointsLieOnTheirRaysAndNormalsFaceTheEye) {
  for (const TestShape shape : {TestShape::Plane, TestShape::Relief, TestShape::Sphere, TestShape::Pin}) {
    const TestSurface scene({.shape = shape, .width = 96, .height = 96, .turn = 20, .tilt = 30});
    int seen = 0;
    for (int row = 0; row < 96; ++row) {
      for (int column = 0; column < 96; ++column) {
        const auto point = scene.at(column, row);
        if (!point) continue;
        ++seen;
        EXPECT_NEAR(point->position[0] / -point->position[2], (2 * column - 95) / 96.0 * 0.36, 1e-9);
        EXPECT_NEAR(point->position[1] / -point->position[2], (95 - 2 * row) / 96.0 * 0.36, 1e-9);
        EXPECT_NEAR(dot(point->normal, point->normal), 1, 1e-9);
        EXPECT_LT(dot(point->normal, point->position), 0.05)
            << static_cast<int>(shape) << ": " << column << ", " << row;
      }
    }
    EXPECT_GT(seen, 500);
  }
}

TEST(TestSurfaces, TheUpperSideOfATiltedPlaneIsFartherAway) {
  const TestSurface scene({.width = 64, .height = 64, .tilt = 40});
  EXPECT_LT(scene.at(32, 20)->position[2], scene.at(32, 44)->position[2]);
  EXPECT_GT(scene.at(32, 32)->normal[1], 0.6);
}

TEST(TestSurfaces, ParametersReachPixelMemoryByTheTransferMap) {
  const Compiled compiled = compile("simple_brick");
  ASSERT_EQ(compiled.said, "");
  pfman::Instance instance(compiled.shader(), 0x1234);
  TestSurface::make_ordinary(instance);
  const TestSurface scene({.width = 130, .height = 70, .turn = 30});
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, pixelflow::kElements);
  const auto byte = [&](int address, int lane) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(array->lanes()));
    array->read(address, bytes);
    return bytes[static_cast<std::size_t>(lane)];
  };
  const auto word = [&](int address, int bytes, int lane) {
    std::uint32_t value = 0;
    for (int n = 0; n < bytes; ++n) value |= static_cast<std::uint32_t>(byte(address + n, lane)) << (8 * n);
    return value;
  };
  scene.fill(instance, 0, 34, *array);
  const int lane = pixelflow::kRegionWidth + 61;  // column 61 of the second row
  const auto point = scene.at(61, 35);
  ASSERT_TRUE(point);
  EXPECT_EQ(word(pfman::kShaderIdAt, 2, lane), 0x1234u);
  EXPECT_EQ(std::bit_cast<float>(word(pfman::kPositionAt + 8, 4, lane)), static_cast<float>(point->position[2]));
  int checked = 0;
  for (const pfman::TransferEntry& entry : pfman::transfer_map(compiled.shader()).entries) {
    if (entry.name == "px_material_normal") {
      const auto raw = static_cast<std::int16_t>(word(entry.address, 2, lane));
      EXPECT_EQ(raw, std::floor(point->normal[0] * 16384 + 0.5));
      ++checked;
    } else if (entry.name == "px_shader_texcoord") {
      EXPECT_EQ(std::bit_cast<float>(word(entry.address + 4, 4, lane)), static_cast<float>(point->shape.texcoord[1]));
      ++checked;
    }
  }
  EXPECT_EQ(checked, 2);

  scene.fill(instance, 128, 64, *array);  // beyond two columns there is no picture
  EXPECT_EQ(word(pfman::kShaderIdAt, 2, 2), 0u);
}

TEST(TestSurfaces, UniformParametersAreTransformedAsTheirAttributesSay) {
  const Compiled compiled = compile("point_light"), brick = compile("fancy_brick");
  ASSERT_EQ(compiled.said + brick.said, "");
  const TestSurface scene({.distance = 0.72, .tilt = 90});
  pfman::Instance light(compiled.shader());
  light.set("position", {0, 1, 0});
  scene.place(light);
  const auto number = [](const pfman::Instance& instance, const char* name, std::size_t n) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(instance.uniforms().at(name).at(n)));
  };
  // Tilted by 90 degrees the shape's y axis points away from the eye; its middle is 2 from the eye.
  EXPECT_NEAR(number(light, "position", 1), 0, 1e-6);
  EXPECT_NEAR(number(light, "position", 2), -3, 1e-6);
  pfman::Instance surface(brick.shader(), 1);
  scene.place(surface);
  EXPECT_NEAR(number(surface, "tangent_t", 2), -1, 1e-6);
  EXPECT_NEAR(number(surface, "tangent_s", 0), 1, 1e-6);
}

}  // namespace
}  // namespace shader_tests
