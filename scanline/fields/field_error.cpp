#include "scanline/fields/field_error.h"

#include <algorithm>
#include <cmath>

#include "scanline/fields/geometry.h"
#include "scanline/fields/triangle_tree.h"

namespace scanline {
namespace {

constexpr double kPointsOnPolygons = 20000;
constexpr int kLines = 1024;  ///< along each axis

/// Points of the unit square that fill it evenly, whatever their number (the R2 sequence).
glm::dvec2 spread(std::uint64_t k) {
  constexpr double kA = 0.7548776662466927, kB = 0.5698402909980532;  // one over the plastic number, and its square
  const auto n = static_cast<double>(k + 1);
  return glm::fract(glm::dvec2(0.5) + n * glm::dvec2(kA, kB));
}

class Measurement {
 public:
  Measurement(const Field& field, const Mesh& mesh) : field_(field), tree_(mesh.positions, triangles_of(mesh)) {
    const Bounds box = field.bounds();
    size_ = glm::length(box.high - box.low);
  }

  FieldError run() {
    visit_edges();
    visit_triangles();
    visit_surface();
    return error_;
  }

 private:
  /// Steps towards the surface, each as long as the field allows; where that leads nowhere, what the field says.
  double distance(const glm::dvec3& p) const {
    const double bound = field_.distance(p);
    if (std::abs(bound) <= 1e-12 * size_) return std::abs(bound);
    const glm::dvec3 way = field_.normal(p) * (bound > 0 ? -1.0 : 1.0);
    double t = std::abs(bound);
    for (int step = 0; step < 200 && t <= size_; ++step) {
      const double left = field_.distance(p + t * way);
      if ((left > 0) != (bound > 0) || std::abs(left) <= 1e-9 * size_) return t;
      t += std::abs(left);
    }
    return std::abs(bound);
  }

  void visit_edges() {
    for (const Triangle& t : tree_.triangles()) {
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 &a = tree_.positions()[t[k]], &b = tree_.positions()[t[(k + 1) % 3]];
        error_.largest = std::max(error_.largest, distance(a));
        if (t[k] < t[(k + 1) % 3]) error_.largest = std::max(error_.largest, distance((a + b) / 2.0));
      }
    }
  }

  /// Points in proportion to area, one at least.
  void visit_triangles() {
    std::vector<double> areas;
    double total = 0;
    for (const Triangle& t : tree_.triangles()) {
      const auto& p = tree_.positions();
      areas.push_back(glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
      total += areas.back();
    }
    if (!(total > 0)) return;
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < areas.size(); ++k) {
      const Triangle& t = tree_.triangles()[k];
      const glm::dvec3 &a = tree_.positions()[t[0]], &b = tree_.positions()[t[1]], &c = tree_.positions()[t[2]];
      const int points = std::max(1, static_cast<int>(kPointsOnPolygons * (areas[k] / total)));
      double sum = 0;
      for (int n = 0; n < points; ++n) {
        glm::dvec2 w = spread(number++);
        if (w.x + w.y > 1) w = 1.0 - w;
        const double here = distance(n == 0 ? (a + b + c) / 3.0 : a + w.x * (b - a) + w.y * (c - a));
        error_.largest = std::max(error_.largest, here);
        sum += here;
      }
      error_.mean += sum / points * (areas[k] / total);
    }
  }

  /// Lines along the axes, marched from side to side of the box: where the sign changes there is a point.
  void visit_surface() {
    const Bounds box = field_.bounds();
    const glm::dvec3 size = box.high - box.low;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(size[axis] > 0)) continue;
      const double least = 1e-4 * size[axis];
      for (std::uint64_t line = 0; line < kLines; ++line) {
        const glm::dvec2 w = spread(line);
        glm::dvec3 from = box.low;
        from[(axis + 1) % 3] += w.x * size[(axis + 1) % 3];
        from[(axis + 2) % 3] += w.y * size[(axis + 2) % 3];
        const auto value = [&](double t) {
          glm::dvec3 p = from;
          p[axis] += t;
          return field_.distance(p);
        };
        double before = -least, at_before = value(before);
        while (before < size[axis] + least) {
          const double t = before + std::max(std::abs(at_before), least), at = value(t);
          if ((at < 0) != (at_before < 0)) visit_root(from, axis, before, t, at_before < 0, value);
          before = t;
          at_before = at;
        }
      }
    }
  }

  template <typename Value>
  void visit_root(glm::dvec3 p, int axis, double low, double high, bool inside_first, const Value& value) {
    for (int k = 0; k < 50; ++k) {
      const double middle = (low + high) / 2;
      ((value(middle) < 0) == inside_first ? low : high) = middle;
    }
    p[axis] += (low + high) / 2;
    const auto nearest = tree_.nearest(p);
    error_.missed = std::max(error_.missed, nearest ? nearest->distance : size_);
  }

  const Field& field_;
  TriangleTree tree_;
  double size_ = 0;
  FieldError error_;
};

}  // namespace

FieldError measure(const Field& field, const Mesh& mesh) { return Measurement(field, mesh).run(); }

}  // namespace scanline
