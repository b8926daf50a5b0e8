// Built-in shapes: closed where the solid is closed, quads as quads, caps as polygons of many sides. They stand around
// the origin, y up. Round ones carry "normal" and "uv" at their corners, flat ones need none.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scanline/mesh.h"

namespace scanline {

/// A box of six polygons: `size` at its foot; its top is smaller by the factor `top` in x and z (a tower's roof, a
/// gable). `center` is in the middle of its height.
struct Box {
  glm::dvec3 center{0}, size{1};
  glm::dvec2 top{1};
};

/// Each box is a solid of its own, also where two of them touch.
Mesh make_boxes(std::span<const Box> boxes);

/// Horizontal, facing up, size.x along x and size.y along z, in divisions.x by divisions.y quads.
Mesh make_plane(const glm::dvec2& size, const glm::ivec2& divisions);

/// A ball of `segments` meridians and `rings` bands; triangles at the poles.
Mesh make_sphere(double radius, int segments, int rings);

/// A frustum about y: a cylinder when both radii are equal, a cone when `top_radius` is 0.
Mesh make_cone(double radius, double top_radius, double height, int segments);

/// A hollow cylinder about y.
Mesh make_tube(double radius, double inner_radius, double height, int segments);

/// A ring about y: the middle of its body runs at `radius`, the body is `thickness` in radius.
Mesh make_torus(double radius, double thickness, int segments, int sides);

/// The outline (x, y), convex or not, in front at z = depth / 2, at the back at -depth / 2.
Mesh make_prism(std::span<const glm::dvec2> outline, double depth);

}  // namespace scanline
