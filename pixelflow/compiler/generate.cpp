#include "pixelflow/compiler/generate.h"

#include <stdexcept>
#include <string>

#include "cmodel/pixelflow/macro.h"
#include "pixelflow/compiler/enable_masks.h"
#include "pixelflow/compiler/externals.h"
#include "pixelflow/compiler/picture_colour.h"
#include "pixelflow/compiler/stream_writer.h"

namespace pfman {
namespace {

using pixelflow::Assembler;
using pixelflow::Gate;
using Kind = ir::Instruction::Kind;

constexpr int kMostIterations = 65536;

/// Walks the code of one stage as the host runs it, and writes what the pixel processors are to do.
class StageWalker {
 public:
  StageWalker(const CompiledShader& shader, Environment& environment, const std::vector<int>& ids, Stream& stream)
      : code_(shader.code),
        map_(shader.map),
        environment_(environment),
        out_(stream),
        masks_(out_, code_, deep(), ids) {}

  /// `bound`: varying parameters to be loaded first, null but in the first stage. `colours`: the picture's colour is
  /// written at the end.
  void walk(int first, int last, const std::map<std::string, Raw>* bound, bool colours) {
    out_.at(code_.where);
    masks_.begin_stage(first, last);
    if (bound) load_bound(*bound);
    for (int at = first; at < last;) at = step(at);
    out_.at(code_.where);
    if (colours) {
      masks_.prepare();
      write_picture_colour(out_, code_, map_);
    }
    masks_.end_stage();
  }

 private:
  const ir::Instruction& instruction(int at) const { return code_.code[static_cast<std::size_t>(at)]; }
  int place(int variable) const { return map_.address[static_cast<std::size_t>(variable)]; }
  std::vector<int> deep() const {
    std::vector<int> addresses;
    for (const int variable : code_.mask_bytes) addresses.push_back(place(variable));
    return addresses;
  }

  void load_bound(const std::map<std::string, Raw>& bound) {
    for (const ir::Parameter& parameter : code_.parameters) {
      const auto value = bound.find(parameter.declared->variable->name);
      if (value == bound.end()) continue;
      const Scalar& type = parameter.declared->variable->type.scalar;
      std::size_t next = 0;
      for (const int variable : parameter.variables) {
        const int count = code_.variables[static_cast<std::size_t>(variable)].count;
        for (int n = 0; n < count; ++n, ++next) {
          if (place(variable) < 0) continue;
          const auto bytes = static_cast<std::uint8_t>(type.bytes());
          out_.operate({.d = {.address = static_cast<std::uint8_t>(place(variable) + n * bytes), .bytes = bytes},
                        .a = {.bytes = bytes, .uniform = true, .constant = value->second.at(next)},
                        .b = {}});
        }
      }
    }
  }

  Raw value(int uniform) { return evaluate(*code_.uniforms[static_cast<std::size_t>(uniform)], environment_); }
  bool condition(int uniform) { return value(uniform).at(0) != 0; }
  std::int64_t integer(int uniform) {
    const Scalar& type = code_.uniforms[static_cast<std::size_t>(uniform)]->type.scalar;
    return static_cast<std::int64_t>(
        convert(value(uniform).at(0), type, Scalar::fixed(true, 64, 0), /*saturate=*/true));
  }

  /// An operand with its address, or the value of a uniform one.
  pixelflow::Operand resolve(const ir::Operand& operand) {
    if (!operand) return {};
    pixelflow::Operand resolved{.bytes = static_cast<std::uint8_t>(operand.bytes), .is_signed = operand.is_signed};
    if (operand.kind == ir::Operand::Kind::Uniform) {
      resolved.uniform = true;
      resolved.constant = value(operand.uniform).at(0);
      return resolved;
    }
    int address = place(operand.variable) + operand.offset;
    if (operand.index >= 0) {
      const std::int64_t index = integer(operand.index);
      if (index < 0 || index >= operand.elements) {
        throw UniformError(code_.uniforms[static_cast<std::size_t>(operand.index)]->where,
                           "index " + std::to_string(index) + " is outside of the array's 0 to " +
                               std::to_string(operand.elements - 1));
      }
      address += static_cast<int>(index) * code_.variables[static_cast<std::size_t>(operand.variable)].scalar.bytes();
    }
    if (place(operand.variable) < 0) throw std::logic_error("an operand without a place in memory");
    resolved.address = static_cast<std::uint8_t>(address);
    return resolved;
  }

  /// Executes one instruction and says which is next.
  int step(int at) {
    const ir::Instruction& i = instruction(at);
    out_.at(i.where);
    switch (i.kind) {
      case Kind::Uniform: value(i.uniform); return at + 1;
      case Kind::If: return condition(i.uniform) ? at + 1 : i.match + 1;
      case Kind::Else: return i.match + 1;
      case Kind::EndIf: return at + 1;
      case Kind::Loop: enter(at); return at + 1;
      case Kind::LoopTest: return condition(i.uniform) ? at + 1 : leave(i.match);
      case Kind::LoopNext:
        if (instruction(i.match).mask >= 0) masks_.next_iteration();
        return at + 1;
      case Kind::EndLoop: return repeat(i.match);
      case Kind::Break: return leave(i.match);
      case Kind::Continue: return next_of(i.match);
      case Kind::IfMasked: masks_.begin_if(at, i.condition ? resolve(i.condition).address : -1); return at + 1;
      case Kind::ElseMasked: masks_.begin_else(); return at + 1;
      case Kind::EndIfMasked: masks_.end_if(); return at + 1;
      case Kind::BreakMasked: masks_.jump(i.match, true); return at + 1;
      case Kind::ContinueMasked: masks_.jump(i.match, false); return at + 1;
      case Kind::Stage: throw std::logic_error("a stage begins within a stage");
      default: execute(i); return at + 1;
    }
  }

  void enter(int loop) {
    iterations_.push_back(0);
    if (instruction(loop).mask >= 0) masks_.begin_loop(loop);
  }
  int leave(int loop) {
    iterations_.pop_back();
    if (instruction(loop).mask >= 0) masks_.end_loop();
    return instruction(loop).match + 1;
  }
  int repeat(int loop) {
    if (++iterations_.back() > kMostIterations) {
      throw UniformError(instruction(loop).where,
                         "the loop has not ended after " + std::to_string(kMostIterations) + " iterations");
    }
    return loop + 1;
  }
  int next_of(int loop) const {
    for (int at = loop + 1; at < instruction(loop).match; ++at) {
      if (instruction(at).kind == Kind::LoopNext && instruction(at).match == loop) return at;
    }
    throw std::logic_error("a loop without a place for continue");
  }

  void execute(const ir::Instruction& i) {
    // Indices and lookups' numbers are evaluated all the same: what they report does not depend on the masks.
    const pixelflow::Operand a = resolve(i.a), b = resolve(i.b), d = resolve(i.d);
    if (!masks_.reachable()) return;
    masks_.prepare();
    switch (i.kind) {
      case Kind::Operate: operate(i, d, a, b); break;
      case Kind::And: out_.logic(pixelflow::Alu::And, d, a, b); break;
      case Kind::Or: out_.logic(pixelflow::Alu::Or, d, a, b); break;
      case Kind::Xor: out_.logic(pixelflow::Alu::Xor, d, a, b); break;
      case Kind::Select:
        if (i.condition) {
          const int condition = resolve(i.condition).address;
          out_.bare([&](Assembler& out) { out.flag_of_memory(pixelflow::Flag::K, condition, 0); });
        }
        out_.select(d, a, b);
        break;
      case Kind::Lookup: look_up(i, d, a); break;
      case Kind::External: call(i); break;
      default: throw std::logic_error("an instruction of no kind");
    }
  }

  void operate(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a,
               const pixelflow::Operand& b) {
    out_.operate({.code = i.code,
                  .d = d,
                  .a = a,
                  .b = b,
                  .scale = i.scale,
                  .flush = false,
                  .work = static_cast<std::uint8_t>(i.work)});
    if (!pixelflow::is_comparison(i.code) || !i.d) return;
    out_.bare([&](Assembler& out) {
      out.store_constant(1, d.address, Gate::EAndK);
      out.store_constant(0, d.address, Gate::EAndNotK);
      for (int n = 1; n < d.bytes; ++n) out.store_constant(0, d.address + n);
    });
  }

  void look_up(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a) {
    constexpr int kFloatBytes = 4;
    const int components = code_.variables[static_cast<std::size_t>(i.d.variable)].count;
    const Lookup lookup{integer(i.uniform), components, i.environment};
    out_.send(lookup, a.address, kFloatBytes * (i.environment ? 3 : 2));
    out_.receive(d.address, components);
  }

  ExternalArgument argument(const ir::Operand& operand, const Type& type) {
    if (operand.kind == ir::Operand::Kind::Uniform) return {.pixel = {}, .uniform = value(operand.uniform)};
    const Scalar& scalar = type.scalar;
    const int kind = scalar.is_float ? 2 : scalar.is_signed ? 1 : 0;
    return {.pixel = PixelVariable{resolve(operand).address, static_cast<std::uint8_t>(scalar.bytes()),
                                   static_cast<std::uint8_t>(kind), static_cast<std::int16_t>(scalar.exponent),
                                   type.count()},
            .uniform = {}};
  }

  void call(const ir::Instruction& i) {
    const PixelExternal external = pixel_external(i.external->linkage);
    if (!external.function) {
      throw UniformError(
          i.where, "external function '" + i.external->name + "' is not registered as '" + i.external->linkage + "'");
    }
    std::vector<ExternalArgument> arguments;
    for (std::size_t n = 0; n < i.arguments.size(); ++n) {
      arguments.push_back(argument(i.arguments[n], i.external->parameters[n]->type));
    }
    if (i.d) arguments.push_back(argument(i.d, i.external->result));
    out_.foreign([&](pixelflow::Program& program) { external.function(program, arguments, i.work); });
  }

  const ir::Code& code_;
  const MemoryMap& map_;
  Environment& environment_;
  StreamWriter out_;
  EnableMasks masks_;
  std::vector<int> iterations_;  ///< of the loops around
};

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
      if (given->second.size() != static_cast<std::size_t>(variable->type.count())) {
        throw std::invalid_argument("parameter '" + variable->name + "' has " + std::to_string(variable->type.count()) +
                                    " numbers, not " + std::to_string(given->second.size()));
      }
      environment[variable] = given->second;
    } else if (parameter.initial) {
      environment[variable] = default_value(parameter, environment);
    }
  }
  return environment;
}

/// First instructions of the stages that follow the first, and the end.
struct StageBounds {
  int illum = -1;  ///< behind its marker; -1: there is none
  int post = -1;
  int first_end = 0;
  int illum_end = 0;
  int end = 0;
};

StageBounds stages(const ir::Code& code) {
  StageBounds bounds;
  bounds.end = static_cast<int>(code.code.size());
  bounds.first_end = bounds.illum_end = bounds.end;
  for (int at = 0; at < bounds.end; ++at) {
    const ir::Instruction& i = code.code[static_cast<std::size_t>(at)];
    if (i.kind != Kind::Stage) continue;
    if (bounds.illum < 0 && bounds.post < 0) bounds.first_end = at;
    if (i.stage == 1) {
      bounds.illum = at + 1;
    } else {
      bounds.illum_end = at;
      bounds.post = at + 1;
    }
  }
  return bounds;
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

}  // namespace pfman
