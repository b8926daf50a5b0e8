// Mistakes of a program: an Error that says what is wrong, and a context that is as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "tests/interface/drawing.h"
#include "tests/pixelflow_model/seed.h"

namespace interface_tests {
namespace {

using watkins::Binding;
using watkins::Context;
using watkins::LightId;
using watkins::ShaderId;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Mistake {
  const char* name;
  const char* text;  ///< that the message holds
  std::function<void(Context&)> call;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = {
      {"vertex_outside", "vertex outside of begin and end", [](Context& c) { c.vertex(0, 0); }},
      {"end_alone", "end without begin", [](Context& c) { c.end(); }},
      {"polygon_of_two", "three or more vertices, not 2",
       [](Context& c) {
         c.begin();
         c.vertex(0, 0);
         c.vertex(1, 0);
         c.end();
       }},
      {"nan_in_material", "no finite number", [](Context& c) { c.material("px_material_shininess", {kNan}); }},
      {"nan_in_light", "no finite number",
       [](Context& c) {
         c.light(LightId{0}, "diffuse", {0, kNan, 0});
       }},
      {"nan_in_matrix", "no finite number", [](Context& c) { c.translate(0, kNan, 0); }},
      {"infinite_matrix", "no finite number", [](Context& c) { c.scale(kInfinity, 1, 1); }},
      {"infinite_normal", "no finite number", [](Context& c) { c.normal(0, 0, kInfinity); }},
      {"nan_in_texture_coordinates", "no finite number", [](Context& c) { c.tex_coord(kNan); }},
      {"nan_in_colour", "no finite number", [](Context& c) { c.color(kNan, 0, 0); }},
      {"nan_in_background", "from 0 to 1", [](Context& c) { c.background(0, kNan, 0); }},
      {"nan_in_bound", "no finite number",
       [](Context& c) {
         c.bound_material(ShaderId{1}, "shown", {0, kNan, 0});
       }},
      {"too_large_for_the_matrix", "range of numbers",
       [](Context& c) {
         c.push_matrix();
         try {
           c.scale(1e300, 1, 1);
           c.bound_material(ShaderId{1}, "shown", {1e300, 0, 0});
         } catch (const watkins::Error&) {
           c.pop_matrix();
           throw;
         }
       }},
      {"rotation_without_axis", "axis", [](Context& c) { c.rotate(30, 0, 0, 0); }},
      {"unknown_parameter", "'flavour'", [](Context& c) { c.material("flavour", {1}); }},
      {"uniform_parameter", "uniform",
       [](Context& c) {
         c.material("shown", {1, 2, 3});
       }},
      {"wrong_length", "has 2 number(s)",
       [](Context& c) {
         c.material("px_material_diffuse", {1, 2});
       }},
      {"unknown_bound_parameter", "no parameter 'flavour'",
       [](Context& c) { c.bound_material(ShaderId{1}, "flavour", {1}); }},
      {"bound_wrong_length", "has 3 number(s), not 1", [](Context& c) { c.bound_material(ShaderId{1}, "shown", {1}); }},
      {"bound_but_ordinary", "material() sets it",
       [](Context& c) {
         c.bound_material(ShaderId{0}, "px_material_diffuse", {1, 1, 1});
       }},
      {"bound_but_the_machines", "machine's own",
       [](Context& c) {
         c.bound_material(ShaderId{0}, "px_shader_position", {1, 1, 1});
       }},
      {"no_such_shader", "no shader 77", [](Context& c) { c.shader(ShaderId{77}); }},
      {"negative_shader", "no shader -1", [](Context& c) { c.shader(ShaderId{-1}); }},
      {"no_such_light", "no light 8", [](Context& c) { c.enable(LightId{8}); }},
      {"light_parameter", "no parameter 'colour'", [](Context& c) { c.light(LightId{0}, "colour", {1}); }},
      {"no_such_function", "no surface 'velvet' is loaded", [](Context& c) { c.new_shader("velvet"); }},
      {"light_as_surface", "'opengl_light' is no surface", [](Context& c) { c.new_shader("opengl_light"); }},
      {"surface_as_light", "'show' is no light", [](Context& c) { c.new_light("show"); }},
      {"binding_outside", "outside of new_shader",
       [](Context& c) { c.shader_parameter_binding("shade", Binding::Material); }},
      {"end_shader_alone", "end_shader without new_shader", [](Context& c) { c.end_shader(); }},
      {"no_such_file", "cannot read 'nowhere.pfman'", [](Context& c) { c.load_extension_code("nowhere.pfman"); }},
      {"no_such_image", "cannot read 'nowhere.png'", [](Context& c) { c.texture(3, "nowhere.png"); }},
      {"texture_zero", "from 1 to", [](Context& c) { c.texture(0, "nowhere.png"); }},
      {"too_many_pops", "pop_matrix without push_matrix", [](Context& c) { c.pop_matrix(); }},
      {"eye_at_target", "target is its position",
       [](Context& c) {
         c.look_at({1, 1, 1}, {1, 1, 1}, {0, 1, 0});
       }},
      {"up_along_sight", "line of sight",
       [](Context& c) {
         c.look_at({0, 0, 5}, {0, 0, 0}, {0, 0, 1});
       }},
      {"flat_field_of_view", "field_of_view", [](Context& c) { c.perspective(180, 1, 10); }},
      {"near_behind_far", "near must be smaller than far", [](Context& c) { c.perspective(45, 10, 1); }},
      {"no_height", "height must be greater than 0", [](Context& c) { c.orthographic(0, 1, 10); }},
      {"size_zero", "width is from 1", [](Context& c) { c.size(0, 10); }},
      {"size_huge", "height is from 1", [](Context& c) { c.size(10, 1 << 20); }},
      {"no_samples", "samples is from 1 to 64, not 0",
       [](Context& c) {
         watkins::Machine machine = c.machine();
         machine.samples = 0;
         c.machine(machine);
       }},
      {"generator_without_macro", "generator's level",
       [](Context& c) {
         watkins::Machine machine = c.machine();
         machine.generator = watkins::Level::Macro;
         c.machine(machine);
       }},
      {"no_frame_rate", "above 0", [](Context& c) { c.frame_rate(0); }},
      {"bad_matrix_mode", "no such matrix", [](Context& c) { c.matrix_mode(static_cast<watkins::MatrixMode>(9)); }},
  };
  return all;
}

/// A context with the shaders of this folder: instance 1 shows its parameters.
class InterfaceMistakes : public testing::Test {
 protected:
  InterfaceMistakes() : file_("show.pfman", kShowShader) { set_up(context_); }
  void set_up(Context& context) {
    prepare(context);
    context.load_extension_code(file_.path());
    context.new_shader("show");
    context.end_shader();
    context.enable(LightId{0});
  }
  static watkins::Picture draw(Context& context) {
    rectangle(context, -1.5, -1, 0, 1);
    context.shader(ShaderId{1});
    rectangle(context, 0.5, -1, 1.5, 1);
    context.shader(ShaderId{0});
    return context.render();
  }
  TemporaryFile file_;
  Context context_;
};

/// What a call says; an empty text where it says nothing.
std::string said(const std::function<void()>& call) {
  try {
    call();
  } catch (const watkins::Error& error) {
    return error.what();
  }
  return {};
}

TEST_F(InterfaceMistakes, ChangeNothing) {
  Context untouched;
  set_up(untouched);
  const std::vector<float> expected = draw(untouched).colors;
  for (const Mistake& mistake : mistakes()) {
    SCOPED_TRACE(mistake.name);
    const std::string text = said([&] { mistake.call(context_); });
    EXPECT_NE(text.find(mistake.text), std::string::npos) << text;
    EXPECT_EQ(draw(context_).colors, expected);
  }
}

TEST_F(InterfaceMistakes, WithinBeginAndEnd) {
  const std::vector<std::function<void()>> calls = {
      [&] { context_.begin(); },
      [&] { context_.shader(ShaderId{1}); },
      [&] { context_.translate(1, 0, 0); },
      [&] { context_.load_identity(); },
      [&] { context_.push_matrix(); },
      [&] {
        context_.bound_material(ShaderId{1}, "shown", {0, 0, 0});
      },
      [&] {
        context_.light(LightId{0}, "diffuse", {1, 1, 1});
      },
      [&] { context_.enable(LightId{1}); },
      [&] { context_.render(); },
      [&] { context_.vertex(0, kNan); },
      [&] { context_.vertex(kInfinity, 0); },
  };
  context_.begin();
  for (std::size_t k = 0; k < calls.size(); ++k) {
    EXPECT_NE(said(calls[k]), "") << k;
    context_.vertex(k % 2 == 0 ? static_cast<double>(k) / 10 : -1.0, static_cast<double>(k) / 10);
  }
  context_.end();
  EXPECT_EQ(context_.render().width, kWidth);
}

TEST_F(InterfaceMistakes, BoundParametersChangeBetweenFrames) {
  const auto change = [&] { context_.bound_material(ShaderId{1}, "shown", {0.25, 0, 0}); };
  const auto light = [&] { context_.light(LightId{0}, "diffuse", {1, 0, 0}); };
  rectangle(context_, -1, -1, 0, 1);
  EXPECT_EQ(said(change), "");  // the frame does not show it so far
  EXPECT_NE(said(light).find("lights change between frames"), std::string::npos);
  context_.shader(ShaderId{1});
  rectangle(context_, 0, -1, 1, 1);
  EXPECT_NE(said(change).find("bound parameters change between frames"), std::string::npos);
  context_.render();
  EXPECT_EQ(said(change), "");
  EXPECT_EQ(said(light), "");
}

TEST_F(InterfaceMistakes, InstancesAreFinishedFirst) {
  const ShaderId open = context_.new_shader("show");
  EXPECT_NE(said([&] { context_.new_shader("show"); }), "");
  EXPECT_NE(said([&] { context_.shader(open); }), "");
  EXPECT_NE(said([&] { context_.render(); }), "");
  EXPECT_NE(said([&] { context_.shader_parameter_binding("shown", Binding::Material); }).find("uniform"),
            std::string::npos);
  context_.end_shader();
  EXPECT_EQ(said([&] { context_.shader(open); }), "");
}

TEST_F(InterfaceMistakes, OfShadersComeWithTheirPlace) {
  const TemporaryFile bad("bad.pfman", "surface bad(output varying fixed<8,8> px_shader_color[3])\n{\n  foo = 1;\n}\n");
  const std::string text = said([&] { context_.load_extension_code(bad.path()); });
  EXPECT_NE(text.find("bad.pfman:3:3: error: "), std::string::npos) << text;
  const TemporaryFile again("again.pfman", kShowShader);
  EXPECT_NE(said([&] { context_.load_extension_code(again.path()); }).find("'show' is loaded already"),
            std::string::npos);
  EXPECT_EQ(context_.functions().size(), 6u);
}

TEST_F(InterfaceMistakes, ThreeColoursNeedThree) {
  context_.load_extension_code("directional_light.pfman");
  const LightId plain = context_.new_light("directional_light");
  context_.enable(plain);
  rectangle(context_, -1, -1, 1, 1);
  EXPECT_NE(said([&] { context_.render(); }), "");
  // The frame is over, and the next one works.
  context_.disable(plain);
  rectangle(context_, -1, -1, 1, 1);
  EXPECT_EQ(context_.render().counts.polygons, 1);
}

TEST_F(InterfaceMistakes, PlacesOutOfReach) {
  context_.begin();
  context_.vertex(1e200, 0);
  context_.vertex(1e200, 1e200);
  context_.vertex(-1e200, 1e200);
  context_.end();
  EXPECT_NE(said([&] { context_.render(); }).find("range of numbers"), std::string::npos);
  EXPECT_EQ(context_.render().counts.polygons, 0);
}

/// Calls in no order, with numbers of all kinds: nothing but Errors, and pictures of the right size.
TEST_F(InterfaceMistakes, RandomCalls) {
  const std::uint64_t seed = pixelflow_tests::seed_or(40);
  SCOPED_TRACE(pixelflow_tests::replay(seed));
  std::mt19937_64 random(seed);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto number = [&]() -> double {
    static const double odd[] = {kNan, kInfinity, -kInfinity, 1e308, -1e-308, 1e30, 0.0, -0.0};
    if (pick(40) == 0) return odd[pick(8)];
    return static_cast<double>(pick(4001) - 2000) / 1000;
  };
  const std::vector<std::string> names = {"px_material_normal", "px_material_diffuse", "shade", "shown", "image",
                                          "px_shader_texcoord", "scene_ambient",       "none",  ""};
  const auto values = [&] {
    watkins::Values result;
    for (int n = pick(5); n > 0; --n) result.push_back(number());
    return result;
  };
  const auto name = [&] { return names[static_cast<std::size_t>(pick(static_cast<int>(names.size())))]; };
  const std::vector<std::string> functions = {"show", "look_up", "show_texture_coordinates", "opengl_surface", "x"};
  context_.size(16, 12);
  const std::vector<std::function<void()>> calls = {
      [&] { context_.begin(); },
      [&] { context_.vertex(number(), number(), number()); },
      [&] { context_.vertex(number(), number(), number()); },
      [&] { context_.vertex(number(), number(), number()); },
      [&] { context_.vertex(number(), number(), number()); },
      [&] { context_.vertex(number(), number(), number()); },
      [&] { context_.end(); },
      [&] { context_.end(); },
      [&] { context_.normal(number(), number(), number()); },
      [&] { context_.tex_coord(number(), number(), number(), number()); },
      [&] { context_.color(number(), number(), number()); },
      [&] { context_.material(name(), values()); },
      [&] { context_.bound_material(ShaderId{pick(6) - 1}, name(), values()); },
      [&] { context_.shader(ShaderId{pick(6) - 1}); },
      [&] { context_.new_shader(functions[static_cast<std::size_t>(pick(5))]); },
      [&] { context_.shader_parameter_binding(name(), static_cast<Binding>(pick(3))); },
      [&] { context_.end_shader(); },
      [&] { context_.light(LightId{pick(10)}, pick(2) ? "position" : "diffuse", values()); },
      [&] { context_.enable(LightId{pick(10)}); },
      [&] { context_.disable(LightId{pick(10)}); },
      [&] { context_.new_light(pick(2) ? "opengl_light" : "show"); },
      [&] { context_.rotate(number() * 100, number(), number(), number()); },
      [&] { context_.translate(number(), number(), number()); },
      [&] { context_.scale(number(), number(), number()); },
      [&] { context_.push_matrix(); },
      [&] { context_.pop_matrix(); },
      [&] { context_.load_identity(); },
      [&] { context_.matrix_mode(static_cast<watkins::MatrixMode>(pick(3))); },
      [&] {
        context_.look_at({number(), number(), number()}, {number(), number(), number()}, {0, 1, 0});
      },
      [&] { context_.perspective(number() * 60, number(), number() * 10); },
      [&] { context_.orthographic(number(), number(), number() * 10); },
      [&] { context_.background(number(), number(), number()); },
      [&] { context_.frame_rate(number()); },
      [&] { context_.frame(static_cast<int>(random())); },
  };
  int pictures = 0, polygons = 0, errors = 0;
  for (int step = 0; step < 20000; ++step) {
    const bool render = pick(400) == 0;
    try {
      if (render) {
        const watkins::Picture picture = context_.render();
        ++pictures;
        polygons += static_cast<int>(picture.counts.polygons);
        ASSERT_EQ(picture.bytes().size(), 16u * 12 * 3);
      } else {
        calls[static_cast<std::size_t>(pick(static_cast<int>(calls.size())))]();
      }
    } catch (const watkins::Error& error) {
      ASSERT_NE(std::string(error.what()), "");
      ++errors;
    }
  }
  EXPECT_GT(pictures, 3);
  EXPECT_GT(polygons, 0);
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace interface_tests
