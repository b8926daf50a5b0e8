// The parser: recursive descent over the preprocessor's tokens, binary operators by precedence. A method a rule of the
// grammar in docs/pfman.md.
//
// A syntax error is thrown (Panic) after it has been reported, and caught where reading can go on: at the next
// statement, parameter list or definition. What is too deep or too wrong to go on ends the text (GiveUp).
#pragma once

#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "pixelflow/language/token.h"

namespace pfman {

class Parser {
 public:
  Parser(std::vector<Token> tokens, Diagnostics& diagnostics);
  std::vector<ast::Definition> run();

 private:
  struct Panic {};
  struct GiveUp {};

  // parser.cpp: tokens and recovery
  const Token& now() const { return tokens_[at_]; }
  const Token& ahead(std::size_t count = 1) const;
  bool at(const char* spelling) const { return now().is(spelling); }
  bool at_end() const { return now().kind == Token::Kind::End; }
  Token take();
  bool accept(const char* spelling);
  Location expect(const char* spelling);
  std::string expect_name();
  [[noreturn]] void unexpected(const std::string& expected);
  void report(int code, Location where, const std::string& text, std::vector<Note> notes = {});
  void skip_statement();
  void skip_definition();
  void skip_braces();
  /// Expects the brace or parenthesis that closes the one at `open`, which the message names.
  void close(const char* spelling, Location open);

  // parse_definitions.cpp
  ast::Definition definition();
  ast::Definition shader();
  ast::Definition function(ast::SpecifiersPtr result);
  ast::Definition external();
  void parameters(std::vector<ast::Declarator>& list);
  std::vector<ast::Declarator> constants();

  // parse_types.cpp
  bool at_type() const;
  ast::SpecifiersPtr specifiers();
  void specifier(ast::Specifiers& specs, bool& based);
  void base_type(ast::Specifiers& specs);
  void check_specifiers(const ast::Specifiers& specs, bool parameter);
  std::vector<ast::ExpressionPtr> dimensions(std::size_t already);
  ast::Declarator declarator(const ast::SpecifiersPtr& specs);

  // parse_statements.cpp
  ast::StatementPtr statement();
  ast::StatementPtr recovering_statement();
  ast::StatementPtr block();
  ast::StatementPtr declaration_or_cast();
  ast::StatementPtr expression_statement();
  ast::StatementPtr if_statement();
  ast::StatementPtr while_statement();
  ast::StatementPtr do_statement();
  ast::StatementPtr for_statement();
  ast::StatementPtr light_statement();
  ast::StatementPtr make_statement(ast::Statement::Kind kind) const;

  // parse_expressions.cpp
  ast::ExpressionPtr expression();
  ast::ExpressionPtr conditional();
  ast::ExpressionPtr binary(int level);
  ast::ExpressionPtr unary();
  ast::ExpressionPtr postfix();
  ast::ExpressionPtr primary();
  ast::ExpressionPtr name_or_call();
  ast::ExpressionPtr number();
  ast::ExpressionPtr array();
  ast::ExpressionPtr cast();
  ast::ExpressionPtr finish_cast(ast::SpecifiersPtr type, bool saturate, Location where);
  ast::ExpressionPtr make(ast::Expression::Kind kind, Location where) const;
  void adopt(ast::Expression& parent, ast::ExpressionPtr child);
  void check_assignable(const ast::Expression& target, Location where);

  class Nesting;  ///< counts levels while it lives

  std::vector<Token> tokens_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  int errors_before_ = 0;
  int expression_depth_ = 0;
  int statement_depth_ = 0;
  int open_arrays_ = 0;         ///< array literals that a Panic would leave open
  ast::ExpressionPtr pending_;  ///< a cast that began a statement like a declaration; the next operand
};

/// Counts a level of nesting while it lives; reports E102 and gives up beyond the limit.
class Parser::Nesting {
 public:
  Nesting(Parser& parser, int& depth, const char* what) : depth_(depth) {
    if (depth_ >= ast::kMaximumNesting) {
      parser.report(102, parser.now().where,
                    std::string(what) + " nested deeper than " + std::to_string(ast::kMaximumNesting) + " levels");
      throw GiveUp{};
    }
    ++depth_;
  }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  int& depth_;
};

}  // namespace pfman
