#include "pixelflow/language/parser.h"

#include <algorithm>
#include <array>

#include "pixelflow/language/lexer.h"
#include "pixelflow/language/parser_state.h"
#include "pixelflow/language/preprocessor.h"

namespace pfman {
namespace {

constexpr std::array kKeywords = {"surface",
                                  "light",
                                  "extern",
                                  "const",
                                  "output",
                                  "uniform",
                                  "varying",
                                  "signed",
                                  "unsigned",
                                  "fixed",
                                  "float",
                                  "int",
                                  "bool",
                                  "void",
                                  "sat",
                                  "unit",
                                  "if",
                                  "else",
                                  "while",
                                  "do",
                                  "for",
                                  "break",
                                  "return",
                                  "continue",
                                  "solar",
                                  "true",
                                  "false",
                                  "illuminate",
                                  "illuminance",
                                  "transform_as_point",
                                  "transform_as_vector",
                                  "transform_as_normal",
                                  "transform_as_texture"};

constexpr std::array kReserved = {"string",    "color",       "point",        "vector", "normal",
                                  "matrix",    "volume",      "displacement", "imager", "atmosphere",
                                  "primitive", "interpolate", "transform",    "gather"};

template <typename Words>
bool contains(const Words& words, const std::string& text) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

std::string shown(const Token& token) {
  if (token.kind == Token::Kind::End) return "end of the text";
  if (token.kind == Token::Kind::String) return "\"" + token.text + "\"";
  return "'" + token.text + "'";
}

}  // namespace

Parser::Parser(std::vector<Token> tokens, Diagnostics& diagnostics)
    : diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {
  tokens_.reserve(tokens.size());
  for (Token& token : tokens) {
    if (token.kind == Token::Kind::Bad || token.is("#") || token.is("##")) {
      if (diagnostics_.errors() - errors_before_ <= kMaximumMistakes) report_bad(token, diagnostics_);
      continue;
    }
    if (token.kind == Token::Kind::Identifier) {
      if (contains(kKeywords, token.text)) token.kind = Token::Kind::Keyword;
      if (contains(kReserved, token.text)) token.kind = Token::Kind::Reserved;
    }
    tokens_.push_back(std::move(token));
  }
  errors_before_ = diagnostics.errors();
}

const Token& Parser::ahead(std::size_t count) const { return tokens_[std::min(at_ + count, tokens_.size() - 1)]; }

Token Parser::take() {
  const Token& token = now();
  if (!at_end()) ++at_;
  return token;
}

bool Parser::accept(const char* spelling) {
  if (!at(spelling)) return false;
  take();
  return true;
}

Location Parser::expect(const char* spelling) {
  if (!at(spelling)) unexpected(std::string("'") + spelling + "'");
  return take().where;
}

void Parser::close(const char* spelling, Location open) {
  if (accept(spelling)) return;
  if (!at_end() || open.line == 0) unexpected(std::string("'") + spelling + "'");
  const char* opening = *spelling == '}' ? "{" : "(";
  report(102, now().where, "unexpected " + shown(now()) + ", expected '" + spelling + "'",
         {{open, std::string("the '") + opening + "' is here"}});
  throw Panic{};
}

std::string Parser::expect_name() {
  if (now().kind != Token::Kind::Identifier) unexpected("a name");
  return take().text;
}

void Parser::unexpected(const std::string& expected) {
  if (now().kind == Token::Kind::Reserved) {
    report(103, now().where, shown(now()) + " is a word of RenderMan's language that pfman reserves");
  } else {
    report(102, now().where, "unexpected " + shown(now()) + ", expected " + expected);
  }
  throw Panic{};
}

void Parser::report(int code, Location where, const std::string& text, std::vector<Note> notes) {
  diagnostics_.add({code, where, text, std::move(notes)});
  if (diagnostics_.errors() - errors_before_ <= kMaximumMistakes) return;
  diagnostics_.add(102, where, "more than " + std::to_string(kMaximumMistakes) + " mistakes; the rest is not read");
  throw GiveUp{};
}

/// To behind the next ';', or to what ends or begins a statement.
void Parser::skip_statement() {
  constexpr std::array kBeginnings = {"if",     "while",    "do",      "for",         "break",      "return",
                                      "return", "continue", "surface", "illuminance", "illuminate", "solar",
                                      "light",  "extern",   "const",   "else"};
  for (; !at_end(); take()) {
    if (open_arrays_ == 0 && (at("{") || at("}"))) return;
    if (at("{")) ++open_arrays_;
    if (at("}")) --open_arrays_;
    if (accept(";")) {
      open_arrays_ = 0;
      return;
    }
    const bool beginning = now().kind == Token::Kind::Keyword && (contains(kBeginnings, now().text) || at_type());
    if (beginning && now().line_start) break;
  }
  open_arrays_ = 0;
}

void Parser::skip_braces() {
  int open = 0;
  while (!at_end()) {
    if (at("{")) ++open;
    if (at("}")) --open;
    take();
    if (open <= 0) return;
  }
}

/// To behind the present definition: its block, or a ';' outside.
void Parser::skip_definition() {
  open_arrays_ = 0;
  while (!at_end()) {
    if (at("{")) {
      skip_braces();
      return;
    }
    if (accept(";") || accept("}")) return;
    const bool beginning = at("surface") || at("light") || at("extern") || at("const");
    if (beginning && now().line_start) return;
    take();
  }
}

std::vector<ast::Definition> Parser::run() {
  std::vector<ast::Definition> definitions;
  try {
    while (!at_end()) {
      const std::size_t begin = at_;
      try {
        definitions.push_back(definition());
      } catch (const Panic&) {
        const bool stray_brace = at_ == begin && at("}");
        if (at_ == begin) take();
        if (!stray_brace) skip_definition();
      }
    }
  } catch (const GiveUp&) {
  }
  return definitions;
}

ast::Unit parse_text(const std::string& text, const std::string& name, const ParseOptions& options,
                     Diagnostics& diagnostics) {
  diagnostics.add_file(name);
  Preprocessed preprocessed = preprocess(text, name, options, diagnostics);
  ast::Unit unit;
  unit.definitions = Parser(std::move(preprocessed.tokens), diagnostics).run();
  unit.pragmas = std::move(preprocessed.pragmas);
  return unit;
}

ast::Unit parse_file(const std::filesystem::path& file, const ParseOptions& options, Diagnostics& diagnostics) {
  const std::string name = file.generic_string();
  const auto text = read_text(file, {diagnostics.add_file(name), 0, 0}, diagnostics);
  return text ? parse_text(*text, name, options, diagnostics) : ast::Unit{};
}

}  // namespace pfman
