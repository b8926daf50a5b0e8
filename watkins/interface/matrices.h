// OpenGL's matrices: the current ones, and what a transformation attribute does (Olano and Lastra 1998, section 3.1).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "pixelflow/language/ast.h"
#include "watkins/context_types.h"

namespace watkins {

class Matrices {
 public:
  const glm::dmat4& model() const { return stacks_[0].back(); }

  /// The calls below throw Error, for numbers that are not finite and for stacks that are empty or full.
  void mode(MatrixMode mode);
  void load(const glm::dmat4& matrix);
  void multiply(const glm::dmat4& matrix);
  void push();
  void pop();

  /// A value by its attribute. Throws Error when the result leaves the range of numbers.
  Values transform(const Values& values, pfman::ast::Transform attribute) const;

 private:
  std::vector<glm::dmat4>& stack() { return stacks_[mode_ == MatrixMode::Texture ? 1 : 0]; }
  std::array<std::vector<glm::dmat4>, 2> stacks_{std::vector{glm::dmat4(1)}, std::vector{glm::dmat4(1)}};
  MatrixMode mode_ = MatrixMode::Model;
};

/// Throws Error when the axis has no length.
glm::dmat4 rotation(double angle, const glm::dvec3& axis);

}  // namespace watkins
