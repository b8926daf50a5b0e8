// Lifetimes by two sweeps to and fro over the code: backwards for what is still used, forwards for what has been given
// a value at all. A variable is alive where both hold.
#include "pixelflow/compiler/lifetime.h"

#include <utility>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/memory_layout.h"

namespace pfman {

using ir::Access;
using ir::Instruction;
using ir::Operand;

namespace {

class Analysis {
 public:
  Analysis(const ir::Code& code)
      : code_(code),
        size_(static_cast<int>(code.code.size())),
        variables_(static_cast<int>(code.variables.size())),
        next_(successors(code)),
        previous_(predecessors(next_)),
        phis_(size_ + 1),
        used_(size_ + 1, variables_),
        given_(size_ + 1, variables_),
        scratch_(1, variables_) {
    for (const ir::Phi& phi : code.phis) phis_[phi.before].push_back(&phi);
    for (int v = 0; v < variables_; ++v) {
      if (code.kind == Shader::Kind::Surface && is_light_variable(code.variables[v])) from_lights_.push_back(v);
    }
    find_used();
    find_given();
  }

  /// used and given before i.
  void alive_before(int i, BitMatrix& out) {
    out.add(i, used_.row(i));
    out.keep(i, given_.row(i));
  }

  void alive_after(int i, BitMatrix& out) {
    used_after(i);
    out.add(i, scratch_.row(0));
    given_after(i);
    out.keep(i, scratch_.row(0));
  }

  const std::vector<const ir::Phi*>& phis(int i) const { return phis_[i]; }
  bool begins_illuminance(int i) const {
    return i < size_ && code_.code[i].kind == Instruction::Kind::Stage && code_.code[i].stage == 1;
  }
  const std::vector<int>& from_lights() const { return from_lights_; }

 private:
  /// The operand that the φ-function takes where control comes from `from`.
  int operand_from(const ir::Phi& phi, int from) const {
    const std::vector<int>& ways = previous_[phi.before];
    for (std::size_t n = 0; n < ways.size(); ++n) {
      if (ways[n] == from) return phi.operands[n];
    }
    return phi.d;
  }

  void used_after(int i) {
    clear();
    BitMatrix& set = scratch_;
    for (const int next : next_[i]) {
      if (phis_[next].empty()) {
        set.add(0, used_.row(next));
        continue;
      }
      BitMatrix through(1, variables_);
      through.add(0, used_.row(next));
      for (const ir::Phi* phi : phis_[next]) through.reset(0, phi->d);
      for (const ir::Phi* phi : phis_[next]) {
        if (used_.test(next, phi->d)) through.set(0, operand_from(*phi, i));
      }
      set.add(0, through.row(0));
    }
  }

  void find_used() {
    for (const int v : ir::used_at_end(code_)) used_.set(size_, v);
    for (const int v : code_.mask_bytes) used_.set(size_, v);
    bool changed = true;
    while (changed) {
      changed = false;
      for (int i = size_ - 1; i >= 0; --i) {
        used_after(i);
        if (begins_illuminance(i)) {
          for (const int v : from_lights_) scratch_.reset(0, v);
        }
        ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
          if (access == Access::Write) scratch_.reset(0, o.variable);
        });
        ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
          if (access != Access::Write) scratch_.set(0, o.variable);
        });
        for (const int v : code_.mask_bytes) scratch_.set(0, v);
        changed |= replace(used_, i);
      }
    }
  }

  void given_after(int i) {
    clear();
    scratch_.add(0, given_.row(i));
    if (begins_illuminance(i)) {
      for (const int v : from_lights_) scratch_.set(0, v);
    }
    ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
      if (access != Access::Read) scratch_.set(0, o.variable);
    });
  }

  void given_at_start(BitMatrix& set) const {
    for (const ir::Parameter& parameter : code_.parameters) {
      for (const int v : parameter.variables) set.set(0, v);
    }
    for (int v = 0; v < variables_; ++v) {
      if (code_.variables[v].address && !is_light_variable(code_.variables[v])) set.set(0, v);
    }
    for (const int v : code_.mask_bytes) set.set(0, v);
  }

  void find_given() {
    bool changed = true;
    BitMatrix sum(1, variables_);
    while (changed) {
      changed = false;
      for (int i = 0; i <= size_; ++i) {
        for (int w = 0; w < sum.words(); ++w) sum.row(0)[w] = 0;
        for (const int from : previous_[i]) {
          clear();
          if (from < 0) {
            given_at_start(scratch_);
          } else {
            given_after(from);
          }
          sum.add(0, scratch_.row(0));
          for (const ir::Phi* phi : phis_[i]) {
            if (scratch_.test(0, operand_from(*phi, from))) sum.set(0, phi->d);
          }
        }
        std::swap(scratch_, sum);
        changed |= replace(given_, i);
      }
    }
  }

  void clear() {
    for (int w = 0; w < scratch_.words(); ++w) scratch_.row(0)[w] = 0;
  }

  /// Row i := the scratch row; true where that changes it.
  bool replace(BitMatrix& set, int i) {
    bool changed = false;
    for (int w = 0; w < set.words(); ++w) {
      changed |= set.row(i)[w] != scratch_.row(0)[w];
      set.row(i)[w] = scratch_.row(0)[w];
    }
    return changed;
  }

  const ir::Code& code_;
  int size_, variables_;
  std::vector<std::vector<int>> next_, previous_;
  std::vector<std::vector<const ir::Phi*>> phis_;  ///< by the instruction behind them
  BitMatrix used_, given_, scratch_;
  std::vector<int> from_lights_;
};

}  // namespace

Lifetimes::Lifetimes(const ir::Code& code)
    : before_(static_cast<int>(code.code.size()) + 1, static_cast<int>(code.variables.size())),
      after_(static_cast<int>(code.code.size()), static_cast<int>(code.variables.size())),
      interference_(static_cast<int>(code.variables.size()), static_cast<int>(code.variables.size())),
      retained_(1, static_cast<int>(code.variables.size())) {
  const int size = static_cast<int>(code.code.size());
  Analysis analysis(code);
  bool has_stages = false;
  for (int i = 0; i <= size; ++i) {
    analysis.alive_before(i, before_);
    for (const ir::Phi* phi : analysis.phis(i)) interference_.add(phi->d, before_.row(i));
    if (i == size) break;
    analysis.alive_after(i, after_);
    const Instruction& instruction = code.code[i];
    ir::each_operand(code, instruction, [&](const Operand& o, Access access) {
      if (access != Access::Read) interference_.add(o.variable, after_.row(i));
    });
    if (instruction.kind == Instruction::Kind::Stage) {
      has_stages = true;
      retained_.add(0, before_.row(i));
      if (analysis.begins_illuminance(i)) {
        for (const int v : analysis.from_lights()) interference_.add(v, after_.row(i));
      }
    }
    ir::keep_apart(code, instruction, [&](int a, int b) { interference_.set(a, b); });
  }
  before_.each(0, [&](int v) { interference_.add(v, before_.row(0)); });
  if (!has_stages) retained_.add(0, before_.row(0));
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    interference_.each(v, [&](int other) { interference_.set(other, v); });
  }
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) interference_.reset(v, v);
}

}  // namespace pfman
