// A surface shader's picture on a test surface, shaded by the pixel processors region by region.
#pragma once

#include <vector>

#include "pixelflow/shading/shading_node.h"
#include "pixelflow/shading/test_surface.h"
#include "program/pixel_options.h"
#include "scanline/picture.h"

namespace program {

struct ShaderPicture {
  scanline::Picture picture;
  pfman::ShadingNode::Cycles cycles;  ///< of all regions that show something
  int regions = 0;
};

/// The values of `surface` are in the test surface's own coordinates, those of `lights` in eye space. A pixel is the
/// mean of samples x samples. The picture is the same on any number of threads. Throws scanline::UserError where the
/// lights do not fit the surface, and pfman::UniformError.
ShaderPicture shade_picture(const pfman::TestView& view, pfman::Instance surface, std::vector<pfman::Instance> lights,
                            const PixelOptions& pixels, int samples, int threads, bool quiet);

}  // namespace program
