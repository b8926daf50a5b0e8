// Lights and illuminance, written out.
#include <gtest/gtest.h>

#include "tests/pfman_check/checked.h"

namespace {

using pfman_tests::Checked;
using pfman_tests::surface;

TEST(pfman_check, local_lights_set_ray_distance_and_direction) {
  const Checked unit(
      "light l(uniform float at[3] = { 0, 0, 0 }) { illuminate (at) px_light_color = px_light_ray / px_light_distance; "
      "}");
  EXPECT_EQ(unit.statements("l"), R"(px_light_color = {0, 0, 0}
px_light_ambient = {0, 0, 0}
px_light_ray = (px_shader_position - at)
px_light_distance = sqrt((((px_light_ray[0] * px_light_ray[0]) + (px_light_ray[1] * px_light_ray[1])) + (px_light_ray[2] * px_light_ray[2])))
px_light_direction = signed fixed<16,14>((-px_light_ray / px_light_distance))
px_light_color = fixed<16,12>((px_light_ray / px_light_distance))
px_light_specular = px_light_color
)");
  EXPECT_FALSE(unit.shader("l").three_colours);
}

TEST(pfman_check, cones_of_lights_blacken_what_is_outside) {
  const Checked unit(R"(light l(uniform float at[3] = { 0, 0, 0 }, uniform float axis[3] = { 0, 0, 1 })
{
    illuminate (at, axis, 0.5) { px_light_color = { 1, 1, 1 }; px_light_specular = { 0.5, 0.5, 0.5 }; }
})");
  const std::string text = unit.statements("l");
  EXPECT_NE(
      text.find(
          R"(if masked (((((px_light_ray[0] * axis[0]) + (px_light_ray[1] * axis[1])) + (px_light_ray[2] * axis[2])) / (px_light_distance * sqrt((((axis[0] * axis[0]) + (axis[1] * axis[1])) + (axis[2] * axis[2]))))) < cos(0.5))
  px_light_color = {0, 0, 0}
  px_light_specular = {0, 0, 0}
)"),
      std::string::npos)
      << text;
}

TEST(pfman_check, distant_lights_have_a_uniform_direction) {
  const Checked unit("light l(uniform float axis[3] = { 0, 0, 1 }) { solar (axis, 0) px_light_color = { 1, 1, 1 }; }");
  EXPECT_EQ(unit.statements("l"), R"(px_light_color = {0, 0, 0}
px_light_ambient = {0, 0, 0}
px_light_ray = (v1 = sqrt((((axis[0] * axis[0]) + (axis[1] * axis[1])) + (axis[2] * axis[2]))), ((v1 != 0) ? (axis / v1) : {0, 0, 0}))
px_light_direction = signed fixed<16,14>(-px_light_ray)
px_light_color = {1, 1, 1}
px_light_specular = px_light_color
)");
}

TEST(pfman_check, lights_without_a_source_are_ambient) {
  const Checked unit("light l() { px_light_color = { 1, 0.5, 0.25 }; }");
  EXPECT_EQ(unit.statements("l"), R"(px_light_direction = {0, 0, 0}
px_light_color = {0, 0, 0}
px_light_ambient = {0, 0, 0}
px_light_color = {1, 0.5, 0.25}
px_light_ambient = px_light_color
px_light_color = {0, 0, 0}
px_light_specular = px_light_color
)");
}

TEST(pfman_check, illuminance_cone_is_a_masked_if) {
  const Checked unit(surface(R"(
    float n = 0;
    illuminance (px_shader_position, { 0, 0, 1 }, 0.5) n += px_light_color[0];
    px_shader_color[0] = n;)"));
  EXPECT_EQ(unit.statements("s"), R"(n = 0
illuminance
  if masked (v1 = sqrt((((0 * 0) + (0 * 0)) + (1 * 1))), v2 = ((v1 != 0) ? ({0, 0, 1} / v1) : {0, 0, 0}), (cos(0.5) <= (((v2[0] * float(px_light_direction[0])) + (v2[1] * float(px_light_direction[1]))) + (v2[2] * float(px_light_direction[2])))))
    n = (n + float(px_light_color[0]))
px_shader_color[0] = fixed<8,8>(n)
)");
  EXPECT_FALSE(unit.shader("s").three_colours);
}

TEST(pfman_check, three_colours_are_noticed) {
  const Checked unit(
      surface("illuminance () px_shader_color = px_light_ambient;") +
      "light l() { solar ({ 0, 0, 1 }, 0) { px_light_color = { 1, 1, 1 }; px_light_ambient = { 1, 1, 1 }; "
      "px_light_specular[0] = 1; } }");
  EXPECT_TRUE(unit.shader("s").three_colours);
  EXPECT_TRUE(unit.shader("l").three_colours);
}

}  // namespace
