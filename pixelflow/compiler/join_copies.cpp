// Copies whose source and result can be one variable go, aggressively (Briggs 1992): the copy itself is no reason to
// keep them apart. After each round lifetimes are found anew, until nothing more can be joined.
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lifetime.h"
#include "pixelflow/compiler/memory_layout.h"

namespace pfman {

using ir::Access;
using ir::Instruction;
using ir::Operand;

namespace {

class Round {
 public:
  explicit Round(ir::Code& code)
      : code_(code),
        variables_(static_cast<int>(code.variables.size())),
        apart_(variables_, variables_),
        to_(variables_),
        keeps_type_(variables_, false),
        writes_(variables_, 0) {
    for (int v = 0; v < variables_; ++v) to_[v] = v;
    for (const ir::Parameter& parameter : code.parameters) {
      for (const int v : parameter.variables) keeps_type_[v] = true;
    }
    for (const int v : code.color) keeps_type_[v] = true;
    for (const Instruction& instruction : code.code) {
      ir::each_operand(code, instruction, [&](const Operand& o, Access access) {
        if (access != Access::Read) ++writes_[o.variable];
      });
    }
    find_apart();
  }

  bool run() {
    bool joined = false;
    for (const Instruction& instruction : code_.code) {
      if (ir::is_plain_copy(code_, instruction)) joined |= join(instruction.d.variable, instruction.a.variable);
    }
    if (!joined) return false;
    for (int v = 0; v < variables_; ++v) to_[v] = find(v);
    ir::replace_variables(code_, to_);
    std::vector<bool> keep(code_.code.size(), true);
    for (std::size_t i = 0; i < keep.size(); ++i) {
      const Instruction& instruction = code_.code[i];
      keep[i] = !ir::is_plain_copy(code_, instruction) || instruction.d.variable != instruction.a.variable;
    }
    ir::keep_instructions(code_, keep);
    ir::drop_unmentioned_variables(code_);
    return true;
  }

 private:
  void find_apart() {
    const Lifetimes lifetimes(code_);
    const auto edge = [&](int a, int b) {
      if (a == b) return;
      apart_.set(a, b);
      apart_.set(b, a);
    };
    for (int v = 0; v < variables_; ++v) apart_.add(v, lifetimes.interference().row(v));
    // What only copies keep apart may be joined: count again without them.
    std::set<std::pair<int, int>> copies;
    for (const Instruction& instruction : code_.code) {
      if (!ir::is_plain_copy(code_, instruction)) continue;
      copies.insert(std::minmax(instruction.d.variable, instruction.a.variable));
    }
    for (const auto& [a, b] : copies) {
      if (apart_.test(a, b) && !interfere_beside_copies(lifetimes, a, b)) {
        apart_.reset(a, b);
        apart_.reset(b, a);
      }
    }
    // The first bytes of a result and of an operand that it overlaps must be the same.
    for (const Instruction& instruction : code_.code) {
      if (!instruction.d) continue;
      const Operand& d = instruction.d;
      for (const Operand* o : {&instruction.a, &instruction.b}) {
        if (o->kind != Operand::Kind::Pixel || (o->offset == d.offset && o->index < 0 && d.index < 0)) continue;
        edge(d.variable, o->variable);
      }
    }
  }

  bool interfere_beside_copies(const Lifetimes& lifetimes, int a, int b) const {
    if (lifetimes.alive_before(0, a) && lifetimes.alive_before(0, b)) return true;
    bool found = false;
    for (int i = 0; i < static_cast<int>(code_.code.size()) && !found; ++i) {
      const Instruction& instruction = code_.code[i];
      if (ir::is_plain_copy(code_, instruction)) {
        if (std::minmax(instruction.d.variable, instruction.a.variable) == std::minmax(a, b)) continue;
      }
      ir::each_operand(code_, instruction, [&](const Operand& o, Access access) {
        if (access == Access::Read) return;
        found |= o.variable == a && lifetimes.alive_after(i, b);
        found |= o.variable == b && lifetimes.alive_after(i, a);
      });
      if (instruction.kind == Instruction::Kind::Stage && instruction.stage == 1) {
        found |= ir::is_light_variable(code_.variables[a]) && lifetimes.alive_after(i, b);
        found |= ir::is_light_variable(code_.variables[b]) && lifetimes.alive_after(i, a);
      }
      ir::keep_apart(code_, instruction,
                     [&](int one, int other) { found |= std::minmax(one, other) == std::minmax(a, b); });
    }
    return found;
  }

  int find(int v) const {
    while (to_[v] != v) v = to_[v];
    return v;
  }

  /// The one that stays: what has a place or a type to keep, then a variable of the source.
  std::optional<std::pair<int, int>> stays_and_goes(int a, int b) const {
    const ir::Variable &va = code_.variables[a], &vb = code_.variables[b];
    if (va.address && vb.address) return std::nullopt;
    if (keeps_type_[a] && keeps_type_[b] && !(va.scalar == vb.scalar)) return std::nullopt;
    const auto rank = [&](int v) {
      const ir::Variable& variable = code_.variables[v];
      return (variable.address ? 4 : 0) + (keeps_type_[v] ? 2 : 0) + (variable.temporary ? 0 : 1);
    };
    return rank(b) > rank(a) ? std::pair{b, a} : std::pair{a, b};
  }

  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b || apart_.test(a, b)) return false;
    const auto pair = stays_and_goes(a, b);
    if (!pair) return false;
    const auto [stays, goes] = *pair;
    if (code_.variables[stays].address && keeps_type_[goes] &&
        !(code_.variables[stays].scalar == code_.variables[goes].scalar)) {
      return false;
    }
    if (is_outside(stays) && is_color(goes)) return false;
    // Lights still read the position: what goes there may not be written but by the copy.
    if (is_position(stays) && writes_[goes] > 1) return false;
    to_[goes] = stays;
    writes_[stays] += writes_[goes] - 1;
    keeps_type_[stays] = keeps_type_[stays] || keeps_type_[goes];
    apart_.add(stays, apart_.row(goes));
    apart_.each(goes, [&, stays = stays](int v) { apart_.set(v, stays); });
    return true;
  }

  bool is_position(int v) const {
    const std::optional<int> address = code_.variables[v].address;
    return address && *address >= kPositionAt && *address < kMaskAt;
  }

  /// In the shared area, where the colour is written in the end.
  bool is_outside(int v) const { return ir::is_light_variable(code_.variables[v]); }
  bool is_color(int v) const {
    return std::any_of(code_.color.begin(), code_.color.end(), [&](int color) { return find(color) == v; });
  }

  ir::Code& code_;
  int variables_;
  BitMatrix apart_;
  std::vector<int> to_;
  std::vector<bool> keeps_type_;
  std::vector<int> writes_;
};

}  // namespace

void join_copies(ir::Code& code) {
  while (Round(code).run()) {
  }
}

}  // namespace pfman
