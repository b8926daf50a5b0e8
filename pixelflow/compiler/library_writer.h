// Functions of the library written out as trees (see tree.h), and the hidden variables that this takes.
//
// `before` collects assignments to hidden variables that have to stand in front of the result, see make_sequence().
#pragma once

#include <string>

#include "pixelflow/compiler/build.h"

namespace pfman {

class LibraryWriter {
 public:
  explicit LibraryWriter(Tree& tree) : tree_(tree) {}

  /// min, max, clamp, mix, step, sign, abs, floor, ceil, round, sqrt of arguments that are all float or all fixed.
  /// Null if one of the arguments is.
  NodePtr generic(const std::string& name, Nodes arguments, Location where);
  NodePtr smoothstep(Nodes arguments, Location where);  ///< of floats
  /// Of floats: divided by its length, zero where that is zero.
  NodePtr normalized(NodePtr vector, Nodes& before);

  NodePtr keep(NodePtr node, Nodes& before);   ///< in a hidden variable
  NodePtr reuse(NodePtr node, Nodes& before);  ///< the same, unless it is plain
  /// An argument of which each element is used once. Arrays of floats are calculated an element at a time, so that they
  /// need not be stored whole; fixed ones keep every bit.
  NodePtr by_elements(NodePtr node, Nodes& before);

 private:
  NodePtr generic_scalar(const std::string& name, Nodes arguments, Location where);
  NodePtr each_element(const std::string& name, const Nodes& arguments, Location where);
  NodePtr mix(Nodes arguments, Nodes& before, Location where);
  NodePtr lesser(NodePtr a, NodePtr b, Nodes& before);
  NodePtr greater(NodePtr a, NodePtr b, Nodes& before);

  Tree& tree_;
};

/// Products of vectors that are plain, or of which each element may be calculated by itself, added from left to right.
NodePtr make_dot(const Node& a, const Node& b, Location where);

/// A variable of the unit, owned by the tree.
Variable* add_variable(Tree& tree, std::string name, const Type& type, Variable::Role role, Location where);

}  // namespace pfman
