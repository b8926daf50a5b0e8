// The rules of a context's state: what a call changes, and for how long. Colours are worked out by hand; a shader's
// fixed<8,8> makes 256 v, rounded down, of a value v.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/interface/drawing.h"

namespace interface_tests {
namespace {

using watkins::Binding;
using watkins::Context;
using watkins::LightId;
using watkins::Picture;

constexpr Rgb kBlack{0, 0, 0};

/// A context with the shaders of this folder.
class InterfaceState : public testing::Test {
 protected:
  InterfaceState() : file_("show.pfman", kShowShader) {
    prepare(context_);
    context_.load_extension_code(file_.path());
  }
  Rgb middle(const Picture& picture) { return at(picture, 0.05, 0.05); }
  Picture whole() {
    rectangle(context_, -1.5, -1, 1.5, 1);
    return context_.render();
  }
  TemporaryFile file_;
  Context context_;
};

TEST_F(InterfaceState, DefaultSurfaceIsOpengl) {
  // The first light shines along the line of sight: 0.2 * 0.2 + 0.8 * 1 = 0.84.
  context_.enable(LightId{0});
  EXPECT_NEAR(middle(whole())[0], 0.84 * 256, 1.5);
  context_.disable(LightId{0});
  EXPECT_NEAR(middle(whole())[0], 0.04 * 256, 1.5);
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {1, 0.5, 0});
  const Rgb ambient = middle(whole());
  EXPECT_NEAR(ambient[0], 0.2 * 256, 1.5);
  EXPECT_NEAR(ambient[1], 0.1 * 256, 1.5);
  EXPECT_EQ(ambient[2], 0);
  EXPECT_EQ(at(whole(), 1.8, 1.3), kBlack);
}

TEST_F(InterfaceState, OnlyTheFirstLightIsWhite) {
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {0, 0, 0});
  context_.enable(LightId{7});
  EXPECT_EQ(middle(whole()), kBlack);
  context_.light(LightId{7}, "diffuse", {0, 1, 0});
  const Rgb green = middle(whole());
  EXPECT_EQ(green[0], 0);
  EXPECT_NEAR(green[1], 0.8 * 256, 1.5);
}

TEST_F(InterfaceState, LightsBeyondEight) {
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {0, 0, 0});
  context_.load_extension_code("directional_light.pfman");
  context_.load_extension_code("opengl_light.pfman");  // is there: nothing happens
  EXPECT_EQ(static_cast<int>(context_.new_light("opengl_light")), 8);
  const LightId ninth{8}, tenth = context_.new_light("opengl_light");
  EXPECT_EQ(static_cast<int>(tenth), 9);
  context_.light(ninth, "diffuse", {0.5, 0, 0});
  context_.light(tenth, "diffuse", {0.25, 0, 1});
  EXPECT_EQ(middle(whole()), kBlack);  // off at first
  context_.enable(ninth);
  EXPECT_NEAR(middle(whole())[0], 0.4 * 256, 1.5);
  context_.enable(tenth);
  const Rgb both = middle(whole());
  EXPECT_NEAR(both[0], 0.6 * 256, 1.5);
  EXPECT_NEAR(both[2], 0.8 * 256, 1.5);
}

TEST_F(InterfaceState, LightsGoThroughTheMatrixWhenTheyAreSet) {
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {0, 0, 0});
  context_.enable(LightId{0});
  context_.push_matrix();
  context_.rotate(60, 0, 1, 0);
  context_.light(LightId{0}, "position", {0, 0, 1, 0});
  context_.pop_matrix();
  EXPECT_NEAR(middle(whole())[0], 0.8 * 0.5 * 256, 2.5);
  context_.translate(0.25, 0, 0);  // too late for the light
  EXPECT_NEAR(middle(whole())[0], 0.8 * 0.5 * 256, 2.5);
}

TEST_F(InterfaceState, BoundValuesGoThroughTheMatrixWhenTheyAreSet) {
  const watkins::ShaderId show = context_.new_shader("show");
  context_.scale(2, 1, 0.5);
  context_.bound_material(show, "shown", {0.125, 0.25, 0.5});
  context_.end_shader();
  context_.load_identity();
  context_.shader(show);
  EXPECT_EQ(middle(whole()), (Rgb{192, 192, 192}));
  context_.bound_material(show, "shown", {0.125, 0.25, 0.375});
  EXPECT_EQ(middle(whole()), (Rgb{160, 192, 224}));
}

TEST_F(InterfaceState, OrdinaryParametersVaryOverAPolygon) {
  const watkins::ShaderId bound = context_.new_shader("show");
  context_.end_shader();
  const watkins::ShaderId ordinary = context_.new_shader("show");
  context_.shader_parameter_binding("shade", Binding::Material);
  context_.end_shader();

  const auto draw = [&] {
    context_.begin();
    context_.material("shade", {0});
    context_.vertex(-1.5, -1);
    context_.material("shade", {0.75});
    context_.vertex(1.5, -1);
    context_.vertex(1.5, 1);
    context_.material("shade", {0});
    context_.vertex(-1.5, 1);
    context_.end();
    return context_.render();
  };
  context_.shader(bound);
  const Picture same = draw();
  for (const double x : {-1.25, 0.0, 1.25}) EXPECT_EQ(at(same, x, 0.5), (Rgb{128, 128, 128}));
  context_.shader(ordinary);
  const Picture varied = draw();
  for (int column = 10; column < 54; ++column) {
    const double x = (column + 0.5) / kWidth * 4 - 2;
    EXPECT_NEAR(at(varied, x, 0.5)[0], (x + 1.5) / 3 * 0.75 * 256, 1.0) << column;
  }
}

TEST_F(InterfaceState, ValuesStayAndPolygonsGo) {
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {0, 0, 0});
  context_.enable(LightId{0});
  context_.color(0.25, 0.5, 0.75);
  const Picture first = whole();
  EXPECT_NEAR(middle(first)[2], 0.75 * 256, 1.5);
  EXPECT_EQ(middle(context_.render()), kBlack);
  EXPECT_EQ(whole().colors, first.colors);
  context_.background(0, 0, 1);
  EXPECT_EQ(middle(context_.render()), (Rgb{0, 0, 255}));
}

TEST_F(InterfaceState, FramesReuseStreams) {
  context_.enable(LightId{0});
  const Picture first = whole();
  EXPECT_GT(first.counts.streams_made, 0);
  const Picture second = whole();
  EXPECT_EQ(second.counts.streams_made, 0);
  EXPECT_GT(second.counts.streams_reused, 0);
  EXPECT_EQ(second.colors, first.colors);

  // Another bound value: what depends on it is made anew, and only that.
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {1, 1, 1});
  const Picture third = whole();
  EXPECT_GT(third.counts.streams_made, 0);
  EXPECT_LT(third.counts.streams_made, first.counts.streams_made);
  EXPECT_NE(third.colors, first.colors);
  context_.size(kWidth / 2, kHeight / 2);
  EXPECT_EQ(whole().width, kWidth / 2);
}

TEST_F(InterfaceState, MatricesMoveVertices) {
  const auto square = [&] { rectangle(context_, 0.75, -0.25, 1.25, 0.25); };
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {4, 4, 4});
  square();
  Picture picture = context_.render();
  EXPECT_NE(at(picture, 1, 0), kBlack);
  EXPECT_EQ(at(picture, 0, 1), kBlack);

  context_.push_matrix();
  context_.rotate(90, 0, 0, 2);
  square();
  context_.pop_matrix();
  picture = context_.render();
  EXPECT_EQ(at(picture, 1, 0), kBlack);
  EXPECT_NE(at(picture, 0, 1), kBlack);

  // The last matrix acts first.
  context_.push_matrix();
  context_.translate(-1, 0, 0);
  context_.scale(0.5, 1, 1);
  square();
  context_.pop_matrix();
  picture = context_.render();
  EXPECT_NE(at(picture, -0.5, 0), kBlack);
  EXPECT_EQ(at(picture, 0, 0), kBlack);

  context_.load_matrix({0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});  // a quarter turn, column by column
  context_.multiply_matrix({-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  square();
  picture = context_.render();
  EXPECT_NE(at(picture, 0, -1), kBlack);
  EXPECT_EQ(at(picture, 0, 1), kBlack);
}

TEST_F(InterfaceState, PolygonsAreSeenFromTheFront) {
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {4, 4, 4});
  context_.scale(-1, 1, 1);
  EXPECT_EQ(middle(whole()), kBlack);
  context_.scale(1, -1, 1);
  EXPECT_NE(middle(whole()), kBlack);
}

TEST_F(InterfaceState, NormalsStandOnScaledSurfaces) {
  context_.enable(LightId{0});
  context_.light(LightId{0}, "position", {1, 2, 4, 0});
  context_.push_matrix();
  context_.scale(0.5, 2, 4);
  context_.normal(1, 1, 2);
  rectangle(context_, -2, -0.5, 2, 0.5);
  context_.pop_matrix();
  const Picture scaled = context_.render();
  context_.normal(2, 0.5, 0.5);
  rectangle(context_, -1, -1, 1, 1);
  const Picture direct = context_.render();
  EXPECT_EQ(scaled.colors, direct.colors);
  context_.normal(0.5, 2, 8);  // as if a normal were a vector
  rectangle(context_, -1, -1, 1, 1);
  EXPECT_NE(scaled.colors, context_.render().colors);
}

TEST_F(InterfaceState, TextureMatrix) {
  const watkins::ShaderId show = context_.new_shader("show_texture_coordinates");
  context_.end_shader();
  context_.shader(show);
  Rgb colour = middle(whole());
  EXPECT_NEAR(colour[0], 128, 5);
  EXPECT_EQ(colour[2], 0);
  context_.matrix_mode(watkins::MatrixMode::Texture);
  context_.translate(0.25, -0.25, 0.5);
  context_.matrix_mode(watkins::MatrixMode::Model);
  colour = middle(whole());
  EXPECT_NEAR(colour[0], 192, 5);
  EXPECT_NEAR(colour[1], 64, 5);
  EXPECT_EQ(colour[2], 128);
}

TEST_F(InterfaceState, TexturesByNumber) {
  std::string image = "P6\n8 8\n255\n";
  for (int k = 0; k < 64; ++k) image += std::string("\x20\x80\xF0", 3);
  const TemporaryFile one("one.ppm", image);
  for (std::size_t k = 11; k < image.size(); k += 3) image[k] = '\x60';
  const TemporaryFile two("two.ppm", image);
  context_.texture(40, one.path());
  context_.texture(17, two.path());
  const watkins::ShaderId look_up = context_.new_shader("look_up");
  context_.bound_material(look_up, "image", {40});
  context_.end_shader();
  context_.shader(look_up);
  EXPECT_EQ(middle(whole()), (Rgb{0x20, 0x80, 0xF0}));
  context_.bound_material(look_up, "image", {17});
  EXPECT_EQ(middle(whole()), (Rgb{0x60, 0x80, 0xF0}));
  context_.texture(17, one.path());
  EXPECT_EQ(middle(whole()), (Rgb{0x20, 0x80, 0xF0}));
}

TEST_F(InterfaceState, TimeIsTheFrameOverTheRate) {
  const watkins::ShaderId show = context_.new_shader("show_time");
  context_.end_shader();
  context_.shader(show);
  context_.frame_rate(8);
  EXPECT_EQ(middle(whole())[0], 32);
  EXPECT_EQ(middle(whole())[0], 64);
  context_.frame(5);
  EXPECT_EQ(middle(whole())[0], 160);
}

TEST_F(InterfaceState, BoundStandardParameters) {
  context_.enable(LightId{0});
  context_.bound_material(watkins::kOpenGlShader, "scene_ambient", {0, 0, 0});
  const watkins::ShaderId painted = context_.new_shader("opengl_surface");
  context_.shader_parameter_binding("px_material_diffuse", Binding::BoundMaterial);
  context_.bound_material(painted, "px_material_diffuse", {0.5, 0, 0});
  context_.bound_material(painted, "scene_ambient", {0, 0, 0});
  context_.end_shader();
  context_.color(0, 1, 0);
  context_.shader(painted);
  const Rgb colour = middle(whole());
  EXPECT_NEAR(colour[0], 128, 1.5);
  EXPECT_EQ(colour[1], 0);
}

TEST_F(InterfaceState, InstancesOfOneFunction) {
  const watkins::ShaderId left = context_.new_shader("show");
  context_.bound_material(left, "shown", {0.25, 0, 0});
  context_.end_shader();
  const watkins::ShaderId right = context_.new_shader("show");
  context_.bound_material(right, "shown", {0, 0.25, 0});
  context_.end_shader();
  for (const double shift : {-1.0, 0.5}) {
    context_.shader(shift < 0 ? left : right);
    rectangle(context_, shift, -1, shift + 0.5, 0);
    rectangle(context_, shift, 0, shift + 0.5, 1);
  }
  const Picture picture = context_.render();
  EXPECT_EQ(at(picture, -0.75, 0.5), (Rgb{192, 128, 128}));
  EXPECT_EQ(at(picture, 0.75, -0.5), (Rgb{128, 192, 128}));
  EXPECT_EQ(picture.counts.polygons, 4);
}

TEST_F(InterfaceState, Introspection) {
  Context fresh;
  ASSERT_EQ(fresh.functions().size(), 2u);
  EXPECT_EQ(fresh.functions()[0].name, "opengl_surface");
  EXPECT_TRUE(fresh.functions()[1].is_light);
  const auto loaded = fresh.load_extension_code("simple_brick.pfman");
  ASSERT_EQ(loaded.size(), 1u);
  EXPECT_EQ(loaded[0].name, "simple_brick");
  ASSERT_EQ(loaded[0].parameters.size(), 8u);  // the result is none
  const watkins::Parameter& normal = loaded[0].parameters[0];
  EXPECT_EQ(normal.name, "px_material_normal");
  EXPECT_TRUE(normal.varying);
  EXPECT_EQ(normal.count, 3);
  EXPECT_TRUE(normal.defaults.empty());
  const watkins::Parameter& width = loaded[0].parameters[2];
  EXPECT_EQ(width.name, "width");
  EXPECT_EQ(width.type, "float");
  EXPECT_FALSE(width.varying);
  EXPECT_EQ(width.defaults, watkins::Values{0.25});
  const watkins::Parameter& mortar = loaded[0].parameters[6];
  EXPECT_EQ(mortar.name, "mortar_color");
  EXPECT_EQ(mortar.type, "fixed<8,8>[3]");
  EXPECT_NEAR(mortar.defaults.at(1), 0.70, 1.0 / 256);
  // The view is made of the position.
  const watkins::Function surface = fresh.functions()[0];
  for (const watkins::Parameter& parameter : surface.parameters) {
    EXPECT_EQ(parameter.giver == watkins::Giver::Machine, parameter.name == "px_shader_position") << parameter.name;
  }
  EXPECT_EQ(fresh.load_extension_code("simple_brick.pfman").size(), 1u);
  EXPECT_EQ(fresh.functions().size(), 3u);
}

}  // namespace
}  // namespace interface_tests
