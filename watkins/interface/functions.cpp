#include "watkins/interface/functions.h"

#include <algorithm>
#include <cmath>

#include "pixelflow/compiler/compile.h"
#include "pixelflow/compiler/generate.h"
#include "watkins/data_folder.h"

namespace watkins {
namespace {

namespace fs = std::filesystem;

/// Found on the shading node from depth and place (6.1.5.2).
bool is_rebuilt(const std::string& name) { return name == "px_shader_position" || name == "px_shader_view"; }

/// The same at all pixels, and set by the machine.
bool is_frame_wide(const std::string& name) {
  return name == "px_shader_eye" || name == "px_shader_time" || name == "px_shader_frame";
}

/// The renderer finds these unless they are bound.
bool is_geometric(const std::string& name) {
  return name == "polygon_normal" || name == "field_visibility" || name == "field_reflection";
}

LoadedParameter describe(const pfman::CompiledShader& shader, const pfman::ShaderParameter& parameter) {
  const pfman::Variable& variable = *parameter.variable;
  LoadedParameter result;
  result.said = {variable.name,         pfman::spelling(variable.type),
                 variable.type.count(), variable.type.varying,
                 Giver::Application,    {}};
  result.transform = variable.transform;
  if (is_rebuilt(variable.name) || is_frame_wide(variable.name)) {
    result.said.giver = Giver::Machine;
    result.settable = false;
  } else if (variable.type.varying && is_geometric(variable.name)) {
    result.said.giver = Giver::Machine;
  }
  if (parameter.initial) {
    for (const std::uint64_t raw : pfman::default_value(shader, parameter)) {
      result.said.defaults.push_back(pfman::to_double(raw, variable.type.scalar));
    }
  }
  return result;
}

std::unique_ptr<LoadedFunction> describe(const pfman::CompiledShader& shader, const fs::path& file) {
  auto result = std::make_unique<LoadedFunction>();
  result->name = shader.shader->name;
  result->is_light = shader.shader->kind == pfman::Shader::Kind::Light;
  result->file = file;
  for (const pfman::ShaderParameter& parameter : shader.shader->parameters) {
    if (!parameter.variable->output) result->parameters.push_back(describe(shader, parameter));
  }
  return result;
}

fs::path find_file(const std::string& name) {
  std::error_code error;
  for (const fs::path& path : {fs::path(name), data_folder() / "shaders" / name}) {
    if (fs::is_regular_file(path, error)) return fs::canonical(path);
  }
  throw Error("cannot read '" + name + "': there is no such file here, nor in '" +
              (data_folder() / "shaders").string() + "'");
}

}  // namespace

bool is_standard(const std::string& parameter) { return parameter.starts_with("px_"); }

const LoadedParameter& LoadedFunction::parameter(const std::string& wanted) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const LoadedParameter& p) { return p.said.name == wanted; });
  if (found == parameters.end()) throw Error("'" + name + "' has no parameter '" + wanted + "'");
  return *found;
}

Function LoadedFunction::said() const {
  Function result{name, is_light, {}};
  for (const LoadedParameter& parameter : parameters) result.parameters.push_back(parameter.said);
  return result;
}

std::vector<const LoadedFunction*> FunctionLibrary::load(const std::string& name) {
  const fs::path file = find_file(name);
  std::vector<const LoadedFunction*> result;
  if (std::find(files_.begin(), files_.end(), file) == files_.end()) {
    pfman::Diagnostics diagnostics;
    const std::unique_ptr<pfman::CompiledUnit> unit = pfman::compile_file(file, {}, diagnostics);
    if (diagnostics.has_errors()) throw Error(diagnostics.text());
    std::vector<std::unique_ptr<LoadedFunction>> loaded;
    for (const pfman::CompiledShader& shader : unit->shaders) {
      const auto same = [&](const auto& function) { return function->name == shader.shader->name; };
      const auto known = std::find_if(functions_.begin(), functions_.end(), same);
      if (known != functions_.end()) {
        throw Error("'" + file.string() + "': a function '" + (*known)->name + "' is loaded already, from '" +
                    (*known)->file.string() + "'");
      }
      loaded.push_back(describe(shader, file));
    }
    for (auto& function : loaded) functions_.push_back(std::move(function));
    files_.push_back(file);
  }
  for (const auto& function : functions_) {
    if (function->file == file) result.push_back(function.get());
  }
  return result;
}

const LoadedFunction& FunctionLibrary::find(const std::string& name, bool is_light) const {
  const std::string kind = is_light ? "light" : "surface";
  for (const auto& function : functions_) {
    if (function->name != name) continue;
    if (function->is_light != is_light) throw Error("'" + name + "' is no " + kind);
    return *function;
  }
  throw Error("no " + kind + " '" + name + "' is loaded");
}

void check_values(const LoadedParameter& parameter, const Values& values) {
  const Parameter& said = parameter.said;
  if (static_cast<int>(values.size()) != said.count) {
    throw Error("parameter '" + said.name + "' has " + std::to_string(said.count) + " number(s), not " +
                std::to_string(values.size()));
  }
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
    throw Error("parameter '" + said.name + "': a value is no finite number");
  }
}

}  // namespace watkins
