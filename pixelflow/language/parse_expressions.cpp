#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "pixelflow/language/parser_state.h"

namespace pfman {

using ast::Expression;
using ast::ExpressionPtr;
using ast::Operator;
using Kind = ast::Expression::Kind;

namespace {

struct BinaryOperator {
  const char* spelling;
  int level;  ///< higher binds stronger
  Operator op;
};

constexpr std::array kBinary = {
    BinaryOperator{"||", 1, Operator::Or},           BinaryOperator{"&&", 2, Operator::And},
    BinaryOperator{"|", 3, Operator::BitOr},         BinaryOperator{"^", 4, Operator::BitXor},
    BinaryOperator{"&", 5, Operator::BitAnd},        BinaryOperator{"==", 6, Operator::Equal},
    BinaryOperator{"!=", 6, Operator::NotEqual},     BinaryOperator{"<", 7, Operator::Less},
    BinaryOperator{"<=", 7, Operator::LessEqual},    BinaryOperator{">", 7, Operator::Greater},
    BinaryOperator{">=", 7, Operator::GreaterEqual}, BinaryOperator{"<<", 8, Operator::ShiftLeft},
    BinaryOperator{">>", 8, Operator::ShiftRight},   BinaryOperator{"+", 9, Operator::Add},
    BinaryOperator{"-", 9, Operator::Subtract},      BinaryOperator{"*", 10, Operator::Multiply},
    BinaryOperator{"/", 10, Operator::Divide},       BinaryOperator{"%", 10, Operator::Remainder}};

const BinaryOperator* binary_operator(const Token& token) {
  if (token.kind != Token::Kind::Punctuator) return nullptr;
  for (const BinaryOperator& entry : kBinary) {
    if (token.text == entry.spelling) return &entry;
  }
  return nullptr;
}

/// The operator of `+=` and its like, None for `=`; nothing for other tokens.
std::optional<Operator> assignment(const Token& token) {
  if (token.is("=")) return Operator::None;
  if (token.kind != Token::Kind::Punctuator || token.text.size() < 2 || token.text.back() != '=') return std::nullopt;
  const std::string_view front = std::string_view(token.text).substr(0, token.text.size() - 1);
  for (const BinaryOperator& entry : kBinary) {
    const bool assigns = entry.level == 3 || entry.level == 4 || entry.level == 5 || entry.level >= 8;
    if (assigns && front == entry.spelling) return entry.op;
  }
  return std::nullopt;
}

/// Where the first nonzero digit of a decimal numeral stands, as a power of ten; far out values are cut off.
bool is_tiny(std::string_view text) {
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  const std::string_view digits = text.substr(0, mark);
  long long power = 0;
  if (mark < text.size()) {
    std::string_view exponent = text.substr(mark + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    const bool negative = exponent.starts_with('-');
    const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (error != std::errc{}) return negative;
  }
  const auto point = static_cast<long long>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<long long>(digits.find_first_of("123456789"));
  return power < first - point;  // below 1, and out of range: near zero
}

}  // namespace

ExpressionPtr Parser::make(Kind kind, Location where) const {
  auto result = std::make_unique<Expression>();
  result->kind = kind;
  result->where = where;
  return result;
}

void Parser::adopt(Expression& parent, ExpressionPtr child) {
  parent.height = std::max(parent.height, child->height + 1);
  parent.operands.push_back(std::move(child));
  if (parent.height <= ast::kMaximumNesting) return;
  report(102, parent.where, "expression of more than " + std::to_string(ast::kMaximumNesting) + " levels");
  throw GiveUp{};
}

void Parser::check_assignable(const Expression& target, Location where) {
  const Expression* root = &target;
  while (root->kind == Kind::Index) root = root->operands[0].get();
  if (root->kind != Kind::Name) report(102, where, "only a variable or an element of one can be assigned");
}

ExpressionPtr Parser::expression() {
  ExpressionPtr left = conditional();
  const auto op = assignment(now());
  if (!op) return left;
  const Location where = take().where;
  check_assignable(*left, where);
  ExpressionPtr result = make(Kind::Assign, where);
  result->op = *op;
  const Nesting nesting(*this, expression_depth_, "expressions");
  ExpressionPtr right = expression();
  adopt(*result, std::move(left));
  adopt(*result, std::move(right));
  return result;
}

ExpressionPtr Parser::conditional() {
  ExpressionPtr test = binary(1);
  if (!at("?")) return test;
  const Nesting nesting(*this, expression_depth_, "expressions");
  ExpressionPtr result = make(Kind::Conditional, take().where);
  adopt(*result, std::move(test));
  adopt(*result, expression());
  expect(":");
  adopt(*result, conditional());
  return result;
}

ExpressionPtr Parser::binary(int level) {
  ExpressionPtr left = unary();
  for (;;) {
    const BinaryOperator* found = binary_operator(now());
    if (found == nullptr || found->level < level) return left;
    ExpressionPtr result = make(Kind::Binary, take().where);
    result->op = found->op;
    adopt(*result, std::move(left));
    adopt(*result, binary(found->level + 1));
    left = std::move(result);
  }
}

ExpressionPtr Parser::unary() {
  if (pending_) return std::move(pending_);
  const Operator op = at("-")   ? Operator::Negate
                      : at("+") ? Operator::Plus
                      : at("!") ? Operator::Not
                      : at("~") ? Operator::Complement
                                : Operator::None;
  if (op != Operator::None) {
    const Nesting nesting(*this, expression_depth_, "expressions");
    ExpressionPtr result = make(Kind::Unary, take().where);
    result->op = op;
    adopt(*result, unary());
    return result;
  }
  const bool casts =
      at("sat") || at("signed") || at("unsigned") || at("float") || at("int") || at("bool") || at("fixed");
  return casts ? cast() : postfix();
}

ExpressionPtr Parser::cast() {
  const Nesting nesting(*this, expression_depth_, "expressions");
  const Location where = now().where;
  const bool saturate = accept("sat");
  auto type = std::make_shared<ast::Specifiers>();
  type->where = now().where;
  if (at("signed") || at("unsigned")) type->sign = take().text == "signed" ? ast::Sign::Signed : ast::Sign::Unsigned;
  base_type(*type);
  return finish_cast(type, saturate, where);
}

/// From the opening parenthesis; `type` may have been read as the beginning of a declaration.
ExpressionPtr Parser::finish_cast(ast::SpecifiersPtr type, bool saturate, Location where) {
  const bool plain = type->rate == ast::Rate::Unspecified && !type->output && !type->unit &&
                     type->transform == ast::Transform::None && type->dimensions.empty() &&
                     type->base != ast::Base::Void;
  if (!plain) unexpected("a name");
  check_specifiers(*type, false);
  const Location open = expect("(");
  ExpressionPtr result = make(Kind::Cast, where);
  result->saturate = saturate;
  result->cast = std::move(type);
  adopt(*result, expression());
  close(")", open);
  return result;
}

ExpressionPtr Parser::postfix() {
  const Nesting nesting(*this, expression_depth_, "expressions");
  ExpressionPtr result = primary();
  while (at("[")) {
    take();
    ExpressionPtr index = make(Kind::Index, result->where);
    adopt(*index, std::move(result));
    adopt(*index, expression());
    expect("]");
    result = std::move(index);
  }
  if (!at("++") && !at("--")) return result;
  check_assignable(*result, now().where);
  const Kind kind = at("++") ? Kind::PostIncrement : Kind::PostDecrement;
  ExpressionPtr step = make(kind, take().where);
  adopt(*step, std::move(result));
  return step;
}

ExpressionPtr Parser::primary() {
  if (now().kind == Token::Kind::Identifier) return name_or_call();
  if (now().kind == Token::Kind::Number) return number();
  if (at("{")) return array();
  if (at("true") || at("false")) {
    ExpressionPtr result = make(Kind::Boolean, now().where);
    result->integer = take().text == "true" ? 1 : 0;
    return result;
  }
  if (!at("(")) unexpected("an expression");
  const Location open = take().where;
  ExpressionPtr result = expression();
  close(")", open);
  return result;
}

ExpressionPtr Parser::name_or_call() {
  ExpressionPtr result = make(Kind::Name, now().where);
  result->name = take().text;
  if (!at("(")) return result;
  const Location open = take().where;
  result->kind = Kind::Call;
  if (!accept(")")) {
    do {
      adopt(*result, conditional());
    } while (accept(","));
    close(")", open);
  }
  return result;
}

ExpressionPtr Parser::array() {
  ExpressionPtr result = make(Kind::Array, now().where);
  const Location open = take().where;
  ++open_arrays_;
  do {
    adopt(*result, conditional());
  } while (accept(","));
  close("}", open);
  --open_arrays_;
  return result;
}

ExpressionPtr Parser::number() {
  const Token token = take();
  const std::string_view text = token.text;
  const auto malformed = [&](const std::string& why) {
    report(101, token.where, "number '" + token.text + "' " + why);
  };
  ExpressionPtr result = make(Kind::Integer, token.where);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal || text.find_first_not_of("0123456789") == std::string_view::npos) {
    const std::string_view digits = hexadecimal ? text.substr(2) : text;
    const char* last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, result->integer, hexadecimal ? 16 : 10);
    if (end != last || digits.empty()) {
      malformed("is malformed");
    } else if (!hexadecimal && digits.size() > 1 && digits.front() == '0') {
      malformed("begins with 0, but there are no octal numbers");
    } else if (error != std::errc{} || result->integer >> 63 != 0) {
      result->integer = 0;
      malformed("is too large, the largest is 9223372036854775807");
    }
    return result;
  }
  result->kind = Kind::Real;
  std::string_view digits = text;
  if (digits.ends_with('f') || digits.ends_with('F')) {
    digits.remove_suffix(1);
    result->float_suffix = true;
  }
  const char* last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, result->real);
  const bool real = digits.find_first_of(".eE") != std::string_view::npos;
  if (end != last || !real) {
    malformed("is malformed");
  } else if (error == std::errc::result_out_of_range) {
    result->real = 0;
    if (!is_tiny(digits)) malformed("is too large");
  }
  return result;
}

}  // namespace pfman
