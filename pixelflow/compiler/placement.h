// Addresses for variables and workspaces in a given order: first fit.
#pragma once

#include <limits>
#include <vector>

#include "pixelflow/compiler/ir.h"
#include "pixelflow/compiler/lifetime.h"

namespace pfman {

/// Where everything lies. Addresses are those of pixel memory, but may leave it where the memory does not suffice.
struct Layout {
  static constexpr int kNowhere = std::numeric_limits<int>::min();
  std::vector<int> address;  ///< by variable; kNowhere for one that is never alive
  std::vector<int> work;     ///< by instruction
  int extent = 0;            ///< bytes from the first one that the shader may use to the last one in use
  int retained = 0;          ///< the same of what is alive where lights run
};

class Placement {
 public:
  Placement(const ir::Code& code, const Lifetimes& lifetimes);

  /// Variables with addresses are where they have to be; `order` names the others that need a place.
  Layout first_fit(const std::vector<int>& order) const;
  /// The same without any sharing.
  Layout one_by_one(const std::vector<int>& order) const;

  /// Variables that need a place, in the order in which they come to life.
  std::vector<int> to_place() const;

  /// No layout has a smaller extent, which instruction least_at() needs, or retains less.
  int least_extent() const { return least_extent_; }
  int least_retained() const { return least_retained_; }
  int least_at() const { return least_at_; }
  /// What adds up to least_extent(): the variables, and the workspace.
  const std::vector<int>& least_variables() const { return least_variables_; }
  int least_workspace() const { return least_workspace_; }

  /// Bytes of the instruction's workspace as its operands lie, for all values of uniform operands and indices.
  int workspace(int instruction, const std::vector<int>& address) const;
  /// Bytes that are occupied during the instruction, its workspace included.
  int bytes(int instruction, const Layout& layout) const;

 private:
  /// A result and an operand that dies in the same instruction: in the same place or apart.
  struct Partner {
    int other = 0;
    int own_offset = 0, own_bytes = 0;
    int other_offset = 0, other_bytes = 0;
  };
  struct Range {
    int first = 0, end = 0;  ///< from the shader's first byte on, in its direction
  };

  int size(int variable) const { return size_[variable]; }
  bool is_own(int variable) const { return own_[variable]; }
  /// From an address to a place in the shader's direction, and back.
  int turn(int place, int bytes) const;
  int turn_back(int at, int bytes) const;
  Range range(int variable, const std::vector<int>& address) const;
  bool fits_partners(int variable, int at, const std::vector<int>& address) const;
  int find_place(int variable, const std::vector<int>& address, std::vector<Range>& ranges) const;
  void add_partners();
  Layout start() const;
  void place_workspaces(Layout& layout) const;

  const ir::Code& code_;
  const Lifetimes& lifetimes_;
  std::vector<int> size_;                       ///< by variable: bytes
  std::vector<char> own_;                       ///< by variable: not in the shared area
  std::vector<std::vector<Partner>> partners_;  ///< by variable
  std::vector<std::vector<int>> occupied_;      ///< by instruction: alive before or after, or its operands
  int least_extent_ = 0, least_retained_ = 0, least_at_ = 0, least_workspace_ = 0;
  std::vector<int> least_variables_;
};

}  // namespace pfman
