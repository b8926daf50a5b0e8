// A camera of the judge's own: rays through samples, eye space, and the way back from the screen.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace deferred {

struct Ray {
  glm::dvec3 origin, direction;  ///< direction: 1 deeper into the picture for each of its lengths
};

struct View {
  bool perspective = true;
  glm::dvec3 position{0, 0, 5}, target{0}, up{0, 1, 0};
  double field_of_view = 45;  ///< vertical, degrees; perspective
  double extent = 2;          ///< of the picture from top to bottom; orthographic
  double near = 1, far = 100;
  int width = 200, height = 100;  ///< by default more than one region, and parts of others

  /// Through the point of the picture that lies so many columns right of its left border, so many rows below its upper
  /// one: a pixel's middle is half a column and half a row from its corner.
  Ray ray(double column, double row) const;
  glm::dvec3 to_eye(const glm::dvec3& point) const;
  glm::dvec3 turned_to_eye(const glm::dvec3& direction) const;
  /// How deep a point lies, 0 at the eye.
  double distance(const glm::dvec3& point) const;
  /// Depth on the screen for a distance: 0 in the near plane, 1 in the far plane.
  double screen_depth(double distance) const;
  /// The point in the world of a vertex of a frame (docs/formats.md, pictures).
  glm::dvec3 from_frame(const glm::dvec3& vertex) const;

  /// [camera] and `size` of a scene file.
  std::string toml() const;

 private:
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  Axes axes() const;
};

}  // namespace deferred
