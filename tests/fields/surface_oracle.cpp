#include "tests/fields/surface_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fields_tests {
namespace {

constexpr double kPi = std::numbers::pi;

Patch disc(double radius, double y) {
  return [=](double u, double v) {
    return glm::dvec3(u * radius * std::cos(2 * kPi * v), y, u * radius * std::sin(2 * kPi * v));
  };
}

}  // namespace

Solid ellipsoid_solid(const glm::dvec3& r) {
  const auto patch = [=](double u, double v) {
    const double ring = std::sin(kPi * u);
    return r * glm::dvec3(ring * std::cos(2 * kPi * v), std::cos(kPi * u), ring * std::sin(2 * kPi * v));
  };
  const auto inside = [=](const glm::dvec3& p) {
    return p.x * p.x / (r.x * r.x) + p.y * p.y / (r.y * r.y) + p.z * p.z / (r.z * r.z) < 1;
  };
  return {{patch}, inside};
}

Solid sphere_solid(double radius) { return ellipsoid_solid(glm::dvec3(radius)); }

Solid torus_solid(double radius, double thickness) {
  const auto patch = [=](double u, double v) {
    const double from_axis = radius + thickness * std::cos(2 * kPi * u);
    return glm::dvec3(from_axis * std::cos(2 * kPi * v), thickness * std::sin(2 * kPi * u),
                      from_axis * std::sin(2 * kPi * v));
  };
  const auto inside = [=](const glm::dvec3& p) {
    const double beside = std::hypot(p.x, p.z) - radius;
    return beside * beside + p.y * p.y < thickness * thickness;
  };
  return {{patch}, inside};
}

Solid frustum_solid(double radius, double top, double height) {
  const auto side = [=](double u, double v) {
    const double r = radius + (top - radius) * u;
    return glm::dvec3(r * std::cos(2 * kPi * v), height * (u - 0.5), r * std::sin(2 * kPi * v));
  };
  const auto inside = [=](const glm::dvec3& p) {
    const double u = p.y / height + 0.5;
    return u > 0 && u < 1 && std::hypot(p.x, p.z) < radius + (top - radius) * u;
  };
  return {{side, disc(radius, -height / 2), disc(top, height / 2)}, inside};
}

Solid box_solid(const glm::dvec3& size) {
  Solid solid;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      solid.surface.push_back([=](double u, double v) {
        glm::dvec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = u - 0.5;
        p[(axis + 2) % 3] = v - 0.5;
        return p * size;
      });
    }
  }
  solid.is_inside = [=](const glm::dvec3& p) {
    return std::abs(p.x) < size.x / 2 && std::abs(p.y) < size.y / 2 && std::abs(p.z) < size.z / 2;
  };
  return solid;
}

Patch triangle_patch(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  // The square's other half is folded back: no corner is stretched to a side.
  return [=](double u, double v) {
    return u + v > 1 ? a + (1 - v) * (b - a) + (1 - u) * (c - a) : a + u * (b - a) + v * (c - a);
  };
}

double nearest_distance(const std::vector<Patch>& surface, const glm::dvec3& point) {
  // Parts of the square are searched each by itself: where a patch closes upon itself both ends of it are tried. No
  // start is on a border, which may be a single point.
  constexpr int kParts = 3, kLattice = 8;
  struct Start {
    const Patch* patch;
    double u, v, distance, reach;  ///< reach: how far the part extends from its middle points, more or less
  };
  const auto distance_to = [&](const Patch& patch, double u, double v) {
    const glm::dvec3 way = patch(u, v) - point;
    return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  };
  std::vector<Start> starts;
  double best = INFINITY;
  for (const Patch& patch : surface) {
    for (int part = 0; part < kParts * kParts; ++part) {
      Start start{&patch, 0, 0, INFINITY, 0};
      for (int k = 0; k < kLattice * kLattice; ++k) {
        const double step = 1.0 / (kParts * kLattice);
        const double u = double(part / kParts) / kParts + (k / kLattice + 0.5) * step;
        const double v = double(part % kParts) / kParts + (k % kLattice + 0.5) * step, d = distance_to(patch, u, v);
        const glm::dvec3 here = patch(u, v);
        start.reach =
            std::max({start.reach, glm::length(patch(u + step, v) - here), glm::length(patch(u, v + step) - here)});
        if (d >= start.distance) continue;
        start.distance = d;
        start.u = u;
        start.v = v;
      }
      best = std::min(best, start.distance);
      starts.push_back(start);
    }
  }
  double nearest = INFINITY;
  for (Start& s : starts) {
    if (s.distance - 2 * s.reach > best) continue;
    for (double step = 1.0 / kLattice; step > 1e-10;) {
      const Start from = s;
      const auto attempt = [&](double to_u, double to_v) {
        const double u = std::clamp(to_u, 0.0, 1.0), v = std::clamp(to_v, 0.0, 1.0), d = distance_to(*s.patch, u, v);
        if (d < s.distance) s = {s.patch, u, v, d, s.reach};
      };
      for (int k = 0; k < 9; ++k) attempt(from.u + (k % 3 - 1) * step, from.v + (k / 3 - 1) * step);
      // Next to the tip of a cone v may be anything before it matters.
      for (int k = 0; s.distance == from.distance && k < 144; ++k) {
        attempt(from.u + (k % 3 - 1) * step, (k / 3 + 0.5) / 48);
      }
      step = s.distance == from.distance ? step / 2 : std::min(2 * step, 1.0 / kLattice);
    }
    nearest = std::min(nearest, s.distance);
  }
  return nearest;
}

}  // namespace fields_tests
