// Attributes over a polygon on the screen, perspective-correct: linear in 1/w (Olano and Lastra 1998, section 6.2: what
// a rendering node puts into its pixels).
#pragma once

#include <cstdint>
#include <vector>

#include "scanline/scene_frame.h"

namespace watkins {

/// A polygon of a frame, cut into triangles. Polygons of more than three corners whose attributes are not linear over
/// them have to be cut somehow; the cut is the same for all pixels, whatever region they are in.
class PolygonSurface {
 public:
  /// `polygon` counts from 0. The frame must outlive it.
  PolygonSurface(const scanline::SceneFrame& frame, std::uint32_t polygon);

  /// A point of the polygon: up to three of its corners and their weights, which are not negative and add up to 1.
  struct Point {
    std::uint32_t corner[3] = {0, 0, 0};  ///< index into the frame's corners
    double weight[3] = {1, 0, 0};         ///< of attributes: perspective is in them
    double w = 1;                         ///< in clip space: distance from the eye, perpendicular to the picture
    double z = 0;                         ///< on the screen, 0 to kDepthRange
  };

  /// What the frame shows at (x, y), its own coordinates. The processor may show a polygon at samples that lie a little
  /// outside of it: they get a point on the border of the nearest
  /// of its triangles.
  Point at(double x, double y) const;

 private:
  struct Triangle {
    std::uint32_t k[3];  ///< corners of the polygon, from 0
    /// Barycentric coordinate i is a x + b y + c.
    double a[3], b[3], c[3];
  };
  void cut();
  void add(std::uint32_t i, std::uint32_t j, std::uint32_t k);

  const scanline::SceneFrame& frame_;
  const std::vector<std::uint32_t>& corners_;
  std::uint32_t first_corner_;
  std::vector<Triangle> triangles_;
};

}  // namespace watkins
