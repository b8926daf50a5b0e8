// From the world to the viewing box.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scanline/scene.h"

namespace scanline {

/// The scene's camera at a moment; before the first key and after the last the nearest one holds.
Camera camera_at(const Scene& scene, double moment);

/// World to eye space: the eye stands at the origin and looks along -z, x to the right and y up.
glm::dmat4 view_matrix(const Camera& camera);

/// World to clip space: after division by w the viewing box is -1 to 1 in x (right), y (up) and z (away; near is -1).
/// `aspect` is width over height of the picture.
glm::dmat4 camera_matrix(const Camera& camera, double aspect);

/// Object to world at a moment; before the first key and after the last the nearest one holds.
glm::dmat4 object_matrix(const std::vector<TransformKey>& keys, double moment);

/// What makes a camera useless, or an empty text.
std::string camera_fault(const Camera& camera);

}  // namespace scanline
