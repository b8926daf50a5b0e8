#include "scanline/fields/geometry.h"

namespace scanline {
namespace {

/// Where between a and b (0 to 1) the point of the segment next to p lies.
double along(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  const double length2 = glm::dot(b - a, b - a);
  return length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
}

/// Cosine and sine; exact at quarter turns.
std::array<double, 2> cos_sin(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0) return {1, 0};
  if (std::abs(turned) == 180) return {-1, 0};
  if (std::abs(turned) == 90) return {0, turned > 0 ? 1.0 : -1.0};
  const double angle = glm::radians(turned);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& p) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double area2 = glm::dot(normal, normal);
  if (area2 > 0) {
    // Inside all three planes that stand on the edges?
    const bool within = glm::dot(glm::cross(normal, b - a), p - a) >= 0 &&
                        glm::dot(glm::cross(normal, c - b), p - b) >= 0 &&
                        glm::dot(glm::cross(normal, a - c), p - c) >= 0;
    if (within) return {p - normal * (glm::dot(p - a, normal) / area2), TrianglePoint::kFace};
  }
  TrianglePoint best;
  double best_distance2 = kInfinite;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 &from = corners[k], &to = corners[(k + 1) % 3];
    const double t = along(from, to, p);
    const glm::dvec3 point = t == 1 ? to : from + t * (to - from);
    const double distance2 = glm::dot(p - point, p - point);
    if (distance2 >= best_distance2) continue;
    best_distance2 = distance2;
    const int feature = t == 0   ? TrianglePoint::kA + k
                        : t == 1 ? TrianglePoint::kA + (k + 1) % 3
                                 : TrianglePoint::kEdgeAb + k;
    best = {point, static_cast<TrianglePoint::Feature>(feature)};
  }
  return best;
}

glm::dmat3 rotation(const glm::dvec3& degrees) {
  const auto [cx, sx] = cos_sin(degrees.x);
  const auto [cy, sy] = cos_sin(degrees.y);
  const auto [cz, sz] = cos_sin(degrees.z);
  // Columns, as glm has them.
  const glm::dmat3 x(1, 0, 0, 0, cx, sx, 0, -sx, cx);
  const glm::dmat3 y(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
  const glm::dmat3 z(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
  return z * y * x;
}

}  // namespace scanline
