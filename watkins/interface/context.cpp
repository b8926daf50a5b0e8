#include "watkins/context.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "scanline/camera.h"
#include "scanline/scene_frame.h"
#include "watkins/interface/context_state.h"

namespace watkins {
namespace {

constexpr int kMostTextures = 65535;
constexpr std::size_t kMostShaders = 65535;  // two bytes of shader ID
constexpr std::size_t kMostLights = 4096;

void check_finite(std::initializer_list<double> numbers, const char* call) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw Error(std::string(call) + ": a value is no finite number");
  }
}

void check_range(int value, int low, int high, const char* what) {
  if (value >= low && value <= high) return;
  throw Error(std::string(what) + " is from " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
              std::to_string(value));
}

glm::dvec3 vector(const std::array<double, 3>& v, const char* call) {
  check_finite({v[0], v[1], v[2]}, call);
  return {v[0], v[1], v[2]};
}

glm::dmat4 matrix(const std::array<double, 16>& numbers) {
  glm::dmat4 result;
  for (int k = 0; k < 16; ++k) result[k / 4][k % 4] = numbers[static_cast<std::size_t>(k)];
  return result;
}

void set_camera(scanline::Camera& camera, const scanline::Camera& wanted) {
  const std::string fault = scanline::camera_fault(wanted);
  if (!fault.empty()) throw Error(fault);
  camera = wanted;
}

}  // namespace

Context::State::State() {
  library.load("opengl_surface.pfman");
  library.load("opengl_light.pfman");
  shaders.emplace_back(library.find("opengl_surface", false));
  lights.assign(kFirstLights, {&library.find("opengl_light", true), {}, false});
  // All but the first are black until they are set.
  for (std::size_t k = 1; k < lights.size(); ++k) {
    lights[k].values = {{"diffuse", {0, 0, 0}}, {"specular", {0, 0, 0}}};
  }
  if (!watkins::has_rtl()) machine.generator = machine.pixels = Level::Model;
}

std::size_t Context::State::index(ShaderId id) const {
  const auto number = static_cast<std::size_t>(id);
  if (number >= shaders.size()) throw Error("there is no shader " + std::to_string(static_cast<int>(id)));
  return number;
}

LightInstance& Context::State::at(LightId id) {
  const auto number = static_cast<std::size_t>(id);
  if (number >= lights.size()) throw Error("there is no light " + std::to_string(static_cast<int>(id)));
  return lights[number];
}

void Context::State::check_outside(const char* call) const {
  if (polygons.is_open()) throw Error(std::string(call) + " within begin and end");
}

void Context::State::check_between_frames(const char* call) const {
  if (polygons.is_open() || !polygons.empty()) {
    throw Error(std::string(call) + ": the frame has polygons already, and lights change between frames");
  }
}

Context::Context() : state_(std::make_unique<State>()) {}
Context::~Context() = default;

bool Context::has_rtl() { return watkins::has_rtl(); }

Machine Context::machine() const { return state_->machine; }

void Context::machine(const Machine& machine) {
  check_range(static_cast<int>(machine.generator), 1, 2, "the generator's level (Model, Rtl)");
  check_range(static_cast<int>(machine.pixels), 0, 2, "the pixel processors' level (Macro, Model, Rtl)");
  if (!has_rtl() && (machine.generator == Level::Rtl || machine.pixels == Level::Rtl)) {
    throw Error("this library has no RTL");
  }
  check_range(machine.samples, 1, kMostSamples, "samples");
  check_range(machine.threads, 1, kMostThreads, "threads");
  check_range(machine.rendering_nodes, 1, kMostRenderingNodes, "rendering_nodes");
  check_range(machine.shading_nodes, 1, kMostShadingNodes, "shading_nodes");
  state_->machine = machine;
}

void Context::size(int width, int height) {
  check_range(width, 1, scanline::kMostPictureWidth, "a picture's width");
  check_range(height, 1, scanline::kMostPictureHeight, "a picture's height");
  state_->scene.width = width;
  state_->scene.height = height;
}

void Context::background(double r, double g, double b) {
  for (const double value : {r, g, b}) {
    if (!(value >= 0 && value <= 1)) throw Error("background: colours are from 0 to 1");
  }
  state_->scene.background = {r, g, b};
}

std::vector<Function> Context::load_extension_code(const std::string& file) {
  std::vector<Function> result;
  try {
    for (const LoadedFunction* function : state_->library.load(file)) result.push_back(function->said());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // a default value that cannot be worked out
    throw Error("'" + file + "': " + error.what());
  }
  return result;
}

std::vector<Function> Context::functions() const {
  std::vector<Function> result;
  for (const auto& function : state_->library.functions()) result.push_back(function->said());
  return result;
}

ShaderId Context::new_shader(const std::string& function) {
  if (state_->defining) throw Error("new_shader before end_shader");
  if (state_->shaders.size() == kMostShaders)
    throw Error("there are " + std::to_string(kMostShaders) + " shaders already");
  state_->shaders.emplace_back(state_->library.find(function, false));
  state_->defining = true;
  return static_cast<ShaderId>(state_->shaders.size() - 1);
}

void Context::shader_parameter_binding(const std::string& parameter, Binding binding) {
  if (!state_->defining) throw Error("shader_parameter_binding outside of new_shader and end_shader");
  state_->shaders.back().set_binding(parameter, binding);
}

void Context::end_shader() {
  if (!state_->defining) throw Error("end_shader without new_shader");
  state_->defining = false;
}

void Context::bound_material(ShaderId shader, const std::string& parameter, const Values& values) {
  state_->check_outside("bound_material");
  const std::size_t index = state_->index(shader);
  const LoadedParameter& found = state_->shaders[index].bindable(parameter);
  check_values(found, values);
  if (state_->polygons.shows(index)) {
    throw Error("bound_material: the frame shows this shader already, and bound parameters change between frames");
  }
  state_->shaders[index].bind(parameter, state_->matrices.transform(values, found.transform));
}

void Context::shader(ShaderId shader) {
  state_->check_outside("shader");
  const std::size_t index = state_->index(shader);
  if (state_->defining && index + 1 == state_->shaders.size()) throw Error("shader before end_shader");
  state_->current = index;
}

void Context::material(const std::string& parameter, const Values& values) {
  // A name may have another length in each function: one that it fits is enough until a polygon needs it.
  bool known = false, uniform = false, fits = false;
  for (const auto& function : state_->library.functions()) {
    if (function->is_light) continue;
    for (const LoadedParameter& p : function->parameters) {
      if (p.said.name != parameter) continue;
      uniform = uniform || !p.said.varying;
      if (!p.said.varying || p.said.giver == Giver::Machine) continue;
      known = true;
      fits = fits || values.size() == static_cast<std::size_t>(p.said.count);
    }
  }
  if (parameter == "px_shader_texcoord" && !values.empty() && values.size() <= 4) known = fits = true;
  if (!known) {
    throw Error("material: " + (uniform
                                    ? "parameter '" + parameter + "' is uniform: bound_material sets it"
                                    : "no loaded surface takes a parameter '" + parameter + "' from the application"));
  }
  if (!fits) throw Error("material: no '" + parameter + "' has " + std::to_string(values.size()) + " number(s)");
  for (const double value : values) check_finite({value}, "material");
  Values current = values;
  if (parameter == "px_shader_texcoord") {
    constexpr double kMissing[4] = {0, 0, 0, 1};
    for (std::size_t k = current.size(); k < 4; ++k) current.push_back(kMissing[k]);
  }
  state_->materials.set(parameter, std::move(current));
}

void Context::normal(double x, double y, double z) {
  check_finite({x, y, z}, "normal");
  state_->materials.set("px_material_normal", {x, y, z});
}

void Context::tex_coord(double s, double t, double r, double q) {
  check_finite({s, t, r, q}, "tex_coord");
  state_->materials.set("px_shader_texcoord", {s, t, r, q});
}

void Context::color(double r, double g, double b) {
  check_finite({r, g, b}, "color");
  state_->materials.set("px_material_diffuse", {r, g, b});
}

void Context::begin() { state_->polygons.begin(state_->current, state_->shaders[state_->current]); }

void Context::vertex(double x, double y, double z) {
  check_finite({x, y, z}, "vertex");
  state_->polygons.vertex({x, y, z}, state_->matrices, state_->materials);
}

void Context::end() { state_->polygons.end(); }

void Context::matrix_mode(MatrixMode mode) {
  state_->check_outside("matrix_mode");
  state_->matrices.mode(mode);
}

void Context::load_identity() {
  state_->check_outside("load_identity");
  state_->matrices.load(glm::dmat4(1));
}

void Context::load_matrix(const std::array<double, 16>& numbers) {
  state_->check_outside("load_matrix");
  state_->matrices.load(matrix(numbers));
}

void Context::multiply_matrix(const std::array<double, 16>& numbers) {
  state_->check_outside("multiply_matrix");
  state_->matrices.multiply(matrix(numbers));
}

void Context::translate(double x, double y, double z) {
  state_->check_outside("translate");
  glm::dmat4 move(1);
  move[3] = glm::dvec4(x, y, z, 1);
  state_->matrices.multiply(move);
}

void Context::rotate(double angle, double x, double y, double z) {
  state_->check_outside("rotate");
  state_->matrices.multiply(rotation(angle, {x, y, z}));
}

void Context::scale(double x, double y, double z) {
  state_->check_outside("scale");
  glm::dmat4 size(1);
  for (int k = 0; k < 3; ++k) size[k][k] = glm::dvec3(x, y, z)[k];
  state_->matrices.multiply(size);
}

void Context::push_matrix() {
  state_->check_outside("push_matrix");
  state_->matrices.push();
}

void Context::pop_matrix() {
  state_->check_outside("pop_matrix");
  state_->matrices.pop();
}

void Context::look_at(const std::array<double, 3>& eye, const std::array<double, 3>& target,
                      const std::array<double, 3>& up) {
  scanline::Camera camera = state_->scene.camera;
  camera.position = vector(eye, "look_at");
  camera.target = vector(target, "look_at");
  camera.up = vector(up, "look_at");
  set_camera(state_->scene.camera, camera);
}

void Context::perspective(double field_of_view, double near, double far) {
  check_finite({field_of_view, near, far}, "perspective");
  scanline::Camera camera = state_->scene.camera;
  camera.projection = scanline::Projection::kPerspective;
  camera.field_of_view = field_of_view;
  camera.near = near;
  camera.far = far;
  set_camera(state_->scene.camera, camera);
}

void Context::orthographic(double height, double near, double far) {
  check_finite({height, near, far}, "orthographic");
  scanline::Camera camera = state_->scene.camera;
  camera.projection = scanline::Projection::kOrthographic;
  camera.height = height;
  camera.near = near;
  camera.far = far;
  set_camera(state_->scene.camera, camera);
}

LightId Context::new_light(const std::string& function) {
  if (state_->lights.size() == kMostLights) throw Error("there are " + std::to_string(kMostLights) + " lights already");
  state_->lights.push_back({&state_->library.find(function, true), {}, false});
  return static_cast<LightId>(state_->lights.size() - 1);
}

void Context::enable(LightId light) {
  state_->check_between_frames("enable");
  state_->at(light).enabled = true;
}

void Context::disable(LightId light) {
  state_->check_between_frames("disable");
  state_->at(light).enabled = false;
}

void Context::light(LightId light, const std::string& parameter, const Values& values) {
  state_->check_between_frames("light");
  LightInstance& instance = state_->at(light);
  const LoadedParameter& found = instance.function->parameter(parameter);
  if (!found.settable) throw Error("parameter '" + parameter + "' is the machine's own");
  check_values(found, values);
  instance.values[parameter] = state_->matrices.transform(values, found.transform);
}

void Context::texture(int number, const std::string& file) {
  check_range(number, 1, kMostTextures, "a texture's number");
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(file, error);
  if (!std::filesystem::is_regular_file(path, error)) throw Error("texture: cannot read '" + file + "'");
  state_->scene.textures[number] = path;
  state_->renderer.reset();  // the file may be another than the last time it was named
}

void Context::frame_rate(double frames_a_second) {
  if (!(frames_a_second > 0) || !std::isfinite(frames_a_second)) throw Error("frame_rate: a number above 0 is wanted");
  state_->scene.frame_rate = frames_a_second;
}

void Context::frame(int number) { state_->frame = number; }

Picture Context::render() {
  state_->check_outside("render");
  if (state_->defining) throw Error("render before end_shader");
  try {
    return state_->draw();
  } catch (const std::exception& error) {
    state_->renderer.reset();
    throw Error(error.what());
  }
}

}  // namespace watkins
