#include "tests/deferred/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace deferred {
namespace {

// What comes between the truth and the picture. Numbers that travel are floats, rounded to nearest once; the shader
// floors to so many fraction bits. Beside that stands the double arithmetic of both sides.
const double kFloat = std::ldexp(1, -24);
constexpr double kDouble = 1e-9;
constexpr int kPlaceBits = 18, kDirectionBits = 22;
// A position is rebuilt from 32 bits of depth by float arithmetic: its error is below this share of its length
// (pixelflow/shading/region_programs.h; of the greatest length in an orthographic view), and what flooring the depth to
// 32 bits costs.
constexpr double kPosition = 4.8e-7;
const double kDepthSteps = std::ldexp(1, 32) - 1;

bool is_direction(Quantity q) { return q == Quantity::kNormal || q == Quantity::kPolygonNormal; }

int fraction_bits(Quantity q) { return is_direction(q) ? kDirectionBits : kPlaceBits; }

double expected(const View& view, const Shown& shown, Quantity quantity, int k) {
  switch (quantity) {
    case Quantity::kPosition: return view.to_eye(shown.world)[k];
    case Quantity::kNormal: return view.turned_to_eye(shown.normal)[k];
    case Quantity::kPolygonNormal: return view.turned_to_eye(shown.polygon_normal)[k];
    case Quantity::kTexture: return shown.uv[k];
    case Quantity::kVolume: return shown.object[k];
  }
  return 0;
}

void note(Verdict& verdict, int column, int row, const std::string& what, double is, double should, double tolerance) {
  if (++verdict.wrong > 1) return;
  std::ostringstream text;
  text.precision(12);
  text << "column " << column << ", row " << row << ": " << what << " is " << is << " and should be " << should
       << " within " << tolerance;
  verdict.first = text.str();
}

}  // namespace

int components(Quantity quantity) { return quantity == Quantity::kTexture ? 2 : 3; }

const char* name(Quantity quantity) {
  constexpr const char* kNames[] = {"show_position", "show_normal", "show_polygon_normal", "show_texture",
                                    "show_volume"};
  return kNames[static_cast<int>(quantity)];
}

std::string shader_text() {
  std::ostringstream text;
  for (const Quantity q : kQuantities) {
    const std::array<const char*, 5> parameter = {"float px_shader_position[3]",
                                                  "transform_as_normal float px_material_normal[3]",
                                                  "transform_as_normal float polygon_normal[3] = { 0, 0, 1 }",
                                                  "float px_shader_texcoord[2]", "float px_shader_texcoord[3]"};
    const std::array<const char*, 5> value = {"px_shader_position", "px_material_normal", "polygon_normal",
                                              "px_shader_texcoord", "px_shader_texcoord"};
    const auto n = static_cast<std::size_t>(q);
    text << "surface " << name(q) << "(output varying fixed<8,8> px_shader_color[3],\n    varying " << parameter[n]
         << ",\n    uniform int component = 0, uniform float factor = 1)\n{\n    signed fixed<24," << fraction_bits(q)
         << "> number = factor * " << value[n] << "[component];\n    fixed<24,0> bits = fixed<24,0>(number << "
         << fraction_bits(q) << ");\n";
    for (int k = 0; k < 3; ++k) {
      text << "    px_shader_color[" << k << "] = fixed<8,8>(bits >> " << 24 - 8 * k << ");\n";
    }
    text << "}\n";
  }
  return text.str();
}

Picture::Picture(const View& v, std::vector<Body> bodies) : view(v), bodies_(std::move(bodies)) {
  for (const Body& body : bodies_) {
    for (std::size_t p = 0; p < body.polygons.size(); ++p) surfaces_.emplace_back(body, p);
  }
}

std::string Picture::scene(Quantity quantity, int component, int halvings) const {
  std::ostringstream text;
  text.precision(17);
  text << view.toml();
  for (std::size_t n = 0; n < bodies_.size(); ++n) {
    text << "[[object]]\ngeometry = \"mesh\"\nfile = \"body" << n << ".obj\"\n";
    const std::pair<const char*, const glm::dvec3*> places[] = {
        {"translate", &bodies_[n].translate}, {"rotate", &bodies_[n].rotate}, {"scale", &bodies_[n].scale}};
    for (const auto& [key, v] : places) {
      text << key << " = [" << v->x << ", " << v->y << ", " << v->z << "]\n";
    }
    text << "shader = {name = \"" << name(quantity)
         << "\", file = \"show.pfman\", parameters = {component = " << component
         << ", factor = " << std::ldexp(1, -halvings) << "}}\n";
  }
  return text.str();
}

void Picture::read_frame(const std::string& frame) {
  std::vector<glm::dvec3> vertices;
  surface_of_.clear();
  std::istringstream in(frame);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      glm::dvec3 v;
      words >> v.x >> v.y >> v.z;
      vertices.push_back(view.from_frame(v));
    }
    if (word != "p") continue;
    std::vector<glm::dvec3> corners;
    glm::dvec3 middle(0);
    for (std::size_t i; words >> i;) corners.push_back(vertices.at(i - 1));
    for (const glm::dvec3& c : corners) middle += c / static_cast<double>(corners.size());
    // Its plane tells whose it is; of several in one plane, that which holds it.
    int best = -1;
    double least = 1e-6 * (1 + glm::length(middle));
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const double apart = surfaces_[s].distance(corners);
      if (apart > least || !surfaces_[s].faces(view)) continue;
      if (best >= 0 && !surfaces_[s].holds(middle)) continue;
      best = static_cast<int>(s);
    }
    surface_of_.push_back(best);
  }
}

bool Picture::find(std::uint32_t polygon, int column, int row, Point& point) const {
  const int number = surface_of_.at(polygon - 1);
  if (number < 0) return false;
  point.surface = &surfaces_[static_cast<std::size_t>(number)];
  const Ray ray = view.ray(column + 0.5, row + 0.5);
  point.distance = point.surface->meet(ray);
  if (!(point.distance >= view.near && point.distance <= view.far)) return false;  // clipped away
  const glm::dvec3 hit = ray.origin + point.distance * ray.direction;
  if (!point.surface->holds(hit)) return false;
  point.shown = point.surface->at(hit);
  return true;
}

Verdict Picture::judge(const vsg_tests::Image& image, Quantity quantity, int component, int halvings) const {
  Verdict verdict;
  const double factor = std::ldexp(1, -halvings), quantum = std::ldexp(1, -fraction_bits(quantity));
  const double corner = glm::length(view.to_eye(view.ray(0, 0).origin + view.far * view.ray(0, 0).direction));
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const auto polygon = static_cast<std::uint32_t>(image.at(column, row, 4));
      if (polygon == 0) continue;
      ++verdict.covered;
      Point point;
      if (!find(polygon, column, row, point)) continue;
      ++verdict.judged;
      const double should = factor * expected(view, point.shown, quantity, component);
      double tolerance = kFloat * std::abs(should) + kDouble;
      if (quantity == Quantity::kPosition) {
        const double length = glm::length(view.to_eye(point.shown.world)), w = point.distance;
        const double step = view.perspective
                                ? length * w * (view.far - view.near) / (view.near * view.far * kDepthSteps)
                                : (view.far - view.near) / kDepthSteps;
        tolerance = factor * (kPosition * (view.perspective ? length : corner) + step) + kDouble;
      }
      std::int32_t bits = 0;
      for (int k = 0; k < 3; ++k) bits = bits << 8 | static_cast<int>(std::lround(255 * image.at(column, row, k)));
      if (bits >= 1 << 23) bits -= 1 << 24;
      // The shader's number lies between this and a quantum more.
      const double is = (bits + 0.5) * quantum;
      tolerance += quantum / 2;
      if (!(std::abs(is - should) <= tolerance)) note(verdict, column, row, name(quantity), is, should, tolerance);
    }
  }
  return verdict;
}

Verdict Picture::judge_channels(const vsg_tests::Image& image) const {
  Verdict verdict;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const auto polygon = static_cast<std::uint32_t>(image.at(column, row, 4));
      if (polygon == 0) {
        if (image.at(column, row, 3) != 32768) note(verdict, column, row, "Z", image.at(column, row, 3), 32768, 0);
        continue;
      }
      ++verdict.covered;
      Point point;
      if (!find(polygon, column, row, point)) continue;
      ++verdict.judged;
      const double depth = 32768 * view.screen_depth(point.distance);
      const double tolerance = 32768 * kDouble + kFloat * depth;
      const double z = image.at(column, row, 3);
      if (!(std::abs(z - depth) <= tolerance)) note(verdict, column, row, "Z", z, depth, tolerance);
      for (int k = 0; k < 3; ++k) {
        const double is = image.at(column, row, 6 + k), should = point.shown.normal[k];
        if (!(std::abs(is - should) <= kFloat + kDouble)) note(verdict, column, row, "normal", is, should, kFloat);
      }
    }
  }
  return verdict;
}

int Picture::nearest(double column, double row) const {
  const Ray ray = view.ray(column, row);
  int best = -1;
  double least = view.far;
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    if (!surfaces_[s].faces(view)) continue;
    const double distance = surfaces_[s].meet(ray);
    if (!(distance >= view.near && distance < least) || !surfaces_[s].holds(ray.origin + distance * ray.direction)) {
      continue;
    }
    least = distance;
    best = static_cast<int>(s);
  }
  return best;
}

/// Whether the first two depths at the sample are closer than both slopes over a pixel.
bool Picture::open(int column, int row) const {
  struct Depth {
    double value, slope;
  };
  std::vector<Depth> depths;
  const Ray ray = view.ray(column + 0.5, row + 0.5), beside = view.ray(column + 1.5, row + 0.5);
  for (const Surface& surface : surfaces_) {
    const double distance = surface.meet(ray);
    if (!surface.faces(view) || !(distance >= view.near && distance < view.far) ||
        !surface.holds(ray.origin + distance * ray.direction)) {
      continue;
    }
    const double depth = view.screen_depth(distance);
    depths.push_back({depth, std::abs(view.screen_depth(surface.meet(beside)) - depth)});
  }
  std::sort(depths.begin(), depths.end(), [](const Depth& a, const Depth& b) { return a.value < b.value; });
  // Slopes are kept with 18 bits behind the point, and stepped from line to line.
  const double rounding = view.height * std::ldexp(1, -18) / 32768;
  for (std::size_t n = 1; n < depths.size(); ++n) {
    if (depths[n].value - depths[0].value <= depths[n].slope + depths[0].slope + 2 * rounding) return true;
  }
  return false;
}

Verdict Picture::judge_visibility(const vsg_tests::Image& image) const {
  // One sample more on each side than the picture has.
  const int stride = image.width + 2;
  std::vector<int> truth;
  for (int row = -1; row <= image.height; ++row) {
    for (int column = -1; column <= image.width; ++column) truth.push_back(nearest(column + 0.5, row + 0.5));
  }
  Verdict verdict;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const auto polygon = static_cast<std::uint32_t>(image.at(column, row, 4));
      verdict.covered += polygon != 0;
      const int* const here = &truth[static_cast<std::size_t>((row + 1) * stride + column + 1)];
      bool settled = true;
      for (int n = 0; n < 9; ++n) settled = settled && here[(n / 3 - 1) * stride + n % 3 - 1] == *here;
      if (!settled || open(column, row)) continue;
      ++verdict.judged;
      const int is = polygon == 0 ? -1 : surface_of_.at(polygon - 1);
      if (is != *here) note(verdict, column, row, "the polygon", is, *here, 0);
    }
  }
  return verdict;
}

}  // namespace deferred
