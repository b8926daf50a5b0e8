// The shader "flat": plain diffuse light on the host, one colour a polygon.
//
// Parameter: color = [r, g, b], 0 to 1, default 0.8 each. A polygon's colour is
//   color * (ambient lights + sum over the other lights of max(0, N . L) * light color * intensity)
// with its world normal N; a point light is seen from the middle of the polygon's vertices in the frame.
#pragma once

#include <vector>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "scanline/shader_stage.h"

namespace scanline {

/// Throws UserError, naming the objects' file and line, when the scene asks for shaders or parameters that do not
/// exist.
void check_shaders(const Scene& scene);

class FlatShader final : public ShaderStage {
 public:
  /// The scene has passed check_shaders.
  FlatShader(const Scene& scene, const SceneFrame& frame);
  void shade(const SpanBand& band, std::span<Rgb8> pixels) const override;

 private:
  std::vector<Rgb8> colors_;  // by polygon number; 0 is the background
};

/// 0 to 1 becomes 0 to 255, rounded to nearest.
Rgb8 to_rgb8(const glm::dvec3& color);

}  // namespace scanline
