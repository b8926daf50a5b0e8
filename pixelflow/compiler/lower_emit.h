// What the parts of lower() build on: instructions, temporaries, trees for the host, control flow on the host.
#pragma once

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

class Emitter {
 protected:
  using Op = Node::Op;
  using Code = pixelflow::Code;
  using Kind = ir::Instruction::Kind;

  Emitter(const Shader& shader, const LowerOptions& options, Diagnostics& diagnostics)
      : shader_(shader), options_(options), diagnostics_(diagnostics) {}

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

  int add_uniform(NodePtr tree);
  Term uniform_value(NodePtr tree);
  Terms elements_of(Variable* variable);
  NodePtr tree_of(const Term& value) const;  ///< a copy of a uniform value's tree
  Variable* hidden(const Type& type);
  Variable* hoist(NodePtr tree);  ///< evaluated here
  NodePtr once(NodePtr tree);     ///< itself, or what it leaves behind where it may only be evaluated once
  void evaluate(NodePtr tree);
  void assign(Variable* variable, NodePtr value);

  // Control flow on the host around instructions that the caller appends.
  int begin_if(NodePtr condition);
  int begin_else(int opening);
  void end_if(int opening);
  int begin_loop();
  void end_loop(int loop);

  const Shader& shader_;
  const LowerOptions options_;
  Diagnostics& diagnostics_;
  ir::Code code_;
  int temporaries_ = 0;
  bool too_long_ = false;
  Location where_;
};

int bytes_of(int bits);

}  // namespace pfman
