#include "pixelflow/language/parser_state.h"

namespace pfman {

using ast::Base;
using ast::Definition;

Definition Parser::definition() {
  if (at("surface") || at("light")) return shader();
  if (at("extern")) return external();
  if (at("const")) {
    Definition result;
    result.kind = Definition::Kind::Constant;
    result.where = now().where;
    result.declarators = constants();
    return result;
  }
  if (at("void") || at_type()) return function(specifiers());
  unexpected("a surface, light, function or constant");
}

Definition Parser::shader() {
  Definition result;
  result.kind = at("surface") ? Definition::Kind::Surface : Definition::Kind::Light;
  take();
  result.where = now().where;
  result.name = expect_name();
  parameters(result.parameters);
  result.body = block();
  return result;
}

Definition Parser::function(ast::SpecifiersPtr result_type) {
  Definition result;
  result.kind = Definition::Kind::Function;
  check_specifiers(*result_type, false);
  result.result = std::move(result_type);
  result.where = now().where;
  result.name = expect_name();
  parameters(result.parameters);
  result.body = block();
  return result;
}

Definition Parser::external() {
  take();
  std::optional<std::string> linkage;
  if (now().kind == Token::Kind::String) linkage = take().text;
  if (!at("void") && !at_type()) unexpected("a type");
  Definition result;
  result.kind = Definition::Kind::Extern;
  result.result = specifiers();
  check_specifiers(*result.result, false);
  result.where = now().where;
  result.name = expect_name();
  parameters(result.parameters);
  expect(";");
  result.linkage = std::move(linkage);
  return result;
}

/// The parameters with their parentheses. After a mistake reading goes on behind them, so that the body is read too.
void Parser::parameters(std::vector<ast::Declarator>& list) {
  const Location open = expect("(");
  try {
    if (accept(")")) return;
    ast::SpecifiersPtr specs;
    for (;;) {
      if (!specs || at_type() || now().kind != Token::Kind::Identifier) {
        specs = specifiers();
        check_specifiers(*specs, true);
      }
      list.push_back(declarator(specs));
      if (accept(";")) {
        if (accept(")")) return;
      } else if (!accept(",")) {
        break;
      }
    }
    close(")", open);
  } catch (const Panic&) {
    open_arrays_ = 0;
    int parentheses = 1;
    bool array = false;  // a brace here opens an array, not the body
    while (!at_end() && parentheses > 0 && (array || !at("{"))) {
      array = at("=") || at(",") || at("{") || at("(");
      if (at("(")) ++parentheses;
      if (at(")")) --parentheses;
      take();
    }
    if (!at("{")) throw;
  }
}

/// `const` to the semicolon.
std::vector<ast::Declarator> Parser::constants() {
  take();
  const ast::SpecifiersPtr specs = specifiers();
  check_specifiers(*specs, false);
  std::vector<ast::Declarator> list;
  do {
    list.push_back(declarator(specs));
    if (!list.back().initial) unexpected("'='");
  } while (accept(","));
  expect(";");
  return list;
}

}  // namespace pfman
