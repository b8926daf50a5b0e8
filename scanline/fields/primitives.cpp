#include "scanline/fields/primitives.h"

#include <algorithm>
#include <cmath>

#include "scanline/fields/geometry.h"

namespace scanline::fields {
namespace {

glm::dvec3 signs(const glm::dvec3& v) { return {v.x < 0 ? -1 : 1, v.y < 0 ? -1 : 1, v.z < 0 ? -1 : 1}; }

class Sphere final : public Field {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  double distance(const glm::dvec3& p) const override { return glm::length(reachable(p)) - radius_; }
  glm::dvec3 normal(const glm::dvec3& p) const override { return unit_or(reachable(p), {0, 1, 0}); }
  Bounds bounds() const override { return {glm::dvec3(-radius_), glm::dvec3(radius_)}; }

 private:
  double radius_;
};

class BoxField final : public Field {
 public:
  BoxField(const glm::dvec3& center, const glm::dvec3& size, double round)
      : center_(center), half_(size / 2.0), core_(glm::max(half_ - round, 0.0)), round_(round) {}

  double distance(const glm::dvec3& p) const override {
    const glm::dvec3 q = glm::abs(reachable(p) - center_) - core_;
    const double inside = std::min(std::max({q.x, q.y, q.z}), 0.0);
    return glm::length(glm::max(q, 0.0)) + inside - round_;
  }

  glm::dvec3 normal(const glm::dvec3& p) const override {
    const glm::dvec3 from_center = reachable(p) - center_, q = glm::abs(from_center) - core_;
    const glm::dvec3 side = signs(from_center);
    int nearest = q.y > q.x ? 1 : 0;
    if (q.z > q[nearest]) nearest = 2;
    glm::dvec3 face{0};
    face[nearest] = side[nearest];
    return unit_or(glm::max(q, 0.0) * side, face);
  }

  Bounds bounds() const override { return {center_ - half_, center_ + half_}; }

 private:
  glm::dvec3 center_, half_, core_;
  double round_;
};

class Plane final : public Field {
 public:
  explicit Plane(const glm::dvec3& normal) : normal_(unit_or(normal, {0, 1, 0})) {}
  double distance(const glm::dvec3& p) const override { return glm::dot(reachable(p), normal_); }
  glm::dvec3 normal(const glm::dvec3&) const override { return normal_; }

  Bounds bounds() const override {
    Bounds box{glm::dvec3(-kInfinite), glm::dvec3(kInfinite)};
    for (int k = 0; k < 3; ++k) {
      if (normal_[k] == 1) box.high[k] = 0;
      if (normal_[k] == -1) box.low[k] = 0;
    }
    return box;
  }

 private:
  glm::dvec3 normal_;
};

class Torus final : public Field {
 public:
  Torus(double radius, double thickness) : radius_(radius), thickness_(thickness) {}

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p.x, p.z)) - radius_, p.y)) - thickness_;
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    const glm::dvec3 outwards = unit_or({p.x, 0, p.z}, {1, 0, 0});
    return unit_or(outwards * (glm::dot(outwards, p) - radius_) + glm::dvec3(0, p.y, 0), {0, 1, 0});
  }

  Bounds bounds() const override {
    const glm::dvec3 size(radius_ + thickness_, thickness_, radius_ + thickness_);
    return {-size, size};
  }

 private:
  double radius_, thickness_;
};

/// Distances in the half plane of (distance from the axis, y), to the outline's three sides.
class Frustum final : public Field {
 public:
  Frustum(double radius, double top_radius, double height)
      : radius_(radius), top_(top_radius), half_(height / 2), slope_(height, radius - top_radius) {
    slope_ /= glm::length(slope_);
  }

  double distance(const glm::dvec3& p) const override { return nearest(p).distance; }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec2 n = nearest(point).normal;
    const glm::dvec3 p = reachable(point), outwards = unit_or({p.x, 0, p.z}, {1, 0, 0});
    return unit_or(outwards * n.x + glm::dvec3(0, n.y, 0), {0, 1, 0});
  }

  Bounds bounds() const override {
    const double widest = std::max(radius_, top_);
    return {{-widest, -half_, -widest}, {widest, half_, widest}};
  }

 private:
  struct Nearest {
    double distance;
    glm::dvec2 normal;
  };

  Nearest nearest(const glm::dvec3& point) const {
    const glm::dvec3 p = reachable(point);
    const glm::dvec2 q(glm::length(glm::dvec2(p.x, p.z)), p.y), foot(radius_, -half_), head(top_, half_);
    const double below = -half_ - q.y, above = q.y - half_, beside = glm::dot(q - foot, slope_);
    if (below <= 0 && above <= 0 && beside <= 0) {
      if (beside >= below && beside >= above) return {beside, slope_};
      return above >= below ? Nearest{above, {0, 1}} : Nearest{below, {0, -1}};
    }
    // Outside: the caps are discs, the side is a segment between foot and head.
    if (below > 0 && q.x <= radius_) return {below, {0, -1}};
    if (above > 0 && q.x <= top_) return {above, {0, 1}};
    const double t = glm::dot(q - foot, head - foot) / glm::dot(head - foot, head - foot);
    if (t > 0 && t < 1) return {beside, slope_};
    const glm::dvec2 from_rim = q - (t > 0 ? head : foot);
    const double length = glm::length(from_rim);
    return {length, length > 0 ? from_rim / length : slope_};
  }

  double radius_, top_, half_;
  glm::dvec2 slope_;  ///< normal of the side
};

/// The nearest point x of the surface satisfies p - x = t (x / radii^2) for the largest root t of a rational equation
/// (the secular equation); s = t + smallest radius^2 is what is sought. One over the root of its sum of squares is
/// concave and rises, so that Newton's method comes up to the root from below, without a step too far.
class Ellipsoid final : public Field {
 public:
  explicit Ellipsoid(const glm::dvec3& radii)
      : radii_(radii), largest_(std::max({radii.x, radii.y, radii.z})), shape_(radii / largest_) {
    smallest_ = std::min({shape_.x, shape_.y, shape_.z});
  }

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point) / largest_;
    const double far = glm::length(p);
    if (far > kFar) return (far - 1) * largest_;
    const glm::dvec3 q = glm::abs(p);
    const double length = glm::length(q - nearest(q)) * largest_;
    return is_inside(q) ? -length : length;
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point) / largest_;
    if (glm::length(p) > kFar) return unit_or(p, {0, 1, 0});
    return unit_or(nearest(glm::abs(p)) * signs(p) / (shape_ * shape_), {0, 1, 0});
  }

  Bounds bounds() const override { return {-radii_, radii_}; }

 private:
  static constexpr double kFar = 1e20;  ///< the solid is a point there, as far as doubles can tell

  bool is_inside(const glm::dvec3& q) const { return glm::dot(q / shape_, q / shape_) < 1; }

  glm::dvec3 nearest(const glm::dvec3& q) const {
    const glm::dvec3 differences = shape_ * shape_ - smallest_ * smallest_;
    // In a plane of symmetry the root would be where denominators vanish: a point next to it is as good.
    glm::dvec3 products = shape_ * glm::max(q, smallest_ * 1e-18);
    double s = 0;  // every term alone must not exceed 1
    for (int k = 0; k < 3; ++k) s = std::max(s, products[k] - differences[k]);
    for (int step = 0; step < 100; ++step) {
      const glm::dvec3 terms = products / (differences + s);
      const double sum = glm::dot(terms, terms), slope = glm::dot(terms * terms, 1.0 / (differences + s));
      const double next = s + (sum / slope) * (std::sqrt(sum) - 1);
      if (!(next > s * (1 + 1e-16))) break;
      s = next;
    }
    return shape_ * (products / (differences + s));
  }

  glm::dvec3 radii_;
  double largest_;
  glm::dvec3 shape_;  ///< radii over the largest
  double smallest_;
};

class ThickTriangle final : public Field {
 public:
  ThickTriangle(const std::array<glm::dvec3, 3>& corners, double thickness) : corners_(corners), thickness_(thickness) {
    flat_ = unit_or(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), {0, 1, 0});
  }

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    return glm::length(p - nearest_on_triangle(corners_, p).point) - thickness_;
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    return unit_or(p - nearest_on_triangle(corners_, p).point, flat_);
  }

  Bounds bounds() const override {
    const auto& [a, b, c] = corners_;
    return {glm::min(a, glm::min(b, c)) - thickness_, glm::max(a, glm::max(b, c)) + thickness_};
  }

 private:
  std::array<glm::dvec3, 3> corners_;
  double thickness_;
  glm::dvec3 flat_;
};

}  // namespace

FieldPointer sphere(double radius) { return std::make_shared<Sphere>(radius); }
FieldPointer box(const glm::dvec3& size, double round) {
  return std::make_shared<BoxField>(glm::dvec3(0), size, round);
}
FieldPointer box(const Bounds& corners) {
  return std::make_shared<BoxField>((corners.low + corners.high) / 2.0, corners.high - corners.low, 0);
}
FieldPointer plane(const glm::dvec3& normal) { return std::make_shared<Plane>(normal); }
FieldPointer torus(double radius, double thickness) { return std::make_shared<Torus>(radius, thickness); }
FieldPointer frustum(double radius, double top_radius, double height) {
  return std::make_shared<Frustum>(radius, top_radius, height);
}
FieldPointer ellipsoid(const glm::dvec3& radii) { return std::make_shared<Ellipsoid>(radii); }
FieldPointer triangle(const std::array<glm::dvec3, 3>& corners, double thickness) {
  return std::make_shared<ThickTriangle>(corners, thickness);
}

}  // namespace scanline::fields
