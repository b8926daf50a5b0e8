#include "pixelflow/shading/test_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pfman {
namespace {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector along(const Vector& origin, const Vector& direction, double t) {
  return {origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]};
}

Vector unit(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::optional<ShapePoint> hit_plane(double extent, const Vector& origin, const Vector& direction) {
  const double t = -origin[2] / direction[2];
  if (!(t > 0)) return std::nullopt;
  const Vector p = along(origin, direction, t);
  if (std::fabs(p[0]) > extent || std::fabs(p[1]) > extent) return std::nullopt;
  return ShapePoint{{p[0], p[1], 0}, {0, 0, 1}, {(p[0] + extent) / 2, (p[1] + extent) / 2}};
}

/// Around the vertical axis from the back, as a map is cut; from the south pole to the north.
std::array<double, 2> globe(const Vector& p) {
  return {std::atan2(p[0], p[2]) / (2 * std::numbers::pi) + 0.5,
          std::asin(std::clamp(p[1], -1.0, 1.0)) / std::numbers::pi + 0.5};
}

std::optional<ShapePoint> hit_sphere(const Vector& origin, const Vector& direction) {
  const double a = dot(direction, direction), b = dot(origin, direction), c = dot(origin, origin) - 1;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double t = (-b - std::sqrt(discriminant)) / a;
  if (!(t > 0)) return std::nullopt;
  const Vector p = unit(along(origin, direction, t));
  return ShapePoint{p, p, globe(p)};
}

/// The parameter where `below` becomes true between t0, where it is false, and t1.
template <typename Below>
double bisect(double t0, double t1, const Below& below) {
  for (int step = 0; step < 28; ++step) {
    const double middle = (t0 + t1) / 2;
    (below(middle) ? t1 : t0) = middle;
  }
  return t1;
}

struct Bump {
  double x, y, radius, height;
};

/// Round particles on the ground, and where the second measurement is high.
constexpr Bump kParticles[] = {
    {-0.52, 0.42, 0.30, 0.26},  {0.35, 0.55, 0.24, 0.20},  {0.62, 0.10, 0.20, 0.17},   {-0.15, -0.62, 0.27, 0.24},
    {-0.70, -0.25, 0.19, 0.14}, {0.02, 0.30, 0.17, 0.12},  {0.42, -0.72, 0.16, 0.11},  {-0.20, 0.80, 0.15, 0.10},
    {0.85, 0.68, 0.17, 0.12},   {-0.88, 0.85, 0.13, 0.08}, {-0.58, -0.78, 0.14, 0.09}, {0.82, -0.35, 0.13, 0.09},
};
constexpr Bump kSecond[] = {
    {-0.35, 0.40, 0.62, 0.95}, {0.55, 0.35, 0.50, 0.65}, {0.15, -0.55, 0.70, 0.85}, {-0.85, -0.60, 0.45, 0.55}};
constexpr double kGreatestHeight = 0.6;
constexpr double kGreatestSlope = 4;

/// (1 - r^2 / R^2)^2 within the radius.
double bell(double squared_distance, double radius) {
  const double inside = 1 - squared_distance / (radius * radius);
  return inside > 0 ? inside * inside : 0;
}

/// A smooth wave between -1 and 1 of period 2, without library functions.
double wave(double x) {
  const double phase = x - 2 * std::floor(x / 2) - 1;
  const double hill = 1 - phase * phase;
  return 2 * hill * hill - 1;
}

double relief_height(double x, double y) {
  double height = 0.030 + 0.012 * (wave(2.3 * x + 0.7 * y) + wave(1.9 * y - 1.1 * x)) +
                  0.004 * wave(9 * x - 4 * y) * wave(7 * y + 5 * x);
  for (const Bump& bump : kParticles) {
    const double dx = x - bump.x, dy = y - bump.y;
    const double squared = (dx * dx + dy * dy) / (bump.radius * bump.radius);
    height += bump.height * bell(squared * squared, 1);  // of the fourth power: rounder than the bell
  }
  const double from_fibre = y + 0.08 - 0.55 * x + 0.62 * x * x * x;
  return height + 0.10 * bell(from_fibre * from_fibre, 0.13);
}

double relief_data(double x, double y) {
  double value = 0.06 + 0.05 * wave(3 * x + 2 * y) * wave(4 * y - x);
  for (const Bump& bump : kSecond) {
    const double dx = x - bump.x, dy = y - bump.y;
    value += bump.height * bell(dx * dx + dy * dy, bump.radius);
  }
  return std::clamp(value, 0.0, 1.0);
}

std::optional<ShapePoint> hit_relief(const Vector& origin, const Vector& direction) {
  if (!(direction[2] < 0)) return std::nullopt;  // seen from above
  double t = std::max(0.0, (kGreatestHeight - origin[2]) / direction[2]);
  const double last = -origin[2] / direction[2];
  const double flat = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
  const auto gap = [&](double at) {
    const Vector p = along(origin, direction, at);
    return p[2] - relief_height(p[0], p[1]);
  };
  double before = t;
  while (t < last) {
    const double left = gap(t);
    if (left <= 0) break;
    before = t;
    // The ground cannot rise faster than its greatest slope; a least step ends grazing rays.
    t += std::max(left / (kGreatestSlope * flat - direction[2]), 1e-4 * last);
  }
  t = std::min(t, last);
  if (gap(t) > 0) return std::nullopt;
  t = bisect(before, t, [&](double at) { return gap(at) <= 0; });
  const Vector p = along(origin, direction, t);
  if (std::fabs(p[0]) > 1 || std::fabs(p[1]) > 1) return std::nullopt;
  constexpr double kStep = 1e-5;
  const double slope_x = (relief_height(p[0] + kStep, p[1]) - relief_height(p[0] - kStep, p[1])) / (2 * kStep);
  const double slope_y = (relief_height(p[0], p[1] + kStep) - relief_height(p[0], p[1] - kStep)) / (2 * kStep);
  ShapePoint point{p, unit({-slope_x, -slope_y, 1}), {(p[0] + 1) / 2, (p[1] + 1) / 2}};
  point.height = relief_height(p[0], p[1]);
  point.data = relief_data(p[0], p[1]);
  return point;
}

/// Squared radius of a regulation pin at heights from the floor, both in inches; the head is a ball.
struct Ring {
  double height, squared_radius;
};
constexpr double kHead = 1.2735;
constexpr double head(double height) { return kHead * kHead - (height - 15 + kHead) * (height - 15 + kHead); }
constexpr Ring kPin[] = {
    {0, 1.015 * 1.015},      {0.75, 1.414 * 1.414},  {2.25, 1.953 * 1.953},   {3.375, 2.255 * 2.255},
    {4.5, 2.383 * 2.383},    {5.875, 2.282 * 2.282}, {7.25, 1.852 * 1.852},   {8.625, 1.236 * 1.236},
    {9.375, 0.983 * 0.983},  {10, 0.898 * 0.898},    {10.875, 0.935 * 0.935}, {11.75, 1.047 * 1.047},
    {12.625, 1.186 * 1.186}, {13.5, head(13.5)},     {14.25, head(14.25)},    {15, 0}};
constexpr int kRings = static_cast<int>(std::size(kPin));
constexpr double kInch = 2.0 / 15;

double ring_slope(int n) {
  const int a = std::max(n - 1, 0), b = std::min(n + 1, kRings - 1);
  if (n == kRings - 1) return -2 * kHead;  // the ball's
  return (kPin[b].squared_radius - kPin[a].squared_radius) / (kPin[b].height - kPin[a].height);
}

/// Squared radius at a height in inches and its derivative: a cubic between rings.
std::array<double, 2> pin_profile(double height) {
  int n = 0;
  while (n < kRings - 2 && kPin[n + 1].height < height) ++n;
  const double length = kPin[n + 1].height - kPin[n].height, x = (height - kPin[n].height) / length;
  const double a = kPin[n].squared_radius, b = kPin[n + 1].squared_radius;
  const double slope_a = ring_slope(n) * length, slope_b = ring_slope(n + 1) * length;
  const double c2 = 3 * (b - a) - 2 * slope_a - slope_b, c3 = 2 * (a - b) + slope_a + slope_b;
  return {a + x * (slope_a + x * (c2 + x * c3)), (slope_a + x * (2 * c2 + x * 3 * c3)) / length};
}

std::optional<ShapePoint> hit_pin(const Vector& origin, const Vector& direction) {
  const auto inside = [&](double t) {
    const Vector p = along(origin, direction, t);
    const double height = (p[1] + 1) / kInch;
    if (height < 0 || height > 15) return false;
    return (p[0] * p[0] + p[2] * p[2]) / (kInch * kInch) < pin_profile(height)[0];
  };
  // Between the planes through the axis' nearest point that hold the pin, in steps that see its thinnest part.
  const double middle = -dot(origin, direction) / dot(direction, direction);
  const double reach = 1.1 / std::sqrt(dot(direction, direction));
  constexpr int kSteps = 220;
  double before = std::max(0.0, middle - reach);
  for (int step = 0; step <= kSteps; ++step) {
    const double t = middle - reach + 2 * reach * step / kSteps;
    if (t <= before) continue;
    if (inside(t)) {
      const Vector p = along(origin, direction, bisect(before, t, inside));
      const double height = (p[1] + 1) / kInch;
      const Vector normal = unit({2 * p[0] / kInch, -pin_profile(height)[1], 2 * p[2] / kInch});
      return ShapePoint{p, normal, {globe(p)[0], std::clamp(height / 15, 0.0, 1.0)}};
    }
    before = t;
  }
  return std::nullopt;
}

}  // namespace

std::optional<TestShape> test_shape(const std::string& word) {
  if (word == "plane") return TestShape::Plane;
  if (word == "relief") return TestShape::Relief;
  if (word == "sphere") return TestShape::Sphere;
  if (word == "pin") return TestShape::Pin;
  return std::nullopt;
}

std::optional<ShapePoint> first_hit(TestShape shape, double extent, const Vector& origin, const Vector& direction) {
  switch (shape) {
    case TestShape::Plane: return hit_plane(extent, origin, direction);
    case TestShape::Relief: return hit_relief(origin, direction);
    case TestShape::Sphere: return hit_sphere(origin, direction);
    case TestShape::Pin: return hit_pin(origin, direction);
  }
  return std::nullopt;
}

}  // namespace pfman
