// What the parser makes of a shader's text: the grammar of docs/pfman.md, nothing resolved.
//
// Expressions, statements and definitions are plain nodes with a kind; which members a kind uses stands beside it.
// Names are as written. Parentheses leave no node.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/language/diagnostics.h"

namespace pfman::ast {

enum class Operator : std::uint8_t {
  None,  ///< plain `=`
  Add,
  Subtract,
  Multiply,
  Divide,
  Remainder,
  ShiftLeft,
  ShiftRight,
  BitAnd,
  BitOr,
  BitXor,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Equal,
  NotEqual,
  And,
  Or,
  Negate,      ///< unary -
  Plus,        ///< unary +
  Not,         ///< !
  Complement,  ///< ~
};
const char* spelling(Operator op);  ///< "+", "<<", "!"; "" for None

/// Expressions have at most this height, statements nest at most so deep: more is a syntax error.
constexpr int kMaximumNesting = 256;

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;

enum class Rate : std::uint8_t { Unspecified, Uniform, Varying };
enum class Sign : std::uint8_t { Unspecified, Unsigned, Signed };
enum class Base : std::uint8_t { Void, Float, Int, Bool, Fixed };
enum class Transform : std::uint8_t { None, Point, Vector, Normal, Texture };

/// `specs` of the grammar. A specifier that stands twice, or two that contradict each other, is a syntax error (E102),
/// two transform attributes are E221; both are the parser's.
struct Specifiers {
  Location where;  ///< of the first of them
  Base base = Base::Void;
  ExpressionPtr size, exponent;  ///< of fixed<size, exponent>
  Sign sign = Sign::Unspecified;
  Rate rate = Rate::Unspecified;
  bool output = false;
  bool unit = false;
  Transform transform = Transform::None;
  Location attribute;                     ///< of `unit` or the transform attribute
  std::vector<ExpressionPtr> dimensions;  ///< written after the type
};
using SpecifiersPtr = std::shared_ptr<const Specifiers>;  ///< shared by the declarators of one declaration

struct Declarator {
  Location where;
  std::string name;
  SpecifiersPtr specifiers;
  std::vector<ExpressionPtr> dimensions;  ///< written after the name; they come before those after the type, 2 in all
  ExpressionPtr initial;                  ///< or null
};

struct Expression {
  enum class Kind : std::uint8_t {
    Name,           // name
    Integer,        // integer
    Real,           // real, float_suffix
    Boolean,        // integer: 0 or 1
    Unary,          // op, operands[0]
    Binary,         // op, operands[0], operands[1]
    Conditional,    // operands[0] ? operands[1] : operands[2]
    Assign,         // operands[0] op= operands[1]
    PostIncrement,  // operands[0]++
    PostDecrement,
    Call,   // name, operands
    Index,  // operands[0][operands[1]]
    Array,  // { operands... }
    Cast,   // saturate, cast, operands[0]
  };
  Kind kind;
  Location where;  ///< of the operator for Binary, Conditional, Assign, PostIncrement; else of the first token
  std::vector<ExpressionPtr> operands;
  std::string name;
  std::uint64_t integer = 0;
  double real = 0;  ///< the double nearest to the literal's text
  bool float_suffix = false;
  Operator op = Operator::None;
  bool saturate = false;
  std::uint32_t height = 1;  ///< levels of the tree from here down, so that who recurses knows his stack
  SpecifiersPtr cast;        ///< base, sign, size and exponent only
};

struct Statement;
using StatementPtr = std::unique_ptr<Statement>;

struct Statement {
  enum class Kind : std::uint8_t {
    Declaration,  // declarators
    Constant,     // declarators, all with `const`
    Expression,   // expressions[0]
    Block,        // body
    If,           // expressions[0], body[0], body[1] if there is an else
    While,        // expressions[0], body[0]
    DoWhile,      // body[0], expressions[0]
    For,          // expressions[0], [1], [2], each or null; body[0]
    Illuminance,  // expressions: none, position, or position, axis, angle; body[0]
    Illuminate,   // expressions: position, or position, axis, angle; body[0]
    Solar,        // expressions: none, or axis, angle; body[0]
    Break,
    Continue,
    Return,  // expressions[0] or none
    Empty,
  };
  Kind kind;
  Location where;  ///< of its first token
  std::vector<ExpressionPtr> expressions;
  std::vector<StatementPtr> body;
  std::vector<Declarator> declarators;
};

struct Pragma {
  Location where;
  std::string text;  ///< behind `#pragma pfman`, without surrounding blanks
};

struct Definition {
  enum class Kind : std::uint8_t { Surface, Light, Function, Extern, Constant };
  Kind kind;
  Location where;  ///< of the name; of a Constant, of `const`
  std::string name;
  SpecifiersPtr result;  ///< Function, Extern; Base::Void for void
  std::vector<Declarator> parameters;
  std::vector<Declarator> declarators;  ///< Constant
  StatementPtr body;                    ///< a Block; Surface, Light, Function
  std::optional<std::string> linkage;   ///< Extern: the C name, if it stands there
};

struct Unit {
  std::vector<Definition> definitions;
  std::vector<Pragma> pragmas;
};

}  // namespace pfman::ast
