#include "scanline/fields/plane_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanline {
namespace {

/// Below this share of the largest eigenvalue planes count as parallel in that direction: a tenth in slope.
constexpr double kParallel = 0.01;

/// Enough to come within a thousandth of the way: the sum's directions differ by no more than a factor of 100.
constexpr int kSweeps = 100;

struct Eigen {
  std::array<double, 3> values;
  std::array<glm::dvec3, 3> vectors;
};

/// Of a symmetric matrix, largest first; by Jacobi's rotations.
Eigen eigen_of(glm::dmat3 m) {
  glm::dmat3 v(1);
  for (int sweep = 0; sweep < 20; ++sweep) {
    if (m[0][1] == 0 && m[0][2] == 0 && m[1][2] == 0) break;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (m[p][q] == 0) continue;
        const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        glm::dmat3 turn(1);
        turn[p][p] = turn[q][q] = c;
        turn[q][p] = s;
        turn[p][q] = -s;
        m = glm::transpose(turn) * m * turn;
        m[p][q] = m[q][p] = 0;
        v = v * turn;
      }
    }
  }
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return m[a][a] > m[b][b]; });
  Eigen result;
  for (int k = 0; k < 3; ++k) {
    result.values[k] = m[order[k]][order[k]];
    result.vectors[k] = v[order[k]];
  }
  return result;
}

bool inside(const Bounds& box, const glm::dvec3& p) {
  return glm::all(glm::lessThanEqual(box.low, p)) && glm::all(glm::lessThanEqual(p, box.high));
}

/// Moves `p` along `direction` to the nearest place inside the box; false when the line misses it.
bool slide_inside(const Bounds& box, const glm::dvec3& direction, glm::dvec3& p) {
  double from = -1e300, to = 1e300;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (p[k] < box.low[k] || p[k] > box.high[k]) return false;
      continue;
    }
    const double low = (box.low[k] - p[k]) / direction[k], high = (box.high[k] - p[k]) / direction[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  if (!(from <= to)) return false;
  p = glm::clamp(p + std::clamp(0.0, from, to) * direction, box.low, box.high);
  return true;
}

}  // namespace

PlaneFit fit_planes(std::span<const Crossing> crossings, const Bounds& room) {
  glm::dvec3 mean{0};
  for (const Crossing& c : crossings) mean += c.point / static_cast<double>(crossings.size());
  glm::dmat3 normals(0);
  glm::dvec3 offsets{0};
  for (const Crossing& c : crossings) {
    normals += glm::outerProduct(c.normal, c.normal);
    offsets += c.normal * glm::dot(c.normal, c.point - mean);
  }
  const Eigen eigen = eigen_of(normals);
  int rank = 0;
  while (rank < 3 && eigen.values[rank] > kParallel * eigen.values[0]) ++rank;
  glm::dvec3 p = mean;
  for (int k = 0; k < rank; ++k) p += eigen.vectors[k] * (glm::dot(eigen.vectors[k], offsets) / eigen.values[k]);
  if (inside(room, p) || (rank == 2 && slide_inside(room, eigen.vectors[2], p))) return {p, {}};
  const glm::dvec3 meeting = p;
  // The planes meet elsewhere: the least sum within the room, found coordinate by coordinate. What keeps it near the
  // mean makes the sum strictly convex.
  for (int k = 0; k < 3; ++k) normals[k][k] += kParallel * eigen.values[0];
  p = glm::clamp(mean, room.low, room.high);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = 0; k < 3; ++k) {
      const double slope = glm::dot(normals[k], p - mean) - offsets[k];
      p[k] = std::clamp(p[k] - slope / normals[k][k], room.low[k], room.high[k]);
    }
  }
  return {p, meeting};
}

}  // namespace scanline
