#include "pixelflow/compiler/ir_access.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "pixelflow/compiler/memory_layout.h"

namespace pfman::ir {

std::string label(const Variable& variable) {
  if (variable.versions.empty()) return variable.name;
  constexpr std::size_t kMost = 4;
  const std::vector<int>& versions = variable.versions;
  std::string text = variable.name;
  if (!text.empty() && !std::isalpha(static_cast<unsigned char>(text.back())) && text.back() != '_') text += '.';
  for (std::size_t n = 0; n < versions.size(); ++n) {
    if (versions.size() > kMost && n == kMost - 1) return text + "_to_" + std::to_string(versions.back());
    text += (n ? "_" : "") + std::to_string(versions[n]);
  }
  return text;
}

int extent(const Code& code, const Instruction& instruction, const Operand& operand) {
  using Kind = Instruction::Kind;
  if (instruction.kind == Kind::Lookup) {
    if (&operand == &instruction.a) return (instruction.environment ? 3 : 2) * operand.bytes;
    return code.variables[operand.variable].bytes() - operand.offset;
  }
  if (instruction.kind == Kind::External) {
    if (&operand == &instruction.d) return instruction.external->result.count() * operand.bytes;
    for (std::size_t n = 0; n < instruction.arguments.size(); ++n) {
      if (&operand != &instruction.arguments[n]) continue;
      const std::vector<pfman::Variable*>& parameters = instruction.external->parameters;
      const Type& type = n < parameters.size() ? parameters[n]->type : instruction.external->result;
      return type.count() * operand.bytes;
    }
  }
  const bool noise = instruction.kind == Kind::Operate && (instruction.code == pixelflow::Code::NoiseFixed ||
                                                           instruction.code == pixelflow::Code::NoiseFloat);
  return noise && &operand == &instruction.a ? instruction.scale * operand.bytes : operand.bytes;
}

Access access_of_result(const Code& code, const Instruction& instruction, const Operand& result) {
  const bool whole = result.index < 0 && result.offset == 0 &&
                     extent(code, instruction, result) >= code.variables[result.variable].bytes();
  return whole ? Access::Write : Access::Update;
}

Access access_of_argument(const Code& code, const Instruction& instruction, std::size_t argument) {
  if (instruction.kind == Instruction::Kind::Stage) return Access::Read;
  const std::vector<pfman::Variable*>& parameters = instruction.external->parameters;
  if (argument >= parameters.size()) return access_of_result(code, instruction, instruction.arguments[argument]);
  return parameters[argument]->output ? Access::Update : Access::Read;
}

bool is_plain_copy(const Code& code, const Instruction& i) {
  if (i.kind != Instruction::Kind::Operate || i.code != pixelflow::Code::Copy) return false;
  const auto whole = [&](const Operand& o) {
    const Variable* const v = o.kind == Operand::Kind::Pixel ? &code.variables[o.variable] : nullptr;
    return v && o.index < 0 && o.offset == 0 && v->count == 1 && v->bytes() == o.bytes;
  };
  return whole(i.d) && whole(i.a) && i.d.bytes == i.a.bytes;
}

bool is_light_variable(const Variable& variable) { return variable.address && *variable.address >= kLightDirectionAt; }

std::vector<int> used_at_end(const Code& code) {
  if (code.kind == Shader::Kind::Surface) return code.color;
  std::vector<int> used;
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    if (is_light_variable(code.variables[v])) used.push_back(v);
  }
  return used;
}

void replace_variables(Code& code, const std::vector<int>& to) {
  for (Instruction& instruction : code.code) {
    each_operand(code, instruction, [&](Operand& o, Access) { o.variable = to[o.variable]; });
  }
  const auto all = [&](std::vector<int>& variables) {
    for (int& v : variables) v = to[v];
  };
  for (Parameter& parameter : code.parameters) all(parameter.variables);
  all(code.color);
  all(code.mask_bytes);
  for (Phi& phi : code.phis) {
    phi.d = to[phi.d];
    all(phi.operands);
  }
}

void drop_unmentioned_variables(Code& code) {
  std::vector<bool> mentioned(code.variables.size(), false);
  const auto all = [&](const std::vector<int>& variables) {
    for (const int v : variables) mentioned[v] = true;
  };
  for (const Instruction& instruction : code.code) {
    each_operand(code, instruction, [&](const Operand& o, Access) { mentioned[o.variable] = true; });
  }
  for (const Parameter& parameter : code.parameters) all(parameter.variables);
  all(code.color);
  all(code.mask_bytes);
  for (const Phi& phi : code.phis) {
    mentioned[phi.d] = true;
    all(phi.operands);
  }
  std::vector<int> to(code.variables.size(), -1);
  int next = 0;
  for (int v = 0; v < static_cast<int>(to.size()); ++v) {
    if (!mentioned[v]) continue;
    to[v] = next;
    if (next != v) code.variables[next] = std::move(code.variables[v]);
    ++next;
  }
  replace_variables(code, to);
  code.variables.resize(next);
}

void add_mask_bytes(Code& code, int bits) {
  while (bits > kMaskByteBits * (1 + static_cast<int>(code.mask_bytes.size()))) {
    Variable byte;
    byte.name = "mask" + std::to_string(code.mask_bytes.size() + 1);
    byte.scalar = Scalar::fixed(false, kMaskByteBits, 0);
    byte.temporary = true;
    byte.where = code.where;
    code.mask_bytes.push_back(static_cast<int>(code.variables.size()));
    code.variables.push_back(std::move(byte));
  }
}

void keep_instructions(Code& code, const std::vector<bool>& keep) {
  std::vector<int> to(code.code.size() + 1);
  int next = 0;
  for (std::size_t i = 0; i < code.code.size(); ++i) {
    to[i] = next;
    if (!keep[i]) continue;
    if (next != static_cast<int>(i)) code.code[next] = std::move(code.code[i]);
    ++next;
  }
  to.back() = next;
  code.code.resize(next);
  for (Instruction& instruction : code.code) {
    if (instruction.match >= 0) instruction.match = to[instruction.match];
  }
  for (Phi& phi : code.phis) phi.before = to[phi.before];
}

}  // namespace pfman::ir
