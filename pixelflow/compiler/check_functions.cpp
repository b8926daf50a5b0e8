// Functions and constants of a unit.
#include <algorithm>

#include "pixelflow/compiler/checker.h"

namespace pfman {

using Kind = ast::Definition::Kind;

void Checker::constants(const std::vector<ast::Declarator>& declarators, Nodes& assignments) {
  for (const ast::Declarator& declarator : declarators) {
    const std::optional<Type> type = type_of(declarator, false);
    Value value = declarator.initial ? expression(*declarator.initial) : Value();
    if (declarator.name.starts_with("px_")) {
      error(112, declarator.where,
            "'" + declarator.name + "': names that begin with px_ are those of standard parameters");
    }
    Type declared = type.value_or(Type());
    declared.is_void = !type;
    Variable* variable = new_variable(declarator.name, declared, Variable::Role::Constant, declarator.where);
    declare(variable, "constant");
    if (type) check_attributes(declarator, *type, false);
    if (declarator.specifiers->rate == ast::Rate::Varying) {
      error(122, declarator.where, "constant '" + declarator.name + "' cannot be varying");
    }
    if (!type || value.mistake()) continue;
    if (!value.type().same_shape(*type)) {
      error(203, declarator.where,
            "cannot initialise '" + declarator.name + "' of type '" + spelling(*type) + "' with '" + value.spelled() +
                "'");
      continue;
    }
    NodePtr initial = convert_to(std::move(value), type->scalar);
    if (!initial) continue;
    if (initial->type.varying || !is_constant(*initial)) {
      error(122, declarator.initial->where, "the value of '" + declarator.name + "' is no constant expression");
      continue;
    }
    const std::optional<Raw> raw = constant_value(*initial);
    if (!raw) continue;
    constants_[variable] = *raw;
    known_.insert(variable);
    assignments.push_back(make_assign(make_read(variable, declarator.where), std::move(initial), declarator.where));
  }
}

void Checker::declare_function(const ast::Definition& definition) {
  const auto found = functions_.find(definition.name);
  if (found != functions_.end() || is_library_function(definition.name)) {
    error(111, definition.where,
          "'" + definition.name + "' is " +
              (found != functions_.end() ? "declared twice; there is no overloading" : "a function of the library"));
    return;
  }
  if (definition.name.starts_with("px_")) {
    error(112, definition.where,
          "'" + definition.name + "': names that begin with px_ are those of standard parameters");
  }
  auto function = std::make_unique<Function>();
  function->name = definition.name;
  function->where = definition.where;
  function->is_external = definition.kind == Kind::Extern;
  function->linkage = definition.linkage.value_or(function->is_external ? definition.name : "");
  bool right = true;
  if (definition.result->base == ast::Base::Void) {
    function->result.is_void = true;
  } else {
    const bool varying = definition.result->rate != ast::Rate::Uniform;
    const std::optional<Type> result = type_of(*definition.result, {}, varying);
    right = result.has_value();
    function->result = result.value_or(Type());
  }
  bool any_varying = false;
  for (const ast::Declarator& declarator : definition.parameters) {
    const bool varying = declarator.specifiers->rate != ast::Rate::Uniform;
    any_varying = any_varying || varying;
    const std::optional<Type> type = type_of(declarator, varying);
    right = right && type.has_value();
    if (type) check_attributes(declarator, *type, false);
    if (declarator.initial) {
      error(122, declarator.where, "parameter '" + declarator.name + "' of a function cannot have a default");
    }
    Type declared = type.value_or(Type());
    declared.is_void = !type;
    Variable* parameter = new_variable(declarator.name, declared, Variable::Role::FunctionParameter, declarator.where);
    parameter->output = declarator.specifiers->output;
    function->parameters.push_back(parameter);
  }
  if (function->is_external && any_varying && !function->result.is_void && !function->result.varying) {
    error(133, definition.where,
          "external function '" + definition.name + "' has varying parameters and cannot have a uniform result");
  }
  functions_[definition.name] = right ? function.get() : nullptr;
  all_functions_[&definition] = std::move(function);
}

namespace {

void collect_calls(const ast::Expression& expression, std::vector<const ast::Expression*>& calls) {
  if (expression.kind == ast::Expression::Kind::Call) calls.push_back(&expression);
  for (const auto& operand : expression.operands) {
    if (operand) collect_calls(*operand, calls);
  }
}

void collect_calls(const ast::Statement& statement, std::vector<const ast::Expression*>& calls) {
  for (const auto& expression : statement.expressions) {
    if (expression) collect_calls(*expression, calls);
  }
  for (const ast::Declarator& declarator : statement.declarators) {
    if (declarator.initial) collect_calls(*declarator.initial, calls);
  }
  for (const auto& inner : statement.body) {
    if (inner) collect_calls(*inner, calls);
  }
}

}  // namespace

/// Each function after those that it calls. A call of a function that is being visited is a recursion.
std::vector<const ast::Definition*> Checker::functions_in_order() {
  struct Visit {
    const ast::Definition* definition;
    std::vector<const ast::Expression*> calls;
    std::size_t next = 0;
  };
  enum class Mark : std::uint8_t { Open, Done };
  std::map<std::string, const ast::Definition*> by_name;
  for (const ast::Definition& definition : unit_.definitions) {
    if (definition.kind == Kind::Function && all_functions_.contains(&definition)) {
      by_name.emplace(definition.name, &definition);
    }
  }
  std::vector<const ast::Definition*> order;
  std::map<const ast::Definition*, Mark> marks;
  for (const ast::Definition& first : unit_.definitions) {
    if (first.kind != Kind::Function || !all_functions_.contains(&first) || marks.contains(&first)) continue;
    std::vector<Visit> visits;
    const auto enter = [&](const ast::Definition* definition) {
      marks[definition] = Mark::Open;
      visits.push_back({definition, {}, 0});
      if (definition->body) collect_calls(*definition->body, visits.back().calls);
    };
    enter(&first);
    while (!visits.empty()) {
      Visit& visit = visits.back();
      if (visit.next == visit.calls.size()) {
        marks[visit.definition] = Mark::Done;
        order.push_back(visit.definition);
        visits.pop_back();
        continue;
      }
      const ast::Expression* call = visit.calls[visit.next++];
      const auto found = by_name.find(call->name);
      if (found == by_name.end()) continue;
      const auto mark = marks.find(found->second);
      if (mark == marks.end()) {
        enter(found->second);
      } else if (mark->second == Mark::Open) {
        error(130, call->where, "'" + call->name + "' calls itself, directly or through other functions");
      }
    }
  }
  return order;
}

void Checker::check_function(const ast::Definition& definition) {
  Function& function = *all_functions_.at(&definition);
  around_ = Surroundings();
  around_.definition = &definition;
  around_.function = &function;
  scopes_.resize(1);
  scopes_.emplace_back();
  for (Variable* parameter : function.parameters) declare(parameter);
  if (!definition.body) return;
  const std::vector<ast::StatementPtr>& body = definition.body->body;
  const bool returns = !body.empty() && body.back()->kind == ast::Statement::Kind::Return;
  for (std::size_t n = 0; n + (returns ? 1 : 0) < body.size(); ++n) statement(*body[n], function.body);
  if (returns) {
    return_value(*body.back(), function);
  } else if (!function.result.is_void) {
    error(131, definition.where, "function '" + function.name + "' has to end with 'return' and a value");
  }
  scopes_.resize(1);
}

void Checker::return_value(const ast::Statement& statement, Function& function) {
  const bool valued = !statement.expressions.empty() && statement.expressions[0];
  if (function.result.is_void || !valued) {
    if (function.result.is_void && valued) {
      error(131, statement.where, "function '" + function.name + "' is void and cannot return a value");
    } else if (!function.result.is_void) {
      error(131, statement.where, "function '" + function.name + "' has to return a value");
    }
    return;
  }
  Value value = expression(*statement.expressions[0]);
  if (value.mistake()) return;
  const Type type = value.type();
  if (type.is_void || !type.same_shape(function.result)) {
    error(
        131, statement.where,
        "function '" + function.name + "' returns '" + spelling(function.result) + "', not '" + value.spelled() + "'");
    return;
  }
  if (type.varying && !function.result.varying) {
    error(301, statement.where, "cannot return a varying value from uniform function '" + function.name + "'");
    return;
  }
  function.value = convert_to(std::move(value), function.result.scalar);
}

}  // namespace pfman
