// Lights and the surfaces' loop over them (Olano and Lastra 1998, section 6.1.5.1): what illuminance, illuminate and
// solar mean, written out as ordinary statements.
//
//   illuminance(P, axis, angle) S    if (dot(normalize(axis), px_light_direction) >= cos(angle)) S
//   illuminate(position, axis, angle) S
//       px_light_ray = px_shader_position - position; px_light_distance = length(px_light_ray);
//       px_light_direction = -px_light_ray / px_light_distance; S
//       if (dot(px_light_ray, axis) / (px_light_distance * length(axis)) < cos(angle)) all three colours = 0;
//   solar(axis, angle) S             px_light_ray = normalize(axis); px_light_direction = -px_light_ray; S
//
// A light starts with black colours. One with neither illuminate nor solar is ambient: its direction is 0, and at its
// end the ambient colour becomes the diffuse one, if no statement assigns it, and the diffuse one black. At last the
// specular colour becomes the diffuse one if no statement assigns it.
#include <algorithm>
#include <array>

#include "pixelflow/compiler/checker.h"

namespace pfman {

using Op = Node::Op;

namespace {

constexpr std::array kColors = {"px_light_color", "px_light_ambient", "px_light_specular"};

Type vector_type(const Scalar& scalar, bool varying) {
  Type type;
  type.scalar = scalar;
  type.varying = varying;
  type.rank = 1;
  type.dimensions = {3, 1};
  return type;
}

NodePtr zeros(const Scalar& scalar, Location where) {
  Nodes elements;
  for (int n = 0; n < 3; ++n) elements.push_back(make_literal(scalar, 0, where));
  return make_array(std::move(elements), where);
}

}  // namespace

/// A variable of the communication area.
Variable* Checker::communicated(const std::string& name) {
  Variable*& variable = light_variables_[name];
  if (variable == nullptr) {
    const bool direction = name == "px_light_direction";
    const Scalar scalar = direction ? Scalar::fixed(true, 16, 14) : Scalar::fixed(false, 16, 12);
    variable = new_variable(name, vector_type(scalar, true), Variable::Role::Light, {});
  }
  return variable;
}

Value Checker::light_variable(const ast::Expression& expression) {
  const std::string& name = expression.name;
  const bool color = std::find(kColors.begin(), kColors.end(), name) != kColors.end();
  const bool in_light = around_.shader != nullptr && around_.shader->kind == Shader::Kind::Light;
  const auto read = [&](Variable* variable) { return Value::typed(make_read(variable, expression.where)); };
  if (color && in_light) {
    around_.colors_named.insert(name);
    return read(communicated(name));
  }
  if (around_.in_illuminance && (color || name == "px_light_direction")) {
    if (name == "px_light_ambient" || name == "px_light_specular") around_.shader->three_colours = true;
    return read(communicated(name));
  }
  if (name == "px_light_ray" && (around_.in_illuminate || around_.in_solar)) return read(around_.ray);
  if (name == "px_light_distance" && around_.in_illuminate) return read(around_.distance);
  const char* scope = nullptr;
  if (color) scope = "the body of illuminance and in lights";
  if (name == "px_light_direction") scope = "the body of illuminance";
  if (name == "px_light_ray") scope = "the bodies of illuminate and solar";
  if (name == "px_light_distance") scope = "the body of illuminate";
  if (scope == nullptr) return mistake(110, expression.where, "undeclared identifier '" + name + "'");
  return mistake(405, expression.where, "'" + name + "' is known in " + scope + " only");
}

/// A float number (rank 0) or vector of three (rank 1). Null for a mistake.
NodePtr Checker::float_of(const ast::Expression& expression, int rank, const char* what) {
  Value value = this->expression(expression);
  if (value.mistake()) return nullptr;
  const Type& type = value.type();
  if (type.is_void || type.rank != rank || (rank == 1 && type.dimensions[0] != 3)) {
    error(132, expression.where,
          std::string(what) + " is " + (rank == 1 ? "an array of 3 numbers" : "a number") + ", not '" + spelling(type) +
              "'");
    return nullptr;
  }
  return convert_to(std::move(value), Scalar::floating());
}

void Checker::illuminance(const ast::Statement& statement, Statements& out, bool top_level) {
  const bool surface = around_.shader != nullptr && around_.shader->kind == Shader::Kind::Surface;
  if (!surface) {
    error(403, statement.where, "'illuminance' is possible in surfaces only");
    return;
  }
  if (!top_level) {
    error(402, statement.where,
          "'illuminance' has to be a statement of the surface's own block, in no other statement");
    return;
  }
  if (around_.illuminance_seen) {
    error(401, statement.where, "a surface has one 'illuminance' at most");
    return;
  }
  around_.illuminance_seen = true;
  const auto& given = statement.expressions;
  if (!given.empty() && (given[0]->kind != ast::Expression::Kind::Name || given[0]->name != "px_shader_position")) {
    error(407, given[0]->where, "the position of 'illuminance' can only be px_shader_position");
  } else if (Symbol* position = given.empty() ? nullptr : find("px_shader_position")) {
    position->used = true;
  }
  StatementPtr result = make_statement(Statement::Kind::Illuminance, statement.where);
  StatementPtr whole = make_statement(Statement::Kind::Block, statement.where);
  NodePtr inside;
  if (given.size() == 3) {
    NodePtr axis = float_of(*given[1], 1, "the axis of a cone");
    NodePtr angle = float_of(*given[2], 0, "the angle of a cone");
    if (axis && angle) {
      Nodes before;
      const NodePtr along = write_.keep(write_.normalized(std::move(axis), before), before);
      const NodePtr direction = to_float(make_read(communicated("px_light_direction"), given[1]->where));
      NodePtr cosine = make_math(pixelflow::Code::Cos, nodes(std::move(angle)), given[2]->where);
      inside = make_operation(Op::LessEqual, nodes(std::move(cosine), make_dot(*along, *direction, given[1]->where)),
                              given[1]->where);
      inside = make_sequence(std::move(before), std::move(inside), given[1]->where);
    }
  }
  around_.in_illuminance = true;
  if (inside) ++around_.masks;
  StatementPtr body = scoped(*statement.body[0]);
  if (inside) --around_.masks;
  around_.in_illuminance = false;
  if (inside) {
    StatementPtr chosen = make_statement(Statement::Kind::If, statement.where);
    chosen->expression = std::move(inside);
    chosen->body.push_back(std::move(body));
    body = std::move(chosen);
  }
  whole->body.push_back(std::move(body));
  result->body.push_back(std::move(whole));
  out.push_back(std::move(result));
}

/// illuminate and solar.
void Checker::light_source(const ast::Statement& statement, Statements& out, bool top_level) {
  const bool local = statement.kind == ast::Statement::Kind::Illuminate;
  const std::string name = local ? "'illuminate'" : "'solar'";
  if (around_.shader == nullptr || around_.shader->kind != Shader::Kind::Light) {
    error(404, statement.where, name + " is possible in lights only");
    return;
  }
  if (!top_level || around_.source_seen) {
    error(404, statement.where,
          around_.source_seen && top_level
              ? "a light has one 'illuminate' or 'solar' at most"
              : name + " has to be a statement of the light's own block, in no other statement");
    return;
  }
  around_.source_seen = true;
  const auto& given = statement.expressions;
  if (!local && given.empty()) {
    error(406, statement.where, "'solar' needs an axis and an angle");
    return;
  }
  StatementPtr whole = make_statement(Statement::Kind::Block, statement.where);
  Statements& list = whole->body;
  const Location where = statement.where;
  const auto assign = [&](Variable* variable, NodePtr value) {
    list.push_back(make_evaluate(make_assign(make_read(variable, where), std::move(value), where)));
  };
  NodePtr axis, angle;
  if (local) {
    NodePtr position = float_of(*given[0], 1, "the position of a light");
    if (given.size() == 3) {
      axis = float_of(*given[1], 1, "the axis of a cone");
      angle = float_of(*given[2], 0, "the angle of a cone");
    }
    around_.ray = new_variable("px_light_ray", vector_type(Scalar::floating(), true), Variable::Role::Local, where);
    Type number;
    number.scalar = Scalar::floating();
    number.varying = true;
    around_.distance = new_variable("px_light_distance", number, Variable::Role::Local, where);
    if (position) {
      assign(around_.ray,
             make_operation(Op::Subtract, nodes(make_read(surface_point(), where), std::move(position)), where));
    }
    const NodePtr ray = make_read(around_.ray, where);
    assign(around_.distance, make_operation(Op::SquareRoot, nodes(make_dot(*ray, *ray, where)), where));
    NodePtr towards = make_operation(Op::Negate, nodes(clone(*ray)), where);
    NodePtr unit = make_operation(Op::Divide, nodes(std::move(towards), make_read(around_.distance, where)), where);
    Variable* direction = communicated("px_light_direction");
    assign(direction, make_convert(std::move(unit), direction->type.scalar));
  } else {
    axis = float_of(*given[0], 1, "the axis of a distant light");
    angle = float_of(*given[1], 0, "the angle of a distant light");
    const bool is_zero = angle && angle->op == Op::Literal && to_double(angle->raw, angle->exact) == 0;
    if (angle && !is_zero) error(603, given[1]->where, "the angle of 'solar' has no effect; it counts as 0");
    const bool varying = axis && axis->type.varying;
    around_.ray = new_variable("px_light_ray", vector_type(Scalar::floating(), varying), Variable::Role::Local, where);
    if (axis) {
      Nodes before;
      NodePtr unit = write_.normalized(std::move(axis), before);
      assign(around_.ray, make_sequence(std::move(before), std::move(unit), where));
    }
    Variable* direction = communicated("px_light_direction");
    NodePtr towards = make_operation(Op::Negate, nodes(make_read(around_.ray, where)), where);
    assign(direction, make_convert(std::move(towards), direction->type.scalar));
    axis = nullptr;
  }
  (local ? around_.in_illuminate : around_.in_solar) = true;
  list.push_back(scoped(*statement.body[0]));
  around_.in_illuminate = around_.in_solar = false;
  if (axis && angle) {
    Nodes before;
    axis = write_.reuse(std::move(axis), before);
    const NodePtr ray = make_read(around_.ray, where);
    NodePtr length = make_operation(Op::SquareRoot, nodes(make_dot(*axis, *axis, where)), where);
    NodePtr lengths = make_operation(Op::Multiply, nodes(make_read(around_.distance, where), std::move(length)), where);
    NodePtr along = make_operation(Op::Divide, nodes(make_dot(*ray, *axis, where), std::move(lengths)), where);
    NodePtr cosine = make_math(pixelflow::Code::Cos, nodes(std::move(angle)), where);
    NodePtr outside = make_operation(Op::Less, nodes(std::move(along), std::move(cosine)), where);
    StatementPtr dark = make_statement(Statement::Kind::If, where);
    dark->expression = make_sequence(std::move(before), std::move(outside), where);
    StatementPtr black = make_statement(Statement::Kind::Block, where);
    for (const char* color : kColors) {
      if (!around_.colors_named.contains(color)) continue;
      Variable* variable = communicated(color);
      black->body.push_back(
          make_evaluate(make_assign(make_read(variable, where), zeros(variable->type.scalar, where), where)));
    }
    if (!black->body.empty()) {
      dark->body.push_back(std::move(black));
      list.push_back(std::move(dark));
    }
  }
  out.push_back(std::move(whole));
}

void Checker::light_colors_before(Statements& out) {
  const Location where = around_.definition->where;
  const auto clear = [&](const char* name) {
    Variable* variable = communicated(name);
    out.push_back(make_evaluate(make_assign(make_read(variable, where), zeros(variable->type.scalar, where), where)));
  };
  if (!around_.source_seen) clear("px_light_direction");
  clear("px_light_color");
  clear("px_light_ambient");
  if (around_.colors_named.contains("px_light_specular")) clear("px_light_specular");
}

void Checker::light_colors_after(Statements& out) {
  const Location where = around_.definition->where;
  const auto& assigned = around_.colors_assigned;
  const auto assign = [&](const char* name, NodePtr value) {
    out.push_back(make_evaluate(make_assign(make_read(communicated(name), where), std::move(value), where)));
  };
  const auto color = [&] { return make_read(communicated("px_light_color"), where); };
  const bool ambient = !around_.source_seen;
  if (ambient) {
    if (!assigned.contains("px_light_ambient")) assign("px_light_ambient", color());
    assign("px_light_color", zeros(communicated("px_light_color")->type.scalar, where));
  }
  around_.shader->three_colours = ambient || assigned.size() == kColors.size();
  if (!assigned.contains("px_light_specular")) assign("px_light_specular", color());
}

}  // namespace pfman
