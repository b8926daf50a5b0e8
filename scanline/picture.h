// A picture: colours, and on request what lies behind every pixel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "scanline/shader_stage.h"

namespace scanline {

/// What `--channels` adds, a value a pixel, row by row. With several samples a pixel, those of the sample at
/// (samples / 2, samples / 2) from the top left: averages of these would mean nothing.
struct PictureChannels {
  std::vector<float> depth;  ///< screen z of the visible surface; the far plane's (kDepthRange) in the background
  std::vector<std::uint32_t> polygon;               ///< number of the frame's polygon, 0 background
  std::vector<std::uint32_t> shader;                ///< number of the shader in shader_names(), from 1; 0 background
  std::vector<float> normal_x, normal_y, normal_z;  ///< that shading sees; world, unit length; 0 in the background
};

class Picture {
 public:
  Picture(int width, int height);
  /// Throws std::invalid_argument unless there are three colours a pixel.
  Picture(int width, int height, std::vector<float> colors);
  int width() const { return width_; }
  int height() const { return height_; }

  /// Red, green and blue of a pixel after the other, 0 to 255. A mean of samples need not be a whole number.
  const std::vector<float>& colors() const { return colors_; }

  /// Sets rows [first_row, first_row + rows) from samples x samples times as many samples, row by row: each pixel the
  /// mean (box filter) of its own. Different rows may be set by different threads at once.
  void set_rows(std::span<const Rgb8> values, int samples, int first_row, int rows);

  /// Shades rows [first_row, first_row + rows) and puts them into the picture, each pixel the mean (box filter) of
  /// samples x samples. `spans` are those of a picture `samples` times as large. Different rows may be shaded by
  /// different threads at once.
  void shade_rows(const ShaderStage& stage, const SpanList& spans, int samples, int first_row, int rows);

  std::optional<PictureChannels> channels;

 private:
  int width_, height_;
  std::vector<float> colors_;
};

/// Names of the shaders that the objects of a scene use, in the order of their first use.
std::vector<std::string> shader_names(const Scene& scene);

}  // namespace scanline
