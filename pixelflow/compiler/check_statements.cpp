// Statements: control flow by rate, masks, jumps, declarations.
#include "pixelflow/compiler/checker.h"

namespace pfman {

using Kind = ast::Statement::Kind;

void Checker::statement(const ast::Statement& statement, Statements& out, bool top_level) {
  switch (statement.kind) {
    case Kind::Declaration:
      for (const ast::Declarator& declarator : statement.declarators) declaration(declarator, out);
      break;
    case Kind::Constant: {
      Nodes assignments;
      constants(statement.declarators, assignments);
      for (NodePtr& assignment : assignments) out.push_back(make_evaluate(std::move(assignment)));
      break;
    }
    case Kind::Expression: {
      NodePtr node = settle(expression(*statement.expressions[0]));
      if (node) out.push_back(make_evaluate(std::move(node)));
      break;
    }
    case Kind::Block: out.push_back(scoped(statement)); break;
    case Kind::If: if_statement(statement, out); break;
    case Kind::While:
    case Kind::DoWhile:
    case Kind::For: loop_statement(statement, out); break;
    case Kind::Illuminance: illuminance(statement, out, top_level); break;
    case Kind::Illuminate:
    case Kind::Solar: light_source(statement, out, top_level); break;
    case Kind::Break:
    case Kind::Continue: jump(statement, out); break;
    case Kind::Return:
      error(131, statement.where,
            around_.function != nullptr ? "'return' is possible as the last statement of a function only"
                                        : "'return' is possible in functions only");
      break;
    case Kind::Empty: break;
  }
}

void Checker::block(const std::vector<ast::StatementPtr>& body, Statements& out, bool top_level) {
  for (const ast::StatementPtr& one : body) statement(*one, out, top_level);
}

/// The statement with a scope of its own, as a Block.
StatementPtr Checker::scoped(const ast::Statement& body) {
  StatementPtr result = make_statement(Statement::Kind::Block, body.where);
  scopes_.emplace_back();
  if (body.kind == Kind::Block) {
    block(body.body, result->body);
  } else {
    statement(body, result->body);
  }
  scopes_.pop_back();
  return result;
}

void Checker::declaration(const ast::Declarator& declarator, Statements& out) {
  const bool varying = declarator.specifiers->rate != ast::Rate::Uniform;
  const std::optional<Type> type = type_of(declarator, varying);
  Value value;
  if (declarator.initial) value = expression(*declarator.initial);
  if (declarator.name.starts_with("px_")) {
    error(112, declarator.where,
          "'" + declarator.name + "': names that begin with px_ are those of standard parameters");
  }
  if (type) check_attributes(declarator, *type, false);
  Type declared = type.value_or(Type());
  declared.is_void = !type;
  Variable* variable = new_variable(declarator.name, declared, Variable::Role::Local, declarator.where);
  declare(variable);
  if (!type) return;
  if (!declarator.initial) {
    out.push_back(make_statement(Statement::Kind::Declare, declarator.where));
    out.back()->variable = variable;
    return;
  }
  if (value.mistake()) return;
  const Type& given = value.type();
  if (given.is_void || !given.same_shape(*type)) {
    error(
        203, declarator.where,
        "cannot initialise '" + declarator.name + "' of type '" + spelling(*type) + "' with '" + value.spelled() + "'");
    return;
  }
  if (!varying && given.varying) {
    error(301, declarator.where, "cannot assign a varying value to uniform variable '" + declarator.name + "'");
    return;
  }
  NodePtr initial = convert_to(std::move(value), type->scalar);
  if (!initial) return;
  out.push_back(
      make_evaluate(make_assign(make_read(variable, declarator.where), std::move(initial), declarator.where)));
}

void Checker::if_statement(const ast::Statement& statement, Statements& out) {
  NodePtr chosen = condition(expression(*statement.expressions[0]));
  const bool masked = chosen && chosen->type.varying;
  StatementPtr result = make_statement(Statement::Kind::If, statement.where);
  if (masked) ++around_.masks;
  for (const ast::StatementPtr& branch : statement.body) result->body.push_back(scoped(*branch));
  if (masked) --around_.masks;
  if (!chosen) return;
  result->expression = std::move(chosen);
  out.push_back(std::move(result));
}

/// The condition of a loop. Null for a mistake.
NodePtr Checker::clause(const ast::Expression& expression) {
  NodePtr node = condition(this->expression(expression));
  if (node && node->type.varying) {
    error(303, node->where, "the condition of a loop varies from pixel to pixel");
    return nullptr;
  }
  return node;
}

void Checker::loop_statement(const ast::Statement& statement, Statements& out) {
  const bool is_for = statement.kind == Kind::For;
  StatementPtr loop = make_statement(Statement::Kind::Loop, statement.where);
  StatementPtr outer = make_statement(Statement::Kind::Block, statement.where);
  const auto clause_at = [&](std::size_t n) -> const ast::Expression* {
    return n < statement.expressions.size() ? statement.expressions[n].get() : nullptr;
  };
  if (is_for && clause_at(0)) {
    NodePtr first = settle(expression(*clause_at(0)));
    if (first) outer->body.push_back(make_evaluate(std::move(first)));
  }
  const ast::Expression* test = clause_at(is_for ? 1 : 0);
  loop->test_last = statement.kind == Kind::DoWhile;
  if (test != nullptr && !loop->test_last) loop->expression = clause(*test);
  CheckedLoop state;
  state.masks = around_.masks;
  around_.loops.push_back(std::move(state));
  loop->body.push_back(scoped(*statement.body[0]));
  state = std::move(around_.loops.back());
  around_.loops.pop_back();
  // Jumps for some pixels only put the whole body under a mask, from its second turn on.
  if (state.masked_breaks || state.masked_continues) {
    for (const Assigned& assigned : state.assigned) {
      error(302, assigned.where,
            "cannot assign to uniform variable '" + assigned.name +
                "' in a loop that some pixels leave by a varying 'break' or 'continue'");
    }
  }
  loop->masked_breaks = state.masked_breaks;
  loop->masked_continues = state.masked_continues;
  if (test != nullptr && loop->test_last) loop->expression = clause(*test);
  if (is_for && clause_at(2)) {
    NodePtr step = settle(expression(*clause_at(2)));
    if (step) {
      loop->step = make_statement(Statement::Kind::Block, step->where);
      loop->step->body.push_back(make_evaluate(std::move(step)));
    }
  }
  if (outer->body.empty()) {
    out.push_back(std::move(loop));
    return;
  }
  outer->body.push_back(std::move(loop));
  out.push_back(std::move(outer));
}

void Checker::jump(const ast::Statement& statement, Statements& out) {
  const bool is_break = statement.kind == Kind::Break;
  if (around_.loops.empty()) {
    error(304, statement.where, std::string("'") + (is_break ? "break" : "continue") + "' outside of a loop");
    return;
  }
  CheckedLoop& loop = around_.loops.back();
  StatementPtr result = make_statement(is_break ? Statement::Kind::Break : Statement::Kind::Continue, statement.where);
  result->masked = around_.masks > loop.masks;
  if (result->masked) (is_break ? loop.masked_breaks : loop.masked_continues) = true;
  out.push_back(std::move(result));
}

}  // namespace pfman
