#include "pixelflow/shading/eye_space.h"

#include <cmath>

namespace pfman {
namespace {

void normalise(std::vector<double>& values) {
  double length = 0;
  for (const double value : values) length = std::hypot(length, value);
  if (!(length > 0)) return;
  for (double& value : values) value /= length;
}

}  // namespace

glm::dmat3 normal_matrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double determinant = glm::dot(m[0], cofactors[0]);
  return determinant != 0 ? cofactors / determinant : cofactors;
}

void to_eye_space(ast::Transform attribute, const glm::dmat4& to_eye, std::vector<double>& values) {
  const glm::dvec3 first(values[0], values[1], values[2]);
  glm::dvec3 result;
  if (attribute == ast::Transform::Normal) {
    result = normal_matrix(glm::dmat3(to_eye)) * first;
  } else if (attribute == ast::Transform::Vector) {
    result = glm::dmat3(to_eye) * first;
  } else {
    result = glm::dvec3(to_eye * glm::dvec4(first, values.size() > 3 ? values[3] : 1));
  }
  for (int n = 0; n < 3; ++n) values[static_cast<std::size_t>(n)] = result[n];
}

void place(Instance& instance, const glm::dmat4& to_eye) {
  for (const ShaderParameter& parameter : instance.shader().shader->parameters) {
    const Variable& variable = *parameter.variable;
    const ast::Transform attribute = variable.transform;
    if (attribute == ast::Transform::None || attribute == ast::Transform::Texture || variable.output) continue;
    const auto& values_of = variable.type.varying ? instance.bound() : instance.uniforms();
    const auto given = values_of.find(variable.name);
    if (given == values_of.end() && variable.type.varying) continue;
    std::vector<double> values(static_cast<std::size_t>(variable.type.count()));
    for (std::size_t n = 0; n < values.size() && given != values_of.end(); ++n) {
      values[n] = to_double(given->second.at(n), variable.type.scalar);
    }
    to_eye_space(attribute, to_eye, values);
    if (variable.unit) normalise(values);
    instance.set(variable.name, values);
  }
}

}  // namespace pfman
