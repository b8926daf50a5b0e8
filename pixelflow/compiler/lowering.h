// The state of lower(): places of variables, statements, expressions, uniform trees, calls, noise and lookups.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pixelflow/compiler/lower_arithmetic.h"

namespace pfman {

class Lowering : public Arithmetic {
 public:
  Lowering(const Tree& tree, const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics);
  ir::Code run();

 private:
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

  // lower_place.cpp
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
  using Arithmetic::store;
  Term fixed_shift(const Node& node, const Term& value);

  // lower_condition.cpp
  /// A bool as a byte, or none where the instruction just appended has left it in K.
  ir::Operand condition(const Node& node);
  std::optional<Comparison> comparison_of(const Node& node);
  ir::Operand compare(const Node& node);

  // lower_sum.cpp
  Terms lower_floored(const Node& node, int exponent);
  bool has_coarse_summand(const Node& node, int exponent) const;

  // lower_uniform.cpp
  Terms uniform_values(const Node& node);
  NodePtr uniform_tree(const Node& node);
  NodePtr hoisting_tree(const Node& node);
  NodePtr conditional_tree(const Node& node);
  Variable* uniform_of(const Variable& variable);

  // lower_call.cpp
  Terms lower_call(const Node& node);
  Terms external_call(const Node& node);
  /// The caller's variables for an output parameter, if it can have these themselves; otherwise none.
  std::vector<int> variables_of(const Terms& places, const Variable& parameter);
  Term argument_value(const Term& value, const Function& function, const Scalar& type);
  bool may_call();

  // lower_library.cpp
  Term lower_noise(const Node& node);
  Term lower_cell_noise(const Node& node);
  Term lower_turbulence(const Node& node);
  Term cell(const Term& coordinate);
  Variable* checked_octaves(const Node& node);
  Terms lower_lookup(const Node& node);

  const Tree& tree_;
  std::map<const Variable*, Binding> bindings_;
  std::set<const Variable*> unit_constants_;
  std::set<const Variable*> indexed_;  ///< varying arrays with an index that is not known
  std::set<const Variable*> written_;  ///< by an assignment, or as an output
  std::set<const Function*> noted_;
  std::vector<int> loops_;  ///< Loop instructions of those around
  int mask_bits_ = 0;       ///< in use
  int depth_ = 0;           ///< of calls
  int calls_ = 0;           ///< written in place
};

bool is_uniform(const Node& node);

}  // namespace pfman
