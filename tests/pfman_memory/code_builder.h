// Code for the pixel processors by hand, an instruction a call.
#pragma once

#include <string>

#include "pixelflow/compiler/ir.h"

namespace pfman_tests {

class CodeBuilder {
 public:
  using Kind = pfman::ir::Instruction::Kind;

  explicit CodeBuilder(const std::string& name, pfman::Shader::Kind kind = pfman::Shader::Kind::Surface);

  /// A variable of the source.
  int variable(const std::string& name, int bytes, int count = 1);
  int float_variable(const std::string& name, int count = 1);
  int temporary(int bytes);
  int at_address(const std::string& name, int bytes, int address);
  /// A parameter, behind those before it.
  int parameter(const std::string& name, int bytes, int count = 1);

  static pfman::ir::Operand all(const pfman::ir::Code& code, int variable);
  pfman::ir::Operand use(int variable) const { return all(code, variable); }
  /// Element `index` (a uniform expression) of a variable.
  pfman::ir::Operand element(int variable, int index) const;
  /// A literal of the size.
  pfman::ir::Operand literal(std::uint64_t value, int bytes);
  int uniform_literal(std::uint64_t value);

  /// Appends; the line of the source goes up by one.
  pfman::ir::Instruction& add(Kind kind);
  pfman::ir::Instruction& operate(pixelflow::Code operation, pfman::ir::Operand d, pfman::ir::Operand a,
                                  pfman::ir::Operand b = {}, int scale = 0);
  int copy(int d, int a);
  int put(int d, std::uint64_t value);

  // Markers, each of which returns its index; the matches are set when the construct ends.
  int begin_if(Kind kind, pfman::ir::Operand condition = {}, int uniform = -1);
  int begin_else(int of);
  void end_if(int of);
  int begin_loop(bool masked_breaks = false, bool masked_continues = false);
  void loop_test(int loop, int uniform);
  void jump(Kind kind, int loop);
  void loop_next(int loop);
  void end_loop(int loop);
  void stage(int number);

  int size() const { return static_cast<int>(code.code.size()); }

  pfman::ir::Code code;

 private:
  int add_variable(const std::string& name, pfman::Scalar scalar, int count);
  std::vector<std::unique_ptr<pfman::ShaderParameter>> declared_;
  std::uint32_t line_ = 0;
  int next_parameter_;
};

}  // namespace pfman_tests
