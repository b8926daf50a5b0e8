// Geometry whose polygons depend on who looks: made anew for every frame of a sequence.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scanline/mesh.h"

namespace scanline {

/// Who looks, in the object's own space.
struct Viewer {
  bool perspective = true;
  glm::dvec3 position{0};
  double pixel_angle = 0;  ///< perspective: radians that a pixel's height subtends in the picture's middle
  double pixel_size = 0;   ///< orthographic: height of a pixel
};

class MeshSource {
 public:
  virtual ~MeshSource() = default;
  /// The same mesh for the same viewer.
  virtual Mesh mesh(const Viewer& viewer) const = 0;
  /// What the corners of every mesh of the source carry.
  virtual std::vector<MeshBuilder::Attribute> attributes() const = 0;
};

}  // namespace scanline
