#include "pixelflow/shading/instance.h"

#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"

namespace pfman {
namespace {

/// Not given by the application but found on the shading node.
bool is_rebuilt(const std::string& name) { return name == "px_shader_position" || name == "px_shader_view"; }
bool is_standard(const std::string& name) { return name.starts_with("px_"); }

const ShaderParameter& find(const CompiledShader& shader, const std::string& name) {
  for (const ShaderParameter& parameter : shader.shader->parameters) {
    if (parameter.variable->name == name && !parameter.variable->output) return parameter;
  }
  throw std::invalid_argument("'" + shader.shader->name + "' has no parameter '" + name + "'");
}

}  // namespace

TransferMap transfer_map(const CompiledShader& shader) {
  TransferMap map;
  map.bytes = kShaderIdBytes;
  for (const ShaderParameter& parameter : shader.shader->parameters) {
    const Variable& variable = *parameter.variable;
    if (!variable.type.varying || variable.output || is_rebuilt(variable.name)) continue;
    map.entries.push_back({variable.name, variable.type, kShaderIdAt + map.bytes});
    map.bytes += variable.type.bytes();
  }
  map.packets = (map.bytes + kPacketPayload - 1) / kPacketPayload;
  return map;
}

std::optional<double> opengl_material(const std::string& parameter) {
  if (parameter == "px_material_ambient") return 0.2;
  if (parameter == "px_material_diffuse") return 0.8;
  const bool is_black = parameter == "px_material_specular" || parameter == "px_material_emission" ||
                        parameter == "px_material_shininess";
  return is_black ? std::optional<double>(0) : std::nullopt;
}

Instance::Instance(const CompiledShader& shader, int id) : shader_(&shader), id_(id) {
  for (const ShaderParameter& parameter : shader.shader->parameters) {
    const Variable& variable = *parameter.variable;
    if (variable.output || !parameter.initial) continue;
    (variable.type.varying ? bound_ : uniforms_)[variable.name] = default_value(shader, parameter);
  }
}

void Instance::set(const std::string& parameter, const std::vector<double>& values) {
  const Scalar& scalar = find(*shader_, parameter).variable->type.scalar;
  Raw raw;
  for (const double value : values) raw.push_back(from_double(value, scalar));
  set_raw(parameter, raw);
}

void Instance::set_raw(const std::string& parameter, const Raw& raw) {
  const Variable& variable = *find(*shader_, parameter).variable;
  if (is_rebuilt(parameter)) throw std::invalid_argument("'" + parameter + "' is found on the shading node");
  check_count(variable, raw);
  if (!variable.type.varying) {
    uniforms_[parameter] = raw;
    return;
  }
  bound_[parameter] = raw;
  std::erase(ordinary_, parameter);
}

void Instance::make_ordinary(const std::string& parameter) {
  if (!find(*shader_, parameter).variable->type.varying) {
    throw std::invalid_argument("parameter '" + parameter + "' is uniform and can only be bound");
  }
  bound_.erase(parameter);
  if (!is_ordinary(parameter)) ordinary_.push_back(parameter);
}

bool Instance::is_ordinary(const std::string& parameter) const {
  if (std::find(ordinary_.begin(), ordinary_.end(), parameter) != ordinary_.end()) return true;
  return is_standard(parameter) && find(*shader_, parameter).variable->type.varying && !bound_.contains(parameter);
}

}  // namespace pfman
