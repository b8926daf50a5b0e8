#include "scanline/flat_shader.h"

#include <algorithm>
#include <cmath>

namespace scanline {
namespace {

constexpr double kDefaultColor = 0.8;

// The parameter's value, or null when it is not a colour.
const std::vector<double>* as_color(const ParameterValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  const auto in_range = [](double x) { return x >= 0 && x <= 1; };
  return numbers && numbers->size() == 3 && std::all_of(numbers->begin(), numbers->end(), in_range) ? numbers : nullptr;
}

glm::dvec3 light_at(const Light& light, const glm::dvec3& position, const glm::dvec3& normal) {
  const glm::dvec3 full = light.color * light.intensity;
  if (light.kind == Light::Kind::kAmbient) return full;
  const glm::dvec3 towards = light.kind == Light::Kind::kDirectional ? -light.direction : light.position - position;
  const double length = glm::length(towards);
  return length > 0 ? full * std::max(0.0, glm::dot(normal, towards) / length) : glm::dvec3(0);
}

}  // namespace

glm::dvec3 color_of(const ShaderCall& shader) {
  for (const char* name : {"color", "rgb"}) {
    const auto found = shader.parameters.find(name);
    if (found == shader.parameters.end()) continue;
    if (const std::vector<double>* c = as_color(found->second)) return {(*c)[0], (*c)[1], (*c)[2]};
  }
  return glm::dvec3(kDefaultColor);
}

FlatShader::FlatShader(const Scene& scene, const SceneFrame& frame) {
  std::vector<glm::dvec3> object_colors;
  for (const Object& object : scene.objects) object_colors.push_back(color_of(object.shader));

  colors_.reserve(frame.polygons.size() + 1);
  colors_.push_back(to_rgb8(scene.background));
  for (std::size_t i = 0; i < frame.polygons.size(); ++i) {
    const PolygonOrigin& origin = frame.polygons[i];
    glm::dvec3 middle(0);
    for (const std::uint32_t vertex : frame.frame.polygons[i]) middle += frame.world[vertex - 1];
    middle /= static_cast<double>(frame.frame.polygons[i].size());
    glm::dvec3 light(0);
    for (const Light& l : scene.lights) light += light_at(l, middle, origin.normal);
    colors_.push_back(to_rgb8(object_colors[origin.object] * light));
  }
}

void FlatShader::shade(const SpanBand& band, std::span<Rgb8> pixels) const {
  for (const Span& span : band.spans) {
    const std::size_t row = static_cast<std::size_t>(span.row - band.first_row) * band.width;
    std::fill(pixels.begin() + row + span.begin, pixels.begin() + row + span.end, colors_[span.polygon]);
  }
}

Rgb8 to_rgb8(const glm::dvec3& color) {
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255)); };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

}  // namespace scanline
