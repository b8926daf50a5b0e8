#include "pixelflow/compiler/allocate.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/compiler/memory_report.h"
#include "pixelflow/compiler/placement.h"

namespace pfman {
namespace {

constexpr int kAvailable = kSharedAt - kParametersAt;
constexpr int kShuffles = 64;  ///< orders that are tried where the usual ones do not fit into the memory

/// Orders in which variables are given their places: as they come to life, as in the paper; then those that find a
/// good place hardest first.
class Orders {
 public:
  Orders(const ir::Code& code, const Lifetimes& lifetimes, std::vector<int> code_order)
      : code_(code), lifetimes_(lifetimes), code_order_(std::move(code_order)), span_(code.variables.size(), 0) {
    for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
      lifetimes.before().each(i, [&](int v) { ++span_[v]; });
    }
  }

  static constexpr int kCount = 6;
  std::vector<int> order(int n) const {
    switch (n) {
      case 0: return code_order_;
      case 1: return sorted([&](int v) { return retained(v); });
      case 2: return sorted([&](int v) { return span_[v]; });
      case 3: return sorted([&](int v) { return code_.variables[v].bytes(); });
      case 4: return sorted([&](int v) { return retained(v) * kMuch + span_[v]; });
      default: return sorted([&](int v) { return retained(v) * kMuch + code_.variables[v].bytes(); });
    }
  }

  /// The same shuffle for the same number.
  std::vector<int> shuffled(std::uint64_t n) const {
    std::vector<int> order = code_order_;
    std::uint64_t state = n * 0x9E3779B97F4A7C15u + 1;
    for (std::size_t left = order.size(); left > 1; --left) {
      state ^= state << 13;
      state ^= state >> 7;
      state ^= state << 17;
      std::swap(order[left - 1], order[state % left]);
    }
    return order;
  }

 private:
  static constexpr int kMuch = 1 << 20;
  int retained(int v) const { return lifetimes_.retained(v) ? 1 : 0; }

  template <typename Weight>
  std::vector<int> sorted(Weight&& weight) const {
    std::vector<int> order = code_order_;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight(a) > weight(b); });
    return order;
  }

  const ir::Code& code_;
  const Lifetimes& lifetimes_;
  std::vector<int> code_order_;
  std::vector<int> span_;  ///< instructions before which a variable is alive
};

Layout best_layout(const ir::Code& code, const Lifetimes& lifetimes, const Placement& placement) {
  const Orders orders(code, lifetimes, placement.to_place());
  Layout best = placement.first_fit(orders.order(0));
  const auto take = [&](Layout other) {
    if (std::tie(other.extent, other.retained) < std::tie(best.extent, best.retained)) best = std::move(other);
  };
  const auto is_best = [&] {
    return best.extent <= placement.least_extent() && best.retained <= placement.least_retained();
  };
  for (int n = 1; n < Orders::kCount && !is_best(); ++n) take(placement.first_fit(orders.order(n)));
  for (int n = 0; n < kShuffles && best.extent > kAvailable; ++n) take(placement.first_fit(orders.shuffled(n)));
  return best;
}

int parameter_bytes(const ir::Code& code) {
  int end = kParametersAt;
  for (const ir::Parameter& parameter : code.parameters) {
    if (parameter.declared && parameter.declared->variable->name == "px_shader_position") continue;
    for (const int v : parameter.variables) {
      const ir::Variable& variable = code.variables[v];
      if (variable.address) end = std::max(end, *variable.address + variable.bytes());
    }
  }
  return end;
}

int uniform_bytes(const ir::Code& code) {
  int sum = 0;
  std::set<int> counted;
  const auto count = [&](const Variable& variable) {
    using Role = Variable::Role;
    if (variable.type.varying || variable.role == Role::Hidden || variable.role == Role::Constant) return;
    if (counted.insert(variable.id).second) sum += variable.type.bytes();
  };
  for (const ir::Parameter& parameter : code.parameters) {
    if (parameter.declared) count(*parameter.declared->variable);
  }
  for (const auto& variable : code.uniform_variables) count(*variable);
  return sum;
}

/// Bytes outside of the parameters' own that hold a variable at some time.
int allocated_bytes(const ir::Code& code, const Layout& layout, int first) {
  std::set<int> bytes;
  for (std::size_t v = 0; v < layout.address.size(); ++v) {
    if (layout.address[v] == Layout::kNowhere || code.variables[v].address) continue;
    for (int n = 0; n < code.variables[v].bytes(); ++n) {
      const int byte = layout.address[v] + n;
      if (byte >= first || code.kind == Shader::Kind::Light) bytes.insert(byte);
    }
  }
  return static_cast<int>(bytes.size());
}

/// The first byte above what is alive behind the shared lookup.
int lookup_water(const ir::Code& code, const Lifetimes& lifetimes, const std::vector<int>& address) {
  int water = kParametersAt;
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    if (code.code[i].kind != ir::Instruction::Kind::Lookup || !code.code[i].shared) continue;
    lifetimes.after().each(i, [&](int v) {
      if (address[v] < kSharedAt) water = std::max(water, address[v] + code.variables[v].bytes());
    });
  }
  return water;
}

}  // namespace

MemoryMap allocate(ir::Code& code, const AllocateOptions& options, Diagnostics& diagnostics) {
  MemoryMap map;
  map.address.assign(code.variables.size(), -1);
  map.parameter_bytes = parameter_bytes(code);
  map.uniform_bytes = uniform_bytes(code);
  map.varying_bytes = code.source_bytes + code.temporary_bytes;
  if (!check_transfer(code, map.parameter_bytes, diagnostics)) return map;

  const Lifetimes lifetimes(code);
  const Placement placement(code, lifetimes);
  map.peak_bytes = placement.least_extent();
  map.peak_at = placement.least_at();
  if (map.peak_bytes > kAvailable) {
    report_full(code, placement, map.peak_bytes, kAvailable, diagnostics);
    return map;
  }
  const Layout layout =
      options.share ? best_layout(code, lifetimes, placement) : placement.one_by_one(placement.to_place());
  if (layout.extent > kAvailable) {
    report_full(code, placement, layout.extent, kAvailable, diagnostics);
    return map;
  }
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    code.code[i].work = layout.work[i];
    const int bytes = placement.bytes(i, layout);
    if (bytes <= map.peak_bytes) continue;
    map.peak_bytes = bytes;
    map.peak_at = i;
  }
  for (std::size_t v = 0; v < layout.address.size(); ++v) map.address[v] = std::max(layout.address[v], -1);
  map.allocated_bytes = allocated_bytes(code, layout, map.parameter_bytes);
  if (code.kind == Shader::Kind::Surface) {
    map.first_free = std::max(kParametersAt + layout.extent, map.parameter_bytes);
    map.high_water = kParametersAt + layout.retained;
    map.lookup_water = lookup_water(code, lifetimes, map.address);
  } else {
    map.first_free = kSharedAt - layout.extent;
  }
  return map;
}

}  // namespace pfman
