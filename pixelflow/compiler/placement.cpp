#include "pixelflow/compiler/placement.h"

#include <algorithm>

#include "pixelflow/compiler/externals.h"
#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"

namespace pfman {

using ir::Access;
using ir::Instruction;
using ir::Operand;

namespace {

/// The first gap of `bytes` bytes between the ranges, from `from` on.
template <typename Ranges>
int first_gap(const Ranges& sorted, int from, int bytes) {
  int at = from;
  for (const auto& range : sorted) {
    if (range.end <= at) continue;
    if (range.first >= at + bytes) break;
    at = range.end;
  }
  return at;
}

template <typename Ranges>
void sort(Ranges& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

constexpr int kFarApart = 1 << 16;

bool is_pixel(const Operand& o) { return o.kind == Operand::Kind::Pixel; }

}  // namespace

Placement::Placement(const ir::Code& code, const Lifetimes& lifetimes)
    : code_(code), lifetimes_(lifetimes), partners_(code.variables.size()) {
  for (const ir::Variable& variable : code.variables) {
    size_.push_back(variable.bytes());
    own_.push_back(!variable.address || *variable.address < kSharedAt);
  }
  // No operation needs less than with operands apart.
  std::vector<int> apart(code.variables.size());
  for (std::size_t v = 0; v < apart.size(); ++v) apart[v] = static_cast<int>(v) * kFarApart;
  const auto own_bytes = [&](const BitMatrix& alive, int i) {
    int sum = 0;
    alive.each(i, [&](int v) { sum += is_own(v) ? size(v) : 0; });
    return sum;
  };
  const BitMatrix* most = nullptr;
  BitMatrix here(1, static_cast<int>(code.variables.size()));
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    here = BitMatrix(1, here.columns());
    here.add(0, lifetimes.before().row(i));
    here.add(0, lifetimes.after().row(i));
    ir::each_operand(code, code.code[i], [&](const Operand& o, Access) { here.set(0, o.variable); });
    std::vector<int>& occupied = occupied_.emplace_back();
    here.each(0, [&](int v) { occupied.push_back(v); });
    const int before = own_bytes(lifetimes.before(), i), after = own_bytes(lifetimes.after(), i);
    const int work = workspace(i, apart), sum = std::max(before, after) + work;
    if (sum <= least_extent_) continue;
    least_extent_ = sum;
    least_at_ = i;
    least_workspace_ = work;
    most = before >= after ? &lifetimes.before() : &lifetimes.after();
  }
  if (most) most->each(least_at_, [&](int v) { least_variables_.push_back(v); });
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    if (lifetimes.retained(v) && is_own(v)) least_retained_ += size(v);
  }
  add_partners();
}

void Placement::add_partners() {
  for (const Instruction& instruction : code_.code) {
    const Operand& d = instruction.d;
    if (!is_pixel(d)) continue;
    for (const Operand* o : {&instruction.a, &instruction.b}) {
      if (!is_pixel(*o) || o->variable == d.variable || lifetimes_.interfere(d.variable, o->variable)) continue;
      const int d_bytes = ir::extent(code_, instruction, d), o_bytes = ir::extent(code_, instruction, *o);
      partners_[d.variable].push_back({o->variable, d.offset, d_bytes, o->offset, o_bytes});
      partners_[o->variable].push_back({d.variable, o->offset, o_bytes, d.offset, d_bytes});
    }
  }
}

int Placement::turn(int place, int bytes) const {
  return code_.kind == Shader::Kind::Surface ? place - kParametersAt : kSharedAt - place - bytes;
}

int Placement::turn_back(int at, int bytes) const {
  return code_.kind == Shader::Kind::Surface ? at + kParametersAt : kSharedAt - at - bytes;
}

Placement::Range Placement::range(int variable, const std::vector<int>& address) const {
  const int first = turn(address[variable], size(variable));
  return {first, first + size(variable)};
}

bool Placement::fits_partners(int variable, int at, const std::vector<int>& address) const {
  const int place = turn_back(at, size(variable));
  for (const Partner& partner : partners_[variable]) {
    if (address[partner.other] == Layout::kNowhere) continue;
    const int own = place + partner.own_offset, other = address[partner.other] + partner.other_offset;
    if (own != other && own < other + partner.other_bytes && other < own + partner.own_bytes) return false;
  }
  return true;
}

int Placement::find_place(int variable, const std::vector<int>& address, std::vector<Range>& ranges) const {
  ranges.clear();
  lifetimes_.interference().each(variable, [&](int v) {
    if (address[v] != Layout::kNowhere && is_own(v)) ranges.push_back(range(v, address));
  });
  sort(ranges);
  int at = first_gap(ranges, 0, size(variable));
  while (!fits_partners(variable, at, address)) at = first_gap(ranges, at + 1, size(variable));
  return at;
}

std::vector<int> Placement::to_place() const {
  std::vector<int> order;
  std::vector<bool> seen(code_.variables.size(), false);
  const auto add = [&](int v) {
    if (!seen[v] && !code_.variables[v].address) order.push_back(v);
    seen[v] = true;
  };
  for (const int v : code_.mask_bytes) add(v);
  for (const std::vector<int>& variables : occupied_) {
    for (const int v : variables) add(v);
  }
  lifetimes_.before().each(static_cast<int>(code_.code.size()), add);
  return order;
}

Layout Placement::start() const {
  Layout layout;
  layout.address.assign(code_.variables.size(), Layout::kNowhere);
  layout.work.assign(code_.code.size(), 0);
  // A parameter's place is taken while it is alive; one that is never read has none.
  std::vector<bool> needed(code_.variables.size(), false);
  for (const std::vector<int>& variables : occupied_) {
    for (const int v : variables) needed[v] = true;
  }
  lifetimes_.before().each(static_cast<int>(code_.code.size()), [&](int v) { needed[v] = true; });
  for (std::size_t v = 0; v < needed.size(); ++v) {
    if (needed[v] && code_.variables[v].address) layout.address[v] = *code_.variables[v].address;
  }
  return layout;
}

Layout Placement::first_fit(const std::vector<int>& order) const {
  Layout layout = start();
  std::vector<Range> scratch;
  for (const int v : order) layout.address[v] = turn_back(find_place(v, layout.address, scratch), size(v));
  place_workspaces(layout);
  return layout;
}

Layout Placement::one_by_one(const std::vector<int>& order) const {
  Layout layout = start();
  int next = 0;
  for (std::size_t v = 0; v < layout.address.size(); ++v) {
    if (layout.address[v] != Layout::kNowhere && is_own(static_cast<int>(v))) {
      next = std::max(next, range(static_cast<int>(v), layout.address).end);
    }
  }
  for (const int v : order) {
    layout.address[v] = turn_back(next, size(v));
    next += size(v);
  }
  place_workspaces(layout);
  return layout;
}

void Placement::place_workspaces(Layout& layout) const {
  std::vector<Range> ranges;
  for (int v = 0; v < static_cast<int>(code_.variables.size()); ++v) {
    if (layout.address[v] == Layout::kNowhere || !is_own(v)) continue;
    const int end = range(v, layout.address).end;
    layout.extent = std::max(layout.extent, end);
    if (lifetimes_.retained(v)) layout.retained = std::max(layout.retained, end);
  }
  for (int i = 0; i < static_cast<int>(code_.code.size()); ++i) {
    const int bytes = workspace(i, layout.address);
    if (bytes == 0) continue;
    ranges.clear();
    for (const int v : occupied_[i]) {
      if (is_own(v)) ranges.push_back(range(v, layout.address));
    }
    sort(ranges);
    const int at = first_gap(ranges, 0, bytes);
    layout.work[i] = turn_back(at, bytes);
    layout.extent = std::max(layout.extent, at + bytes);
  }
}

int Placement::workspace(int i, const std::vector<int>& address) const {
  const Instruction& instruction = code_.code[i];
  if (instruction.kind == Instruction::Kind::External) {
    return pixel_external(instruction.external->linkage).workspace_bytes;
  }
  if (instruction.kind != Instruction::Kind::Operate) return 0;
  // What counts is which operands lie on each other: the operation is asked with places of that pattern.
  constexpr int kD = 128, kA = 176, kB = 224;
  pixelflow::Operation operation;
  operation.code = instruction.code;
  operation.scale = instruction.scale;
  const auto operand = [&](const Operand& o, int place) {
    pixelflow::Operand out;
    out.address = static_cast<std::uint8_t>(place);
    out.bytes = static_cast<std::uint8_t>(o.bytes);
    out.is_signed = o.is_signed;
    out.uniform = o.kind == Operand::Kind::Uniform;
    return out;
  };
  const Operand &d = instruction.d, &a = instruction.a, &b = instruction.b;
  const auto on_d = [&](const Operand& o) {
    return is_pixel(o) && is_pixel(d) && address[o.variable] + o.offset == address[d.variable] + d.offset;
  };
  const auto may_be_off_d = [&](const Operand& o) { return !on_d(o) || d.index >= 0 || o.index >= 0; };
  const bool same = is_pixel(a) && is_pixel(b) && a.variable == b.variable && a.offset == b.offset;
  int most = 0;
  for (int pattern = 0; pattern < 4; ++pattern) {
    const bool a_on_d = pattern & 1, b_on_d = pattern & 2;
    const auto possible = [&](const Operand& o, bool on) {
      if (!is_pixel(o)) return !on;
      return on ? on_d(o) || (is_pixel(d) && o.variable == d.variable && (d.index >= 0 || o.index >= 0))
                : may_be_off_d(o);
    };
    if (!possible(a, a_on_d) || !possible(b, b_on_d)) continue;
    operation.d = operand(d, kD);
    operation.a = operand(a, a_on_d ? kD : kA);
    operation.b = operand(b, b_on_d ? kD : same && !a_on_d ? kA : kB);
    most = std::max(most, pixelflow::workspace_bytes(operation));
  }
  return most;
}

int Placement::bytes(int instruction, const Layout& layout) const {
  std::vector<Range> ranges;
  for (const int v : occupied_[instruction]) {
    if (is_own(v)) ranges.push_back(range(v, layout.address));
  }
  sort(ranges);
  int sum = workspace(instruction, layout.address), end = 0;
  for (const Range& range : ranges) {
    sum += std::max(0, range.end - std::max(end, range.first));
    end = std::max(end, range.end);
  }
  return sum;
}

}  // namespace pfman
