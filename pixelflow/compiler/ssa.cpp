// Static single assignment (Muchnick 1997; Briggs 1992), instruction by instruction. A variable keeps its number as it
// is at the start of the shader; each definition of all of it gets a new one. A definition of a part changes the
// variable that it finds.
#include <algorithm>
#include <map>
#include <set>

#include "pixelflow/compiler/dominators.h"
#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lifetime.h"
#include "pixelflow/compiler/uninitialised.h"

namespace pfman {

using ir::Access;
using ir::Instruction;
using ir::Operand;

namespace {

class Renaming {
 public:
  explicit Renaming(ir::Code& code)
      : code_(code),
        originals_(static_cast<int>(code.variables.size())),
        size_(static_cast<int>(code.code.size())),
        previous_(predecessors(successors(code))),
        dominators_(previous_),
        renamed_(originals_, true),
        current_(originals_),
        phis_(size_ + 1) {
    for (int v = 0; v < originals_; ++v) {
      current_[v] = v;
      original_.push_back(v);
      renamed_[v] = !ir::is_light_variable(code.variables[v]);
    }
    for (const int v : code.mask_bytes) renamed_[v] = false;
  }

  void run() {
    place_phis();
    rename();
    number();
  }

 private:
  void place_phis() {
    const Lifetimes lifetimes(code_);
    std::vector<std::vector<int>> definitions(originals_);
    for (int i = 0; i < size_; ++i) {
      ir::each_operand(code_, code_.code[i], [&](const Operand& o, Access access) {
        if (access == Access::Write && renamed_[o.variable]) definitions[o.variable].push_back(i + 1);
      });
    }
    for (int v = 0; v < originals_; ++v) {
      std::set<int> placed;
      std::vector<int> open = definitions[v];
      while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        for (const int meeting : dominators_.frontier[node]) {
          if (!lifetimes.alive_before(meeting - 1, v) || !placed.insert(meeting).second) continue;
          open.push_back(meeting);
        }
      }
      for (const int meeting : placed) {
        phis_[meeting - 1].push_back(static_cast<int>(code_.phis.size()));
        code_.phis.push_back({meeting - 1, v, std::vector<int>(previous_[meeting - 1].size(), v)});
      }
    }
  }

  int add(int original) {
    code_.variables.push_back(code_.variables[original]);
    code_.variables.back().address.reset();
    original_.push_back(original);
    return static_cast<int>(code_.variables.size()) - 1;
  }

  /// Down the tree of dominators; on the way back up, names are what they were.
  void rename() {
    struct Level {
      int node;
      std::size_t child = 0;
      std::vector<std::pair<int, int>> undo;  ///< original, its name before
    };
    std::map<int, std::vector<int>> next;  // -1: the start
    for (int i = 0; i <= size_; ++i) {
      for (const int from : previous_[i]) next[from].push_back(i);
    }
    std::vector<Level> path{{0, 0, {}}};
    visit(-1, next[-1], path.back().undo);
    while (!path.empty()) {
      Level& level = path.back();
      if (level.child == dominators_.children[level.node].size()) {
        for (auto it = level.undo.rbegin(); it != level.undo.rend(); ++it) current_[it->first] = it->second;
        path.pop_back();
        continue;
      }
      const int node = dominators_.children[level.node][level.child++];
      path.push_back({node, 0, {}});
      visit(node - 1, next[node - 1], path.back().undo);
    }
  }

  void visit(int i, const std::vector<int>& next, std::vector<std::pair<int, int>>& undo) {
    const auto define = [&](int original) {
      undo.push_back({original, current_[original]});
      return current_[original] = add(original);
    };
    if (i >= 0) {
      for (const int p : phis_[i]) code_.phis[p].d = define(code_.phis[p].d);
    }
    if (i == size_) {
      for (int& v : code_.color) v = current_[v];
    } else if (i >= 0) {
      ir::each_operand(code_, code_.code[i], [&](Operand& o, Access access) {
        const bool whole = access == Access::Write && renamed_[o.variable];
        o.variable = whole ? define(o.variable) : current_[o.variable];
      });
    }
    for (const int to : next) {
      const std::vector<int>& ways = previous_[to];
      for (const int p : phis_[to]) {
        ir::Phi& phi = code_.phis[p];
        for (std::size_t n = 0; n < ways.size(); ++n) {
          if (ways[n] == i) phi.operands[n] = current_[original_[phi.d]];
        }
      }
    }
  }

  /// Versions in the order of the text; a φ-function has those that it chooses from.
  void number() {
    std::vector<int> count(originals_, 0);
    std::vector<bool> phi_result(code_.variables.size(), false), mentioned(code_.variables.size(), false);
    for (const ir::Phi& phi : code_.phis) {
      phi_result[phi.d] = true;
      for (const int v : phi.operands) mentioned[v] = true;
    }
    for (const Instruction& instruction : code_.code) {
      ir::each_operand(code_, instruction, [&](const Operand& o, Access) { mentioned[o.variable] = true; });
    }
    for (const ir::Parameter& parameter : code_.parameters) {
      for (const int v : parameter.variables) mentioned[v] = true;
    }
    for (const int v : code_.color) mentioned[v] = true;
    const auto give = [&](int v) {
      if (code_.variables[v].versions.empty()) code_.variables[v].versions = {++count[original_[v]]};
    };
    for (int v = 0; v < originals_; ++v) {
      if (mentioned[v] && renamed_[v]) give(v);
    }
    for (const Instruction& instruction : code_.code) {
      ir::each_operand(code_, instruction, [&](const Operand& o, Access access) {
        if (access != Access::Read && !phi_result[o.variable] && renamed_[original_[o.variable]]) give(o.variable);
      });
    }
    bool changed = true;
    while (changed) {
      changed = false;
      for (const ir::Phi& phi : code_.phis) {
        std::set<int> all(code_.variables[phi.d].versions.begin(), code_.variables[phi.d].versions.end());
        const std::size_t before = all.size();
        for (const int v : phi.operands) {
          all.insert(code_.variables[v].versions.begin(), code_.variables[v].versions.end());
        }
        if (all.size() == before) continue;
        code_.variables[phi.d].versions.assign(all.begin(), all.end());
        changed = true;
      }
    }
    for (std::size_t v = 0; v < code_.variables.size(); ++v) {
      ir::Variable& variable = code_.variables[v];
      if (variable.temporary && count[original_[v]] == 1) variable.versions.clear();
    }
  }

  ir::Code& code_;
  int originals_, size_;
  std::vector<std::vector<int>> previous_;
  Dominators dominators_;
  std::vector<bool> renamed_;  ///< by original
  std::vector<int> current_;   ///< name of each original here
  std::vector<int> original_;  ///< of each variable
  std::vector<std::vector<int>> phis_;
};

void count_bytes(ir::Code& code) {
  std::vector<bool> counts(code.variables.size(), true);
  for (const ir::Parameter& parameter : code.parameters) {
    for (const int v : parameter.variables) counts[v] = false;
  }
  for (const int v : code.mask_bytes) counts[v] = false;
  code.source_bytes = code.temporary_bytes = 0;
  for (std::size_t v = 0; v < code.variables.size(); ++v) {
    const ir::Variable& variable = code.variables[v];
    if (counts[v] && !variable.address)
      (variable.temporary ? code.temporary_bytes : code.source_bytes) += variable.bytes();
  }
}

}  // namespace

void to_ssa(ir::Code& code, Diagnostics& diagnostics) {
  warn_of_uninitialised(code, diagnostics);
  count_bytes(code);
  code.phis.clear();
  Renaming(code).run();
  ir::drop_unmentioned_variables(code);
}

}  // namespace pfman
