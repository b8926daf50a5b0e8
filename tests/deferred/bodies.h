// Objects of the judge's own: what a mesh file says, and what the polygons show at a point.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/deferred/view.h"

namespace deferred {

struct Corner {
  glm::dvec3 position, normal;
  glm::dvec2 uv;
};

/// An object: polygons in its own space, counter-clockwise in front, and where it stands. Numbers are multiples of 1/16
/// so that they are the same in a mesh file, in its reader's single precision, and here.
struct Body {
  std::vector<std::vector<Corner>> polygons;
  glm::dvec3 translate{0}, rotate{0}, scale{1};

  std::string obj() const;
  /// Object to world: scaled first, turned about x, y and z, moved last.
  glm::dmat3 matrix() const;
};

/// What a polygon shows at a point. Attributes are linear over its plane: three corners say all of them.
struct Shown {
  glm::dvec3 world, object;
  glm::dvec3 normal, polygon_normal;  ///< world, unit
  glm::dvec2 uv;
};

/// One polygon in the world.
class Surface {
 public:
  Surface(const Body& body, std::size_t polygon);

  /// Where the ray meets the plane, in lengths of its direction; infinite when it runs along it.
  double meet(const Ray& ray) const;
  bool holds(const glm::dvec3& point_of_plane) const;
  /// Greatest distance of the points from the plane.
  double distance(const std::vector<glm::dvec3>& points) const;
  bool faces(const View& view) const;
  Shown at(const glm::dvec3& point_of_plane) const;

 private:
  const std::vector<Corner>* corners_;
  glm::dmat3 matrix_, inverse_;
  glm::dvec3 translate_;
  std::vector<glm::dvec3> world_;
  glm::dvec3 front_;      ///< unit normal of the front
  std::size_t three_[3];  ///< corners that span the plane best
};

/// `count` triangles of all sizes and directions around the origin, with attributes of their own at every corner.
Body triangle_soup(std::mt19937_64& random, int count, int sixteenths);

/// A star of `points` points that lies aslant, seen from both sides: attributes linear over it.
Body star(int points);

/// A box of six quads with slanted normals.
Body box();

}  // namespace deferred
