#include "pixelflow/compiler/lower.h"

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lowering.h"
#include "pixelflow/compiler/memory_layout.h"

namespace pfman {
namespace {

/// The position as it lies in the shared area; a shader that declares it in another type has a variable of its own too.
bool is_position(const Variable& variable) {
  return variable.role == Variable::Role::Parameter && variable.name == "px_shader_position";
}

/// Where a varying parameter or a light variable has to lie; nothing for those that the shader computes itself.
std::optional<int> fixed_place(const Variable& variable) {
  if (is_position(variable)) return kPositionAt;
  if (variable.role != Variable::Role::Light) return std::nullopt;
  if (variable.name == "px_light_direction") return kLightDirectionAt;
  if (variable.name == "px_light_color") return kLightColorAt;
  if (variable.name == "px_light_ambient") return kLightAmbientAt;
  if (variable.name == "px_light_specular") return kLightSpecularAt;
  return std::nullopt;
}

std::string element_name(const Variable& variable, int element) {
  const Type& type = variable.type;
  if (!type.is_array()) return variable.name;
  if (type.rank == 1) return variable.name + "[" + std::to_string(element) + "]";
  return variable.name + "[" + std::to_string(element / type.dimensions[1]) + "][" +
         std::to_string(element % type.dimensions[1]) + "]";
}

}  // namespace

Lowering::Lowering(const Tree& tree, const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics)
    : Arithmetic(shader, options, diagnostics), tree_(tree) {
  code_.kind = shader.kind;
  code_.name = shader.name;
  code_.where = shader.where;
  for (const NodePtr& constant : tree.constants) unit_constants_.insert(constant->operands.at(0)->variable);
}

ir::Code Lowering::run() {
  where_ = shader_.where;
  note_variables(shader_.body);
  declare_parameters();
  lower_body(shader_.body);
  finish_colour();
  ir::add_mask_bytes(code_, code_.mask_bits);
  return std::move(code_);
}

void Lowering::note_variables(const std::vector<StatementPtr>& body) {
  for (const StatementPtr& statement : body) note_variables(*statement);
}

void Lowering::note_variables(const Statement& statement) {
  if (statement.expression) note_variables(*statement.expression);
  if (statement.step) note_variables(*statement.step);
  note_variables(statement.body);
}

void Lowering::note_variables(const Node& node) {
  const auto root = [](const Node* place) {
    while (place->op == Op::Element) place = place->operands[0].get();
    return place->op == Op::Variable ? place->variable : nullptr;
  };
  for (const NodePtr& operand : node.operands) note_variables(*operand);
  if (node.op == Op::Assign || node.op == Op::Postfix) written_.insert(root(node.operands[0].get()));
  if (node.op == Op::Element && node.operands[1]->op != Op::Literal) indexed_.insert(root(&node));
  if (node.op != Op::Call) return;
  for (std::size_t n = 0; n < node.operands.size(); ++n) {
    if (node.function->parameters[n]->output) written_.insert(root(node.operands[n].get()));
  }
  if (!noted_.insert(node.function).second) return;
  note_variables(node.function->body);
  if (node.function->value) note_variables(*node.function->value);
}

void Lowering::declare_parameters() {
  int next = kParametersAt;
  for (const ShaderParameter& declared : shader_.parameters) {
    const Variable& variable = *declared.variable;
    ir::Parameter parameter;
    parameter.declared = &declared;
    const bool made_here = variable.output || variable.name == "px_shader_view";
    if (variable.type.varying && !made_here) {
      parameter.variables = binding(variable).variables;
      if (!fixed_place(variable)) {
        for (const int number : parameter.variables) {
          ir::Variable& placed = code_.variables[static_cast<std::size_t>(number)];
          placed.address = next;
          next += placed.bytes();
        }
      }
    }
    code_.parameters.push_back(std::move(parameter));
  }
}

Lowering::Binding& Lowering::binding(const Variable& variable) {
  const auto found = bindings_.find(&variable);
  if (found != bindings_.end()) return found->second;
  Binding made;
  const std::optional<int> place = fixed_place(variable);
  const bool together = indexed_.contains(&variable);
  const int count = variable.type.count();
  for (int n = 0; n < (together ? 1 : count); ++n) {
    const std::string name = together ? variable.name : element_name(variable, n);
    const int number = add_variable(name, variable.type.scalar, together ? count : 1, false);
    ir::Variable& added = code_.variables[static_cast<std::size_t>(number)];
    added.where = variable.where;
    added.source = variable.name;
    added.temporary = variable.role == Variable::Role::Hidden;
    if (place) added.address = *place + n * variable.type.scalar.bytes();
    made.variables.push_back(number);
  }
  if (is_position(variable)) code_.needs_position = true;
  return bindings_[&variable] = std::move(made);
}

void Lowering::finish_colour() {
  if (shader_.kind != Shader::Kind::Surface) return;
  for (const ShaderParameter& parameter : shader_.parameters) {
    const Variable& variable = *parameter.variable;
    if (!variable.output) continue;
    const Binding colour = binding(variable);
    if (static_cast<int>(colour.variables.size()) == variable.type.count()) {
      code_.color.insert(code_.color.end(), colour.variables.begin(), colour.variables.end());
      continue;
    }
    for (int n = 0; n < variable.type.count(); ++n) {
      const int number = add_variable(element_name(variable, n), variable.type.scalar, 1, true);
      operate_into(whole(number), Code::Copy, whole(colour.variables[0], n));
      code_.color.push_back(number);
    }
  }
}

ir::Code lower(const Tree& tree, const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics) {
  return Lowering(tree, shader, options, diagnostics).run();
}

}  // namespace pfman
