// Texts as trees, and trees in short.
#pragma once

#include <string>

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/ast.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman_tests {

/// A unit, checked and sized.
class Checked {
 public:
  explicit Checked(const std::string& text);

  const pfman::Tree& tree() const { return tree_; }
  std::string messages() const { return diagnostics_.text(); }
  const pfman::Shader& shader(const std::string& name) const;
  const pfman::Function& function(const std::string& name) const;

  /// The statements of a shader, one a line, blocks indented.
  std::string statements(const std::string& shader) const;

 private:
  pfman::ast::Unit unit_;
  pfman::Tree tree_;
  pfman::Diagnostics diagnostics_;
};

/// A node in the language's own notation: fully parenthesised, conversions as casts, hidden variables as v1, v2, ... in
/// the order in which they are met.
std::string formula(const pfman::Node& node);

/// A surface around the statements.
std::string surface(const std::string& statements, const std::string& parameters = "");

}  // namespace pfman_tests
