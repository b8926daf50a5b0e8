#include <charconv>

#include "pixelflow/language/parser.h"

namespace pfman {

const char* ast::spelling(Operator op) {
  switch (op) {
    case Operator::None: return "";
    case Operator::Add: return "+";
    case Operator::Subtract: return "-";
    case Operator::Multiply: return "*";
    case Operator::Divide: return "/";
    case Operator::Remainder: return "%";
    case Operator::ShiftLeft: return "<<";
    case Operator::ShiftRight: return ">>";
    case Operator::BitAnd: return "&";
    case Operator::BitOr: return "|";
    case Operator::BitXor: return "^";
    case Operator::Less: return "<";
    case Operator::LessEqual: return "<=";
    case Operator::Greater: return ">";
    case Operator::GreaterEqual: return ">=";
    case Operator::Equal: return "==";
    case Operator::NotEqual: return "!=";
    case Operator::And: return "&&";
    case Operator::Or: return "||";
    case Operator::Negate: return "-";
    case Operator::Plus: return "+";
    case Operator::Not: return "!";
    case Operator::Complement: return "~";
  }
  return "";
}

namespace {

using ast::Base;
using ast::Definition;
using ast::Expression;
using ast::Rate;
using ast::Sign;
using ast::Statement;
using ast::Transform;

class Dump {
 public:
  std::string take() { return std::move(text_); }

  void definition(const Definition& node) {
    switch (node.kind) {
      case Definition::Kind::Surface: line("surface " + node.name); break;
      case Definition::Kind::Light: line("light " + node.name); break;
      case Definition::Kind::Function: line("function " + node.name); break;
      case Definition::Kind::Extern:
        line("extern " + (node.linkage ? "\"" + *node.linkage + "\" " : std::string()) + node.name);
        break;
      case Definition::Kind::Constant: line("const"); break;
    }
    const Deeper deeper(*this);
    if (node.result) type("result", *node.result);
    for (const auto& parameter : node.parameters) declarator("parameter", parameter);
    for (const auto& constant : node.declarators) declarator("constant", constant);
    if (node.body) statement(*node.body);
  }

  void pragma(const ast::Pragma& node) { line("pragma " + node.text); }

 private:
  struct Deeper {
    explicit Deeper(Dump& dump) : owner(dump) { ++owner.depth_; }
    ~Deeper() { --owner.depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    Dump& owner;
  };

  void line(const std::string& text) { text_ += std::string(2 * depth_, ' ') + text + "\n"; }

  static std::string words(const ast::Specifiers& specs) {
    std::string text;
    const auto word = [&](bool stands, const char* spelling) {
      if (stands) text += std::string(text.empty() ? "" : " ") + spelling;
    };
    word(specs.output, "output");
    word(specs.rate == Rate::Uniform, "uniform");
    word(specs.rate == Rate::Varying, "varying");
    word(specs.unit, "unit");
    word(specs.transform == Transform::Point, "transform_as_point");
    word(specs.transform == Transform::Vector, "transform_as_vector");
    word(specs.transform == Transform::Normal, "transform_as_normal");
    word(specs.transform == Transform::Texture, "transform_as_texture");
    word(specs.sign == Sign::Signed, "signed");
    word(specs.sign == Sign::Unsigned, "unsigned");
    word(specs.base == Base::Void, "void");
    word(specs.base == Base::Float, "float");
    word(specs.base == Base::Int, "int");
    word(specs.base == Base::Bool, "bool");
    word(specs.base == Base::Fixed, "fixed");
    return text;
  }

  void type(const std::string& head, const ast::Specifiers& specs) {
    line(head + " " + words(specs));
    const Deeper deeper(*this);
    parts(specs);
  }

  void parts(const ast::Specifiers& specs) {
    labelled("size", specs.size);
    labelled("exponent", specs.exponent);
    for (const auto& dimension : specs.dimensions) labelled("type dimension", dimension);
  }

  void declarator(const std::string& head, const ast::Declarator& node) {
    line(head + " " + node.name + ": " + words(*node.specifiers));
    const Deeper deeper(*this);
    parts(*node.specifiers);
    for (const auto& dimension : node.dimensions) labelled("dimension", dimension);
    labelled("initial", node.initial);
  }

  void labelled(const std::string& label, const ast::ExpressionPtr& node) {
    if (!node) return;
    line(label);
    const Deeper deeper(*this);
    expression(*node);
  }

  void statement(const Statement& node) {
    line(name(node.kind));
    const Deeper deeper(*this);
    for (const auto& declared : node.declarators) declarator("variable", declared);
    if (node.kind == Statement::Kind::DoWhile) {
      for (const auto& inner : node.body) statement(*inner);
    }
    for (const auto& part : node.expressions) {
      if (part) {
        expression(*part);
      } else {
        line("nothing");
      }
    }
    if (node.kind == Statement::Kind::DoWhile) return;
    for (const auto& inner : node.body) statement(*inner);
  }

  static const char* name(Statement::Kind kind) {
    switch (kind) {
      case Statement::Kind::Declaration: return "declaration";
      case Statement::Kind::Constant: return "const";
      case Statement::Kind::Expression: return "expression";
      case Statement::Kind::Block: return "block";
      case Statement::Kind::If: return "if";
      case Statement::Kind::While: return "while";
      case Statement::Kind::DoWhile: return "do";
      case Statement::Kind::For: return "for";
      case Statement::Kind::Illuminance: return "illuminance";
      case Statement::Kind::Illuminate: return "illuminate";
      case Statement::Kind::Solar: return "solar";
      case Statement::Kind::Break: return "break";
      case Statement::Kind::Continue: return "continue";
      case Statement::Kind::Return: return "return";
      case Statement::Kind::Empty: return "empty";
    }
    return "";
  }

  void expression(const Expression& node) {
    line(head(node));
    const Deeper deeper(*this);
    if (node.cast) type("to", *node.cast);
    for (const auto& operand : node.operands) expression(*operand);
  }

  static std::string head(const Expression& node) {
    switch (node.kind) {
      case Expression::Kind::Name: return "name " + node.name;
      case Expression::Kind::Integer: return "integer " + std::to_string(node.integer);
      case Expression::Kind::Real: return "real " + shortest(node.real) + (node.float_suffix ? " f" : "");
      case Expression::Kind::Boolean: return node.integer != 0 ? "true" : "false";
      case Expression::Kind::Unary: return std::string("unary ") + spelling(node.op);
      case Expression::Kind::Binary: return std::string("binary ") + spelling(node.op);
      case Expression::Kind::Conditional: return "conditional";
      case Expression::Kind::Assign: return std::string("assign ") + spelling(node.op) + "=";
      case Expression::Kind::PostIncrement: return "increment";
      case Expression::Kind::PostDecrement: return "decrement";
      case Expression::Kind::Call: return "call " + node.name;
      case Expression::Kind::Index: return "index";
      case Expression::Kind::Array: return "array";
      case Expression::Kind::Cast: return node.saturate ? "cast sat" : "cast";
    }
    return "";
  }

  static std::string shortest(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, result.ptr);
  }

  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace

std::string dump(const ast::Unit& unit) {
  Dump dump;
  for (const auto& pragma : unit.pragmas) dump.pragma(pragma);
  for (const auto& definition : unit.definitions) dump.definition(definition);
  return dump.take();
}

}  // namespace pfman
