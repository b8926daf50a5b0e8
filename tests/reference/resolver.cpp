// Definitions, declarations, types.
#include "tests/reference/resolver.h"

#include "tests/reference/limit.h"
#include "tests/reference/machine.h"

namespace reference {

using Definition = pfman::ast::Definition;

Resolver::Resolver(const pfman::ast::Unit& unit) : unit_(unit) {
  scopes_.emplace_back();
  declare("px_light_direction", signed_fixed(16, 14), {3, 0}, false);
  for (const char* name : {"px_light_color", "px_light_ambient", "px_light_specular"}) {
    declare(name, unsigned_fixed(16, 12), {3, 0}, false);
  }
  declare("px_light_ray", kFloat, {3, 0}, false);
  declare("px_light_distance", kFloat, {}, false);
  declare("px_shader_position", kFloat, {3, 0}, false);
  for (const Definition& definition : unit.definitions) {
    if (definition.kind == Definition::Kind::Constant) declare_constants(definition.declarators);
  }
}

Variable* Resolver::declare(const std::string& name, const Number& number, const Shape& shape, bool uniform) {
  variables_.push_back({name, number, shape, uniform, false, {}});
  return scopes_.back()[name] = &variables_.back();
}

Variable* Resolver::declare(const pfman::ast::Declarator& declarator, bool uniform) {
  const Number number = number_of(*declarator.specifiers);
  return declare(declarator.name, number, shape_of(*declarator.specifiers, declarator.dimensions), uniform);
}

void Resolver::declare_constants(const std::vector<pfman::ast::Declarator>& declarators) {
  for (const auto& declarator : declarators) {
    if (!declarator.initial) fail(122, declarator.where, "constant without a value");
    const Number number = number_of(*declarator.specifiers);
    NodePtr value = root(node(*declarator.initial), number);
    Variable* variable = declare(declarator, true);
    variable->constant = true;
    Machine machine(1);
    variable->value = machine.evaluate(*value);
  }
}

Variable* Resolver::find(const std::string& name, pfman::Location where) const {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const auto found = scope->find(name);
    if (found != scope->end()) return found->second;
  }
  fail(110, where, "unknown name " + name);
}

Number Resolver::number_of(const Specifiers& specifiers) {
  using pfman::ast::Base;
  switch (specifiers.base) {
    case Base::Float: return kFloat;
    case Base::Int: return signed_fixed(32, 0);
    case Base::Bool: return kBool;
    case Base::Fixed: {
      const bool is_signed = specifiers.sign == pfman::ast::Sign::Signed;
      const int size = constant_integer(*specifiers.size), exponent = constant_integer(*specifiers.exponent);
      if (size < 1 + (is_signed ? 1 : 0) || size > 64 || exponent < -64 || exponent > 128) {
        fail(201, specifiers.where, "fixed<> out of range");
      }
      return {false, is_signed, size, exponent};
    }
    case Base::Void: break;
  }
  fail(102, specifiers.where, "void is no type of a value");
}

Shape Resolver::shape_of(const Specifiers& specifiers, const std::vector<pfman::ast::ExpressionPtr>& dimensions) {
  std::vector<int> sizes;
  for (const auto* list : {&dimensions, &specifiers.dimensions}) {
    for (const auto& size : *list) sizes.push_back(constant_integer(*size));
  }
  for (const int size : sizes) {
    if (size < 1 || size > 65536) fail(201, specifiers.where, "array dimension out of range");
  }
  if (sizes.size() > 2) fail(102, specifiers.where, "more than two dimensions");
  return {sizes.empty() ? 0 : sizes[0], sizes.size() < 2 ? 0 : sizes[1]};
}

int Resolver::constant_integer(const Expression& expression) {
  NodePtr value = whole(node(expression));
  if (!is_constant(*value)) fail(201, expression.where, "not constant");
  Machine machine(1);
  const Wide result = machine.integer_of(*value);
  if (result < -1000000 || result > 1000000) fail(201, expression.where, "out of range");
  return static_cast<int>(result);
}

Function& Resolver::function(const std::string& name) {
  const auto found = functions_.find(name);
  if (found != functions_.end()) {
    if (!found->second.body) throw Error(130, "recursion of " + name);
    return found->second;
  }
  const Definition* definition = nullptr;
  for (const Definition& one : unit_.definitions) {
    if (one.kind == Definition::Kind::Function && one.name == name) definition = &one;
  }
  if (definition == nullptr) throw Error(110, "unknown function " + name);
  Function& made = functions_[name];
  made.name = name;
  made.definition = definition;
  // A function sees constants and its own names.
  std::vector<std::map<std::string, Variable*>> callers(scopes_.begin() + 1, scopes_.end());
  scopes_.resize(1);
  std::vector<int> loops;
  loops.swap(varying_ifs_);
  Variable* const result = result_;
  scopes_.emplace_back();
  for (const auto& parameter : definition->parameters) {
    made.parameters.push_back(declare(parameter, parameter.specifiers->rate == pfman::ast::Rate::Uniform));
  }
  if (definition->result->base != pfman::ast::Base::Void) {
    variables_.push_back({name,
                          number_of(*definition->result),
                          shape_of(*definition->result, {}),
                          definition->result->rate == pfman::ast::Rate::Uniform,
                          false,
                          {}});
    made.result = &variables_.back();
  }
  result_ = made.result;
  made.body = step(*definition->body);
  result_ = result;
  varying_ifs_.swap(loops);
  scopes_.resize(1);
  scopes_.insert(scopes_.end(), callers.begin(), callers.end());
  return made;
}

namespace {

/// A shader's parameter: standard ones have their own rate, whatever is written.
bool is_uniform(const pfman::ast::Declarator& declarator) {
  const std::string& name = declarator.name;
  if (!name.starts_with("px_")) return declarator.specifiers->rate != pfman::ast::Rate::Varying;
  return name == "px_shader_eye" || name == "px_shader_time" || name == "px_shader_frame";
}

}  // namespace

Shader Resolver::shader(const std::string& name) {
  for (const Definition& definition : unit_.definitions) {
    const bool light = definition.kind == Definition::Kind::Light;
    if ((!light && definition.kind != Definition::Kind::Surface) || definition.name != name) continue;
    Shader made;
    made.light = light;
    scopes_.emplace_back();
    for (const auto& declarator : definition.parameters) {
      const auto& specifiers = *declarator.specifiers;
      Parameter parameter;
      NodePtr initial = declarator.initial ? node(*declarator.initial) : nullptr;
      parameter.variable = declare(declarator, is_uniform(declarator));
      parameter.unit = specifiers.unit;
      parameter.output = specifiers.output;
      if (initial) parameter.initial = root(std::move(initial), parameter.variable->number);
      made.parameters.push_back(std::move(parameter));
    }
    for (bool& assigned : three_colors_) assigned = false;
    made.body = step(*definition.body);
    for (int n = 0; n < 3; ++n) made.three_colors[n] = three_colors_[n];
    scopes_.resize(1);
    return made;
  }
  throw Error(0, "no shader of the name " + name);
}

}  // namespace reference
