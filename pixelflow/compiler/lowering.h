// The state of lower() and its parts, which stand in lower*.cpp: statements, expressions, uniform trees, calls, fixed
// point, float, noise and lookups.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pixelflow/compiler/build.h"
#include "pixelflow/compiler/lower.h"

namespace pfman {

constexpr int kMostBits = 64;  ///< of a number that is computed
constexpr int kBitsOfByte = 8;

/// A scalar while it is lowered: where its bytes are, and what they mean. Exact: the raw number there is a number of
/// `type`. Otherwise only its low type.size bits are known to be the value's: whoever needs more has it wrapped().
struct Term {
  ir::Operand at;
  Scalar type;
  bool exact = true;
};
using Terms = std::vector<Term>;

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
    Terms values;                ///< a parameter that its function does not write, given these
    Variable* uniform = nullptr;
  };
  /// Less, LessEqual or Equal of scalars, or the opposite.
  struct Comparison {
    Op op = Op::Equal;
    Term a, b;
    bool negated = false;
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
  void too_long(const std::string& limit);
  /// A variable of pixel memory for a variable of the tree.
  Binding& binding(const Variable& variable);
  Terms place_of(const Node& node);
  Terms element_of(const Node& node);
  NodePtr index_tree(const Node& node);
  NodePtr table_lookup(const Node& element, int rows, int columns);
  Term first_of(const Terms& all, const Scalar& scalar);

  // lower_statement.cpp
  void lower_body(const std::vector<StatementPtr>& body);
  void lower_statement(const Statement& statement);
  void lower_if(const Statement& statement);
  void lower_loop(const Statement& statement);
  void lower_jump(const Statement& statement);
  void test_loop(const Statement& statement, int loop);
  void begin_illuminance(const Statement& statement);
  void take_bits(int count);
  // Control flow on the host around instructions that the caller appends.
  int begin_if(NodePtr condition);
  int begin_else(int opening);
  void end_if(int opening);
  int begin_loop();
  void end_loop(int loop);

  // lower_expression.cpp
  Terms lower_node(const Node& node);
  Terms lower_varying(const Node& node);
  Term lower_scalar(const Node& node) { return lower_node(node).at(0); }
  Terms lower_elementwise(const Node& node);
  Term lower_binary(const Node& node, const Term& a, const Term& b);
  Term lower_unary(const Node& node, const Term& a);
  Terms lower_select(const Node& node);
  Terms lower_assign(const Node& node);
  void store(const Node& target, const Terms& values);
  void store(const Term& target, const Term& value);
  Term convert(const Term& value, const Scalar& to, bool saturate);

  // lower_condition.cpp
  /// A bool as a byte, or none where the instruction just appended has left it in K.
  ir::Operand condition(const Node& node);
  std::optional<Comparison> comparison_of(const Node& node);
  ir::Operand compare(const Node& node);
  ir::Operand compare_values(Op op, const Term& a, const Term& b, bool to_byte);
  Term sign_of(const Term& value);
  Term logical_not(const Term& value);
  bool is_zero(const Term& value) const;

  // lower_sum.cpp
  Terms lower_floored(const Node& node, int exponent);
  bool has_coarse_summand(const Node& node, int exponent) const;

  // lower_uniform.cpp
  Terms uniform_values(const Node& node);
  Term uniform_value(NodePtr tree);
  Terms elements_of(Variable* variable);
  NodePtr tree_of(const Term& value) const;  ///< a copy of a uniform value's tree
  NodePtr uniform_tree(const Node& node);
  NodePtr hoisting_tree(const Node& node);
  NodePtr conditional_tree(const Node& node);
  Variable* hidden(const Type& type);
  Variable* hoist(NodePtr tree);  ///< evaluated here
  NodePtr once(NodePtr tree);     ///< itself, or what it leaves behind where it may only be evaluated once
  void evaluate(NodePtr tree);
  void assign(Variable* variable, NodePtr value);
  int add_uniform(NodePtr tree);
  Variable* uniform_of(const Variable& variable);

  // lower_call.cpp
  Terms lower_call(const Node& node);
  Terms external_call(const Node& node);
  /// The caller's variables for an output parameter, if it can have these themselves; otherwise none.
  std::vector<int> variables_of(const Terms& places, const Variable& parameter);
  Term argument_value(const Term& value, const Function& function, const Scalar& type);
  bool may_call();

  // lower_fixed.cpp, lower_multiply.cpp, lower_divide.cpp
  Term with_type(const Term& value, const Scalar& type);
  Term wrapped(const Term& value);
  Term needed(const Term& value, int bits);
  Term reduced(const Term& value, const Scalar& type);
  Term finished(const Term& value, const Scalar& type);
  Term shifted_left(const Term& value, int places, int bits);
  Term shifted_right(const Term& value, int places, int bits);
  Term aligned(const Term& value, int exponent, int bits);
  Term at_least(const Term& value, int exponent);
  Term extended(const Term& value, int bytes);
  Term fixed_convert(const Term& value, const Scalar& to);
  Term fixed_saturate(const Term& value, const Scalar& to);
  Term fixed_add(const Term& a, const Term& b, bool subtract, const Scalar& type);
  Term fixed_bitwise(Op op, const Term& a, const Term& b, const Scalar& type);
  Term fixed_complement(const Term& value, const Scalar& type);
  Term fixed_shift(const Node& node, const Term& value);
  Term fixed_abs(const Term& value, const Scalar& type);
  Term fixed_round(Op op, const Term& value, const Scalar& type);
  Term fixed_square_root(const Term& value, const Scalar& type);
  Term fixed_multiply(const Term& a, const Term& b, const Scalar& type);
  int power_of_two(const Term& value) const;
  Term joined(const ir::Operand& upper, const ir::Operand& lower, int places, const Scalar& type);
  Term product(const Term& a, const Term& b, int places, const Scalar& full, int bits);
  Term fixed_divide(const Term& a, const Term& b, const Scalar& type);
  Term scaled_quotient(const Term& a, const Term& b, int places, int bits);
  Term shifted_quotient(const Term& a, const Term& b, int places, int bits);
  Term fixed_remainder(const Term& a, const Term& b, const Scalar& type);
  Term nonzero(const Term& value);

  // lower_float.cpp
  Term to_float(const Term& value);
  Term to_fixed(const Term& value, const Scalar& to);
  Term float_negate(const Term& value);
  Term float_abs(const Term& value);
  Term float_round(Op op, const Term& value);
  Term float_remainder(const Term& a, const Term& b);
  Term float_binary(Code code, const Term& a, const Term& b);

  // lower_library.cpp
  Term lower_noise(const Node& node);
  Term lower_cell_noise(const Node& node);
  Term lower_turbulence(const Node& node);
  Term cell(const Term& coordinate);
  Variable* checked_octaves(const Node& node);
  Terms lower_lookup(const Node& node);
  /// A variable that holds them one after another; a single value `count` times.
  int gathered(const Terms& values, const Scalar& type, int count = 0);

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
  std::vector<int> loops_;  ///< Loop instructions of those around
  int mask_bits_ = 0;       ///< in use
  int depth_ = 0;           ///< of calls
  int calls_ = 0;           ///< written in place
  int temporaries_ = 0;
  bool too_long_ = false;
  Location where_;
};

bool is_uniform(const Node& node);

// Types of raw numbers.
Scalar at_exponent(const Scalar& type, int exponent);  ///< the same range, more or fewer bits behind the point
bool fits(const Scalar& type, const Scalar& into);     ///< both of one exponent
Scalar contents_of(const Term& value);                 ///< all that its bytes can hold
int bytes_of(int bits);

}  // namespace pfman
