// From syntax tree to nodes and steps: names, types, and the sizes of fixed-point numbers. The program is taken to be
// valid; where it is not, Error is thrown, or the program means something.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/reference/node.h"

namespace reference {

struct Parameter {
  Variable* variable = nullptr;
  bool unit = false;
  bool output = false;
  NodePtr initial;  ///< or null
};

struct Shader {
  bool light = false;
  std::vector<Parameter> parameters;
  StepPtr body;               ///< a Block
  bool three_colors[3] = {};  ///< whether it assigns px_light_color, _ambient, _specular somewhere
};

class Resolver {
 public:
  explicit Resolver(const pfman::ast::Unit& unit);
  Shader shader(const std::string& name);
  Function& function(const std::string& name);
  /// A variable that every shader sees: px_light_color and its kind, px_shader_position.
  Variable& common(const std::string& name) { return *scopes_.front().at(name); }

 private:
  using Expression = pfman::ast::Expression;
  using Statement = pfman::ast::Statement;
  using Specifiers = pfman::ast::Specifiers;
  using Operator = pfman::ast::Operator;
  using Nodes = std::vector<NodePtr>;

  // Definitions and types.
  Variable* declare(const std::string& name, const Number& number, const Shape& shape, bool uniform);
  Variable* declare(const pfman::ast::Declarator& declarator, bool uniform);
  void declare_constants(const std::vector<pfman::ast::Declarator>& declarators);
  Variable* find(const std::string& name, pfman::Location where) const;
  Number number_of(const Specifiers& specifiers);
  Shape shape_of(const Specifiers& specifiers, const std::vector<pfman::ast::ExpressionPtr>& dimensions);
  int constant_integer(const Expression& expression);

  // Statements.
  StepPtr step(const Statement& statement);
  StepPtr if_step(const Statement& statement);
  StepPtr loop_step(const Statement& statement);
  StepPtr light_step(const Statement& statement, Step::Kind kind);
  StepPtr body_step(const Statement& statement);  ///< with a scope of its own

  // Expressions.
  NodePtr node(const Expression& expression);
  NodePtr literal_node(const Expression& expression);
  NodePtr array_node(const Expression& expression);
  NodePtr conditional_node(const Expression& expression);
  NodePtr assignment_node(const Expression& expression);
  void note_color(const Node& target);
  NodePtr increment_node(const Expression& expression);
  NodePtr call_node(const Expression& expression);
  NodePtr unary_node(Operator op, NodePtr operand, pfman::Location where);
  NodePtr binary_node(Operator op, NodePtr a, NodePtr b, pfman::Location where);
  NodePtr arithmetic_node(Operator op, NodePtr a, NodePtr b, pfman::Location where);
  NodePtr comparison_node(Operator op, NodePtr a, NodePtr b, pfman::Location where);
  NodePtr shift_node(Operator op, NodePtr a, NodePtr b, pfman::Location where);
  NodePtr builtin_node(const std::string& name, Nodes operands, pfman::Location where);

  std::deque<Variable> variables_;
  std::vector<std::map<std::string, Variable*>> scopes_;
  std::map<std::string, Function> functions_;
  const pfman::ast::Unit& unit_;
  std::vector<int> varying_ifs_;  ///< around a statement, of each loop that it is in
  Variable* result_ = nullptr;    ///< of the function
  bool three_colors_[3] = {};
};

// Pieces of the passes over expressions; each takes a node that has no demand yet.

NodePtr make_node(Node::Kind kind, pfman::Location where);
/// Gives literals without a type one: that of `surroundings`, or of their own.
void settle(Node& node, const std::optional<Number>& surroundings);
/// Literals among `nodes` take the type of the others; then, if one is float, all are made floats. False, and nothing
/// done, where all are literals.
bool meet(std::vector<NodePtr>& nodes);
/// A root: the node, converted to `target`.
NodePtr root(NodePtr node, const Number& target, bool saturate = false);
/// A root that keeps every bit.
NodePtr whole(NodePtr node);
NodePtr condition(NodePtr node);
/// Comparisons and remainders align their operands exactly, in 64 bits.
void require_alignment(const Number& a, const Number& b, pfman::Location where);
/// Of a Builtin, once its operands are typed.
void type_builtin(Node& node);
[[noreturn]] void fail(int code, pfman::Location where, const std::string& text);
NodePtr fold(pfman::ast::Operator op, const Node& a, const Node* b, pfman::Location where);
bool is_constant(const Node& node);
Shape broadcast(const Shape& a, const Shape& b, pfman::Location where);

}  // namespace reference
