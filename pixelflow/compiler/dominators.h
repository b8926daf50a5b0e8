// Dominators of the instructions by the way of Cooper, Harvey and Kennedy ("A simple, fast dominance algorithm", 2001).
#pragma once

#include <vector>

namespace pfman {

/// Nodes are the start of the shader (0), its instructions (from 1) and its end.
struct Dominators {
  /// What predecessors() gave.
  explicit Dominators(const std::vector<std::vector<int>>& predecessors);

  std::vector<int> order;                  ///< of a depth-first search, reversed: dominators come first
  std::vector<int> parent;                 ///< the immediate dominator; of the start itself
  std::vector<std::vector<int>> children;  ///< by node
  std::vector<std::vector<int>> frontier;  ///< where a definition in the node meets others, ascending
};

}  // namespace pfman
