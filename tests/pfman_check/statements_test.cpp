// Statements, parameters and functions as trees.
#include <gtest/gtest.h>

#include "tests/pfman_check/checked.h"

namespace {

using pfman_tests::Checked;
using pfman_tests::surface;

TEST(pfman_check, jumps_are_masked_under_varying_conditions_of_their_loop) {
  const Checked unit(surface(R"(
    float v = 1;
    uniform int i;
    for (i = 0; i < 3; i++) {
      if (i == 1) continue;
      if (v > 1) { if (i > 1) break; }
    }
    if (v > 2) {
      while (true) break;
    })"));
  EXPECT_EQ(unit.statements("s"), R"(v = 1
declare i
i = 0
while with masked breaks (i < 3)
  if (i == 1)
    continue
  if masked (1 < v)
    if (1 < i)
      masked break
step
  i++ = int((i + 1))
if masked (2 < v)
  while 1
    break
)");
  EXPECT_EQ(unit.messages(), "");
}

TEST(pfman_check, comparisons_are_less_or_less_equal) {
  const Checked unit(surface("float a = 1, b = 2; bool c = a > b || a >= b && a != b;"));
  EXPECT_EQ(unit.statements("s"), "a = 1\nb = 2\nc = ((b < a) || ((b <= a) && (a != b)))\n");
}

TEST(pfman_check, assignments_convert_their_values) {
  const Checked unit(surface(R"(
    fixed<8,4> a = 1.5;
    float f = a;
    a = f;
    a *= 2;
    a++;
    bool b = a;
    float v[2] = { a, f };
    v[1] -= a;)"));
  EXPECT_EQ(unit.statements("s"), R"(a = 1.5
f = float(a)
a = fixed<8,4>(f)
a = fixed<8,4>((a * 2))
a++ = fixed<8,4>((a + 1))
b = bool(a)
v = {float(a), f}
v[1] = (v[1] - float(a))
)");
}

TEST(pfman_check, literals_are_folded_and_typed) {
  const Checked unit(surface(R"(
    const int n = 3;
    float a = 1 / 4 + 2 * 3;
    fixed<8,8> b = a < 1 ? 1.0 / 3 : 0;
    fixed<8,0> c = -7 % 4 + (6 >> 1 | 8);
    c = c << n;
    float v[n * 2];
    v[n - 1] = 1.0f;
    bool d = 2 > 1 && !0;)"));
  EXPECT_EQ(unit.statements("s"), R"(n = 3
a = 6.25
b = fixed<8,8>(((a < 1) ? 0.333328 : 0))
c = 12
c = fixed<8,0>((c << 3))
declare v
v[2] = 1
d = 1
)");
}

TEST(pfman_check, unit_parameters_are_normalised_where_they_are_used) {
  const std::string parameters =
      "varying unit float px_material_normal[3]; uniform unit signed fixed<8,6> a[2] = { 1, 0 }; "
      "varying unit float px_material_diffuse[3]; varying fixed<8,0> px_shader_position[3]; uniform float "
      "px_shader_eye[3]";
  const Checked unit(
      surface("float x = px_material_normal[0] + a[1] + px_shader_position[2] + px_shader_eye[0];", parameters));
  EXPECT_EQ(unit.statements("s"), R"(px_shader_position = fixed<8,0>(px_shader_position)
px_shader_eye = {0, 0, 0}
px_material_normal = (v1 = sqrt((((px_material_normal[0] * px_material_normal[0]) + (px_material_normal[1] * px_material_normal[1])) + (px_material_normal[2] * px_material_normal[2]))), ((v1 != 0) ? (px_material_normal / v1) : {0, 0, 0}))
a = signed fixed<8,6>((v2 = float(a), v3 = sqrt(((v2[0] * v2[0]) + (v2[1] * v2[1]))), ((v3 != 0) ? (v2 / v3) : {0, 0})))
x = (((px_material_normal[0] + float(a[1])) + float(px_shader_position[2])) + px_shader_eye[0])
)");
  for (const auto& parameter : unit.shader("s").parameters) {
    EXPECT_EQ(parameter.used, parameter.variable->name != "px_material_diffuse") << parameter.variable->name;
  }
}

TEST(pfman_check, functions_stand_after_those_that_they_call) {
  const Checked unit(
      "float a(float x) { return b(x) + c(x); }\nfloat b(float x) { return c(x); }\n"
      "float c(float x) { return d(x); }\nextern \"dee\" float d(float x);\n");
  std::string order;
  for (const auto& function : unit.tree().functions) order += function->name;
  EXPECT_EQ(order, "dcba");
  EXPECT_TRUE(unit.function("d").is_external);
  EXPECT_EQ(unit.function("d").linkage, "dee");
  EXPECT_EQ(pfman_tests::formula(*unit.function("a").value), "(b(x) + c(x))");
}

TEST(pfman_check, outputs_of_another_type_pass_through_variables_of_their_own) {
  const Checked unit("void f(output float x; output fixed<8,0> n) { x = n; }\n" +
                     surface("fixed<8,4> a = 1; fixed<8,0> b[2] = { 1, 2 }; f(a, b[1]);"));
  EXPECT_EQ(unit.statements("s"), "a = 1\nb = {1, 2}\n(v1 = float(a), f(v1, b[1]), a = fixed<8,4>(v1))\n");
}

TEST(pfman_check, elements_of_expressions_are_expressions_of_elements) {
  const Checked unit(surface(R"(
    float v[3] = { 1, 2, 3 };
    uniform int i = 1;
    float a = (v * 2 + v)[2] + { 4, 5, 6 } [1] + (-v)[i];
    a = { a, 1, 2 } [i];)"));
  EXPECT_EQ(unit.statements("s"), R"(v = {1, 2, 3}
i = 1
a = ((((v[2] * 2) + v[2]) + 5) + -v[i])
a = (v1 = {a, 1, 2}, v1[i])
)");
}

TEST(pfman_check, indices_with_effects_are_evaluated_once) {
  const Checked unit(surface("float v[3] = { 1, 2, 3 }; uniform int i = 0; v[i++] += 1;"));
  EXPECT_EQ(unit.statements("s"), "v = {1, 2, 3}\ni = 0\n(v1 = i++ = int((i + 1)), v[v1] = (v[v1] + 1))\n");
}

}  // namespace
