#include "scanline/polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scanline {
namespace {

/// Relative to the square of the polygon's size; rounding of a collinear polygon's coordinates stays below.
constexpr double kNoArea = 1e-14;

double size_of(std::span<const glm::dvec3> points) {
  glm::dvec3 low = points[0], high = points[0];
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(high - low);
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Strictly on both sides of each other.
bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  return ((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) && ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0));
}

/// One turn in one direction: always to the same side, and x changes direction at most twice.
bool is_convex(const std::vector<glm::dvec2>& p) {
  const std::size_t n = p.size();
  int left = 0, right = 0, reversals = 0;
  double direction = 0, first_direction = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = turn(p[k], p[(k + 1) % n], p[(k + 2) % n]);
    left += t > 0;
    right += t < 0;
    const double dx = p[(k + 1) % n].x - p[k].x;
    if (dx == 0) continue;
    if (direction * dx < 0) ++reversals;
    if (first_direction == 0) first_direction = dx;
    direction = dx;
  }
  if (direction * first_direction < 0) ++reversals;
  return (left == 0 || right == 0) && reversals <= 2;
}

}  // namespace

glm::dvec3 newell_vector(std::span<const glm::dvec3> points) {
  glm::dvec3 sum{0};
  // Relative to the first vertex: far from the origin the products would otherwise cancel badly.
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    sum += glm::cross(points[k] - points[0], points[k + 1] - points[0]);
  }
  return sum;
}

bool has_area(std::span<const glm::dvec3> points) {
  if (points.size() < 3) return false;
  const double size = size_of(points);
  return glm::length(newell_vector(points)) > kNoArea * size * size;
}

double unevenness(std::span<const glm::dvec3> points) {
  const double size = size_of(points);
  const glm::dvec3 normal = newell_vector(points);
  const double length = glm::length(normal);
  if (length <= kNoArea * size * size) return 0;
  glm::dvec3 centre{0};
  for (const glm::dvec3& p : points) centre += (p - points[0]) / static_cast<double>(points.size());
  double worst = 0;
  for (const glm::dvec3& p : points) {
    worst = std::max(worst, std::abs(glm::dot(p - points[0] - centre, normal) / length));
  }
  return worst / size;
}

bool crosses_itself(std::span<const glm::dvec3> points) {
  const std::size_t n = points.size();
  if (n < 4) return false;
  // Not along Newell's vector: the two halves of a bow tie cancel in it. Their sizes do not.
  glm::dvec3 spread{0};
  for (std::size_t k = 1; k + 1 < n; ++k) {
    spread += glm::abs(glm::cross(points[k] - points[0], points[k + 1] - points[0]));
  }
  const double size = size_of(points);
  if (glm::length(spread) <= kNoArea * size * size) return false;  // on a line: only rounding could cross
  int dropped = spread.x > spread.y ? 0 : 1;
  if (spread.z > spread[dropped]) dropped = 2;
  std::vector<glm::dvec2> p;
  p.reserve(n);
  for (const glm::dvec3& q : points) p.emplace_back(q[(dropped + 1) % 3], q[(dropped + 2) % 3]);
  if (is_convex(p)) return false;

  // Edges in order of their left ends: each need only be held against those that start before it ends.
  struct Edge {
    double left, right;
    std::size_t from;
  };
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < n; ++k) {
    const auto [left, right] = std::minmax(p[k].x, p[(k + 1) % n].x);
    edges.push_back({left, right, k});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n && edges[j].left <= edges[i].right; ++j) {
      const std::size_t a = edges[i].from, b = edges[j].from;
      if (cross(p[a], p[(a + 1) % n], p[b], p[(b + 1) % n])) return true;
    }
  }
  return false;
}

}  // namespace scanline
