// Pre-frame processing (chapter II): a scene at one moment becomes a frame, with what shading will want to know.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scanline/frame.h"
#include "scanline/scene.h"
#include "vsg_parameters.h"

namespace scanline {

/// Where a polygon of the frame comes from. Index: polygon number - 1.
struct PolygonOrigin {
  std::uint32_t object = 0;   ///< index into Scene::objects
  std::uint32_t polygon = 0;  ///< index into that object's mesh
  glm::dvec3 normal{0};       ///< unit normal of the polygon in world space, front side
};

/// A named attribute at every corner of the frame's polygons (after clipping), as in MeshAttribute; corners of objects
/// without it hold zeros. "normal" is in world space, not normalised, and points to the front like the polygon's own.
struct FrameAttribute {
  std::string name;
  int components = 3;
  std::vector<double> values;
};

struct SceneFrame {
  Frame frame;                          ///< of (width + 2) x (height + 1), see docs/formats.md, pictures
  std::vector<PolygonOrigin> polygons;  ///< one a polygon of the frame
  std::vector<glm::dvec3> world;        ///< world position of every vertex of the frame
  std::vector<double> w;                ///< clip-space w of every vertex: attributes are linear in 1/w on the screen
  std::vector<std::uint32_t> first_corner;  ///< corners before each polygon of the frame; one entry more than polygons
  std::vector<FrameAttribute> attributes;
  std::vector<Diagnostic> warnings;  ///< polygons that cross themselves or are not planar
};

/// Depth on the screen runs from 0 (near plane) to this (far plane), linearly on the screen: half of the number range
/// |z| < 2^16, so that an edge's slope carried past its ends still stays inside.
constexpr double kDepthRange = 32768.0;

/// The largest picture: its frame has two columns and one scan line more, and the processor counts these.
constexpr int kMostPictureWidth = (1 << vsg::kCoordinateBits) - 1 - 2;
constexpr int kMostPictureHeight = (1 << vsg::kCoordinateBits) - 1 - 1;

/// Transforms, projects and clips against the six planes of the viewing box. `width` x `height` is the picture (after
/// --size and --samples); `moment` is the frame number of the sequence. Polygons stand in the order of the scene.
/// Throws UserError when the picture is larger than a frame can be or coordinates leave the range of numbers.
SceneFrame make_scene_frame(const Scene& scene, double moment, int width, int height);

}  // namespace scanline
