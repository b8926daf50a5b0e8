// Common lighting and texturing: as if the code stood in the shader.
#include <gtest/gtest.h>

#include "tests/pfman_check/checked.h"

namespace {

using pfman_tests::Checked;

const std::string kParameters =
    "(output varying fixed<8,8> px_shader_color[3], varying unit float px_material_normal[3],\n"
    " varying float px_shader_view[3], varying float px_shader_texcoord[2])\n";

TEST(pfman_check, shared_phong_and_texture_are_the_code_written_out) {
  const Checked shared("#pragma pfman shared_phong\n#pragma pfman shared_texture\nsurface s" + kParameters + R"({
    px_magic_texid = 3;
    px_magic_texcoord = px_shader_texcoord;
    px_magic_kd = { px_magic_texel[0], px_magic_texel[1], px_magic_texel[2] };
    px_magic_ks = { 0.5, 0.5, 0.5 };
    px_magic_exp = 16;
    px_shader_color = px_magic_diffuse + px_magic_highlight;
})");
  std::string written = "surface s" + kParameters + R"({
    float kd[3], ks[3], exp, diffuse[3], highlight[3];
    uniform int texid;
    float texcoord[2];
    fixed<8,8> texel[4];
    texid = 3;
    texcoord = px_shader_texcoord;
    texel = texture4(texid, texcoord[0], texcoord[1]);
    kd = { texel[0], texel[1], texel[2] };
    ks = { 0.5, 0.5, 0.5 };
    exp = 16;
    diffuse = { 0, 0, 0 };
    highlight = { 0, 0, 0 };
    illuminance () {
        float facing = dot(px_material_normal, px_light_direction);
        if (facing > 0) {
            diffuse += kd * facing * px_light_color;
            float halfway[3] = normalize(px_light_direction - px_shader_view);
            float shine = pow(max(dot(px_material_normal, halfway), 0), exp);
            highlight += ks * shine * px_light_color;
        }
    }
    px_shader_color = diffuse + highlight;
})";
  const Checked unit(written);
  EXPECT_EQ(shared.messages(), "");
  EXPECT_EQ(unit.messages(), "");
  std::string text = shared.statements("s");
  for (std::size_t at = text.find("px_magic_"); at != std::string::npos; at = text.find("px_magic_")) text.erase(at, 9);
  EXPECT_EQ(text, unit.statements("s"));
  EXPECT_TRUE(shared.shader("s").shared_phong);
  EXPECT_TRUE(shared.shader("s").shared_texture);
}

/// Where the result is named behind the lights only, the lookup is made before them all the same.
TEST(pfman_check, shared_texture_stands_before_the_illuminance) {
  const std::string flag = "#pragma pfman shared_texture\n", lookup = "texture4(";
  const Checked own(flag +
                    R"(surface s(output varying fixed<8,8> px_shader_color[3], varying float px_shader_texcoord[2])
{
    px_magic_texid = 3;
    px_magic_texcoord = px_shader_texcoord;
    fixed<16,12> sum[3] = { 0, 0, 0 };
    illuminance () { sum = px_light_color; }
    px_shader_color = { px_magic_texel[0] * sum[0], 0, 0 };
})");
  EXPECT_EQ(own.messages(), "");
  EXPECT_LT(own.statements("s").find(lookup), own.statements("s").find("illuminance"));
  const Checked phong(flag + "#pragma pfman shared_phong\nsurface s" + kParameters + R"({
    px_magic_texid = 3;
    px_magic_texcoord = px_shader_texcoord;
    px_magic_kd = px_magic_ks = { 1, 1, 1 };
    px_magic_exp = 2;
    float lit[3] = px_magic_diffuse + px_magic_highlight;
    px_shader_color = { px_magic_texel[0] * lit[0], 0, 0 };
})");
  EXPECT_LT(phong.statements("s").find(lookup), phong.statements("s").find("illuminance"));
}

TEST(pfman_check, shared_results_that_nobody_reads_cost_nothing) {
  const Checked unit(
      "#pragma pfman shared_phong\nsurface s(output varying fixed<8,8> px_shader_color[3]) { px_magic_exp = 1; }");
  EXPECT_EQ(unit.messages(), "");
  EXPECT_EQ(unit.statements("s").find("illuminance"), std::string::npos);
}

TEST(pfman_check, flags_belong_to_the_surface_around_or_behind_them) {
  const std::string head = "(output varying fixed<8,8> px_shader_color[3])\n{\n";
  const std::string body = "px_shader_color = { 0, 0, 0 };\n}\n";
  const Checked unit("surface a" + head + "#pragma pfman shared_phong\n" + body +
                     "#pragma pfman shared_texture\nsurface b" + head + body + "surface c" + head + body +
                     "#pragma pfman shared_phong\n");
  EXPECT_EQ(unit.messages(), "");
  EXPECT_TRUE(unit.shader("a").shared_phong);
  EXPECT_FALSE(unit.shader("a").shared_texture);
  EXPECT_TRUE(unit.shader("b").shared_texture);
  EXPECT_FALSE(unit.shader("b").shared_phong);
  EXPECT_TRUE(unit.shader("c").shared_phong);
}

TEST(pfman_check, shared_lighting_excludes_an_illuminance) {
  const Checked unit("surface s" + kParameters + R"({
#pragma pfman shared_phong
    px_magic_kd = px_magic_ks = { px_shader_texcoord[0], 0, 0 };
    px_magic_exp = 1;
    px_magic_diffuse[0] = 1;
    illuminance () { }
})");
  EXPECT_EQ(unit.messages(),
            "t.pfman:7:25: error: cannot assign to the shared result 'px_magic_diffuse' [E306]\n"
            "t.pfman:8:5: error: a surface has one 'illuminance' at most [E401]\n");
}

}  // namespace
