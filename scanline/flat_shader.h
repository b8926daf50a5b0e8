// Plain diffuse light on the host, one colour a polygon: what false-colour pictures are drawn over.
//
// A polygon's colour is color * (ambient lights + sum over the other lights of max(0, N . L) * light color * intensity)
// with its world normal N; a point light is seen from the middle of the polygon's vertices in the frame, and one of the
// shading language shines from above.
#pragma once

#include <vector>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "scanline/shader_stage.h"

namespace scanline {

/// Parameter `color` or `rgb` of a shader where it is a colour, three numbers from 0 to 1; otherwise 0.8 each.
glm::dvec3 color_of(const ShaderCall& shader);

class FlatShader final : public ShaderStage {
 public:
  FlatShader(const Scene& scene, const SceneFrame& frame);
  void shade(const SpanBand& band, std::span<Rgb8> pixels) const override;

 private:
  std::vector<Rgb8> colors_;  // by polygon number; 0 is the background
};

/// 0 to 1 becomes 0 to 255, rounded to nearest.
Rgb8 to_rgb8(const glm::dvec3& color);

}  // namespace scanline
