#include "pixelflow/language/parser_state.h"

namespace pfman {

using ast::Statement;
using ast::StatementPtr;
using Kind = ast::Statement::Kind;

StatementPtr Parser::make_statement(Kind kind) const {
  auto result = std::make_unique<Statement>();
  result->kind = kind;
  result->where = now().where;
  return result;
}

StatementPtr Parser::statement() {
  const Nesting nesting(*this, statement_depth_, "statements");
  if (at("{")) return block();
  if (at("if")) return if_statement();
  if (at("while")) return while_statement();
  if (at("do")) return do_statement();
  if (at("for")) return for_statement();
  if (at("illuminance") || at("illuminate") || at("solar")) return light_statement();
  if (at_type()) return declaration_or_cast();
  if (at("const")) {
    StatementPtr result = make_statement(Kind::Constant);
    result->declarators = constants();
    return result;
  }
  if (at("break") || at("continue")) {
    StatementPtr result = make_statement(at("break") ? Kind::Break : Kind::Continue);
    take();
    expect(";");
    return result;
  }
  if (at("return")) {
    StatementPtr result = make_statement(Kind::Return);
    take();
    if (!at(";")) result->expressions.push_back(expression());
    expect(";");
    return result;
  }
  if (at(";")) {
    StatementPtr result = make_statement(Kind::Empty);
    take();
    return result;
  }
  return expression_statement();
}

/// A statement, or after a mistake the empty one, with the place behind it.
StatementPtr Parser::recovering_statement() {
  const std::size_t begin = at_;
  StatementPtr nothing = make_statement(Kind::Empty);
  try {
    return statement();
  } catch (const Panic&) {
    pending_.reset();
    if (at_ == begin && !at("}")) take();
    skip_statement();
  }
  return nothing;
}

StatementPtr Parser::block() {
  StatementPtr result = make_statement(Kind::Block);
  const Location open = expect("{");
  // A definition's first word means that a brace is missing before it.
  while (!at_end() && !at("}") && !at("surface") && !at("light") && !at("extern")) {
    result->body.push_back(recovering_statement());
  }
  if (accept("}")) return result;
  try {
    close("}", open);
  } catch (const Panic&) {
    // Whatever follows belongs to the definitions, also for the blocks around this one.
  }
  return result;
}

StatementPtr Parser::declaration_or_cast() {
  StatementPtr result = make_statement(Kind::Declaration);
  const ast::SpecifiersPtr specs = specifiers();
  if (at("(")) {
    pending_ = finish_cast(specs, false, result->where);
    return expression_statement();
  }
  check_specifiers(*specs, false);
  do {
    result->declarators.push_back(declarator(specs));
  } while (accept(","));
  expect(";");
  return result;
}

StatementPtr Parser::expression_statement() {
  StatementPtr result = make_statement(Kind::Expression);
  if (pending_) result->where = pending_->where;
  result->expressions.push_back(expression());
  expect(";");
  return result;
}

StatementPtr Parser::if_statement() {
  StatementPtr result = make_statement(Kind::If);
  take();
  const Location open = expect("(");
  result->expressions.push_back(expression());
  close(")", open);
  result->body.push_back(recovering_statement());
  if (accept("else")) result->body.push_back(recovering_statement());
  return result;
}

StatementPtr Parser::while_statement() {
  StatementPtr result = make_statement(Kind::While);
  take();
  const Location open = expect("(");
  result->expressions.push_back(expression());
  close(")", open);
  result->body.push_back(recovering_statement());
  return result;
}

StatementPtr Parser::do_statement() {
  StatementPtr result = make_statement(Kind::DoWhile);
  take();
  result->body.push_back(recovering_statement());
  expect("while");
  const Location open = expect("(");
  result->expressions.push_back(expression());
  close(")", open);
  expect(";");
  return result;
}

StatementPtr Parser::for_statement() {
  StatementPtr result = make_statement(Kind::For);
  take();
  const Location open = expect("(");
  if (at_type()) {
    const Location where = now().where;
    const ast::SpecifiersPtr specs = specifiers();
    if (at("(")) {
      pending_ = finish_cast(specs, false, where);
      result->expressions.push_back(expression());
    } else {
      report(102, where, "the clauses of 'for' are expressions; declare its variable before it");
      declarator(specs);
      result->expressions.push_back(nullptr);
    }
  } else {
    result->expressions.push_back(at(";") ? nullptr : expression());
  }
  expect(";");
  result->expressions.push_back(at(";") ? nullptr : expression());
  expect(";");
  result->expressions.push_back(at(")") ? nullptr : expression());
  close(")", open);
  result->body.push_back(recovering_statement());
  return result;
}

/// illuminance, illuminate and solar: each has a position, an axis and an angle, or some of them.
StatementPtr Parser::light_statement() {
  const Kind kind = at("illuminance") ? Kind::Illuminance : at("illuminate") ? Kind::Illuminate : Kind::Solar;
  StatementPtr result = make_statement(kind);
  take();
  const Location open = expect("(");
  if (kind == Kind::Illuminate || !at(")")) {
    result->expressions.push_back(conditional());
    const bool more = kind == Kind::Solar ? (expect(","), true) : accept(",");
    if (more) result->expressions.push_back(conditional());
    if (more && kind != Kind::Solar) {
      expect(",");
      result->expressions.push_back(conditional());
    }
  }
  close(")", open);
  result->body.push_back(recovering_statement());
  return result;
}

}  // namespace pfman
