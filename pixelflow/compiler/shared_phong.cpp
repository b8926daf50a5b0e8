#include "pixelflow/compiler/shared_phong.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/compiler/stage_walker.h"

namespace pfman {
namespace {

using Kind = ir::Instruction::Kind;

constexpr int kComponents = 3;
constexpr int kFirstResult = 13;  ///< among the numbers: normal, view, kd, ks, exp come before
constexpr int kNumbers = 19;      ///< and six results

/// Numbers of the variables of the source, one after another; empty where one is missing.
std::vector<ir::Operand> operands_of(const ir::Code& code, const std::string& source) {
  std::vector<ir::Operand> operands;
  for (std::size_t v = 0; v < code.variables.size(); ++v) {
    const ir::Variable& variable = code.variables[v];
    if (variable.source != source) continue;
    for (int n = 0; n < variable.count; ++n) {
      ir::Operand operand;
      operand.kind = ir::Operand::Kind::Pixel;
      operand.is_signed = variable.scalar.is_signed;
      operand.variable = static_cast<int>(v);
      operand.bytes = variable.scalar.bytes();
      operand.offset = n * operand.bytes;
      operands.push_back(operand);
    }
  }
  return operands;
}

const ir::Instruction* stage(const ir::Code& code, int number) {
  for (const ir::Instruction& instruction : code.code) {
    if (instruction.kind == Kind::Stage && instruction.stage == number) return &instruction;
  }
  return nullptr;
}

bool reads_after_lights(const ir::Code& code, const std::vector<ir::Operand>& results) {
  const ir::Instruction* const post = stage(code, 2);
  const auto is_result = [&](const ir::Operand& operand) {
    return operand.kind == ir::Operand::Kind::Pixel &&
           std::any_of(results.begin(), results.end(),
                       [&](const ir::Operand& result) { return result.variable == operand.variable; });
  };
  for (const ir::Instruction* at = post + 1; at != code.code.data() + code.code.size(); ++at) {
    if (is_result(at->a) || is_result(at->b)) return true;
  }
  return false;
}

std::string common_surface(const ir::Code::SharedPhong& types) {
  return "#pragma pfman shared_phong\n"
         "surface shared_phong(output varying fixed<8,8> px_shader_color[3],\n"
         "    varying " +
         spelling(types.normal) + " px_material_normal[3], varying " + spelling(types.view) +
         " px_shader_view[3], varying float px_material_diffuse[3],\n"
         "    varying float px_material_specular[3], varying float px_material_shininess) {\n"
         "  px_magic_kd = px_material_diffuse;\n  px_magic_ks = px_material_specular;\n"
         "  px_magic_exp = px_material_shininess;\n"
         "  px_shader_color = px_magic_diffuse + px_magic_highlight;\n}\n";
}

/// The places of what the stage names.
std::vector<int> places(const CompiledShader& surface, int number) {
  std::vector<int> result;
  for (const ir::Operand& operand : stage(surface.code, number)->arguments) {
    result.push_back(surface.map.address[static_cast<std::size_t>(operand.variable)] + operand.offset);
  }
  return result;
}

std::vector<int> sizes(const ir::Code& code) {
  std::vector<int> result;
  for (const ir::Operand& operand : stage(code, 1)->arguments) result.push_back(operand.bytes);
  return result;
}

}  // namespace

void mark_shared_phong(ir::Code& code, const Shader& shader) {
  if (!shader.shared_phong || !code.has_illuminance) return;
  std::vector<ir::Operand> inputs, results;
  for (const char* name : {"px_material_normal", "px_shader_view", "px_magic_kd", "px_magic_ks", "px_magic_exp"}) {
    const std::vector<ir::Operand> numbers = operands_of(code, name);
    inputs.insert(inputs.end(), numbers.begin(), numbers.end());
  }
  for (const char* name : {"px_magic_diffuse", "px_magic_highlight"}) {
    const std::vector<ir::Operand> numbers = operands_of(code, name);
    if (!reads_after_lights(code, numbers)) return;
    results.insert(results.end(), numbers.begin(), numbers.end());
  }
  if (inputs.size() != kFirstResult || inputs.size() + results.size() != kNumbers) return;
  const auto scalar = [&](std::size_t n) {
    return code.variables[static_cast<std::size_t>(inputs[n].variable)].scalar;
  };
  code.shared_phong = {scalar(0), scalar(kComponents)};
  for (ir::Instruction& instruction : code.code) {
    if (instruction.kind != Kind::Stage) continue;
    if (instruction.stage == 1) instruction.arguments = inputs;
    instruction.arguments.insert(instruction.arguments.end(), results.begin(), results.end());
  }
}

SharedPhong::SharedPhong(const CompiledShader& surface) : types_(surface.code.shared_phong.value()) {
  Diagnostics diagnostics;
  unit_ = compile_text(common_surface(types_), "shared_phong", {}, diagnostics);
  if (diagnostics.has_errors() || !unit_->shaders[0].code.shared_phong) {
    throw std::logic_error("the common lighting does not compile: " + diagnostics.text());
  }
  const CompiledShader& common = unit_->shaders[0];
  std::array<bool, pixelflow::kMemoryBytes> in_block{}, used{};
  const std::vector<int> at = places(common, 1), bytes = sizes(common.code);
  block_bytes_ = std::accumulate(bytes.begin(), bytes.end(), 0);
  for (std::size_t n = 0; n < at.size(); ++n) std::fill_n(in_block.begin() + at[n], bytes[n], true);
  for (const auto& part : own_illum({}).parts) {
    for (const pixelflow::Instruction& i : part.program.instructions) {
      if (reads_memory(i) || writes_memory(i)) used[i.addr] = true;
    }
    for (const pixelflow::Step& step : part.program.steps) {
      if (!step.operation) continue;
      const pixelflow::Operation& o = *step.operation;
      std::fill_n(used.begin() + o.work, step.workspace_bytes, true);
      for (const pixelflow::Operand& operand : {o.d, o.a, o.b}) {
        if (!operand.uniform) std::fill_n(used.begin() + operand.address, operand.bytes, true);
      }
    }
  }
  for (int address = kParametersAt; address < kSharedAt; ++address) {
    const auto byte = static_cast<std::size_t>(address);
    if (used[byte] && !in_block[byte]) work_.push_back(address);
  }
}

bool SharedPhong::serves(const CompiledShader& surface) const {
  const auto& types = surface.code.shared_phong;
  return types && types->normal == types_.normal && types->view == types_.view;
}

Stream SharedPhong::own_illum(const std::vector<int>& ids) const {
  const CompiledShader& common = unit_->shaders[0];
  const StageBounds bounds = stages(common.code);
  Environment environment;
  Stream stream;
  StageWalker(common, environment, ids, stream).walk(bounds.illum, bounds.illum_end, nullptr, false);
  return stream;
}

Stream SharedPhong::illum(int block, const std::vector<int>& ids) const {
  std::array<std::uint8_t, pixelflow::kMemoryBytes> to{};
  std::iota(to.begin(), to.end(), std::uint8_t{0});
  const std::vector<int> at = places(unit_->shaders[0], 1), bytes = sizes(unit_->shaders[0].code);
  int next = block;
  for (std::size_t n = 0; n < at.size(); ++n) {
    for (int byte = 0; byte < bytes[n]; ++byte)
      to[static_cast<std::size_t>(at[n] + byte)] = static_cast<std::uint8_t>(next++);
  }
  for (const int address : work_) to[static_cast<std::size_t>(address)] = static_cast<std::uint8_t>(next++);

  Stream stream = own_illum(ids);
  for (auto& part : stream.parts) {
    for (pixelflow::Instruction& i : part.program.instructions) {
      if (reads_memory(i) || writes_memory(i)) i.addr = to[i.addr];
    }
    for (pixelflow::Step& step : part.program.steps) {
      if (!step.operation) continue;
      pixelflow::Operation& o = *step.operation;
      for (pixelflow::Operand* operand : {&o.d, &o.a, &o.b}) operand->address = to[operand->address];
      o.work = to[o.work];
    }
  }
  return stream;
}

Stream SharedPhong::copies(const CompiledShader& surface, int block, const std::vector<int>& ids, bool back) const {
  Stream stream;
  StreamWriter out(stream);
  out.at(surface.code.where);
  out.bare([&](pixelflow::Assembler& assembler) { enable_ids(assembler, ids); });
  const std::vector<int> before = places(surface, 1), after = places(surface, 2), bytes = sizes(surface.code);
  int next = block;
  for (std::size_t n = 0; n < before.size(); ++n) {
    const auto size = static_cast<std::uint8_t>(bytes[n]);
    const pixelflow::Operand common{.address = static_cast<std::uint8_t>(next), .bytes = size};
    next += size;
    if (back && n < kFirstResult) continue;
    const int own_at = back ? after[n - kFirstResult] : before[n];
    const pixelflow::Operand own{.address = static_cast<std::uint8_t>(own_at), .bytes = size};
    out.operate({.d = back ? own : common, .a = back ? common : own, .b = {}});
  }
  return stream;
}

}  // namespace pfman
