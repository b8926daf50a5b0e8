// From visible segments to the pixels of regions: what a rendering node puts into its elements (Olano and Lastra 1998,
// sections 5.1, 6.1.5.2 and 6.2.1).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "pixelflow/shading/region.h"
#include "scanline/field_scene.h"
#include "scanline/spans.h"
#include "watkins/interpolation.h"
#include "watkins/renderer.h"
#include "watkins/scene_shading.h"

namespace watkins {

/// A sample's visible surface.
struct SurfacePoint {
  std::uint32_t object = 0;
  std::uint32_t polygon = 0;  ///< of the node's frame, from 1; 0 when a ray found the surface
  double w = 0;               ///< distance from the eye, perpendicular to the picture
  glm::dvec3 position{0};     ///< in the world
  glm::dvec3 normal{0};       ///< unit, in the world
  glm::dvec3 polygon_normal{0};
  PolygonSurface::Point corners;  ///< where its attributes come from
};

/// Builds the regions of one moment. Immutable: any number of threads may ask.
class RegionBuilder {
 public:
  /// All arguments must outlive it. `width` x `height` are samples.
  RegionBuilder(const scanline::Scene& scene, const SceneShading& shading, const VisibleFrame& visible, int width,
                int height, bool traced);

  /// What a rendering node shows in a region, pixel by pixel in order of row and column.
  struct Visible {
    std::vector<std::uint8_t> columns, rows;  ///< of the region
    std::vector<SurfacePoint> points;
    int packets = 1;  ///< that their parameters need
    scanline::FieldCost cost;
  };
  /// `node`: which rendering node; `column`, `row`: the region's upper left sample.
  Visible find(std::size_t node, int column, int row) const;
  /// The pixels with their parameters, in as many packets as are given. Adds to the cost.
  pfman::RegionPixels pack(std::size_t node, Visible& visible, int packets) const;

  const pfman::EyeSpace& eye_space() const { return eye_; }
  /// Depth on the screen, 0 to scanline::kDepthRange.
  double screen_depth(double w) const;

 private:
  struct Ray {
    glm::dvec3 origin, direction;  ///< direction: w grows by 1 along it
  };
  struct Node {
    const scanline::SceneFrame* frame;
    scanline::SpanList spans;
    /// For each object, the frame's attribute that each of its surface's sources takes; -1 for none.
    std::vector<std::vector<int>> attributes;
    int normals = -1, coordinates = -1;
  };
  Ray ray(int column, int row) const;
  SurfacePoint on_polygon(const Node& node, const PolygonSurface& surface, std::uint32_t polygon, int column, int row,
                          scanline::FieldCost& cost) const;
  bool trace(int column, int row, SurfacePoint& point, scanline::FieldCost& cost) const;
  void values(const Node* node, const SurfacePoint& point, const ParameterSource& source, int attribute,
              scanline::FieldCost& cost, std::vector<double>& result) const;
  std::uint32_t depth(double w) const;

  const scanline::Scene& scene_;
  const SceneShading& shading_;
  scanline::Camera camera_;
  glm::dmat4 view_, from_eye_;
  std::vector<glm::dmat4> to_world_, to_object_;
  scanline::FieldScene fields_;
  std::vector<const scanline::Light*> lights_;  ///< but ambient ones
  pfman::EyeSpace eye_;
  int width_, height_;
  bool traced_;
  std::vector<Node> nodes_;
};

}  // namespace watkins
