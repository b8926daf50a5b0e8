#include "watkins/region_builder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/eye_space.h"
#include "scanline/camera.h"

namespace watkins {
namespace {

using pixelflow::kRegionHeight;
using pixelflow::kRegionWidth;
using scanline::FieldCost;
using Kind = ParameterSource::Kind;

pfman::EyeSpace eye_space(const scanline::Camera& camera, int width, int height) {
  pfman::EyeSpace eye;
  eye.perspective = camera.projection == scanline::Projection::kPerspective;
  eye.near = camera.near;
  eye.far = camera.far;
  const double top = eye.perspective ? std::tan(glm::radians(camera.field_of_view) / 2) : camera.height / 2;
  const double step = 2 * top / height;
  eye.dx = step;
  eye.x0 = -step * (width - 1) / 2;
  eye.dy = -step;
  eye.y0 = step * (height - 1) / 2;
  return eye;
}

/// Normalised; `otherwise` where there is no direction.
glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

void put(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint64_t raw, int count) {
  for (int n = 0; n < count; ++n) bytes[at + static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(raw >> (8 * n));
}

int find_attribute(const scanline::SceneFrame& frame, const std::string& name) {
  for (std::size_t k = 0; k < frame.attributes.size(); ++k) {
    if (frame.attributes[k].name == name) return static_cast<int>(k);
  }
  return -1;
}

/// The mean of a frame's attribute at a point; components that it does not have stay as they are.
void interpolate(const scanline::FrameAttribute& attribute, const PolygonSurface::Point& point, std::size_t count,
                 double* result) {
  const auto components = static_cast<std::size_t>(attribute.components);
  for (std::size_t c = 0; c < std::min(count, components); ++c) {
    result[c] = 0;
    for (int n = 0; n < 3; ++n) result[c] += point.weight[n] * attribute.values[point.corner[n] * components + c];
  }
}

}  // namespace

RegionBuilder::RegionBuilder(const scanline::Scene& scene, const SceneShading& shading, const VisibleFrame& visible,
                             int width, int height, bool traced)
    : scene_(scene),
      shading_(shading),
      camera_(scanline::camera_at(scene, visible.moment)),
      view_(scanline::view_matrix(camera_)),
      from_eye_(glm::inverse(view_)),
      fields_(scene, visible.moment),
      eye_(watkins::eye_space(camera_, width, height)),
      width_(width),
      height_(height),
      traced_(traced) {
  for (const scanline::Object& object : scene.objects) {
    to_world_.push_back(scanline::object_matrix(object.keys, visible.moment));
    to_object_.push_back(glm::inverse(to_world_.back()));
  }
  for (const scanline::Light& light : scene.lights) {
    if (light.shader || light.kind != scanline::Light::Kind::kAmbient) lights_.push_back(&light);
  }
  for (std::size_t k = 0; k < visible.frames.size(); ++k) {
    const scanline::SceneFrame& frame = visible.frames[k];
    Node node{&frame, scanline::SpanList(visible.answers[k]), {}, find_attribute(frame, "normal"), -1};
    for (std::size_t n = 0; n < scene.objects.size(); ++n) {
      std::vector<int>& attributes = node.attributes.emplace_back();
      for (const ParameterSource& source : shading.object(n).sources) {
        const bool has = source.kind == Kind::TexCoord && has_attribute(scene.objects[n], "uv", 1);
        attributes.push_back(has                              ? find_attribute(frame, "uv")
                             : source.kind == Kind::Attribute ? find_attribute(frame, source.name)
                                                              : -1);
      }
    }
    nodes_.push_back(std::move(node));
  }
}

RegionBuilder::Ray RegionBuilder::ray(int column, int row) const {
  const double x = eye_.x0 + eye_.dx * column, y = eye_.y0 + eye_.dy * row;
  const auto place = [&](double z_x, double z_y, double z, double w) {
    return glm::dvec3(from_eye_ * glm::dvec4(z_x, z_y, z, w));
  };
  if (eye_.perspective) return {place(0, 0, 0, 1), place(x, y, -1, 0)};
  return {place(x, y, 0, 1), place(0, 0, -1, 0)};
}

double RegionBuilder::screen_depth(double w) const {
  const double near = eye_.near, far = eye_.far;
  const double share = eye_.perspective ? (1 / near - 1 / w) / (1 / near - 1 / far) : (w - near) / (far - near);
  return scanline::kDepthRange * std::clamp(share, 0.0, 1.0);
}

std::uint32_t RegionBuilder::depth(double w) const {
  const double range = pfman::kFarthest;
  const double value = std::floor(screen_depth(w) / scanline::kDepthRange * range);
  return static_cast<std::uint32_t>(std::clamp(value, 0.0, range - 1));
}

/// What a polygon of the frame shows at a sample.
SurfacePoint RegionBuilder::on_polygon(const Node& node, const PolygonSurface& surface, std::uint32_t polygon,
                                       int column, int row, FieldCost& cost) const {
  SurfacePoint point;
  const scanline::PolygonOrigin& origin = node.frame->polygons[polygon - 1];
  point.object = origin.object;
  point.polygon = polygon;
  point.polygon_normal = origin.normal;
  point.corners = surface.at(column + scanline::kGuardColumns, height_ - row);
  const Ray sight = ray(column, row);
  // Orthographic views have no distance in w: depth on the screen tells it.
  point.w =
      eye_.perspective ? point.corners.w : eye_.near + (eye_.far - eye_.near) * point.corners.z / scanline::kDepthRange;
  point.position = sight.origin + point.w * sight.direction;
  if (scene_.objects[point.object].field) {
    if (const auto hit = fields_.recover(point.object, sight.origin, sight.direction, point.w, cost)) {
      point.w = hit->t;
      point.position = hit->position;
      point.normal = hit->normal;
    } else {
      // The line of sight passes the field's outline: a normal turned away from the eye is bent back to where it is
      // seen edge-on.
      const glm::dvec3 normal = fields_.normal(point.object, point.position, cost);
      const double away = std::max(0.0, glm::dot(normal, sight.direction));
      const double length2 = glm::dot(sight.direction, sight.direction);
      point.normal = unit(normal - away / length2 * sight.direction, normal);
    }
    point.polygon_normal = point.normal;
    return point;
  }
  glm::dvec3 normal(0);
  if (node.normals >= 0) {
    interpolate(node.frame->attributes[static_cast<std::size_t>(node.normals)], point.corners, 3, &normal.x);
  }
  point.normal = unit(normal, point.polygon_normal);
  return point;
}

bool RegionBuilder::trace(int column, int row, SurfacePoint& point, FieldCost& cost) const {
  const Ray sight = ray(column, row);
  const auto hit = fields_.first_hit(sight.origin, sight.direction, eye_.near, eye_.far, cost);
  if (!hit) return false;
  point.object = hit->object;
  point.polygon = 0;
  point.w = hit->t;
  point.position = hit->position;
  point.normal = point.polygon_normal = hit->normal;
  return true;
}

void RegionBuilder::values(const Node* node, const SurfacePoint& point, const ParameterSource& source, int attribute,
                           FieldCost& cost, std::vector<double>& result) const {
  const auto count = static_cast<std::size_t>(source.type.count());
  result.assign(count, 0.0);
  const auto local = [&] { return glm::dvec3(to_object_[point.object] * glm::dvec4(point.position, 1)); };
  const auto set = [&](const glm::dvec3& v) {
    for (std::size_t n = 0; n < std::min<std::size_t>(count, 3); ++n) result[n] = v[static_cast<int>(n)];
  };
  switch (source.kind) {
    case Kind::Normal: return set(glm::dvec3(view_ * glm::dvec4(point.normal, 0)));
    case Kind::PolygonNormal: return set(glm::dvec3(view_ * glm::dvec4(point.polygon_normal, 0)));
    case Kind::TexCoord: {
      if (attribute >= 0 && node) break;
      // Along the two axes that the face is turned to least.
      const glm::dvec3 p = local(),
                       n = glm::abs(glm::transpose(glm::dmat3(to_world_[point.object])) * point.polygon_normal);
      const bool side = n.x > n.y && n.x > n.z, top = !side && n.y > n.z;
      result[0] = side ? p.z : p.x;
      result[1] = top ? p.z : p.y;
      return;
    }
    case Kind::Volume:
      set(local());
      if (count > 3) result[3] = 1;
      return;
    case Kind::Visibility:
      for (std::size_t n = 0; n < count; ++n) {
        const bool asked = scene_.fields.shadows && !fields_.empty() && n < lights_.size();
        result[n] = asked ? fields_.visibility(point.position, point.normal, *lights_[n], cost) : 1;
      }
      return;
    case Kind::Reflection:
      if (!scene_.fields.reflections) return;
      return set(fields_.reflection(
          point.position, point.normal,
          eye_.perspective ? point.position - glm::dvec3(from_eye_[3]) : -glm::dvec3(from_eye_[2]), cost));
    case Kind::Attribute: break;
  }
  if (attribute < 0 || !node) return;
  interpolate(node->frame->attributes[static_cast<std::size_t>(attribute)], point.corners, count, result.data());
  if (count < 3 || source.transform == pfman::ast::Transform::None ||
      source.transform == pfman::ast::Transform::Texture) {
    return;
  }
  pfman::to_eye_space(source.transform, view_ * to_world_[point.object], result);
}

RegionBuilder::Visible RegionBuilder::find(std::size_t number, int first_column, int first_row) const {
  Visible visible;
  const auto add = [&](const SurfacePoint& point, int column, int row) {
    visible.columns.push_back(static_cast<std::uint8_t>(column - first_column));
    visible.rows.push_back(static_cast<std::uint8_t>(row - first_row));
    visible.packets = std::max(visible.packets, shading_.object(point.object).packets);
    visible.points.push_back(point);
  };
  const int end_column = std::min(first_column + kRegionWidth, width_);
  const int rows = std::min(kRegionHeight, height_ - first_row);
  if (traced_) {
    SurfacePoint point;
    for (int row = first_row; row < first_row + rows; ++row) {
      for (int column = first_column; column < end_column; ++column) {
        if (trace(column, row, point, visible.cost)) add(point, column, row);
      }
    }
    return visible;
  }
  const Node& node = nodes_[number];
  std::unordered_map<std::uint32_t, PolygonSurface> surfaces;
  for (const scanline::Span& span : node.spans.band(first_row, rows).spans) {
    const int begin = std::max(span.begin, first_column), end = std::min(span.end, end_column);
    if (span.polygon == 0 || begin >= end) continue;
    const PolygonSurface& surface = surfaces.try_emplace(span.polygon, *node.frame, span.polygon - 1).first->second;
    for (int column = begin; column < end; ++column) {
      add(on_polygon(node, surface, span.polygon, column, span.row, visible.cost), column, span.row);
    }
  }
  return visible;
}

pfman::RegionPixels RegionBuilder::pack(std::size_t number, Visible& visible, int packets) const {
  const Node* const node = traced_ ? nullptr : &nodes_[number];
  const auto stride = static_cast<std::size_t>(packets * pfman::kPacketPayload);
  pfman::RegionPixels pixels;
  pixels.columns = visible.columns;
  pixels.rows = visible.rows;
  pixels.packets = packets;
  pixels.payload.resize(stride * visible.points.size());
  std::vector<double> numbers;
  std::size_t first = 0;
  for (const SurfacePoint& point : visible.points) {
    const ObjectSurface& surface = shading_.object(point.object);
    pixels.depth.push_back(depth(point.w));
    put(pixels.payload, first, static_cast<std::uint64_t>(surface.shader_id), pfman::kShaderIdBytes);
    for (std::size_t k = 0; k < surface.sources.size(); ++k) {
      const ParameterSource& source = surface.sources[k];
      values(node, point, source, node ? node->attributes[point.object][k] : -1, visible.cost, numbers);
      const int bytes = source.type.scalar.bytes();
      std::size_t at = first + static_cast<std::size_t>(source.offset);
      for (const double value : numbers) {
        put(pixels.payload, at, pfman::from_double(value, source.type.scalar), bytes);
        at += static_cast<std::size_t>(bytes);
      }
    }
    first += stride;
  }
  return pixels;
}

}  // namespace watkins
