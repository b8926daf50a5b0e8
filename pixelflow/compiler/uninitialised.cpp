#include "pixelflow/compiler/uninitialised.h"

#include <set>
#include <string>
#include <tuple>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lifetime.h"

namespace pfman {

using ir::Access;
using ir::Operand;

namespace {

/// The ways of pixels, but that every loop is taken to run once at least: otherwise an array that a loop fills would
/// always be suspected.
std::vector<std::vector<int>> likely_successors(const ir::Code& code) {
  std::vector<std::vector<int>> next = successors(code);
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    if (code.code[i].kind != ir::Instruction::Kind::LoopTest) continue;
    const int end = code.code[code.code[i].match].match;
    std::erase(next[i], end + 1);
    next[end].push_back(end + 1);
  }
  return next;
}

}  // namespace

void warn_of_uninitialised(const ir::Code& code, Diagnostics& diagnostics) {
  const int size = static_cast<int>(code.code.size());
  const int variables = static_cast<int>(code.variables.size());
  const std::vector<std::vector<int>> next = likely_successors(code);
  // Row i: variables without a value on some way to instruction i. Only ways that pixels can take count.
  BitMatrix without(size + 1, variables);
  std::vector<bool> reached(size + 1, false);
  reached[0] = true;
  for (int v = 0; v < variables; ++v) {
    if (!code.variables[v].address) without.set(0, v);
  }
  for (const ir::Parameter& parameter : code.parameters) {
    for (const int v : parameter.variables) without.reset(0, v);
  }
  for (const int v : code.mask_bytes) without.reset(0, v);

  std::vector<int> open{0};
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    if (i == size) continue;
    BitMatrix after(1, variables);
    after.add(0, without.row(i));
    ir::each_operand(code, code.code[i], [&](const Operand& o, Access access) {
      if (access != Access::Read) after.reset(0, o.variable);
    });
    for (const int to : next[i]) {
      bool changed = !reached[to];
      reached[to] = true;
      for (int w = 0; w < after.words(); ++w) {
        changed |= (after.row(0)[w] & ~without.row(to)[w]) != 0;
      }
      if (!changed) continue;
      without.add(to, after.row(0));
      open.push_back(to);
    }
  }

  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, std::uint32_t>> told;
  const auto tell = [&](int v, Location place) {
    const ir::Variable& variable = code.variables[v];
    const std::string& name = variable.source.empty() ? variable.name : variable.source;
    if (!told.insert({name, variable.where.file, variable.where.line, variable.where.column}).second) return;
    diagnostics.add(604, place, "'" + name + "' may be used before it has a value");
  };
  for (int i = 0; i < size; ++i) {
    if (!reached[i]) continue;
    ir::each_operand(code, code.code[i], [&](const Operand& o, Access access) {
      if (access != Access::Read || code.variables[o.variable].temporary || !without.test(i, o.variable)) return;
      tell(o.variable, code.code[i].where);
    });
  }
  for (const int v : code.color) {
    if (reached[size] && without.test(size, v)) tell(v, code.variables[v].where);
  }
}

}  // namespace pfman
