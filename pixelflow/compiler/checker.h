// The checker's state and its parts, for check*.cpp alone.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pixelflow/compiler/build.h"
#include "pixelflow/compiler/check.h"
#include "pixelflow/compiler/check_state.h"
#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/library_writer.h"

namespace pfman {

class Checker {
 public:
  Checker(const ast::Unit& unit, Tree& tree, Diagnostics& diagnostics)
      : unit_(unit), tree_(tree), diagnostics_(diagnostics), write_(tree) {}
  void run();

 private:
  // Definitions: check.cpp, check_functions.cpp, check_shaders.cpp, check_parameters.cpp.
  void constants(const std::vector<ast::Declarator>& declarators, std::vector<NodePtr>& assignments);
  void declare_function(const ast::Definition& definition);
  std::vector<const ast::Definition*> functions_in_order();
  void check_function(const ast::Definition& definition);
  void return_value(const ast::Statement& statement, Function& function);
  void check_shader(const ast::Definition& definition);
  void shader_parameter(const ast::Declarator& declarator, Shader& shader);
  void standard_parameter(const ast::Declarator& declarator, const Type& type);
  NodePtr default_value(const ast::Declarator& declarator, const Type& type);
  void check_attributes(const ast::Declarator& declarator, const Type& type, bool of_shader);
  void prologue(Shader& shader, std::vector<StatementPtr>& out);
  void normalize_parameter(Variable* variable, std::vector<StatementPtr>& out);
  void warn_unused(const ast::Definition& definition);
  Variable* surface_point();

  // Names and types: check_types.cpp.
  void error(int code, Location where, std::string text) { diagnostics_.add(code, where, std::move(text)); }
  Value mistake(int code, Location where, std::string text);
  Variable* new_variable(std::string name, const Type& type, Variable::Role role, Location where);
  Symbol* find(const std::string& name);
  Symbol& declare(Variable* variable, const char* protection = nullptr);
  std::optional<Scalar> scalar_of(const ast::Specifiers& specifiers);
  std::optional<Type> type_of(const ast::Specifiers& specifiers, const std::vector<ast::ExpressionPtr>& dimensions,
                              bool varying);
  std::optional<Type> type_of(const ast::Declarator& declarator, bool varying) {
    return type_of(*declarator.specifiers, declarator.dimensions, varying);
  }
  bool is_constant(const Node& node) const;
  std::optional<Raw> constant_value(const Node& node);
  std::optional<std::int64_t> constant_integer(const ast::Expression& expression);
  std::optional<std::int64_t> constant_integer(const Node& node);

  // Untyped and typed: check_values.cpp.
  NodePtr settle(Value value, const std::optional<Scalar>& surroundings = std::nullopt);
  bool meet(Values& values, Nodes& typed);
  void settle_together(Values values, Nodes& typed);
  NodePtr convert_to(Value value, const Scalar& target, bool saturate = false);
  NodePtr condition(Value value);
  NodePtr fit(const Value& value, NodePtr literal, const Scalar& target, bool saturate);
  Value untyped(Value::Kind kind, Values parts, Location where);

  // Expressions: check_expressions.cpp, check_operators.cpp, check_fold.cpp, check_assignments.cpp, check_calls.cpp.
  Value expression(const ast::Expression& expression);
  Value name(const ast::Expression& expression);
  Value light_variable(const ast::Expression& expression);
  Value index(const ast::Expression& expression);
  NodePtr index_of(const Type& array, const ast::Expression& expression);
  Value array(const ast::Expression& expression);
  Value conditional(const ast::Expression& expression);
  Value cast(const ast::Expression& expression);
  Value logic(const ast::Expression& expression);
  Value unary(ast::Operator op, Value operand, Location where);
  Value binary(ast::Operator op, Value a, Value b, Location where);
  Value arithmetic(ast::Operator op, Value a, Value b, Location where);
  Value comparison(ast::Operator op, Value a, Value b, Location where);
  Value shift(ast::Operator op, Value a, Value b, Location where);
  Value fold(ast::Operator op, const Value& a, const Value* b, Location where);
  Value assignment(const ast::Expression& expression);
  Value postfix(const ast::Expression& expression);
  NodePtr place(const ast::Expression& expression, Nodes& before);
  bool assignable(const ast::Expression& expression, bool varying, Location where);
  Value call(const ast::Expression& expression);
  Value call_function(const Function& function, const ast::Expression& expression);
  NodePtr argument(const ast::Expression& expression, Variable& parameter, Nodes& before, Nodes& after);
  bool same_shapes(const Type& a, const Type& b, Location where);
  void warn_mixed(const Node& node);

  // The library: check_library.cpp, check_vectors.cpp, check_noise.cpp.
  Value call_library(const ast::Expression& expression);
  Value library(const std::string& name, Values arguments, Location where);
  Value functions_of_floats(const std::string& name, Values arguments, Location where);
  Value noise(const std::string& name, Values arguments, Location where);
  Value turbulence(Values arguments, Location where);
  Value lookup(const std::string& name, Values arguments, Location where);
  Value vectors(const std::string& name, Values arguments, Location where);
  Value transformed(const std::string& name, Values arguments, Location where);
  bool arguments_fit(const std::string& name, const Values& arguments, Location where);
  NodePtr uniform_integer(Value value, const char* what);

  // Statements: check_statements.cpp, check_lights.cpp, check_shared.cpp.
  using Statements = std::vector<StatementPtr>;
  void statement(const ast::Statement& statement, Statements& out, bool top_level = false);
  void block(const std::vector<ast::StatementPtr>& body, Statements& out, bool top_level = false);
  StatementPtr scoped(const ast::Statement& body);
  void declaration(const ast::Declarator& declarator, Statements& out);
  void if_statement(const ast::Statement& statement, Statements& out);
  void loop_statement(const ast::Statement& statement, Statements& out);
  void jump(const ast::Statement& statement, Statements& out);
  NodePtr clause(const ast::Expression& expression);
  void illuminance(const ast::Statement& statement, Statements& out, bool top_level);
  void light_source(const ast::Statement& statement, Statements& out, bool top_level);
  NodePtr float_of(const ast::Expression& expression, int rank, const char* what);
  Variable* communicated(const std::string& name);
  void surface_body(const ast::Definition& definition, Statements& out);
  void light_colors_before(Statements& out);
  void light_colors_after(Statements& out);
  void read_flags();
  void shared_variable(const char* name, const Scalar& scalar, int elements, bool varying, bool result,
                       Statements& out);
  void insert_common(const std::string& flag, Location where, Statements& out);

  const ast::Unit& unit_;
  Tree& tree_;
  Diagnostics& diagnostics_;
  LibraryWriter write_;
  std::vector<std::map<std::string, Symbol>> scopes_;
  std::map<std::string, Function*> functions_;  ///< null: its declaration was a mistake
  std::map<const ast::Definition*, std::unique_ptr<Function>> all_functions_;
  std::map<std::string, Variable*> light_variables_;
  bool point_used_ = false;  ///< the surface point, by what the language does itself
  std::map<const ast::Definition*, std::map<std::string, Location>> flags_;
  std::vector<ast::StatementPtr> common_;  ///< common code put into shaders
  bool in_common_code_ = false;
  Environment constants_;
  std::set<const Variable*> known_;  ///< those of them that have a value
  Surroundings around_;
  int effects_ = 0;  ///< assignments and calls with effects met so far
};

bool is_library_function(const std::string& name);

}  // namespace pfman
