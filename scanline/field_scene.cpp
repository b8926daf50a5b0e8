#include "scanline/field_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanline/camera.h"
#include "scanline/fields/geometry.h"

namespace scanline {
namespace {

constexpr int kMostSteps = 20000;
constexpr int kMostShadowSteps = 5000;
constexpr double kDefaultColor = 0.8;
/// How far rays start off a surface, in distances from the eye.
constexpr double kLift = 1e-7;
constexpr double kReach = 1000;  // in farthest distances of the camera

glm::dvec3 transformed(const glm::dmat4& matrix, const glm::dvec3& v, double w) {
  return glm::dvec3(matrix * glm::dvec4(v, w));
}

bool is_finite(const glm::dmat4& matrix) {
  for (int k = 0; k < 16; ++k) {
    if (!std::isfinite(matrix[k / 4][k % 4])) return false;
  }
  return true;
}

/// Numbers of a parameter; none if it is missing or is something else.
std::vector<double> numbers(const ShaderCall& call, const std::string& name) {
  const auto found = call.parameters.find(name);
  if (found == call.parameters.end()) return {};
  if (const double* number = std::get_if<double>(&found->second)) return {*number};
  const auto* list = std::get_if<std::vector<double>>(&found->second);
  return list ? *list : std::vector<double>();
}

glm::dvec3 color(const ShaderCall& call, const std::string& name, double otherwise) {
  const std::vector<double> c = numbers(call, name);
  if (c.size() == 1) return glm::dvec3(c[0]);
  return c.size() == 3 ? glm::dvec3(c[0], c[1], c[2]) : glm::dvec3(otherwise);
}

/// The shading language keeps the word `color` for itself: it stands for the parameter `rgb` in scenes.
const char* color_name(const ShaderCall& call) { return call.parameters.contains("rgb") ? "rgb" : "color"; }

/// The way from a point to a light, and where it ends in lengths of that way: 1, or nowhere.
struct Way {
  glm::dvec3 direction{0};
  double end = 1;
};

std::optional<Way> way_to(const Light& light, const glm::dvec3& point) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (!light.shader) {
    if (light.kind == Light::Kind::kAmbient) return std::nullopt;
    if (light.kind == Light::Kind::kPoint) return Way{light.position - point, 1};
    return Way{-light.direction, kNever};
  }
  const std::vector<double> position = numbers(*light.shader, "position");
  if (position.size() == 3 || position.size() == 4) {
    const glm::dvec3 at(position[0], position[1], position[2]);
    const double w = position.size() == 4 ? position[3] : 1;  // OpenGL's: a light far away has 0
    return w == 0 ? Way{at, kNever} : Way{at / w - point, 1};
  }
  const std::vector<double> direction = numbers(*light.shader, "direction");
  if (direction.size() == 3) return Way{-glm::dvec3(direction[0], direction[1], direction[2]), kNever};
  return std::nullopt;
}

glm::dvec3 full_light(const Light& light) {
  if (!light.shader) return light.color * light.intensity;
  return color(*light.shader, color_name(*light.shader), 1) * color(*light.shader, "intensity", 1);
}

}  // namespace

FieldCost& FieldCost::operator+=(const FieldCost& other) {
  rays += other.rays;
  evaluations += other.evaluations;
  missed += other.missed;
  return *this;
}

FieldScene::FieldScene(const Scene& scene, double moment) : scene_(scene) {
  const Camera camera = camera_at(scene, moment);
  eye_ = camera.position;
  reach_ = kReach * camera.far;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const Object& object = scene.objects[k];
    if (!object.field) continue;
    const glm::dmat4 to_field = glm::inverse(object_matrix(object.keys, moment));
    if (!is_finite(to_field)) continue;
    objects_.push_back({static_cast<std::uint32_t>(k), object.field.get(), object.field->bounds(), to_field,
                        glm::transpose(glm::dmat3(to_field))});
  }
}

FieldLine FieldScene::line(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction,
                           FieldCost& cost) const {
  return FieldLine(*placed.field, placed.bounds, transformed(placed.to_field, origin, 1),
                   transformed(placed.to_field, direction, 0), cost.evaluations);
}

FieldHit FieldScene::hit(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction, double t,
                         FieldCost& cost) const {
  const glm::dvec3 position = origin + t * direction;
  return {placed.object, t, position, normal(placed.object, position, cost)};
}

const FieldScene::Placed* FieldScene::find(std::uint32_t object) const {
  const auto found = std::lower_bound(objects_.begin(), objects_.end(), object,
                                      [](const Placed& p, std::uint32_t number) { return p.object < number; });
  return found != objects_.end() && found->object == object ? &*found : nullptr;
}

std::optional<FieldHit> FieldScene::first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                              double to, FieldCost& cost) const {
  ++cost.rays;
  const double reach = reach_ / glm::length(direction);
  const Placed* first = nullptr;
  for (const Placed& placed : objects_) {
    const auto t = line(placed, origin, direction, cost).first_entry(from, to, reach, kMostSteps);
    if (!t) continue;
    first = &placed;
    to = *t;
  }
  if (!first) return std::nullopt;
  return hit(*first, origin, direction, to, cost);
}

std::optional<FieldHit> FieldScene::recover(std::uint32_t object, const glm::dvec3& origin, const glm::dvec3& direction,
                                            double t, FieldCost& cost) const {
  ++cost.rays;
  if (const Placed* placed = find(object)) {
    if (const auto entry = line(*placed, origin, direction, cost).entry_near(t))
      return hit(*placed, origin, direction, *entry, cost);
  }
  ++cost.missed;
  return std::nullopt;
}

glm::dvec3 FieldScene::normal(std::uint32_t object, const glm::dvec3& point, FieldCost& cost) const {
  constexpr glm::dvec3 kUp(0, 1, 0);
  const Placed* placed = find(object);
  if (!placed) return kUp;
  ++cost.evaluations;
  return unit_or(placed->to_normal * placed->field->normal(transformed(placed->to_field, point, 1)), kUp);
}

glm::dvec3 FieldScene::lifted(const glm::dvec3& point, const glm::dvec3& normal) const {
  return point + kLift * glm::length(point - eye_) * normal;
}

double FieldScene::visibility(const glm::dvec3& point, const glm::dvec3& normal, const Light& light,
                              FieldCost& cost) const {
  const auto way = way_to(light, point);
  if (!way || way->direction == glm::dvec3(0)) return 1;
  if (!(glm::dot(way->direction, normal) > 0)) return 0;
  ++cost.rays;
  const double reach = reach_ / glm::length(way->direction);
  for (const Placed& placed : objects_) {
    FieldLine line = this->line(placed, lifted(point, normal), way->direction, cost);
    if (line.first_entry(0, way->end, reach, kMostShadowSteps)) return 0;
  }
  return 1;
}

glm::dvec3 FieldScene::reflection(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& view,
                                  FieldCost& cost) const {
  // A surface seen from behind, which polygons near an outline may be, mirrors what lies straight behind it.
  const glm::dvec3 mirrored = view - 2 * std::min(glm::dot(view, normal), 0.0) * normal;
  const auto hit = first_hit(lifted(point, normal), mirrored, 0, std::numeric_limits<double>::infinity(), cost);
  if (!hit) return scene_.background;
  glm::dvec3 light(0);
  for (const Light& l : scene_.lights) {
    if (!l.shader && l.kind == Light::Kind::kAmbient) {
      light += full_light(l);
      continue;
    }
    const auto way = way_to(l, hit->position);
    if (!way) continue;
    const double facing = glm::dot(unit_or(way->direction, glm::dvec3(0)), hit->normal);
    if (!(facing > 0)) continue;
    const double seen = scene_.fields.shadows ? visibility(hit->position, hit->normal, l, cost) : 1;
    light += seen * facing * full_light(l);
  }
  const ShaderCall& shader = scene_.objects[hit->object].shader;
  return color(shader, color_name(shader), kDefaultColor) * light;
}

}  // namespace scanline
