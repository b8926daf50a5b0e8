#include "watkins/interface/instances.h"

#include "pixelflow/shading/instance.h"

namespace watkins {
namespace {

/// The renderer adds up a scene's ambient lights in it; a context has none, but the parameter's own value.
const std::string kSceneAmbient = "scene_ambient";

scanline::ParameterValue parameter_value(const Values& values) {
  if (values.size() == 1) return values[0];
  return values;
}

}  // namespace

SurfaceInstance::SurfaceInstance(const LoadedFunction& function) : function_(&function) {
  for (const LoadedParameter& p : function.parameters) {
    if (p.said.name == kSceneAmbient && !p.said.defaults.empty()) bound_[kSceneAmbient] = p.said.defaults;
  }
}

bool SurfaceInstance::is_ordinary(const LoadedParameter& p) const {
  if (!p.said.varying || !p.settable) return false;
  const auto chosen = bindings_.find(p.said.name);
  if (chosen != bindings_.end()) return chosen->second == Binding::Material;
  return is_standard(p.said.name) && p.said.giver == Giver::Application;
}

void SurfaceInstance::set_binding(const std::string& parameter, Binding binding) {
  const LoadedParameter& p = function_->parameter(parameter);
  if (!p.settable) throw Error("parameter '" + parameter + "' is the machine's own");
  if (binding == Binding::Material) {
    if (!p.said.varying) throw Error("parameter '" + parameter + "' is uniform and can only be bound");
    if (p.said.giver == Giver::Machine) throw Error("parameter '" + parameter + "' is given by the machine or bound");
  } else if (binding != Binding::BoundMaterial) {
    throw Error("there is no such binding");
  }
  bindings_[parameter] = binding;
  if (binding == Binding::Material) bound_.erase(parameter);
}

const LoadedParameter& SurfaceInstance::bindable(const std::string& parameter) const {
  const LoadedParameter& p = function_->parameter(parameter);
  if (!p.settable) throw Error("parameter '" + parameter + "' is the machine's own");
  if (is_ordinary(p)) throw Error("parameter '" + parameter + "' is not bound in this instance: material() sets it");
  return p;
}

std::vector<const LoadedParameter*> SurfaceInstance::ordinary() const {
  std::vector<const LoadedParameter*> result;
  for (const LoadedParameter& p : function_->parameters) {
    if (is_ordinary(p)) result.push_back(&p);
  }
  return result;
}

scanline::ShaderCall SurfaceInstance::call() const {
  scanline::ShaderCall call;
  call.name = function_->name;
  call.file = function_->file;
  for (const auto& [name, values] : bound_) call.parameters[name] = parameter_value(values);
  // What is bound without a value of its own still must not come from anywhere else.
  for (const auto& [name, binding] : bindings_) {
    const Parameter& said = function_->parameter(name).said;
    if (binding != Binding::BoundMaterial || bound_.contains(name)) continue;
    call.parameters[name] = parameter_value(said.defaults.empty() ? initial_value(said) : said.defaults);
  }
  return call;
}

scanline::Light LightInstance::light() const {
  scanline::Light light;
  light.shader = scanline::ShaderCall{};
  light.shader->name = function->name;
  light.shader->file = function->file;
  for (const auto& [name, numbers] : values) light.shader->parameters[name] = parameter_value(numbers);
  return light;
}

Values initial_value(const Parameter& parameter) {
  Values result(static_cast<std::size_t>(parameter.count), pfman::opengl_material(parameter.name).value_or(0));
  const std::string& name = parameter.name;
  if (name == "px_material_normal" && result.size() >= 3) result[2] = 1;
  if (name == "px_shader_texcoord" && result.size() == 4) result[3] = 1;
  return result;
}

}  // namespace watkins
