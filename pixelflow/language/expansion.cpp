#include <algorithm>

#include "pixelflow/language/lexer.h"
#include "pixelflow/language/macros.h"

namespace pfman {
namespace {

constexpr int kMaximumDepth = 200;  // of macro calls in arguments of macro calls

Token make_string(const std::vector<Token>& tokens, const Token& use) {
  Token result;
  result.kind = Token::Kind::String;
  result.where = use.where;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i > 0 && tokens[i].space) result.text += ' ';
    if (tokens[i].kind != Token::Kind::String) {
      result.text += tokens[i].text;
      continue;
    }
    result.text += "\\\"";
    for (const char c : tokens[i].text) {
      if (c == '"' || c == '\\') result.text += '\\';
      result.text += c;
    }
    result.text += "\\\"";
  }
  return result;
}

}  // namespace

Expansion::~Expansion() {
  for (const Context& context : contexts_) {
    if (context.macro) context.macro->active = false;
  }
}

Token Expansion::fetch() {
  while (!contexts_.empty()) {
    Context& top = contexts_.back();
    if (top.next < top.tokens.size()) {
      Token token = std::move(top.tokens[top.next++]);
      if (token.kind == Token::Kind::Identifier) {
        const auto macro = table_.find(token.text);
        if (macro && macro->active) token.painted = true;
      }
      return token;
    }
    if (top.macro) top.macro->active = false;
    contexts_.pop_back();
  }
  return read_();
}

void Expansion::put_back(Token token) { contexts_.push_back({{std::move(token)}, 0, nullptr}); }

Token Expansion::next() {
  for (;;) {
    Token token = fetch();
    if (table_.exhausted()) {
      token.kind = Token::Kind::End;
      return token;
    }
    if (token.kind != Token::Kind::Identifier || token.painted) return token;
    if (token.text == "__LINE__") {
      token.kind = Token::Kind::Number;
      token.text = std::to_string(token.where.line);
      return token;
    }
    if (token.text == "__FILE__") {
      token.kind = Token::Kind::String;
      token.text = table_.diagnostics().files()[token.where.file];
      return token;
    }
    const auto macro = table_.find(token.text);
    if (!macro || macro->active || !enter(macro, token)) return token;
  }
}

/// False when the name of a function-like macro stands without arguments.
bool Expansion::enter(const std::shared_ptr<Macro>& macro, const Token& use) {
  std::vector<Tokens> given;
  if (macro->function) {
    Token ahead = fetch();
    if (!ahead.is("(")) {
      put_back(std::move(ahead));
      return false;
    }
    auto found = arguments(*macro, use);
    if (!found) return true;
    given = std::move(*found);
  }
  auto tokens = substitute(*macro, given, use);
  if (!tokens) return true;
  if (!tokens->empty()) {
    tokens->front().space = use.space;
    tokens->front().line_start = use.line_start;
  }
  macro->active = true;
  contexts_.push_back({std::move(*tokens), 0, macro});
  return true;
}

/// The arguments up to the closing parenthesis; nothing after a mistake.
std::optional<std::vector<Expansion::Tokens>> Expansion::arguments(const Macro& macro, const Token& use) {
  std::vector<Tokens> given(1);
  int open = 0;
  for (;;) {
    Token token = fetch();
    if (table_.exhausted()) return std::nullopt;
    if (token.kind == Token::Kind::End) {
      table_.diagnostics().add(100, use.where, "macro '" + macro.name + "' is used without a closing ')'");
      put_back(std::move(token));
      return std::nullopt;
    }
    if (open == 0 && token.is(")")) break;
    if (open == 0 && token.is(",")) {
      given.emplace_back();
      continue;
    }
    if (token.is("(")) ++open;
    if (token.is(")")) --open;
    token.space |= token.line_start;
    token.line_start = false;
    if (!table_.charge(token)) return std::nullopt;
    given.back().push_back(std::move(token));
  }
  if (macro.parameters.empty() && given.size() == 1 && given[0].empty()) given.clear();
  if (given.size() != macro.parameters.size()) {
    table_.diagnostics().add(100, use.where,
                             "macro '" + macro.name + "' takes " + std::to_string(macro.parameters.size()) +
                                 " arguments, not " + std::to_string(given.size()));
    return std::nullopt;
  }
  return given;
}

std::optional<Expansion::Tokens> Expansion::substitute(const Macro& macro, const std::vector<Tokens>& arguments,
                                                       const Token& use) {
  if (depth_ >= kMaximumDepth && macro.function) {
    table_.exhaust(use.where, "macro calls nested deeper than " + std::to_string(kMaximumDepth));
    return std::nullopt;
  }
  std::vector<std::optional<Tokens>> expanded(arguments.size());
  const auto parameter = [&](const Token& token) {
    const auto found = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
    return token.kind == Token::Kind::Identifier ? static_cast<std::size_t>(found - macro.parameters.begin())
                                                 : macro.parameters.size();
  };

  Tokens result;
  bool pasting = false;     // behind ##
  bool left_empty = false;  // what stands left of it is an empty argument
  for (std::size_t i = 0; i < macro.body.size(); ++i) {
    if (macro.body[i].is("##")) {
      pasting = true;
      continue;
    }
    const bool stringize = macro.function && macro.body[i].is("#");
    const Token& token = macro.body[stringize ? ++i : i];
    const bool before_paste = i + 1 < macro.body.size() && macro.body[i + 1].is("##");
    const std::size_t index = parameter(token);
    Tokens operand;
    if (stringize) {
      operand.push_back(make_string(arguments[index], use));
    } else if (index == macro.parameters.size()) {
      operand.push_back(token);
      operand.back().where = use.where;
    } else if (pasting || before_paste) {
      operand = arguments[index];
    } else {
      if (!expanded[index]) expanded[index] = expand(arguments[index], table_, depth_ + 1);
      operand = *expanded[index];
    }
    if (!operand.empty()) operand.front().space = token.space;
    for (const Token& piece : operand) {
      if (!table_.charge(piece)) return std::nullopt;
    }
    std::size_t first = 0;
    if (pasting && !left_empty && !operand.empty()) paste(result, operand[first++], use);
    left_empty = operand.empty() && (!pasting || left_empty);
    for (; first < operand.size(); ++first) result.push_back(std::move(operand[first]));
    pasting = false;
  }
  return result;
}

void Expansion::paste(Tokens& result, const Token& right, const Token& use) {
  Token& left = result.back();
  const bool strings = left.kind == Token::Kind::String || right.kind == Token::Kind::String;
  Diagnostics unused;
  std::vector<Token> made = lex(left.text + right.text, 0, unused);
  if (strings || made.size() != 2 || made[0].kind == Token::Kind::Bad) {
    table_.diagnostics().add(100, use.where, "'##' makes no token of '" + left.text + "' and '" + right.text + "'");
    result.push_back(right);
    return;
  }
  left.kind = made[0].kind;
  left.text = std::move(made[0].text);
  left.where = use.where;
  left.painted = false;
  table_.charge(left);
}

std::vector<Token> expand(const std::vector<Token>& tokens, MacroTable& table, int depth) {
  std::size_t next = 0;
  const auto read = [&] {
    if (next < tokens.size()) return tokens[next++];
    Token end;
    if (!tokens.empty()) end.where = tokens.back().where;
    return end;
  };
  Expansion expansion(table, read, depth);
  std::vector<Token> result;
  for (Token token = expansion.next(); token.kind != Token::Kind::End; token = expansion.next()) {
    result.push_back(std::move(token));
  }
  return result;
}

}  // namespace pfman
