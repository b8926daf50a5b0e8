// Parameters of shaders: the standard ones have their shapes and rates, the others a default.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "pixelflow/compiler/checker.h"

namespace pfman {
namespace {

struct Standard {
  std::string_view name;
  bool of_lights;  ///< lights may declare it too
  bool varying;
  int least, most;  ///< elements; 0: a scalar
};

constexpr std::array kStandards = {
    Standard{"px_material_normal", false, true, 3, 3},   Standard{"px_material_diffuse", false, true, 3, 3},
    Standard{"px_material_ambient", false, true, 3, 3},  Standard{"px_material_specular", false, true, 3, 3},
    Standard{"px_material_emission", false, true, 3, 3}, Standard{"px_material_shininess", false, true, 0, 0},
    Standard{"px_shader_texcoord", false, true, 2, 4},   Standard{"px_shader_position", true, true, 3, 3},
    Standard{"px_shader_view", true, true, 3, 3},        Standard{"px_shader_eye", true, false, 3, 3},
    Standard{"px_shader_time", true, false, 0, 0},       Standard{"px_shader_frame", true, false, 0, 0},
    Standard{"px_shader_color", false, true, 3, 3},
};

const Standard* find_standard(const std::string& name) {
  const auto found =
      std::find_if(kStandards.begin(), kStandards.end(), [&](const Standard& one) { return one.name == name; });
  return found == kStandards.end() ? nullptr : &*found;
}

const char* spelling(ast::Transform transform) {
  switch (transform) {
    case ast::Transform::Point: return "transform_as_point";
    case ast::Transform::Vector: return "transform_as_vector";
    case ast::Transform::Normal: return "transform_as_normal";
    default: return "transform_as_texture";
  }
}

}  // namespace

void Checker::check_attributes(const ast::Declarator& declarator, const Type& type, bool of_shader) {
  const ast::Specifiers& specifiers = *declarator.specifiers;
  const bool transformed = specifiers.transform != ast::Transform::None;
  if (!transformed && !specifiers.unit) return;
  if (!of_shader) {
    const std::string attribute = transformed ? spelling(specifiers.transform) : "unit";
    error(603, specifiers.attribute,
          "'" + attribute + "' has no effect on '" + declarator.name + "', which is no parameter of a shader");
    return;
  }
  const auto has_shape = [&](int least, int most) {
    return type.rank == 1 && type.dimensions[0] >= least && type.dimensions[0] <= most;
  };
  const auto mistake = [&](const std::string& text) {
    error(220, specifiers.attribute, text + "; '" + declarator.name + "' is '" + pfman::spelling(type) + "'");
  };
  if (transformed) {
    const std::string attribute = std::string("'") + spelling(specifiers.transform) + "'";
    switch (specifiers.transform) {
      case ast::Transform::Normal:
        if (!has_shape(3, 3)) mistake(attribute + " needs an array of 3 numbers");
        break;
      case ast::Transform::Texture:
        if (!has_shape(1, 4)) mistake(attribute + " needs an array of 1 to 4 numbers");
        break;
      default:
        if (!has_shape(3, 4)) mistake(attribute + " needs an array of 3 or 4 numbers");
    }
  }
  const bool signed_numbers = type.scalar.is_float || type.scalar.is_signed;
  if (specifiers.unit && (!has_shape(2, 4) || !signed_numbers)) {
    mistake("'unit' needs an array of 2 to 4 float or signed numbers");
  }
}

/// A px_ parameter's name, shape and rate.
void Checker::standard_parameter(const ast::Declarator& declarator, const Type& type) {
  const bool light = around_.definition->kind == ast::Definition::Kind::Light;
  const Standard* standard = find_standard(declarator.name);
  const std::string quoted = "'" + declarator.name + "'";
  if (standard == nullptr || (light && !standard->of_lights)) {
    error(112, declarator.where, quoted + " is no standard parameter of a " + (light ? "light" : "surface"));
    return;
  }
  if (declarator.initial) error(123, declarator.where, "standard parameter " + quoted + " cannot have a default");
  const bool shaped = standard->least == 0 ? type.rank == 0
                                           : type.rank == 1 && type.dimensions[0] >= standard->least &&
                                                 type.dimensions[0] <= standard->most;
  if (!shaped) {
    std::string needed = "a number";
    if (standard->least > 0) needed = "an array of " + std::to_string(standard->least);
    if (standard->most > standard->least) needed += " to " + std::to_string(standard->most);
    error(124, declarator.where,
          "standard parameter " + quoted + " is " + needed + ", not '" + pfman::spelling(type) + "'");
  } else if (type.varying != standard->varying) {
    error(124, declarator.where, "standard parameter " + quoted + " is " + (standard->varying ? "varying" : "uniform"));
  }
  const bool color = declarator.name == "px_shader_color";
  if (declarator.specifiers->output != color) {
    error(color ? 120 : 124, declarator.where,
          color ? "px_shader_color has to be an output" : "standard parameter " + quoted + " cannot be an output");
  }
}

/// Null for a mistake.
NodePtr Checker::default_value(const ast::Declarator& declarator, const Type& type) {
  if (!declarator.initial) {
    error(122, declarator.where, "parameter '" + declarator.name + "' needs a default");
    return nullptr;
  }
  Value value = expression(*declarator.initial);
  if (value.mistake()) return nullptr;
  if (value.type().is_void || !value.type().same_shape(type)) {
    error(203, declarator.initial->where,
          "the default of '" + declarator.name + "' is '" + value.spelled() + "'; '" + pfman::spelling(type) +
              "' is needed");
    return nullptr;
  }
  NodePtr node = convert_to(std::move(value), type.scalar);
  if (!node) return nullptr;
  if (node->type.varying || !is_constant(*node)) {
    error(122, declarator.initial->where, "the default of '" + declarator.name + "' is no constant expression");
    return nullptr;
  }
  return node;
}

void Checker::shader_parameter(const ast::Declarator& declarator, Shader& shader) {
  const ast::Specifiers& specifiers = *declarator.specifiers;
  const bool light = shader.kind == Shader::Kind::Light;
  const std::string& name = declarator.name;
  const bool standard = name.starts_with("px_");
  const Standard* known = standard ? find_standard(name) : nullptr;
  const bool usually_varying = known != nullptr && known->varying;
  const bool varying =
      specifiers.rate == ast::Rate::Varying || (specifiers.rate == ast::Rate::Unspecified && usually_varying);
  const int errors = diagnostics_.errors();
  const std::optional<Type> type = type_of(declarator, varying);
  ShaderParameter parameter;
  if (type) {
    check_attributes(declarator, *type, true);
    if (standard) {
      standard_parameter(declarator, *type);
    } else {
      parameter.initial = default_value(declarator, *type);
      if (specifiers.output) {
        error(120, declarator.where,
              light ? "a light has no output parameters" : "px_shader_color is the only output of a surface");
      }
      if (light && varying) error(121, declarator.where, "parameter '" + name + "' of a light cannot be varying");
    }
  }
  Type declared = type.value_or(Type());
  declared.is_void = !type;
  // What is derived from other things on the shading node is no parameter that comes in.
  const bool point = name == "px_shader_position";
  const bool derived =
      name == "px_shader_view" || name == "px_shader_eye" || (point && (!declared.scalar.is_float || specifiers.unit));
  Variable* variable =
      new_variable(name, declared, derived ? Variable::Role::Local : Variable::Role::Parameter, declarator.where);
  variable->output = specifiers.output;
  variable->unit = specifiers.unit;
  variable->transform = specifiers.transform;
  Symbol& symbol = declare(variable, standard && name != "px_shader_color" ? "input parameter" : nullptr);
  symbol.used = diagnostics_.errors() > errors;  // nothing more is to be said of a mistake
  if (point && !derived) around_.position = variable;
  if (derived) return;
  parameter.variable = variable;
  shader.parameters.push_back(std::move(parameter));
}

/// Where the pixel's point comes in, in eye space.
Variable* Checker::surface_point() {
  if (around_.position == nullptr) {
    Type type;
    type.scalar = Scalar::floating();
    type.varying = true;
    type.rank = 1;
    type.dimensions = {3, 1};
    around_.position = new_variable("px_shader_position", type, Variable::Role::Parameter, around_.definition->where);
    ShaderParameter parameter;
    parameter.variable = around_.position;
    around_.shader->parameters.push_back(std::move(parameter));
  }
  point_used_ = true;
  return around_.position;
}

void Checker::normalize_parameter(Variable* variable, Statements& out) {
  const Location where = variable->where;
  Nodes before;
  NodePtr vector = write_.normalized(to_float(make_read(variable, where)), before);
  NodePtr value = make_sequence(std::move(before), std::move(vector), where);
  out.push_back(make_evaluate(
      make_assign(make_read(variable, where), make_convert(std::move(value), variable->type.scalar), where)));
}

/// What is done before the shader's first statement, for the parameters that it uses.
void Checker::prologue(Shader& shader, Statements& out) {
  Statements units;
  for (const ast::Declarator& declarator : around_.definition->parameters) {
    const Symbol* symbol = find(declarator.name);
    if (symbol == nullptr || !symbol->used || symbol->variable->where != declarator.where) continue;
    Variable* variable = symbol->variable;
    if (variable->type.is_void) continue;
    const Location where = variable->where;
    const auto assign = [&](NodePtr value) {
      out.push_back(make_evaluate(
          make_assign(make_read(variable, where), make_convert(std::move(value), variable->type.scalar), where)));
    };
    if (declarator.name == "px_shader_view") {
      Nodes before;
      NodePtr view = write_.normalized(make_read(surface_point(), where), before);
      assign(make_sequence(std::move(before), std::move(view), where));
    } else if (declarator.name == "px_shader_eye") {
      assign(make_array(nodes(make_float(0, where), make_float(0, where), make_float(0, where)), where));
    } else {
      if (declarator.name == "px_shader_position" && variable->role == Variable::Role::Local) {
        assign(make_read(surface_point(), where));
      }
      if (variable->unit) normalize_parameter(variable, units);
    }
  }
  for (StatementPtr& unit : units) out.push_back(std::move(unit));
  for (ShaderParameter& parameter : shader.parameters) {
    const Symbol* symbol = find(parameter.variable->name);
    const bool named = symbol != nullptr && symbol->variable == parameter.variable && symbol->used;
    parameter.used = named || parameter.variable->output || (parameter.variable == around_.position && point_used_);
  }
}

void Checker::warn_unused(const ast::Definition& definition) {
  for (const ast::Declarator& declarator : definition.parameters) {
    const Symbol* symbol = find(declarator.name);
    if (symbol == nullptr || symbol->used || declarator.name == "px_shader_color") continue;
    const Type& type = symbol->variable->type;
    if (type.is_void) continue;
    std::string text = "parameter '" + declarator.name + "' is not used";
    const bool travels =
        type.varying && symbol->variable->role == Variable::Role::Parameter && declarator.name != "px_shader_position";
    if (travels) text += ", but every pixel carries its " + std::to_string(type.bytes()) + " bytes";
    error(606, declarator.where, std::move(text));
  }
}

}  // namespace pfman
