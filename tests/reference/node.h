// A shader with its names resolved and its numbers typed: what the interpreter walks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "tests/reference/number.h"

namespace reference {

/// Rows and columns of an array; a scalar has no rows, an array of one dimension no columns.
struct Shape {
  int rows = 0, columns = 0;

  int count() const { return (rows == 0 ? 1 : rows) * (columns == 0 ? 1 : columns); }
  bool scalar() const { return rows == 0; }
  Shape element() const { return {columns, 0}; }
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// Raw bits, element after element, each of one lane (uniform) or of all.
struct Value {
  int lanes = 1;
  std::vector<Raw> raw;

  Value() = default;
  Value(int lane_count, int elements) : lanes(lane_count), raw(static_cast<std::size_t>(lane_count * elements)) {}
  int elements() const { return static_cast<int>(raw.size()) / lanes; }
  /// One element stands for every element, one lane for every lane.
  Raw at(int element, int lane) const {
    const int first = element * lanes;
    return raw[static_cast<std::size_t>((first < static_cast<int>(raw.size()) ? first : 0) + (lanes == 1 ? 0 : lane))];
  }
  Raw& to(int element, int lane) { return raw[static_cast<std::size_t>(element * lanes + (lanes == 1 ? 0 : lane))]; }
};

struct Variable {
  std::string name;
  Number number;
  Shape shape;
  bool uniform = false;
  bool constant = false;
  Value value;
};

struct Node;
struct Builtin;
using NodePtr = std::unique_ptr<Node>;
struct Function;

struct Node {
  enum class Kind {
    Literal,      // raw; before it has a type: real, text
    Read,         // variable
    Index,        // operands[0][operands[1]]
    Array,        // { operands... }
    Unary,        // op, operands[0]
    Binary,       // op, operands[0], operands[1]: arithmetic and bits
    Compare,      // op, operands[0], operands[1]
    Logic,        // && || !: op, operands
    Shift,        // op, operands[0] by operands[1], a uniform count that is not constant
    Scale,        // operands[0] 2^shift: a shift by a constant
    Conditional,  // operands[0] ? operands[1] : operands[2]
    Convert,      // operands[0] to target; saturate
    Assign,       // operands[0] = operands[1]
    Increment,    // operands[0] = operands[1]; the value is the old one
    Call,         // function, operands: an argument a parameter; results: where output parameters go back to
    Builtin,      // builtin, operands
  };
  Kind kind = Kind::Literal;
  pfman::Location where;
  std::vector<NodePtr> operands;
  Number number;  ///< bottom-up when made, limited by the pass from the top
  Shape shape;
  bool uniform = true;
  /// A literal, or a choice among literals, without a type yet: it takes that of its surroundings.
  bool untyped = false;
  bool real = false;   ///< there is a real literal among them
  double literal = 0;  ///< the literal's value
  Raw raw = 0;         ///< once it has a type; before, an integer literal's value
  Variable* variable = nullptr;
  pfman::ast::Operator op = pfman::ast::Operator::None;
  int shift = 0;
  Number target;  ///< of a conversion; number may ask for less of it
  bool saturate = false;
  Function* function = nullptr;
  std::vector<NodePtr> results;
  const Builtin* builtin = nullptr;
};

struct Step;
using StepPtr = std::unique_ptr<Step>;

struct Step {
  enum class Kind {
    Evaluate,     // nodes[0]
    Declare,      // variable, nodes[0] or null
    Block,        // body
    If,           // nodes[0], body[0], perhaps body[1]; varying
    Loop,         // nodes: condition, step or null; body[0]; body_first for do
    Break,        // masked
    Continue,     // masked
    Return,       // nodes[0] or null
    Illuminance,  // nodes: none, or axis and angle; body[0]
    Illuminate,   // nodes: position, perhaps axis and angle; body[0]
    Solar,        // nodes: axis; body[0]
  };
  Kind kind = Kind::Block;
  pfman::Location where;
  std::vector<NodePtr> nodes;
  std::vector<StepPtr> body;
  Variable* variable = nullptr;
  bool varying = false;
  bool masked = false;
  bool body_first = false;
};

struct Function {
  std::string name;
  const pfman::ast::Definition* definition = nullptr;
  std::vector<Variable*> parameters;
  Variable* result = nullptr;
  StepPtr body;
};

}  // namespace reference
