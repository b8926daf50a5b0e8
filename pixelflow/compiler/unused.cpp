// Code whose result nobody uses: what is needed is marked from the outputs backwards, the rest goes.
#include <vector>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lifetime.h"

namespace pfman {

using ir::Access;
using ir::Instruction;
using ir::Operand;
using Kind = ir::Instruction::Kind;

namespace {

/// Evaluating it may fail, or changes something.
bool has_effect(const Node& node) {
  using Op = Node::Op;
  switch (node.op) {
    case Op::Assign:
    case Op::Postfix:
    case Op::Call: return true;
    case Op::Element:
    case Op::ShiftLeft:
    case Op::ShiftRight:
      if (node.operands[1]->op != Op::Literal) return true;
      break;
    default: break;
  }
  for (const NodePtr& operand : node.operands) {
    if (operand && has_effect(*operand)) return true;
  }
  return false;
}

class Marking {
 public:
  explicit Marking(ir::Code& code)
      : code_(code), needed_(code.code.size(), false), branch_(code.code.size(), -1), writers_(code.variables.size()) {
    for (const NodePtr& node : code.uniforms) effects_.push_back(node && has_effect(*node));
  }

  std::vector<bool> needed() {
    const int size = static_cast<int>(code_.code.size());
    find_branches();
    for (int i = 0; i < size; ++i) {
      ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
        if (access != Access::Read) writers_[o.variable].push_back(i);
      });
    }
    for (const int v : ir::used_at_end(code_)) need_variable(v);
    for (int i = 0; i < size; ++i) {
      if (is_needed_anyway(i)) need(i);
    }
    while (!open_.empty()) {
      const int i = open_.back();
      open_.pop_back();
      ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
        if (access != Access::Write) need_variable(o.variable);
      });
    }
    return needed_;
  }

 private:
  bool is_needed_anyway(int i) const {
    const Instruction& instruction = code_.code[i];
    switch (instruction.kind) {
      case Kind::Operate:
      case Kind::And:
      case Kind::Or:
      case Kind::Xor:
      case Kind::Select:
      case Kind::Lookup: break;
      case Kind::IfMasked:
      case Kind::ElseMasked:
      case Kind::EndIfMasked: return false;
      default: return true;
    }
    if (!instruction.d && !leaves_condition(i)) return true;
    bool effect = instruction.uniform >= 0 && effects_[instruction.uniform];
    for (const Operand* o : {&instruction.d, &instruction.a, &instruction.b, &instruction.condition}) {
      effect |= o->kind == Operand::Kind::Uniform && effects_[o->uniform];
      effect |= o->kind == Operand::Kind::Pixel && o->index >= 0;
    }
    return effect;
  }

  /// The instruction behind it takes K as this one leaves it.
  bool leaves_condition(int i) const {
    if (i + 1 >= static_cast<int>(code_.code.size())) return false;
    const Instruction& next = code_.code[i + 1];
    return (next.kind == Kind::Select || next.kind == Kind::IfMasked) && !next.condition;
  }

  void need(int i) {
    if (needed_[i]) return;
    needed_[i] = true;
    open_.push_back(i);
    // A choice by K stands behind the comparison that makes it.
    if (i > 0 && leaves_condition(i - 1)) need(i - 1);
    // What is needed within a masked branch needs the branch.
    if (branch_[i] >= 0) need(branch_[i]);
    if (is_branch(code_.code[i].kind)) need(code_.code[i].match);
  }

  static bool is_branch(Kind kind) { return kind == Kind::IfMasked || kind == Kind::ElseMasked; }

  void find_branches() {
    std::vector<int> open;
    for (int i = 0; i < static_cast<int>(code_.code.size()); ++i) {
      const Kind kind = code_.code[i].kind;
      if (!open.empty()) branch_[i] = open.back();
      if (kind == Kind::IfMasked) open.push_back(i);
      if (kind == Kind::EndIfMasked) open.pop_back();
    }
  }

  void need_variable(int v) {
    for (const int i : writers_[v]) need(i);
  }

  ir::Code& code_;
  std::vector<bool> needed_;
  std::vector<int> branch_;  ///< the masked branch around an instruction; its IfMasked
  std::vector<std::vector<int>> writers_;
  std::vector<bool> effects_;  ///< by uniform expression
  std::vector<int> open_;
};

}  // namespace

void drop_unused(ir::Code& code) {
  ir::keep_instructions(code, Marking(code).needed());
  ir::drop_unmentioned_variables(code);
}

}  // namespace pfman
