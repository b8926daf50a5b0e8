// Surfaces and lights.
#include <algorithm>

#include "pixelflow/compiler/checker.h"

namespace pfman {

using Kind = ast::Definition::Kind;

void Checker::check_shader(const ast::Definition& definition) {
  auto owned = std::make_unique<Shader>();
  Shader& shader = *owned;
  shader.kind = definition.kind == Kind::Surface ? Shader::Kind::Surface : Shader::Kind::Light;
  const bool surface = shader.kind == Shader::Kind::Surface;
  shader.name = definition.name;
  shader.where = definition.where;
  around_ = Surroundings();
  around_.definition = &definition;
  around_.shader = &shader;
  point_used_ = false;
  scopes_.resize(1);
  scopes_.emplace_back();
  for (const ast::Declarator& declarator : definition.parameters) shader_parameter(declarator, shader);
  const auto colors = std::count_if(shader.parameters.begin(), shader.parameters.end(),
                                    [](const ShaderParameter& one) { return one.variable->name == "px_shader_color"; });
  if (surface && colors != 1) {
    error(120, definition.where,
          "surface '" + definition.name + "' needs the parameter 'output varying px_shader_color'");
  }
  Statements body;
  if (definition.body && surface) surface_body(definition, body);
  if (definition.body && !surface) block(definition.body->body, body, true);
  prologue(shader, shader.body);
  if (!surface) light_colors_before(shader.body);
  for (StatementPtr& statement : body) shader.body.push_back(std::move(statement));
  if (!surface) light_colors_after(shader.body);
  warn_unused(definition);
  scopes_.resize(1);
  tree_.shaders.push_back(std::move(owned));
}

}  // namespace pfman
