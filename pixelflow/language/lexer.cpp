#include "pixelflow/language/lexer.h"

#include <array>

namespace pfman {
namespace {

constexpr std::array kPunctuators = {"<<=", ">>=", "##", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "++",
                                     "--",  "+=",  "-=", "*=", "/=", "%=", "&=", "|=", "^=", "+",  "-",  "*",
                                     "/",   "%",   "<",  ">",  "=",  "!",  "&",  "|",  "^",  "~",  "?",  ":",
                                     ";",   ",",   "(",  ")",  "[",  "]",  "{",  "}",  "#"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The characters of a text without its line splices, and where each stands.
class Characters {
 public:
  explicit Characters(std::string_view text) : text_(text) { skip_splices(); }

  bool at_end() const { return position_ >= text_.size(); }
  char now() const { return at_end() ? '\0' : text_[position_]; }
  char after() const {
    Characters next = *this;
    next.step();
    return next.now();
  }
  void step() {
    if (at_end()) return;
    if (text_[position_] == '\n') {
      new_line();
    } else {
      ++column_;
    }
    ++position_;
    skip_splices();
  }
  std::uint32_t line() const { return line_; }
  std::uint32_t column() const { return column_; }

 private:
  void new_line() {
    ++line_;
    column_ = 1;
  }
  void skip_splices() {
    while (position_ < text_.size() && text_[position_] == '\\') {
      const std::size_t end = position_ + (text_.substr(position_ + 1, 1) == "\r" ? 2 : 1);
      if (end >= text_.size() || text_[end] != '\n') return;
      position_ = end + 1;
      new_line();
    }
  }

  std::string_view text_;
  std::size_t position_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t column_ = 1;
};

class Lexer {
 public:
  Lexer(std::string_view text, std::uint32_t file, Diagnostics& diagnostics)
      : at_(text), file_(file), diagnostics_(diagnostics) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    do {
      tokens.push_back(next());
    } while (tokens.back().kind != Token::Kind::End);
    return tokens;
  }

 private:
  Location here() const { return {file_, at_.line(), at_.column()}; }

  void take(Token& token) {
    token.text += at_.now();
    at_.step();
  }

  Token next() {
    Token token;
    skip_blanks(token);
    token.line_start = line_start_;
    line_start_ = false;
    token.where = here();
    if (at_.at_end()) return token;
    const char c = at_.now();
    if (is_letter(c)) {
      token.kind = Token::Kind::Identifier;
      while (is_letter(at_.now()) || is_digit(at_.now())) take(token);
    } else if (is_digit(c) || (c == '.' && is_digit(at_.after()))) {
      number(token);
    } else if (c == '"') {
      string(token);
    } else {
      punctuator(token);
    }
    return token;
  }

  void skip_blanks(Token& token) {
    while (!at_.at_end()) {
      const char c = at_.now();
      if (c == '\n') {
        line_start_ = true;
        at_.step();
      } else if (is_blank(c)) {
        at_.step();
      } else if (c == '/' && at_.after() == '/') {
        while (!at_.at_end() && at_.now() != '\n') at_.step();
      } else if (c == '/' && at_.after() == '*') {
        block_comment();
      } else {
        return;
      }
      token.space = true;
    }
  }

  void block_comment() {
    const Location start = here();
    at_.step();
    at_.step();
    while (!at_.at_end()) {
      const bool closes = at_.now() == '*' && at_.after() == '/';
      at_.step();
      if (!closes) continue;
      at_.step();
      return;
    }
    diagnostics_.add(101, start, "comment without an end");
  }

  void number(Token& token) {
    token.kind = Token::Kind::Number;
    for (;;) {
      const char c = at_.now();
      if (!is_digit(c) && !is_letter(c) && c != '.') return;
      take(token);
      const bool hexadecimal = token.text.size() > 1 && (token.text[1] == 'x' || token.text[1] == 'X');
      const bool exponent = (c == 'e' || c == 'E') && !hexadecimal;
      if (exponent && (at_.now() == '+' || at_.now() == '-')) take(token);
    }
  }

  void string(Token& token) {
    token.kind = Token::Kind::String;
    at_.step();
    while (at_.now() != '"') {
      if (at_.at_end() || at_.now() == '\n') {
        token.kind = Token::Kind::Bad;
        token.text.insert(0, 1, '"');
        return;
      }
      if (at_.now() == '\\' && at_.after() != '\n') take(token);
      if (!at_.at_end()) take(token);
    }
    at_.step();
  }

  void punctuator(Token& token) {
    token.kind = Token::Kind::Punctuator;
    for (const char* spelling : kPunctuators) {
      Characters ahead = at_;
      const char* rest = spelling;
      while (*rest != '\0' && ahead.now() == *rest) {
        ahead.step();
        ++rest;
      }
      if (*rest != '\0') continue;
      token.text = spelling;
      at_ = ahead;
      return;
    }
    token.kind = Token::Kind::Bad;
    take(token);
    // The rest of a character of several bytes (UTF-8), so that it counts once.
    while ((static_cast<unsigned char>(at_.now()) & 0xC0) == 0x80) take(token);
  }

  Characters at_;
  std::uint32_t file_;
  Diagnostics& diagnostics_;
  bool line_start_ = true;
};

}  // namespace

std::vector<Token> lex(std::string_view text, std::uint32_t file, Diagnostics& diagnostics) {
  return Lexer(text, file, diagnostics).run();
}

void report_bad(const Token& token, Diagnostics& diagnostics) {
  if (token.text.starts_with('"')) {
    diagnostics.add(101, token.where, "string without a closing '\"'");
    return;
  }
  const auto byte = static_cast<unsigned char>(token.text.empty() ? '\0' : token.text.front());
  const bool visible = (byte > 0x20 && byte < 0x7F) || (byte >= 0xC0 && token.text.size() > 1);
  constexpr const char* kHex = "0123456789abcdef";
  const std::string shown = visible ? "'" + token.text + "'" : std::string("0x") + kHex[byte >> 4] + kHex[byte & 15];
  diagnostics.add(101, token.where, "bad character " + shown);
}

}  // namespace pfman
