#include "pixelflow/language/condition.h"

#include <charconv>
#include <string_view>

namespace pfman {
namespace {

constexpr int kMaximumDepth = 256;

struct Mistake {};

int precedence(const Token& token) {
  if (token.kind != Token::Kind::Punctuator) return 0;
  const std::string_view text = token.text;
  if (text == "||") return 1;
  if (text == "&&") return 2;
  if (text == "|") return 3;
  if (text == "^") return 4;
  if (text == "&") return 5;
  if (text == "==" || text == "!=") return 6;
  if (text == "<" || text == "<=" || text == ">" || text == ">=") return 7;
  if (text == "<<" || text == ">>") return 8;
  if (text == "+" || text == "-") return 9;
  if (text == "*" || text == "/" || text == "%") return 10;
  return 0;
}

class Condition {
 public:
  Condition(std::vector<Token> tokens, Diagnostics& diagnostics)
      : tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

  std::int64_t value() {
    const std::int64_t result = conditional(true);
    if (now().kind != Token::Kind::End) fail("unexpected '" + now().text + "' in a condition");
    return result;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  [[noreturn]] void fail(const std::string& text) {
    diagnostics_.add(100, now().where, text);
    throw Mistake{};
  }
  void enter() {
    if (++depth_ > kMaximumDepth) fail("condition nested deeper than " + std::to_string(kMaximumDepth));
  }
  bool accept(const char* spelling) {
    if (!now().is(spelling)) return false;
    ++at_;
    return true;
  }
  void expect(const char* spelling) {
    if (!accept(spelling)) fail(std::string("expected '") + spelling + "' in a condition");
  }

  // `live`: the value counts; in a part that && || ?: leave out, a division by zero is no mistake.
  std::int64_t conditional(bool live) {
    enter();
    const std::int64_t test = binary(1, live);
    std::int64_t result = test;
    if (accept("?")) {
      const std::int64_t yes = conditional(live && test != 0);
      expect(":");
      const std::int64_t no = conditional(live && test == 0);
      result = test != 0 ? yes : no;
    }
    --depth_;
    return result;
  }

  std::int64_t binary(int level, bool live) {
    std::int64_t left = unary(live);
    for (int found = precedence(now()); found >= level; found = precedence(now())) {
      const std::string op = now().text;
      ++at_;
      const bool right_live = live && !(op == "&&" && left == 0) && !(op == "||" && left != 0);
      const std::int64_t right = binary(found + 1, right_live);
      left = apply(op, left, right, right_live);
    }
    return left;
  }

  std::int64_t apply(const std::string& op, std::int64_t left, std::int64_t right, bool live) {
    const auto a = static_cast<std::uint64_t>(left);
    const auto b = static_cast<std::uint64_t>(right);
    if (op == "||") return left != 0 || right != 0;
    if (op == "&&") return left != 0 && right != 0;
    if (op == "|") return left | right;
    if (op == "^") return left ^ right;
    if (op == "&") return left & right;
    if (op == "==") return left == right;
    if (op == "!=") return left != right;
    if (op == "<") return left < right;
    if (op == "<=") return left <= right;
    if (op == ">") return left > right;
    if (op == ">=") return left >= right;
    if (op == "+") return static_cast<std::int64_t>(a + b);
    if (op == "-") return static_cast<std::int64_t>(a - b);
    if (op == "*") return static_cast<std::int64_t>(a * b);
    if (!live) return 0;
    if (op == "<<" || op == ">>") {
      if (right < 0 || right > 63) fail("shift by " + std::to_string(right) + " in a condition");
      return op == "<<" ? static_cast<std::int64_t>(a << b) : left >> right;
    }
    if (right == 0) fail("division by zero in a condition");
    if (right == -1) return op == "/" ? static_cast<std::int64_t>(0 - a) : 0;
    return op == "/" ? left / right : left % right;
  }

  std::int64_t unary(bool live) {
    enter();
    std::int64_t result = 0;
    if (accept("-")) {
      result = static_cast<std::int64_t>(0 - static_cast<std::uint64_t>(unary(live)));
    } else if (accept("+")) {
      result = unary(live);
    } else if (accept("!")) {
      result = unary(live) == 0;
    } else if (accept("~")) {
      result = ~unary(live);
    } else {
      result = primary(live);
    }
    --depth_;
    return result;
  }

  std::int64_t primary(bool live) {
    if (accept("(")) {
      const std::int64_t result = conditional(live);
      expect(")");
      return result;
    }
    const Token token = now();
    if (token.kind == Token::Kind::End) fail("a condition lacks an operand");
    if (token.kind == Token::Kind::Identifier) {
      ++at_;
      return token.text == "true";
    }
    if (token.kind != Token::Kind::Number) fail("unexpected '" + token.text + "' in a condition");
    const bool hexadecimal = token.text.starts_with("0x") || token.text.starts_with("0X");
    const char* begin = token.text.data() + (hexadecimal ? 2 : 0);
    const char* end = token.text.data() + token.text.size();
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value, hexadecimal ? 16 : 10);
    if (error != std::errc{} || rest != end || *begin == '-') {
      fail("'" + token.text + "' is no integer of a condition");
    }
    ++at_;
    return value;
  }

  std::vector<Token> tokens_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool evaluate_condition(const std::vector<Token>& line, Location directive, MacroTable& table) {
  // `defined` looks at names, so it comes before expansion.
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!line[i].is_identifier("defined")) {
      tokens.push_back(line[i]);
      continue;
    }
    const bool parenthesis = i + 1 < line.size() && line[i + 1].is("(");
    const std::size_t name = i + (parenthesis ? 2 : 1);
    const std::size_t last = name + (parenthesis ? 1 : 0);
    if (last >= line.size() || line[name].kind != Token::Kind::Identifier || (parenthesis && !line[last].is(")"))) {
      table.diagnostics().add(100, line[i].where, "'defined' without a name");
      return false;
    }
    Token number = line[i];
    number.kind = Token::Kind::Number;
    number.text = table.find(line[name].text) ? "1" : "0";
    tokens.push_back(std::move(number));
    i = last;
  }
  tokens = expand(tokens, table);
  if (table.exhausted()) return false;
  Token end;
  end.where = line.empty() ? directive : line.back().where;
  tokens.push_back(end);
  try {
    return Condition(std::move(tokens), table.diagnostics()).value() != 0;
  } catch (const Mistake&) {
    return false;
  }
}

}  // namespace pfman
