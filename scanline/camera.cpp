#include "scanline/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace scanline {
namespace {

constexpr double kLargestDepthRatio = 1e9;

/// The value of keys at a moment: mix(a, b, t) between two of them.
template <typename Key, typename Mix>
Key key_at(const std::vector<Key>& keys, double moment, Mix mix) {
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), moment, [](double m, const Key& k) { return m < k.frame; });
  if (after == keys.begin()) return keys.front();
  if (after == keys.end()) return keys.back();
  const Key &a = *(after - 1), &b = *after;
  return mix(a, b, (moment - a.frame) / (b.frame - a.frame));
}

}  // namespace

Camera camera_at(const Scene& scene, double moment) {
  if (scene.camera_keys.empty()) return scene.camera;
  return key_at(scene.camera_keys, moment,
                [](const CameraKey& a, const CameraKey& b, double t) {
                  CameraKey key = a;
                  key.camera.position = glm::mix(a.camera.position, b.camera.position, t);
                  key.camera.target = glm::mix(a.camera.target, b.camera.target, t);
                  key.camera.up = glm::mix(a.camera.up, b.camera.up, t);
                  key.camera.field_of_view = glm::mix(a.camera.field_of_view, b.camera.field_of_view, t);
                  key.camera.height = glm::mix(a.camera.height, b.camera.height, t);
                  return key;
                })
      .camera;
}

glm::dmat4 view_matrix(const Camera& c) { return glm::lookAtRH(c.position, c.target, c.up); }

glm::dmat4 camera_matrix(const Camera& c, double aspect) {
  const glm::dmat4 view = view_matrix(c);
  if (c.projection == Projection::kPerspective) {
    return glm::perspectiveRH_NO(glm::radians(c.field_of_view), aspect, c.near, c.far) * view;
  }
  const double y = c.height / 2, x = y * aspect;
  return glm::orthoRH_NO(-x, x, -y, y, c.near, c.far) * view;
}

glm::dmat4 object_matrix(const std::vector<TransformKey>& keys, double moment) {
  const TransformKey key = key_at(keys, moment, [](const TransformKey& a, const TransformKey& b, double t) {
    return TransformKey{0, glm::mix(a.translate, b.translate, t), glm::mix(a.rotate, b.rotate, t),
                        glm::mix(a.scale, b.scale, t)};
  });
  glm::dmat4 m = glm::translate(glm::dmat4(1), key.translate);
  m = glm::rotate(m, glm::radians(key.rotate.z), glm::dvec3(0, 0, 1));
  m = glm::rotate(m, glm::radians(key.rotate.y), glm::dvec3(0, 1, 0));
  m = glm::rotate(m, glm::radians(key.rotate.x), glm::dvec3(1, 0, 0));
  return glm::scale(m, key.scale);
}

std::string camera_fault(const Camera& c) {
  const glm::dvec3 direction = c.target - c.position;
  if (glm::length(direction) == 0) return "the camera's target is its position";
  if (glm::length(c.up) == 0) return "the camera's up has no length";
  const double sine = glm::length(glm::cross(glm::normalize(direction), glm::normalize(c.up)));
  if (!(sine > 1e-9)) return "the camera's up runs along its line of sight";
  if (c.projection == Projection::kPerspective) {
    if (!(c.field_of_view > 0 && c.field_of_view < 180)) return "field_of_view must lie between 0 and 180 degrees";
    if (!(c.near > 0)) return "near must be greater than 0";
  } else if (!(c.height > 0)) {
    return "height must be greater than 0";
  }
  if (!(c.near < c.far)) return "near must be smaller than far";
  if (c.projection == Projection::kPerspective && c.far / c.near > kLargestDepthRatio) {
    return "far is more than 1e9 times near: no depth would be left between them";
  }
  return {};
}

}  // namespace scanline
