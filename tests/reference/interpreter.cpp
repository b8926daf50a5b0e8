#include "tests/reference/interpreter.h"

#include <algorithm>
#include <bit>

#include "tests/reference/builtin.h"
#include "tests/reference/machine.h"
#include "tests/reference/resolver.h"

namespace reference {
namespace {

constexpr const char* kColors[3] = {"px_light_color", "px_light_ambient", "px_light_specular"};

Value value_of(const RawValues& raw, int elements, const std::string& name) {
  const auto count = static_cast<std::size_t>(elements);
  if (raw.empty() || raw.size() % count != 0) throw Error(0, "wrong number of values for " + name);
  Value value(static_cast<int>(raw.size() / count), elements);
  value.raw = raw;
  return value;
}

Value converted_to(const Value& floats, const Number& number) {
  Value value = floats;
  for (Raw& raw : value.raw) raw = converted(raw, kFloat, number, false);
  return value;
}

/// Through floats, whatever the parameter is.
Value unit_length(Value value, const Number& number) {
  for (Raw& raw : value.raw) raw = converted(raw, number, kFloat, false);
  return converted_to(normalized(value), number);
}

Value position_of(const Input& input) {
  return input.position.empty() ? Value(1, 3) : value_of(input.position, 3, "px_shader_position");
}

Value parameter_value(const Parameter& parameter, const ParameterValues& uniform, const Input& input, bool light,
                      Machine& machine) {
  const Variable& variable = *parameter.variable;
  const int elements = variable.shape.count();
  const auto& given = variable.uniform ? uniform : input.varying;
  const auto found = given.find(variable.name);
  if (found != given.end() && !(light && !variable.uniform)) return value_of(found->second, elements, variable.name);
  if (variable.name == "px_shader_position") return converted_to(position_of(input), variable.number);
  if (variable.name == "px_shader_view") return converted_to(normalized(position_of(input)), variable.number);
  if (variable.name == "px_shader_time") return converted_to(float_value(input.time), variable.number);
  if (variable.name == "px_shader_frame") {
    Value value(1, 1);
    value.raw[0] = converted(static_cast<Raw>(input.frame), signed_fixed(64, 0), variable.number, false);
    return value;
  }
  return parameter.initial ? machine.evaluate(*parameter.initial) : Value(1, elements);
}

void set_parameters(const Shader& shader, const ParameterValues& uniform, const Input& input, Machine& machine) {
  for (const Parameter& parameter : shader.parameters) {
    Variable& variable = *parameter.variable;
    Value value = parameter_value(parameter, uniform, input, shader.light, machine);
    if (parameter.unit && variable.name != "px_shader_view") value = unit_length(std::move(value), variable.number);
    machine.assign_everywhere(variable, value);
  }
}

Machine::Light light_variables(Resolver& resolver) {
  return {&resolver.common("px_shader_position"),
          &resolver.common("px_light_ray"),
          &resolver.common("px_light_distance"),
          &resolver.common("px_light_direction"),
          {&resolver.common(kColors[0]), &resolver.common(kColors[1]), &resolver.common(kColors[2])}};
}

bool has_source(const Step& step) {
  return step.kind == Step::Kind::Illuminate || step.kind == Step::Kind::Solar ||
         (step.kind == Step::Kind::Block &&
          std::any_of(step.body.begin(), step.body.end(), [](const StepPtr& inner) { return has_source(*inner); }));
}

}  // namespace

LightResult Interpreter::light(const std::string& name, const ParameterValues& uniform, const Input& input) const {
  Resolver resolver(*unit_);
  const Shader shader = resolver.shader(name);
  if (!shader.light) throw Error(0, name + " is no light");
  Machine machine(input.lanes, input.textures);
  machine.use(light_variables(resolver));
  machine.assign_everywhere(resolver.common("px_shader_position"), position_of(input));
  const Value none(1, 3);
  for (const char* variable : {"px_light_direction", "px_light_color", "px_light_ambient", "px_light_specular",
                               "px_light_ray", "px_light_distance"}) {
    machine.assign_everywhere(resolver.common(variable), none);
  }
  set_parameters(shader, uniform, input, machine);
  machine.run(*shader.body);
  Variable &color = resolver.common(kColors[0]), &ambient = resolver.common(kColors[1]);
  Variable& specular = resolver.common(kColors[2]);
  if (!has_source(*shader.body)) {
    if (!shader.three_colors[1]) machine.assign_everywhere(ambient, color.value);
    machine.assign_everywhere(color, none);
  }
  if (!shader.three_colors[2]) machine.assign_everywhere(specular, color.value);
  return {resolver.common("px_light_direction").value.raw, color.value.raw, ambient.value.raw, specular.value.raw};
}

SurfaceResult Interpreter::surface(const std::string& name, const Input& input) const {
  Resolver resolver(*unit_);
  const Shader shader = resolver.shader(name);
  if (shader.light) throw Error(0, name + " is no surface");
  Machine machine(input.lanes, input.textures);
  machine.use(light_variables(resolver));
  set_parameters(shader, input.uniform, input, machine);
  for (const StepPtr& step : shader.body->body) {
    if (step->kind != Step::Kind::Illuminance) {
      machine.run(*step);
      continue;
    }
    for (const LightInput& one : input.lights) {
      const LightResult lit = light(one.shader, one.uniform, input);
      const RawValues* const parts[] = {&lit.direction, &lit.color, &lit.ambient, &lit.specular};
      const char* const names[] = {"px_light_direction", kColors[0], kColors[1], kColors[2]};
      for (int n = 0; n < 4; ++n)
        machine.assign_everywhere(resolver.common(names[n]), value_of(*parts[n], 3, names[n]));
      machine.run(*step);
    }
  }
  const Parameter* color = nullptr;
  for (const Parameter& parameter : shader.parameters) {
    if (parameter.variable->name == "px_shader_color") color = &parameter;
  }
  if (color == nullptr) throw Error(120, name + " has no px_shader_color");
  SurfaceResult result{color->variable->number, color->variable->value.raw, {}};
  for (const Raw raw : result.raw) {
    const Number to = unsigned_fixed(8, 8);
    const Raw eight = result.number.floating ? float_to_fixed(raw, to) : fixed_to_fixed(raw, result.number, to, true);
    result.color.push_back(static_cast<std::uint8_t>(eight));
  }
  return result;
}

void Interpreter::resolve_all() const {
  using Kind = pfman::ast::Definition::Kind;
  Resolver resolver(*unit_);
  for (const pfman::ast::Definition& definition : unit_->definitions) {
    if (definition.kind == Kind::Function) resolver.function(definition.name);
    if (definition.kind == Kind::Surface || definition.kind == Kind::Light) resolver.shader(definition.name);
  }
}

std::vector<ParameterInfo> Interpreter::parameters(const std::string& name) const {
  Resolver resolver(*unit_);
  const Shader shader = resolver.shader(name);
  std::vector<ParameterInfo> all;
  for (const Parameter& parameter : shader.parameters) {
    const Variable& variable = *parameter.variable;
    all.push_back({variable.name, variable.number, variable.shape.count(), variable.uniform, parameter.output});
  }
  return all;
}

}  // namespace reference
