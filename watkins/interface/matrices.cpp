#include "watkins/interface/matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "pixelflow/shading/eye_space.h"

namespace watkins {
namespace {

using pfman::ast::Transform;

constexpr std::size_t kDepth = 64;  // of a stack

bool is_finite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

}  // namespace

void Matrices::mode(MatrixMode mode) {
  if (mode != MatrixMode::Model && mode != MatrixMode::Texture) throw Error("there is no such matrix");
  mode_ = mode;
}

void Matrices::load(const glm::dmat4& matrix) {
  if (!is_finite(matrix)) throw Error("a matrix holds what is no finite number");
  stack().back() = matrix;
}

void Matrices::multiply(const glm::dmat4& matrix) { load(stack().back() * matrix); }

void Matrices::push() {
  if (stack().size() == kDepth) throw Error("more than " + std::to_string(kDepth) + " matrices on the stack");
  stack().push_back(stack().back());
}

void Matrices::pop() {
  if (stack().size() == 1) throw Error("pop_matrix without push_matrix");
  stack().pop_back();
}

Values Matrices::transform(const Values& values, Transform attribute) const {
  if (attribute == Transform::None) return values;
  const std::size_t n = std::min<std::size_t>(values.size(), 4);
  glm::dvec4 v(0, 0, 0, attribute == Transform::Vector ? 0 : 1);
  for (std::size_t k = 0; k < n; ++k) v[static_cast<int>(k)] = values[k];
  if (attribute == Transform::Vector) v.w = 0;
  if (attribute == Transform::Texture) {
    v = stacks_[1].back() * v;
  } else if (attribute == Transform::Normal) {
    v = glm::dvec4(pfman::normal_matrix(glm::dmat3(model())) * glm::dvec3(v), 0);
  } else {
    v = model() * v;
  }
  Values result = values;
  for (std::size_t k = 0; k < n; ++k) {
    result[k] = v[static_cast<int>(k)];
    if (!std::isfinite(result[k])) throw Error("a transformed value leaves the range of numbers");
  }
  return result;
}

glm::dmat4 rotation(double angle, const glm::dvec3& axis) {
  const double length = glm::length(axis);
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(angle)) {
    throw Error("a rotation has a finite angle and an axis with a length");
  }
  return glm::rotate(glm::dmat4(1), glm::radians(angle), axis / length);
}

}  // namespace watkins
