// Masks, loops, functions, lights: lane by lane.
#include <gtest/gtest.h>

#include "tests/reference/shaders.h"

namespace reference_tests {
namespace {

using namespace reference;

/// px_shader_color[0] of a body over lanes whose x is 0, 1, 2 ...
std::vector<Raw> over_lanes(const std::string& body, int lanes = 8, const std::string& before = "") {
  Input input;
  input.lanes = lanes;
  for (int lane = 0; lane < lanes; ++lane) input.varying["x"].push_back(static_cast<Raw>(lane));
  const SurfaceResult result = run(before +
                                       "surface s(output varying fixed<16,0> px_shader_color[3], varying fixed<8,0> x "
                                       "= 0, uniform int n = 5) { fixed<16,0> r = 0; " +
                                       body + " px_shader_color = {r, 0, 0}; }",
                                   input);
  return {result.raw.begin(), result.raw.begin() + lanes};
}

using Lanes = std::vector<Raw>;

TEST(Statements, varying_if_goes_both_ways) {
  EXPECT_EQ(over_lanes("if (x < 3) r = 1; else if (x == 5) r = 2; else r = 3;"), (Lanes{1, 1, 1, 3, 3, 2, 3, 3}));
}

TEST(Statements, a_choice_by_what_only_may_vary_keeps_its_lanes) {
  EXPECT_EQ(over_lanes("bool b = x == 1; r = (n == 5 ? 0 : b) ? 7 : x;", 4), (Lanes{0, 1, 2, 3}));
  EXPECT_EQ(over_lanes("bool b = x == 1; r = (n == 4 ? 0 : b) ? 7 : x;", 4), (Lanes{0, 7, 2, 3}));
}

TEST(Statements, masked_break_stops_a_lane_and_the_loop_goes_on) {
  EXPECT_EQ(over_lanes("uniform int i; for (i = 0; i < n; i++) { if (i == x) break; r += 1; } r += 100 * i;"),
            (Lanes{500, 501, 502, 503, 504, 505, 505, 505}));
}

TEST(Statements, masked_continue_skips_the_rest_of_an_iteration) {
  EXPECT_EQ(over_lanes("uniform int i = 0; while (i < n) { i++; if (x % 2 == 0) { if (i == 2) continue; } r += i; }"),
            (Lanes{13, 15, 13, 15, 13, 15, 13, 15}));
}

TEST(Statements, break_in_an_else_leaves_the_rest_to_the_others) {
  EXPECT_EQ(
      over_lanes("uniform int i; for (i = 0; i < 4; i++) { if (x > 3) r += 1; else { r += 10; break; } r += 100; }"),
      (Lanes{10, 10, 10, 10, 404, 404, 404, 404}));
}

TEST(Statements, uniform_break_is_ordinary) {
  EXPECT_EQ(over_lanes("uniform int i; for (i = 0; i < 100; i++) { if (i == 3) break; r += 1; } r += 10 * i;", 2),
            (Lanes{33, 33}));
  EXPECT_EQ(over_lanes("uniform int i = 0; do { i++; if (i % 2 == 0) continue; r += i; } while (i < n);", 1),
            (Lanes{9}));
}

TEST(Statements, inner_loops_keep_the_lanes_of_the_outer) {
  EXPECT_EQ(
      over_lanes("uniform int i, j; for (i = 0; i < 3; i++) { for (j = 0; j < 3; j++) { if (j > x) break; r += 1; } "
                 "if (i == x) break; r += 10; }",
                 4),
      (Lanes{1, 14, 29, 39}));
}

TEST(Statements, functions_return_and_copy_back_under_the_mask) {
  const std::string functions =
      "fixed<16,0> twice(fixed<16,0> a) { return 2 * a; } "
      "void swap(output fixed<16,0> a, output fixed<16,0> b) { fixed<16,0> c = a; a = b; b = c; } ";
  EXPECT_EQ(
      over_lanes("fixed<16,0> a = 1, b = 2; if (x > 1) swap(a, b); r = twice(a) * 10 + twice(twice(b));", 4, functions),
      (Lanes{28, 28, 44, 44}));
}

TEST(Statements, too_many_iterations_are_an_error) {
  EXPECT_THROW(over_lanes("while (true) r += 1;"), Error);
  EXPECT_THROW(over_lanes("uniform int i; for (i = 0; i <= 65536; i++) n;"), Error);
  EXPECT_NO_THROW(over_lanes("uniform int i; for (i = 0; i < 65536; i++) n;", 1));
}

TEST(Lights, three_colors_and_their_defaults) {
  const pfman::ast::Unit unit = parse(
      "light plain(uniform float c = 0.5) { solar ({0, 0, -2}, 0.0) { px_light_color = {c, 1, 100}; } }"
      "light ambient() { px_light_color = {0.25, 0, 0}; }"
      "light near(uniform float p[3] = {0, 0, 2}) { illuminate (p) { px_light_color = {px_light_distance, 0, 0}; "
      "px_light_ambient = {1, 1, 1}; px_light_specular = {0, 0, 0}; } }"
      "light spot() { illuminate ({0, 0, 2}, {0, 0, -1}, 0.5) { px_light_color = {1, 1, 1}; } }");
  const Interpreter interpreter(unit);
  Input input;
  const LightResult plain = interpreter.light("plain", {{"c", {float_bits(2)}}}, input);
  EXPECT_EQ(plain.direction, (RawValues{0, 0, 1u << 14}));
  EXPECT_EQ(plain.color, (RawValues{2u << 12, 1u << 12, 0xFFFF}));
  EXPECT_EQ(plain.specular, plain.color);
  EXPECT_EQ(plain.ambient, (RawValues{0, 0, 0}));
  const LightResult ambient = interpreter.light("ambient", {}, input);
  EXPECT_EQ(ambient.color, (RawValues{0, 0, 0}));
  EXPECT_EQ(ambient.ambient, (RawValues{1u << 10, 0, 0}));
  EXPECT_EQ(ambient.direction, (RawValues{0, 0, 0}));
  const LightResult near = interpreter.light("near", {}, input);
  EXPECT_EQ(near.color, (RawValues{2u << 12, 0, 0}));
  EXPECT_EQ(near.ambient, (RawValues{1u << 12, 1u << 12, 1u << 12}));
  EXPECT_EQ(near.specular, (RawValues{0, 0, 0}));
  EXPECT_EQ(near.direction, (RawValues{0, 0, 1u << 14}));
  input.lanes = 2;
  input.position = {0, float_bits(2), 0, 0, 0, 0};
  EXPECT_EQ(interpreter.light("spot", {}, input).color, (RawValues{4096, 0, 4096, 0, 4096, 0}));
}

TEST(Lights, a_surface_sums_them_within_its_cone) {
  const std::string text =
      "light up() { solar ({0, -1, 0}, 0.0) { px_light_color = {1, 0, 0}; } }"
      "light side() { solar ({-1, 0, 0}, 0.0) { px_light_color = {0, 1, 0}; } }"
      "surface s(output varying float px_shader_color[3], uniform float angle = 1) { float sum[3] = {0, 0, 0}; "
      "illuminance (px_shader_position, {0, 1, 0}, angle) { sum += px_light_color; } "
      "px_shader_color = sum; }";
  const std::string declared = "varying float px_shader_position[3], ";
  std::string with_position = text;
  with_position.insert(with_position.find("uniform float angle"), declared);
  Input input;
  input.lights = {{"up", {}}, {"side", {}}};
  EXPECT_EQ(run(with_position, input).raw, (RawValues{float_bits(1), 0, 0}));
  input.uniform["angle"] = {float_bits(2)};
  EXPECT_EQ(run(with_position, input).raw, (RawValues{float_bits(1), float_bits(1), 0}));
  EXPECT_EQ(run(with_position, input).color, (std::vector<std::uint8_t>{255, 255, 0}));
}

}  // namespace
}  // namespace reference_tests
