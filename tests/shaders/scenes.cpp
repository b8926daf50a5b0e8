#include "tests/shaders/scenes.h"

#include <algorithm>

namespace shader_tests {
namespace {

using pfman::Instance;

pfman::TestView view_of(const std::string& surface) {
  pfman::TestView view;
  if (surface.starts_with("data_") || surface.starts_with("terrain_")) {
    view.shape = pfman::TestShape::Relief;
    view.turn = 25;
    view.tilt = 48;
  }
  if (surface == "bowling_pin") view.shape = pfman::TestShape::Pin;
  if (surface == "volume_wood" || surface == "opengl_surface" || surface == "flat" || surface == "plastic")
    view.shape = pfman::TestShape::Sphere;
  return view;
}

Instance instance_of(const Compiled& compiled) {
  Instance instance(compiled.shader(), 1);
  pfman::TestSurface::make_ordinary(instance);
  const std::string name = compiled.shader().shader->name;
  if (name == "ripple_mirror") instance.set("px_shader_time", {1.25});
  // Many turns of a masked loop take long in the RTL.
  if (name.starts_with("mandelbrot")) instance.set("iterations", {12});
  // Five lights at once are too much for what is bright all over.
  const auto is_rgb = [](const pfman::ShaderParameter& parameter) { return parameter.variable->name == "rgb"; };
  if (std::ranges::any_of(compiled.shader().shader->parameters, is_rgb)) instance.set("rgb", {0.1, 0.15, 0.2});
  if (name == "terrain_gloss" || name == "terrain_lit") instance.set("high_height", {0.3});
  if (name == "opengl_surface") {
    instance.set("px_material_specular", {0.7, 0.6, 0.5});
    instance.set("px_material_shininess", {20});
    instance.set("px_material_emission", {0.02, 0, 0.05});
  }
  return instance;
}

std::vector<std::string> lights_for(const Compiled& surface) {
  if (!surface.shader().code.has_illuminance) return {};
  if (surface.shader().shader->three_colours) return {"opengl_light"};
  return {"point_light", "directional_light", "spot_light", "paned_window", "opengl_light"};
}

Instance light_instance(const Compiled& compiled) {
  const std::string name = compiled.shader().shader->name;
  Instance light(compiled.shader());
  const auto set = [&](const char* parameter, std::vector<double> values) { light.set(parameter, values); };
  if (name == "point_light") {
    set("position", {-1, 1.5, -1.2});
    set("falloff", {0.1});
  } else if (name == "spot_light") {
    set("position", {1, 1, 0});
    set("target", {0, 0, -2.8});
  } else if (name == "directional_light") {
    set("direction", {1, -1, -2});
  } else if (name == "paned_window") {
    set("lamp", {1, 2, 1});
    set("middle", {0.5, 1, -0.8});
  } else if (name == "opengl_light") {
    set("position", {-1, 1, -0.5, 1});
    set("quadratic_attenuation", {0.2});
    set("spot_direction", {0.4, -0.4, -0.8});
    set("spot_cutoff", {60});
    set("spot_exponent", {4});
  }
  return light;
}

}  // namespace

std::vector<std::string> surface_files() {
  std::vector<std::string> names;
  for (const std::string& name : shader_files()) {
    if (!name.ends_with("_light") && name != "paned_window") names.push_back(name);
  }
  return names;
}

Scene make_scene(const std::string& surface, const pfman::Options& options) {
  Scene scene;
  scene.surface = compile(surface, options);
  for (const std::string& name : lights_for(scene.surface)) scene.light_units.push_back(compile(name, options));
  for (const Compiled& unit : scene.light_units) scene.lights.push_back(light_instance(unit));
  scene.instance.push_back(instance_of(scene.surface));
  scene.view = view_of(surface);
  return scene;
}

}  // namespace shader_tests
