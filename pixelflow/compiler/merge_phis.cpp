// A φ-function's result and operands become one variable. All of them are versions of one variable of the code before,
// of which only one can be in use at a time, so that they never get in each other's way.
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lifetime.h"

namespace pfman {
namespace {

class Webs {
 public:
  explicit Webs(int variables) : to_(variables) {
    for (int v = 0; v < variables; ++v) to_[v] = v;
  }
  int find(int v) const {
    while (to_[v] != v) v = to_[v];
    return v;
  }
  /// The lower number stays: of a parameter, the one that it has at the start.
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    to_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> to_;
};

/// No definition of a variable may stand where another one of its web is alive, nor may two of them have their places.
void check(const ir::Code& code, const std::vector<int>& to, const std::map<int, std::vector<int>>& members) {
  const auto refuse = [&](int v, const char* what) {
    throw std::logic_error("merge_phis: " + code.variables[v].name + ": " + what);
  };
  const Lifetimes lifetimes(code);
  const auto defined = [&](int v, const auto& is_alive) {
    for (const int other : members.at(to[v])) {
      if (other != v && is_alive(other)) refuse(v, "two versions are alive at once");
    }
  };
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    ir::each_operand(code, code.code[i], [&](const ir::Operand& o, ir::Access access) {
      if (access != ir::Access::Read) defined(o.variable, [&](int v) { return lifetimes.alive_after(i, v); });
    });
  }
  for (const ir::Phi& phi : code.phis) {
    defined(phi.d, [&](int v) { return lifetimes.alive_before(phi.before, v); });
  }
  for (const auto& [web, all] : members) {
    for (const int v : all) {
      if (v != web && code.variables[v].address) refuse(v, "two versions have places of their own");
    }
  }
}

/// True where d and the operand have bytes in common but do not begin with the same one.
bool shifts_within_itself(const ir::Operand& d, const ir::Operand& o) {
  return d.kind == ir::Operand::Kind::Pixel && o.kind == ir::Operand::Kind::Pixel && d.variable == o.variable &&
         d.index < 0 && o.index < 0 && d.offset != o.offset && d.offset < o.offset + o.bytes &&
         o.offset < d.offset + d.bytes;
}

/// A result lies exactly on an operand or apart from it. Joined versions may shift a number within itself, by whole
/// bytes: then the operand is copied first.
void copy_shifted_operands(ir::Code& code) {
  std::vector<ir::Instruction> all;
  std::vector<int> to;
  for (ir::Instruction& instruction : code.code) {
    for (ir::Operand* o : {&instruction.a, &instruction.b}) {
      if (!shifts_within_itself(instruction.d, *o)) continue;
      ir::Variable copy;
      copy.name = code.variables[o->variable].name + "'";
      copy.scalar = Scalar::fixed(o->is_signed, 8 * o->bytes, 0);
      copy.temporary = true;
      copy.where = instruction.where;
      const int variable = static_cast<int>(code.variables.size());
      code.variables.push_back(std::move(copy));
      ir::Instruction& move = all.emplace_back();
      move.where = instruction.where;
      move.a = *o;
      move.d = *o;
      move.d.variable = variable;
      move.d.offset = 0;
      *o = move.d;
    }
    to.push_back(static_cast<int>(all.size()));
    all.push_back(std::move(instruction));
  }
  code.code = std::move(all);
  for (ir::Instruction& instruction : code.code) {
    if (instruction.match >= 0) instruction.match = to[instruction.match];
  }
}

}  // namespace

void merge_phis(ir::Code& code) {
  if (code.phis.empty()) return;
  const int variables = static_cast<int>(code.variables.size());
  Webs webs(variables);
  for (const ir::Phi& phi : code.phis) {
    for (const int v : phi.operands) webs.join(phi.d, v);
  }
  std::map<int, std::vector<int>> members;
  std::vector<int> to(variables);
  for (int v = 0; v < variables; ++v) {
    to[v] = webs.find(v);
    members[to[v]].push_back(v);
  }
  check(code, to, members);
  for (const auto& [web, all] : members) {
    std::set<int> versions;
    for (const int v : all) versions.insert(code.variables[v].versions.begin(), code.variables[v].versions.end());
    code.variables[web].versions.assign(versions.begin(), versions.end());
  }
  code.phis.clear();
  ir::replace_variables(code, to);
  ir::drop_unmentioned_variables(code);
  copy_shifted_operands(code);
}

}  // namespace pfman
