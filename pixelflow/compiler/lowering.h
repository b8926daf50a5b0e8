// The state of lower() and its parts, which stand in lower*.cpp: statements, expressions, uniform trees, calls, fixed
// point, float, noise and lookups.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "pixelflow/compiler/lower.h"

namespace pfman {

/// A scalar while it is lowered: where its bytes are, and what they mean. Exact: the raw number there is a number of
/// `type`. Otherwise only its low type.size bits are known to be the value's: whoever needs more has it wrapped().
struct Value {
  ir::Operand at;
  Scalar type;
  bool exact = true;
};
using Values = std::vector<Value>;

class Lowering {
 public:
  Lowering(const Tree& tree, const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics);
  ir::Code run();

 private:
  using Op = Node::Op;
  using Code = pixelflow::Code;
  using Kind = ir::Instruction::Kind;

  /// What stands for a variable of the tree.
  struct Binding {
    std::vector<int> variables;  ///< varying: one for each scalar, or a single one with a count
    Values values;               ///< a parameter that its function does not write, given these
    Variable* uniform = nullptr;
  };
  struct LoopContext {
    int start = 0;  ///< its Loop instruction
    int break_bit = -1, continue_bit = -1;
    int breaks = 0, continues = 0;  ///< masked ones met so far
  };

  // lower.cpp
  void declare_parameters();
  void finish_colour();
  void note_variables(const std::vector<StatementPtr>& body);
  void note_variables(const Statement& statement);
  void note_variables(const Node& node);

  // lower_emit.cpp: instructions and places.
  int append(ir::Instruction instruction);
  ir::Instruction& at(int index) { return code_.code[static_cast<std::size_t>(index)]; }
  int add_variable(const std::string& name, const Scalar& scalar, int count, bool temporary);
  ir::Operand whole(int variable, int element = 0) const;
  ir::Operand temporary(const Scalar& scalar) { return whole(add_variable({}, scalar, 1, true)); }
  ir::Operand pixel(const ir::Operand& operand);
  ir::Operand operate(Code code, const Scalar& type, ir::Operand a, ir::Operand b = {}, int scale = 0);
  void operate_into(const ir::Operand& d, Code code, ir::Operand a, ir::Operand b = {}, int scale = 0);
  ir::Operand join(Kind kind, const Scalar& type, ir::Operand a, ir::Operand b);
  ir::Operand select(const ir::Operand& condition, const Scalar& type, const ir::Operand& a, const ir::Operand& b);
  ir::Operand constant(std::uint64_t raw, const Scalar& type);
  void error(const std::string& text);
  /// A variable of pixel memory for a variable of the tree.
  Binding& binding(const Variable& variable);
  Values place_of(const Node& node);
  Values element_of(const Node& node);
  NodePtr index_tree(const Node& node);
  NodePtr table_lookup(const Node& element, int rows, int columns);
  Value first_of(const Values& all, const Scalar& scalar);

  // lower_statement.cpp
  void lower_body(const std::vector<StatementPtr>& body);
  void lower_statement(const Statement& statement);
  void lower_if(const Statement& statement);
  void lower_loop(const Statement& statement);
  void lower_jump(const Statement& statement);
  void test_loop(const Statement& statement, int loop);
  void begin_illuminance(const Statement& statement);
  int take_bits(int count);
  // Control flow on the host around instructions that the caller appends.
  int begin_if(NodePtr condition);
  int begin_else(int opening);
  void end_if(int opening);
  int begin_loop();
  void end_loop(int loop);

  // lower_expression.cpp
  Values lower_node(const Node& node);
  Values lower_varying(const Node& node);
  Value lower_scalar(const Node& node) { return lower_node(node).at(0); }
  Values lower_elementwise(const Node& node);
  Value lower_binary(const Node& node, const Value& a, const Value& b);
  Value lower_unary(const Node& node, const Value& a);
  Values lower_select(const Node& node);
  Values lower_assign(const Node& node);
  void store(const Node& target, const Values& values);
  void store(const Value& target, const Value& value);
  /// A bool as a byte, or none where the instruction just appended has left it in K.
  ir::Operand condition(const Node& node);
  ir::Operand compare(const Node& node);
  ir::Operand compare_values(Op op, const Value& a, const Value& b, bool to_byte);
  Value logical_not(const Value& value);
  Value convert(const Value& value, const Scalar& to, bool saturate);

  // lower_uniform.cpp
  Values uniform_values(const Node& node);
  Value uniform_value(NodePtr tree);
  Values elements_of(Variable& variable);
  NodePtr tree_of(const Value& value) const;  ///< a copy of a uniform value's tree
  NodePtr uniform_tree(const Node& node);
  NodePtr hoisting_tree(const Node& node);
  NodePtr conditional_tree(const Node& node);
  Variable* hidden(const Type& type);
  Variable* hoist(NodePtr tree);
  void evaluate(NodePtr tree);
  int add_uniform(NodePtr tree);
  Variable* uniform_of(const Variable& variable);

  // lower_call.cpp
  Values lower_call(const Node& node);
  Values external_call(const Node& node);
  void store_uniform(Variable& variable, const Node& value);
  /// The caller's variables for an output parameter, if it can have these themselves; otherwise none.
  std::vector<int> variables_of(const Values& places, const Variable& parameter);
  Value argument_value(const Value& value, const Function& function, const Scalar& type);
  bool may_call();

  // lower_fixed.cpp, lower_multiply.cpp, lower_divide.cpp
  Value with_type(const Value& value, const Scalar& type);
  Value wrapped(const Value& value);
  Value needed(const Value& value, int bits);
  Value reduced(const Value& value, const Scalar& type);
  Value finished(const Value& value, const Scalar& type);
  Value shifted_left(const Value& value, int places, int bits);
  Value shifted_right(const Value& value, int places, int bits);
  Value aligned(const Value& value, int exponent, int bits);
  Value extended(const Value& value, int bytes);
  Value fixed_convert(const Value& value, const Scalar& to);
  Value fixed_saturate(const Value& value, const Scalar& to);
  Value fixed_add(const Value& a, const Value& b, bool subtract, const Scalar& type);
  Value fixed_bitwise(Op op, const Value& a, const Value& b, const Scalar& type);
  Value fixed_complement(const Value& value, const Scalar& type);
  Value fixed_shift(const Node& node, const Value& value);
  Value fixed_abs(const Value& value, const Scalar& type);
  Value fixed_round(Op op, const Value& value, const Scalar& type);
  Value fixed_square_root(const Value& value, const Scalar& type);
  Value fixed_multiply(const Value& a, const Value& b, const Scalar& type);
  int power_of_two(const Value& value) const;
  Value joined(const ir::Operand& upper, const ir::Operand& lower, int places, const Scalar& type);
  Value product(const Value& a, const Value& b, int places, const Scalar& full, int bits);
  Value fixed_divide(const Value& a, const Value& b, const Scalar& type);
  Value scaled_quotient(const Value& a, const Value& b, int places, int bits);
  Value shifted_quotient(const Value& a, const Value& b, int places, int bits);
  Value fixed_remainder(const Value& a, const Value& b, const Scalar& type);
  Value nonzero(const Value& value);

  // lower_float.cpp
  Value to_float(const Value& value);
  Value to_fixed(const Value& value, const Scalar& to);
  Value float_negate(const Value& value);
  Value float_abs(const Value& value);
  Value float_round(Op op, const Value& value);
  Value float_remainder(const Value& a, const Value& b);
  Value float_binary(Code code, const Value& a, const Value& b);

  // lower_library.cpp
  Value lower_noise(const Node& node);
  Value lower_cell_noise(const Node& node);
  Value lower_turbulence(const Node& node);
  Value cell(const Value& coordinate);
  Variable* checked_octaves(const Node& node);
  Values lower_lookup(const Node& node);
  /// A variable that holds them one after another; a single value `count` times.
  int gathered(const Values& values, const Scalar& type, int count = 0);

  const Tree& tree_;
  const Shader& shader_;
  const LowerOptions options_;
  Diagnostics& diagnostics_;
  ir::Code code_;
  std::map<const Variable*, Binding> bindings_;
  std::set<const Variable*> unit_constants_;
  std::set<const Variable*> indexed_;  ///< varying arrays with an index that is not known
  std::set<const Variable*> written_;  ///< by an assignment, or as an output
  std::set<const Function*> noted_;
  std::vector<LoopContext> loops_;
  int mask_bits_ = 0;  ///< in use
  int depth_ = 0;      ///< of calls
  int calls_ = 0;      ///< written in place
  int temporaries_ = 0;
  bool too_long_ = false;
  Location where_;
};

// Nodes of uniform trees.
NodePtr make_node(Node::Op op, const Type& type, Location where);
NodePtr make_literal(std::uint64_t raw, const Scalar& type, Location where);
NodePtr make_reference(Variable& variable, Location where);
NodePtr make_unary(Node::Op op, const Scalar& type, NodePtr a);
NodePtr make_binary(Node::Op op, const Scalar& type, NodePtr a, NodePtr b);
bool has_effects(const Node& node);  ///< an assignment or a call
bool is_uniform(const Node& node);

// Types of raw numbers.
Scalar at_exponent(const Scalar& type, int exponent);  ///< the same range, more or fewer bits behind the point
bool fits(const Scalar& type, const Scalar& into);     ///< both of one exponent
Scalar contents_of(const Value& value);                ///< all that its bytes can hold
int bytes_of(int bits);

}  // namespace pfman
