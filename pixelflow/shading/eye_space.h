// Parameters that an application gives in its own coordinates, in those of shading (Olano and Lastra 1998,
// section 3.1).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "pixelflow/shading/instance.h"

namespace pfman {

/// Takes normals where `m` takes points: inverse and transposed; of a singular matrix what it comes to but for a
/// factor.
glm::dmat3 normal_matrix(const glm::dmat3& m);

/// Three or four numbers with a transform attribute, those of texture coordinates apart. `to_eye` is affine.
void to_eye_space(ast::Transform attribute, const glm::dmat4& to_eye, std::vector<double>& values);

/// Takes the uniform and the bound varying parameters of `instance` that have a transform attribute to eye space, those
/// of texture coordinates apart: given values, defaults, and zeros where there is neither. Those that are also `unit`
/// are normalised, so that a scale does not drive them out of the reach of their type. `to_eye` is affine. Not to be
/// done twice with one instance.
void place(Instance& instance, const glm::dmat4& to_eye);

}  // namespace pfman
