#include "scanline/picture.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scanline {
namespace {

// z = z0 + zx x + zy y over the screen; the best plane when a polygon is not quite flat.
struct Plane {
  double z0 = 0, zx = 0, zy = 0;
};

Plane plane_of(const Frame& frame, const std::vector<std::uint32_t>& polygon) {
  glm::dvec3 normal(0), middle(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FrameVertex& a = frame.vertices[polygon[i] - 1];
    const FrameVertex& b = frame.vertices[polygon[(i + 1) % polygon.size()] - 1];
    normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    middle += glm::dvec3(a.x, a.y, a.z);
  }
  middle /= static_cast<double>(polygon.size());
  if (normal.z == 0) return {middle.z, 0, 0};  // edge-on: never visible
  const double zx = -normal.x / normal.z, zy = -normal.y / normal.z;
  return {middle.z - zx * middle.x - zy * middle.y, zx, zy};
}

}  // namespace

Picture::Picture(int width, int height)
    : width_(width), height_(height), colors_(3 * static_cast<std::size_t>(width) * height) {}

Picture::Picture(int width, int height, std::vector<float> colors)
    : width_(width), height_(height), colors_(std::move(colors)) {
  if (colors_.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("a picture has three colours a pixel");
}

void Picture::shade_rows(const ShaderStage& stage, const SpanList& spans, int samples, int first_row, int rows) {
  const std::size_t sample_width = static_cast<std::size_t>(spans.width());
  std::vector<Rgb8> shaded(sample_width * samples * rows);
  stage.shade(spans.band(first_row * samples, rows * samples), shaded);

  const auto count = static_cast<float>(samples * samples);
  for (int row = 0; row < rows; ++row) {
    float* out = &colors_[3 * static_cast<std::size_t>(first_row + row) * width_];
    for (int column = 0; column < width_; ++column) {
      std::uint32_t r = 0, g = 0, b = 0;
      for (int j = 0; j < samples; ++j) {
        const Rgb8* sample = &shaded[(static_cast<std::size_t>(row) * samples + j) * sample_width + column * samples];
        for (int i = 0; i < samples; ++i) {
          r += sample[i].r;
          g += sample[i].g;
          b += sample[i].b;
        }
      }
      *out++ = static_cast<float>(r) / count;
      *out++ = static_cast<float>(g) / count;
      *out++ = static_cast<float>(b) / count;
    }
  }
}

std::vector<std::string> shader_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) {
    if (std::find(names.begin(), names.end(), object.shader.name) == names.end()) names.push_back(object.shader.name);
  }
  return names;
}

PictureChannels make_channels(const Scene& scene, const SceneFrame& frame, const SpanList& spans, int samples) {
  const int width = spans.width() / samples, height = spans.height() / samples;
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  PictureChannels c;
  c.depth.assign(pixels, static_cast<float>(kDepthRange));
  for (auto* numbers : {&c.polygon, &c.shader}) numbers->assign(pixels, 0);
  for (auto* numbers : {&c.normal_x, &c.normal_y, &c.normal_z}) numbers->assign(pixels, 0);

  const std::vector<std::string> names = shader_names(scene);
  std::vector<std::uint32_t> shader_of_object;
  for (const Object& object : scene.objects) {
    const auto found = std::find(names.begin(), names.end(), object.shader.name);
    shader_of_object.push_back(static_cast<std::uint32_t>(found - names.begin()) + 1);
  }

  const int middle = samples / 2;
  for (const Span& span : spans.spans()) {
    if (span.polygon == 0 || span.row % samples != middle) continue;
    const PolygonOrigin& origin = frame.polygons[span.polygon - 1];
    const Plane plane = plane_of(frame.frame, frame.frame.polygons[span.polygon - 1]);
    const double y = spans.height() - span.row;
    const std::size_t row = static_cast<std::size_t>(span.row / samples) * width;
    // The first column whose middle sample is in the span.
    for (int column = (span.begin - middle + samples - 1) / samples; column * samples + middle < span.end; ++column) {
      const double x = column * samples + middle + kGuardColumns;
      const std::size_t pixel = row + column;
      c.depth[pixel] = static_cast<float>(plane.z0 + plane.zx * x + plane.zy * y);
      c.polygon[pixel] = span.polygon;
      c.shader[pixel] = shader_of_object[origin.object];
      c.normal_x[pixel] = static_cast<float>(origin.normal.x);
      c.normal_y[pixel] = static_cast<float>(origin.normal.y);
      c.normal_z[pixel] = static_cast<float>(origin.normal.z);
    }
  }
  return c;
}

}  // namespace scanline
