// Names, types as they are declared, and constant expressions.
#include <cmath>

#include "pixelflow/compiler/checker.h"
#include "pixelflow/compiler/size_fixed.h"

namespace pfman {

Value Checker::mistake(int code, Location where, std::string text) {
  error(code, where, std::move(text));
  return {};
}

Variable* Checker::new_variable(std::string name, const Type& type, Variable::Role role, Location where) {
  return add_variable(tree_, std::move(name), type, role, where);
}

Symbol* Checker::find(const std::string& name) {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const auto found = scope->find(name);
    if (found != scope->end()) return &found->second;
  }
  return nullptr;
}

Symbol& Checker::declare(Variable* variable, const char* protection) {
  const std::string& name = variable->name;
  auto& scope = scopes_.back();
  const auto found = scope.find(name);
  if (found != scope.end()) {
    diagnostics_.add({111,
                      variable->where,
                      "'" + name + "' is declared twice in the same block",
                      {{found->second.variable->where, "the first declaration"}}});
  } else if (const Symbol* outer = in_common_code_ ? nullptr : find(name)) {
    diagnostics_.add({605,
                      variable->where,
                      "'" + name + "' hides a variable of the same name",
                      {{outer->variable->where, "the hidden variable"}}});
  }
  Symbol& symbol = scope[name];
  symbol = {variable, protection, around_.masks, around_.loops.size(), false, false};
  return symbol;
}

std::optional<Scalar> Checker::scalar_of(const ast::Specifiers& specifiers) {
  switch (specifiers.base) {
    case ast::Base::Float: return Scalar::floating();
    case ast::Base::Int: return Scalar::integer();
    case ast::Base::Bool: return Scalar::boolean();
    case ast::Base::Void: return std::nullopt;
    case ast::Base::Fixed: break;
  }
  if (!specifiers.size || !specifiers.exponent) return std::nullopt;
  const std::optional<std::int64_t> size = constant_integer(*specifiers.size);
  const std::optional<std::int64_t> exponent = constant_integer(*specifiers.exponent);
  if (!size || !exponent) return std::nullopt;
  const bool is_signed = specifiers.sign == ast::Sign::Signed;
  const int least = is_signed ? 2 : 1;
  if (*size < least || *size > 64) {
    error(201, specifiers.size->where,
          "size " + std::to_string(*size) + " of a" + (is_signed ? " signed" : "n unsigned") +
              " fixed<> is out of range; " + std::to_string(least) + " to 64 are possible");
    return std::nullopt;
  }
  if (*exponent < -64 || *exponent > 128) {
    error(201, specifiers.exponent->where,
          "exponent " + std::to_string(*exponent) + " of a fixed<> is out of range; -64 to 128 are possible");
    return std::nullopt;
  }
  return Scalar::fixed(is_signed, static_cast<int>(*size), static_cast<int>(*exponent));
}

std::optional<Type> Checker::type_of(const ast::Specifiers& specifiers,
                                     const std::vector<ast::ExpressionPtr>& dimensions, bool varying) {
  constexpr std::int64_t kLargest = 65536;
  Type type;
  type.varying = varying;
  const std::optional<Scalar> scalar = scalar_of(specifiers);
  if (!scalar) return std::nullopt;
  type.scalar = *scalar;
  std::int64_t count = 1;
  for (const auto* list : {&dimensions, &specifiers.dimensions}) {
    for (const ast::ExpressionPtr& dimension : *list) {
      const std::optional<std::int64_t> length = constant_integer(*dimension);
      if (!length) return std::nullopt;
      count = *length >= 1 && *length <= kLargest ? count * *length : 0;
      if (count < 1 || count > kLargest || type.rank == 2) {
        error(201, dimension->where,
              "array dimension " + std::to_string(*length) + " is out of range; 1 to " + std::to_string(kLargest) +
                  " elements are possible");
        return std::nullopt;
      }
      type.dimensions[static_cast<std::size_t>(type.rank++)] = static_cast<int>(*length);
    }
  }
  return type;
}

/// Literals, constants and what is calculated from them.
bool Checker::is_constant(const Node& node) const {
  switch (node.op) {
    case Node::Op::Variable:
      // Hidden ones are assigned within the expression itself.
      return node.variable->role == Variable::Role::Constant || node.variable->role == Variable::Role::Hidden;
    case Node::Op::Assign:
      if (node.operands[0]->op != Node::Op::Variable || node.operands[0]->variable->role != Variable::Role::Hidden) {
        return false;
      }
      break;
    case Node::Op::Postfix:
    case Node::Op::Call:
    case Node::Op::Texture:
    case Node::Op::Environment: return false;
    default: break;
  }
  for (const NodePtr& operand : node.operands) {
    if (!is_constant(*operand)) return false;
  }
  return true;
}

namespace {

/// Of constants whose own value was a mistake nothing is known.
bool all_known(const Node& node, const std::set<const Variable*>& known) {
  if (node.op == Node::Op::Variable && node.variable->role == Variable::Role::Constant) {
    return known.contains(node.variable);
  }
  for (const NodePtr& operand : node.operands) {
    if (!all_known(*operand, known)) return false;
  }
  return true;
}

}  // namespace

/// Nothing for a mistake, which is reported.
std::optional<Raw> Checker::constant_value(const Node& node) {
  if (!all_known(node, known_)) return std::nullopt;
  const int errors = diagnostics_.errors();
  const NodePtr sized = clone(node);
  size_root(*sized, diagnostics_);
  if (diagnostics_.errors() > errors) return std::nullopt;
  try {
    return evaluate(*sized, constants_);
  } catch (const UniformError& mistake) {
    error(122, mistake.where, mistake.what());
    return std::nullopt;
  }
}

std::optional<std::int64_t> Checker::constant_integer(const Node& node) {
  if (node.type.is_void || node.type.is_array() || !is_constant(node)) {
    error(201, node.where, "a constant integer is needed here");
    return std::nullopt;
  }
  const std::optional<Raw> raw = constant_value(node);
  if (!raw) return std::nullopt;
  const double value = to_double(raw->at(0), node.exact);
  if (node.exact.is_float || value != std::floor(value) || std::fabs(value) >= 0x1p31) {
    error(201, node.where, "a constant integer is needed here");
    return std::nullopt;
  }
  return static_cast<std::int64_t>(value);
}

std::optional<std::int64_t> Checker::constant_integer(const ast::Expression& expression) {
  Value value = this->expression(expression);
  if (value.mistake()) return std::nullopt;
  if (value.kind == Value::Kind::Literal && !value.real && std::fabs(value.number) < 0x1p31) return value.integer;
  const NodePtr node = settle(std::move(value));
  if (!node) return std::nullopt;
  return constant_integer(*node);
}

}  // namespace pfman
