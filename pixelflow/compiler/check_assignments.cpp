// Assignments and what may be assigned where.
#include "pixelflow/compiler/checker.h"

namespace pfman {

using Kind = ast::Expression::Kind;

namespace {

const ast::Expression& base_of(const ast::Expression& expression) {
  const ast::Expression* base = &expression;
  while (base->kind == Kind::Index) base = base->operands[0].get();
  return *base;
}

bool is_written_by_lights(const std::string& name) {
  return name == "px_light_color" || name == "px_light_ambient" || name == "px_light_specular";
}

}  // namespace

/// A variable or an element of one, to be read and written. Null for a mistake.
NodePtr Checker::place(const ast::Expression& expression, Nodes& before) {
  if (expression.kind == Kind::Name) return settle(name(expression));
  if (expression.kind != Kind::Index) {
    error(306, expression.where, "what stands here is no variable and cannot be assigned");
    return nullptr;
  }
  NodePtr array = place(*expression.operands[0], before);
  if (!array) return nullptr;
  if (!array->type.is_array()) {
    error(203, expression.operands[1]->where, "an index of type '" + spelling(array->type) + "', which is no array");
    return nullptr;
  }
  NodePtr index = index_of(array->type, *expression.operands[1]);
  if (!index) return nullptr;
  if (!is_pure(*index)) index = write_.reuse(std::move(index), before);
  return make_element(*array, *index);
}

/// Whether a value, varying or not, may be assigned to what `expression`, a place, names.
bool Checker::assignable(const ast::Expression& expression, bool varying, Location where) {
  const std::string& name = base_of(expression).name;
  if (name.starts_with("px_light_")) {
    if (around_.in_illuminance || !is_written_by_lights(name)) {
      error(306, where, "'" + name + "' can only be read here");
      return false;
    }
    around_.colors_assigned.insert(name);
    return true;
  }
  const Symbol* symbol = find(name);
  if (symbol->protection != nullptr && !(symbol->shared && in_common_code_)) {
    error(306, where, "cannot assign to " + std::string(symbol->protection) + " '" + name + "'");
    return false;
  }
  if (symbol->variable->type.varying) return true;
  if (varying) {
    error(301, where, "cannot assign a varying value to uniform variable '" + name + "'");
    return false;
  }
  if (symbol->masks < around_.masks) {
    error(
        302, where,
        "cannot assign to uniform variable '" + name + "' under a varying condition, which holds for some pixels only");
    return false;
  }
  for (std::size_t n = symbol->loops; n < around_.loops.size(); ++n) {
    around_.loops[n].assigned.push_back({name, where});
  }
  return true;
}

Value Checker::assignment(const ast::Expression& expression) {
  const ast::Expression& target = *expression.operands[0];
  Nodes before;
  NodePtr place = this->place(target, before);
  Value value = this->expression(*expression.operands[1]);
  ++effects_;
  if (!place || value.mistake()) return {};
  if (expression.op != ast::Operator::None) {
    value = binary(expression.op, Value::typed(clone(*place)), std::move(value), expression.where);
    if (value.mistake()) return {};
  }
  const Type type = value.type();
  const std::string given = value.spelled();
  if (type.is_void) return mistake(202, value.where, "a call of a void function has no value");
  if (!type.same_shape(place->type)) {
    return mistake(203, expression.where,
                   "cannot assign '" + given + "' to '" + spelling(place->type) + "': their shapes differ");
  }
  if (!assignable(target, type.varying, expression.where)) return {};
  NodePtr converted = convert_to(std::move(value), place->exact);
  if (!converted) return {};
  NodePtr node = make_assign(std::move(place), std::move(converted), expression.where);
  return Value::typed(make_sequence(std::move(before), std::move(node), expression.where));
}

Value Checker::postfix(const ast::Expression& expression) {
  const ast::Expression& target = *expression.operands[0];
  Nodes before;
  NodePtr place = this->place(target, before);
  ++effects_;
  if (!place) return {};
  if (place->type.is_array()) {
    return mistake(202, expression.where, "'++' and '--' take a number, not '" + spelling(place->type) + "'");
  }
  if (!assignable(target, false, expression.where)) return {};
  const bool up = expression.kind == Kind::PostIncrement;
  Value next = binary(up ? ast::Operator::Add : ast::Operator::Subtract, Value::typed(clone(*place)),
                      Value::whole(1, expression.where), expression.where);
  const Type type = place->type;
  const Scalar scalar = place->exact;
  NodePtr converted = convert_to(std::move(next), scalar);
  if (!converted) return {};
  NodePtr node = make_node(Node::Op::Postfix, scalar, nodes(std::move(place), std::move(converted)), expression.where);
  node->type = type;
  return Value::typed(make_sequence(std::move(before), std::move(node), expression.where));
}

}  // namespace pfman
