#include "pixelflow/compiler/dominators.h"

#include <algorithm>
#include <utility>

namespace pfman {

Dominators::Dominators(const std::vector<std::vector<int>>& predecessors) {
  const int size = static_cast<int>(predecessors.size()) + 1;
  std::vector<std::vector<int>> next(size);
  for (int node = 1; node < size; ++node) {
    for (const int from : predecessors[node - 1]) next[from + 1].push_back(node);
  }
  std::vector<std::size_t> tried(size, 0);
  std::vector<bool> seen(size, false);
  std::vector<int> path{0};
  seen[0] = true;
  while (!path.empty()) {
    const int node = path.back();
    if (tried[node] == next[node].size()) {
      order.push_back(node);
      path.pop_back();
      continue;
    }
    const int to = next[node][tried[node]++];
    if (seen[to]) continue;
    seen[to] = true;
    path.push_back(to);
  }
  std::reverse(order.begin(), order.end());
  std::vector<int> rank(size);
  for (int n = 0; n < static_cast<int>(order.size()); ++n) rank[order[n]] = n;

  parent.assign(size, -1);
  parent[0] = 0;
  for (bool changed = true; std::exchange(changed, false);) {
    for (const int node : order) {
      if (node == 0) continue;
      int common = -1;
      for (const int from : predecessors[node - 1]) {
        int other = from + 1;
        if (parent[other] < 0) continue;
        if (common < 0) common = other;
        while (common != other) {
          int& later = rank[common] > rank[other] ? common : other;
          later = parent[later];
        }
      }
      changed |= parent[node] != common;
      parent[node] = common;
    }
  }

  children.resize(size);
  frontier.resize(size);
  for (const int node : order) {
    if (node == 0) continue;
    children[parent[node]].push_back(node);
    if (predecessors[node - 1].size() < 2) continue;
    for (const int from : predecessors[node - 1]) {
      for (int above = from + 1; above != parent[node]; above = parent[above]) {
        if (frontier[above].empty() || frontier[above].back() != node) frontier[above].push_back(node);
      }
    }
  }
}

}  // namespace pfman
