#include "pixelflow/compiler/stage_walker.h"

#include <stdexcept>

#include "cmodel/pixelflow/macro.h"
#include "pixelflow/compiler/externals.h"
#include "pixelflow/compiler/picture_colour.h"

namespace pfman {
namespace {

using pixelflow::Assembler;
using pixelflow::Gate;
using Kind = ir::Instruction::Kind;

constexpr int kMostIterations = 65536;

pixelflow::Operand number(int address, int bytes) {
  return {.address = static_cast<std::uint8_t>(address), .bytes = static_cast<std::uint8_t>(bytes)};
}

}  // namespace

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

StageWalker::StageWalker(const CompiledShader& shader, Environment& environment, const std::vector<int>& ids,
                         Stream& stream)
    : code_(shader.code), map_(shader.map), environment_(environment), out_(stream), masks_(out_, code_, deep(), ids) {}

void StageWalker::walk(int first, int last, const std::map<std::string, Raw>* bound, bool colours) {
  out_.at(code_.where);
  last_ = last;
  masks_.begin_stage(first, last);
  for (const ir::Parameter& parameter : code_.parameters) {
    if (!bound) break;
    const auto value = bound->find(parameter.declared->variable->name);
    if (value != bound->end()) load(parameter, value->second);
  }
  for (int at = first; at < last;) at = step(at);
  out_.at(code_.where);
  if (colours) {
    masks_.prepare();
    write_picture_colour(out_, code_, map_);
  }
  masks_.end_stage();
}

void StageWalker::walk_call(const std::vector<ExternalArgument>& parameters, const std::vector<PixelVariable>& results,
                            const PixelWorkspace& workspace) {
  const int last = static_cast<int>(code_.code.size());
  out_.at(code_.where);
  masks_.begin_call(0, last, workspace.mask, workspace.free_mask_bit);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    const ir::Parameter& parameter = code_.parameters[n];
    if (!parameters[n].pixel) {
      load(parameter, parameters[n].uniform);
      continue;
    }
    int from = parameters[n].pixel->address;
    for (const int variable : parameter.variables) {
      const ir::Variable& to = code_.variables[static_cast<std::size_t>(variable)];
      const int bytes = to.scalar.bytes();
      for (int e = 0; e < to.count; ++e, from += bytes) {
        if (place(variable) < 0) continue;
        out_.operate({.d = number(place(variable) + e * bytes, bytes), .a = number(from, bytes), .b = {}});
      }
    }
  }
  for (int at = 0; at < last;) at = step(at);
  masks_.prepare();
  std::size_t colour = 0;
  for (const PixelVariable& result : results) {
    for (int n = 0; n < result.count; ++n, ++colour) {
      out_.operate({.d = number(result.address + n * result.bytes, result.bytes),
                    .a = number(place(code_.color.at(colour)), result.bytes),
                    .b = {}});
    }
  }
  masks_.end_call();
}

std::vector<int> StageWalker::deep() const {
  std::vector<int> addresses;
  for (const int variable : code_.mask_bytes) addresses.push_back(place(variable));
  return addresses;
}

void StageWalker::load(const ir::Parameter& parameter, const Raw& value) {
  std::size_t next = 0;
  for (const int variable : parameter.variables) {
    const ir::Variable& to = code_.variables[static_cast<std::size_t>(variable)];
    const int bytes = to.scalar.bytes();
    for (int n = 0; n < to.count; ++n, ++next) {
      if (place(variable) < 0) continue;
      pixelflow::Operand constant = number(0, bytes);
      constant.uniform = true;
      constant.constant = value.at(next);
      out_.operate({.d = number(place(variable) + n * bytes, bytes), .a = constant, .b = {}});
    }
  }
}

std::int64_t StageWalker::integer(int uniform) {
  const Scalar& type = code_.uniforms[static_cast<std::size_t>(uniform)]->type.scalar;
  return static_cast<std::int64_t>(convert(value(uniform).at(0), type, Scalar::fixed(true, 64, 0), /*saturate=*/true));
}

pixelflow::Operand StageWalker::resolve(const ir::Operand& operand) {
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
      throw UniformError(
          code_.uniforms[static_cast<std::size_t>(operand.index)]->where,
          "index " + std::to_string(index) + " is outside of the array's 0 to " + std::to_string(operand.elements - 1));
    }
    address += static_cast<int>(index) * code_.variables[static_cast<std::size_t>(operand.variable)].scalar.bytes();
  }
  if (place(operand.variable) < 0) throw std::logic_error("an operand without a place in memory");
  resolved.address = static_cast<std::uint8_t>(address);
  return resolved;
}

int StageWalker::step(int at) {
  const ir::Instruction& i = instruction(at);
  out_.at(i.where);
  environment_.count(1, i.where);
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
    case Kind::Lookup: return i.shared ? share_lookup(at) : (execute(i), at + 1);
    case Kind::Stage: throw std::logic_error("a stage begins within a stage");
    default: execute(i); return at + 1;
  }
}

void StageWalker::enter(int loop) {
  iterations_.push_back(0);
  if (instruction(loop).mask >= 0) masks_.begin_loop(loop);
}
int StageWalker::leave(int loop) {
  iterations_.pop_back();
  if (instruction(loop).mask >= 0) masks_.end_loop();
  return instruction(loop).match + 1;
}
int StageWalker::repeat(int loop) {
  if (++iterations_.back() > kMostIterations) {
    throw UniformError(instruction(loop).where,
                       "the loop has not ended after " + std::to_string(kMostIterations) + " iterations");
  }
  return loop + 1;
}
int StageWalker::next_of(int loop) const {
  for (int at = loop + 1; at < instruction(loop).match; ++at) {
    if (instruction(at).kind == Kind::LoopNext && instruction(at).match == loop) return at;
  }
  throw std::logic_error("a loop without a place for continue");
}

void StageWalker::execute(const ir::Instruction& i) {
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

void StageWalker::operate(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a,
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

void StageWalker::look_up(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a) {
  constexpr int kFloatBytes = 4;
  const int components = code_.variables[static_cast<std::size_t>(i.d.variable)].count;
  const Lookup lookup{integer(i.uniform), components, i.environment, {}};
  out_.send(lookup, a.address, kFloatBytes * (i.environment ? 3 : 2));
  out_.receive(d.address, components);
}

/// Elements of other shaders work in between: what stands before it and what follows are as two stages.
int StageWalker::share_lookup(int at) {
  const ir::Instruction& i = instruction(at);
  const Lookup::Shared places{resolve(i.a).address, resolve(i.d).address};
  const int components = code_.variables[static_cast<std::size_t>(i.d.variable)].count;
  masks_.end_stage();
  out_.share({integer(i.uniform), components, i.environment, places});
  masks_.begin_stage(at + 1, last_);
  return at + 1;
}

ExternalArgument StageWalker::argument(const ir::Operand& operand, const Type& type) {
  if (operand.kind == ir::Operand::Kind::Uniform) return {.pixel = {}, .uniform = value(operand.uniform)};
  const Scalar& scalar = type.scalar;
  return {.pixel = PixelVariable{resolve(operand).address, static_cast<std::uint8_t>(scalar.bytes()),
                                 pixel_kind(scalar), static_cast<std::int16_t>(scalar.exponent), type.count()},
          .uniform = {}};
}

void StageWalker::call(const ir::Instruction& i) {
  const PixelExternal external = pixel_external(i.external->linkage);
  if (!external.function) {
    throw UniformError(
        i.where, "external function '" + i.external->name + "' is not registered as '" + i.external->linkage + "'");
  }
  std::vector<ExternalArgument> arguments;
  for (std::size_t n = 0; n < i.arguments.size(); ++n) {
    const auto& parameters = i.external->parameters;
    // A varying result follows the parameters.
    arguments.push_back(argument(i.arguments[n], n < parameters.size() ? parameters[n]->type : i.external->result));
  }
  if (i.d) arguments.push_back(argument(i.d, i.external->result));
  const EnableMasks::SharedByte mask = masks_.settle();
  const PixelWorkspace workspace{i.work, external.workspace_bytes, mask.known, mask.free_bit};
  out_.foreign([&](pixelflow::Program& program) { external.function(program, arguments, workspace); });
}

}  // namespace pfman
