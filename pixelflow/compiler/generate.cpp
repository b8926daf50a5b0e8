#include "pixelflow/compiler/generate.h"

#include <stdexcept>
#include <string>

#include "pixelflow/compiler/stage_walker.h"

namespace pfman {
namespace {

using Kind = ir::Instruction::Kind;

Raw default_value(const ShaderParameter& parameter, Environment& constants) {
  const Raw value = evaluate(*parameter.initial, constants);
  const Type& type = parameter.variable->type;
  Raw result(static_cast<std::size_t>(type.count()));
  for (std::size_t n = 0; n < result.size(); ++n) {
    result[n] = convert(value.at(value.size() > 1 ? n : 0), parameter.initial->type.scalar, type.scalar);
  }
  return result;
}

/// What the host knows before the first stage: constants of the unit, parameters; everything else is zero.
Environment start(const CompiledShader& shader, const GenerateInput& input) {
  Environment environment;
  const auto clear = [&](const Variable* variable) {
    environment[variable].assign(static_cast<std::size_t>(variable->type.count()), 0);
  };
  for (const NodePtr& constant : shader.tree->constants) evaluate(*constant, environment);
  for (const auto& variable : shader.code.uniform_variables) clear(variable.get());
  for (const ShaderParameter& parameter : shader.shader->parameters) {
    const Variable* variable = parameter.variable;
    if (variable->type.varying) continue;
    clear(variable);
    const auto given = input.uniforms.find(variable->name);
    if (given != input.uniforms.end()) {
      check_count(*variable, given->second);
      environment[variable] = given->second;
    } else if (parameter.initial) {
      environment[variable] = default_value(parameter, environment);
    }
  }
  return environment;
}

void count_cycles(const Stream& stream, Streams& streams) {
  for (const Stream::Part& part : stream.parts) {
    const pixelflow::Program& program = part.program;
    for (std::size_t n = 0; n < program.steps.size(); ++n) {
      std::uint64_t cycles = 0;
      for (std::uint32_t at = 0; at < program.steps[n].count; ++at) {
        cycles += static_cast<std::uint64_t>(pixelflow::cycles(program.instructions[program.steps[n].first + at]));
      }
      streams.cycles_by_line[{part.places[n].file, part.places[n].line}] += cycles;
    }
  }
}

}  // namespace

std::uint64_t Stream::cycles() const {
  std::uint64_t sum = 0;
  for (const Part& part : parts) sum += part.program.cycles();
  return sum;
}

Raw default_value(const CompiledShader& shader, const ShaderParameter& parameter) {
  Environment constants;
  for (const NodePtr& constant : shader.tree->constants) evaluate(*constant, constants);
  return default_value(parameter, constants);
}

Streams generate(const CompiledShader& shader, const GenerateInput& input) {
  Environment environment = start(shader, input);
  const StageBounds bounds = stages(shader.code);
  Streams streams;
  const auto walk = [&](Stream& stream, int first, int last, const std::map<std::string, Raw>* bound = nullptr) {
    const bool colours = shader.code.kind == Shader::Kind::Surface && last == bounds.end;
    StageWalker(shader, environment, input.shader_ids, stream).walk(first, last, bound, colours);
  };
  walk(streams.pre, 0, bounds.first_end, &input.bound_varying);
  if (bounds.illum >= 0) {
    for (int light = 0; light < input.lights; ++light) {
      const Environment before = environment;
      walk(streams.illum.emplace_back(), bounds.illum, bounds.illum_end);
      // Nothing changed: for all further lights the stream is the same.
      if (light == 0 && environment == before) break;
    }
  }
  if (bounds.post >= 0) walk(streams.post, bounds.post, bounds.end);
  count_cycles(streams.pre, streams);
  for (const Stream& stream : streams.illum) count_cycles(stream, streams);
  count_cycles(streams.post, streams);
  return streams;
}

void check_count(const Variable& parameter, const Raw& value) {
  const int count = parameter.type.count();
  if (value.size() == static_cast<std::size_t>(count)) return;
  throw std::invalid_argument("parameter '" + parameter.name + "' has " + std::to_string(count) +
                              (count == 1 ? " number, not " : " numbers, not ") + std::to_string(value.size()));
}

}  // namespace pfman
