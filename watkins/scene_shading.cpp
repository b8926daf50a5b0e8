#include "watkins/scene_shading.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/eye_space.h"
#include "pixelflow/shading/test_textures.h"
#include "scanline/camera.h"
#include "watkins/data_folder.h"
#include "watkins/texture_file.h"

namespace watkins {
namespace {

using scanline::Object;
using scanline::ParameterValue;
using scanline::ShaderCall;
using Kind = ParameterSource::Kind;

/// Numbers of images that scenes name; those below are the shaders' own.
constexpr int kFirstImage = 16;
/// Parameter of surfaces: the sum of the scene's ambient lights, unless the scene gives it another value.
const std::string kSceneAmbient = "scene_ambient";

const pfman::Variable* parameter(const pfman::CompiledShader& shader, const std::string& name) {
  for (const pfman::ShaderParameter& p : shader.shader->parameters) {
    if (p.variable->name == name && !p.variable->output) return p.variable;
  }
  return nullptr;
}

/// Whether values that the shading node holds depend on where the object stands.
bool has_transform(const pfman::Instance& instance) {
  const auto& parameters = instance.shader().shader->parameters;
  return std::any_of(parameters.begin(), parameters.end(), [&](const pfman::ShaderParameter& p) {
    using pfman::ast::Transform;
    const pfman::Variable& v = *p.variable;
    const bool is_moved = v.transform != Transform::None && v.transform != Transform::Texture;
    return is_moved && (!v.type.varying || instance.bound().contains(v.name));
  });
}

bool same_keys(const Object& a, const Object& b) {
  return std::equal(a.keys.begin(), a.keys.end(), b.keys.begin(), b.keys.end(),
                    [](const scanline::TransformKey& x, const scanline::TransformKey& y) {
                      return x.frame == y.frame && x.translate == y.translate && x.rotate == y.rotate &&
                             x.scale == y.scale;
                    });
}

/// Whether both take the scene's ambient light, or neither.
bool same_ambient(const Object& a, const Object& b) {
  return a.shader.parameters.contains(kSceneAmbient) == b.shader.parameters.contains(kSceneAmbient);
}

}  // namespace

ShadingFiles::ShadingFiles() : textures(pfman::test_textures()) {}

bool has_attribute(const Object& object, const std::string& name, int components) {
  const auto fits = [&](const auto& a) { return a.name == name && a.components >= components; };
  if (object.source) {
    const auto attributes = object.source->attributes();
    return std::any_of(attributes.begin(), attributes.end(), fits);
  }
  return std::any_of(object.mesh.attributes.begin(), object.mesh.attributes.end(), fits);
}

SceneShading::SceneShading(const scanline::Scene& scene, const std::string& scene_file, ShadingFiles& files)
    : scene_(scene), scene_file_(scene_file), files_(files), first_image_(kFirstImage) {
  keep_textures();
  for (std::size_t k = 0; k < scene.objects.size(); ++k) add_object(k);
  for (const scanline::Light& light : scene.lights) add_light(light);
  if (files_.diagnostics.has_errors()) {
    for (const pfman::Diagnostic& d : files_.diagnostics.all()) {
      if (d.is_error()) {
        mistakes_.push_back({files_.diagnostics.files()[d.where.file], static_cast<int>(d.where.line),
                             static_cast<int>(d.where.column), d.text});
      }
    }
  }
  if (!mistakes_.empty()) throw scanline::UserError(mistakes_);
  warnings_ = files_.diagnostics.text();
}

void SceneShading::wrong(int line, std::string message) {
  scanline::Diagnostic mistake{scene_file_, line, 0, std::move(message)};
  const bool said = std::any_of(mistakes_.begin(), mistakes_.end(), [&](const scanline::Diagnostic& d) {
    return d.line == mistake.line && d.message == mistake.message;
  });
  if (!said) mistakes_.push_back(std::move(mistake));
}

const pfman::CompiledShader* SceneShading::find(const ShaderCall& call, pfman::Shader::Kind kind) {
  const bool own = call.file.empty();
  const std::filesystem::path path = own ? data_folder() / "shaders" / (call.name + ".pfman") : call.file;
  auto& units = files_.units;
  auto known = std::find_if(units.begin(), units.end(), [&](const auto& file) { return file->path == path; });
  if (known == units.end()) {
    std::error_code ignored;  // a name may be longer than files have
    if (!std::filesystem::is_regular_file(path, ignored)) {
      wrong(call.line, own ? "there is no shader '" + call.name + "'; one of your own needs a 'file'"
                           : "cannot read '" + path.string() + "'");
      return nullptr;
    }
    auto unit = pfman::compile_file(path, {}, files_.diagnostics);
    units.push_back(std::make_unique<ShadingFiles::Unit>(ShadingFiles::Unit{path, std::move(unit)}));
    known = units.end() - 1;
  }
  if (files_.diagnostics.has_errors()) return nullptr;  // said of the file
  const pfman::CompiledShader* shader = (*known)->unit->find(call.name);
  const char* const wanted = kind == pfman::Shader::Kind::Surface ? "surface" : "light";
  if (!shader || shader->shader->kind != kind) {
    wrong(call.line, "'" + path.string() + "' has no " + wanted + " '" + call.name + "'");
    return nullptr;
  }
  return shader;
}

/// Images of the scene's own numbers that are there already stay; unless others are, too, which nobody has asked for.
void SceneShading::keep_textures() {
  if (files_.images != scene_.textures) {
    files_.textures = pfman::test_textures();
    files_.images.clear();
    for (const auto& [number, path] : scene_.textures) read_texture(number, path, 0);
  }
  if (!scene_.textures.empty()) first_image_ = std::max(first_image_, scene_.textures.rbegin()->first + 1);
}

void SceneShading::read_texture(int number, const std::filesystem::path& path, int line) {
  try {
    files_.textures.set(number, read_texture_file(path));
    files_.images[number] = path;
  } catch (const scanline::UserError& e) {
    wrong(line, "cannot read '" + path.string() + "'");
    mistakes_.insert(mistakes_.end(), e.diagnostics().begin(), e.diagnostics().end());
  } catch (const std::invalid_argument& e) {  // it does not fit into the memory
    wrong(line, "'" + path.string() + "': " + e.what());
  }
}

int SceneShading::texture(const std::string& name, int line) {
  const std::filesystem::path path = std::filesystem::path(scene_file_).parent_path() / name;
  const auto [known, is_new] = images_.try_emplace(path.string(), first_image_ + static_cast<int>(images_.size()));
  if (is_new) read_texture(known->second, path, line);
  return known->second;
}

void SceneShading::bind(pfman::Instance& instance, const ShaderCall& call) {
  for (const auto& [given, value] : call.parameters) {
    // The language keeps the word `color` for itself.
    const std::string name = given == "color" ? "rgb" : given;
    if (name != given && call.parameters.contains(name)) {
      wrong(call.line, "'color' and 'rgb' are one parameter of '" + call.name + "'");
      continue;
    }
    const pfman::Variable* const p = parameter(instance.shader(), name);
    const bool whole = p && p->type.scalar == pfman::Scalar::integer();
    std::vector<double> numbers;
    if (const double* number = std::get_if<double>(&value)) numbers = {*number};
    if (const bool* flag = std::get_if<bool>(&value)) numbers = {*flag ? 1.0 : 0.0};
    if (const auto* list = std::get_if<std::vector<double>>(&value)) numbers = *list;
    if (const auto* text = std::get_if<std::string>(&value)) {
      if (p && (!whole || p->type.varying || p->type.is_array())) {
        wrong(call.line, "parameter '" + name + "' of '" + call.name + "' is no whole number: a text names an image");
        continue;
      }
      numbers = {static_cast<double>(p ? texture(*text, call.line) : 0)};
    }
    if (whole && std::any_of(numbers.begin(), numbers.end(), [](double n) { return n != std::floor(n); })) {
      wrong(call.line, "parameter '" + name + "' of '" + call.name + "' must be a whole number");
      continue;
    }
    try {
      instance.set(name, numbers);
    } catch (const std::invalid_argument& mistake) {
      wrong(call.line, mistake.what());
    }
  }
}

bool SceneShading::add_source(const Object& object, const pfman::TransferEntry& entry, pfman::Instance& instance,
                              ObjectSurface& surface) {
  const std::string& name = entry.name;
  const int count = entry.type.count();
  ParameterSource source{Kind::Attribute, name, entry.address - pfman::kShaderIdAt, entry.type,
                         parameter(instance.shader(), name)->transform};
  if (object.shader.parameters.contains(name)) return true;  // bound
  if (name == "px_material_normal" && count == 3) {
    source.kind = Kind::Normal;
  } else if (name == "polygon_normal" && count == 3) {
    source.kind = Kind::PolygonNormal;
  } else if (name == "px_shader_texcoord") {
    source.kind = has_attribute(object, name, count) ? Kind::Attribute : count == 2 ? Kind::TexCoord : Kind::Volume;
  } else if (name == "field_visibility") {
    source.kind = Kind::Visibility;
  } else if (name == "field_reflection" && count == 3) {
    source.kind = Kind::Reflection;
  } else if (has_attribute(object, name, count)) {
    source.kind = Kind::Attribute;
  } else if (name == "px_material_diffuse" && has_attribute(object, "color", count)) {
    source.name = "color";
  } else if (instance.bound().contains(name)) {
    return true;  // its default
  } else if (const auto material = pfman::opengl_material(name)) {
    instance.set(name, std::vector<double>(static_cast<std::size_t>(count), *material));
    return true;
  } else {
    wrong(object.shader.line ? object.shader.line : object.line,
          "surface '" + object.shader.name + "' needs '" + name + "': object '" + object.name +
              "' has neither a parameter nor an attribute of that name with " + std::to_string(count) + " number(s)");
    return false;
  }
  instance.make_ordinary(name);
  surface.sources.push_back(source);
  const int end = source.offset + entry.type.bytes();
  surface.packets = std::max(surface.packets, (end + pfman::kPacketPayload - 1) / pfman::kPacketPayload);
  return true;
}

void SceneShading::add_object(std::size_t index) {
  const Object& object = scene_.objects[index];
  ObjectSurface& surface = objects_.emplace_back();
  const pfman::CompiledShader* shader = find(object.shader, pfman::Shader::Kind::Surface);
  if (!shader) return;
  pfman::Instance instance(*shader, static_cast<int>(surfaces_.size()) + 1);
  bind(instance, object.shader);
  const pfman::TransferMap map = pfman::transfer_map(*shader);
  surface.map_bytes = map.bytes;
  for (const pfman::TransferEntry& entry : map.entries) add_source(object, entry, instance, surface);
  if (surface.packets > pfman::kMostPackets) {
    wrong(object.shader.line, "the varying parameters of '" + object.shader.name + "' take " +
                                  std::to_string(map.bytes) + " bytes a pixel with the shader's ID, more than " +
                                  std::to_string(pfman::kMostPackets * pfman::kPacketPayload));
  }
  // Objects share an instance when nothing tells them apart.
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const Made& made = surfaces_[k];
    if (&made.instance.shader() != shader || made.instance.uniforms() != instance.uniforms() ||
        made.instance.bound() != instance.bound() || objects_[made.object].sources != surface.sources ||
        !same_ambient(scene_.objects[made.object], object) ||
        (has_transform(instance) && !same_keys(scene_.objects[made.object], object))) {
      continue;
    }
    surface.shader_id = made.instance.id();
    return;
  }
  surface.shader_id = instance.id();
  if (surface.shader_id >= 1 << 8 * pfman::kShaderIdBytes)
    wrong(object.line, "the scene has too many shader instances");
  surfaces_.push_back({std::move(instance), index});
}

void SceneShading::add_light(const scanline::Light& light) {
  using scanline::Light;
  if (!light.shader && light.kind == Light::Kind::kAmbient) return;  // in scene_ambient
  ShaderCall call;
  if (light.shader) {
    call = *light.shader;
  } else {
    const bool directional = light.kind == Light::Kind::kDirectional;
    const glm::dvec3& place = directional ? light.direction : light.position;
    call.name = directional ? "directional_light" : "point_light";
    call.parameters[directional ? "direction" : "position"] = std::vector<double>{place.x, place.y, place.z};
    call.parameters["rgb"] = std::vector<double>{light.color.r, light.color.g, light.color.b};
    call.parameters["intensity"] = light.intensity;
  }
  const pfman::CompiledShader* shader = find(call, pfman::Shader::Kind::Light);
  if (!shader) return;
  pfman::Instance& instance = lights_.emplace_back(*shader, static_cast<int>(lights_.size()) + 1);
  bind(instance, call);
}

void SceneShading::set_standard(pfman::Instance& instance, double moment) const {
  const auto set = [&](const std::string& name, const std::vector<double>& values) {
    const pfman::Variable* p = parameter(instance.shader(), name);
    if (p && !p->type.varying && p->type.count() == static_cast<int>(values.size())) instance.set(name, values);
  };
  set("px_shader_time", {moment / scene_.frame_rate});
  set("px_shader_frame", {moment});
}

std::vector<pfman::Instance> SceneShading::surfaces(double moment) const {
  const glm::dmat4 view = scanline::view_matrix(scanline::camera_at(scene_, moment));
  glm::dvec3 ambient(0);
  for (const scanline::Light& light : scene_.lights) {
    if (!light.shader && light.kind == scanline::Light::Kind::kAmbient) ambient += light.color * light.intensity;
  }
  std::vector<pfman::Instance> result;
  for (const Made& made : surfaces_) {
    pfman::Instance instance = made.instance;
    const Object& object = scene_.objects[made.object];
    set_standard(instance, moment);
    const pfman::Variable* p = parameter(instance.shader(), kSceneAmbient);
    if (p && !p->type.varying && p->type.count() == 3 && !object.shader.parameters.contains(kSceneAmbient)) {
      instance.set(kSceneAmbient, {ambient.r, ambient.g, ambient.b});
    }
    pfman::place(instance, view * scanline::object_matrix(object.keys, moment));
    result.push_back(std::move(instance));
  }
  return result;
}

std::vector<pfman::Instance> SceneShading::lights(double moment) const {
  const glm::dmat4 view = scanline::view_matrix(scanline::camera_at(scene_, moment));
  std::vector<pfman::Instance> result = lights_;
  for (pfman::Instance& light : result) {
    set_standard(light, moment);
    pfman::place(light, view);
  }
  return result;
}

scanline::UserError SceneShading::mistake(const pfman::UniformError& error) const {
  scanline::Diagnostic diagnostic;
  const std::vector<std::string>& names = files_.diagnostics.files();
  if (error.where.file < names.size()) diagnostic.file = names[error.where.file];
  diagnostic.line = static_cast<int>(error.where.line);
  diagnostic.column = static_cast<int>(error.where.column);
  diagnostic.message = error.what();
  return scanline::UserError(std::move(diagnostic));
}

}  // namespace watkins
