#include "tests/terrain/mesh_judge.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace terrain_tests {

using scanline::TerrainCell;

MeshJudge::MeshJudge(const scanline::Mesh& mesh, const scanline::TerrainSurface& surface)
    : mesh_(mesh), surface_(surface) {
  const int columns = surface.columns(), rows = surface.rows();
  // The map's scale, from two opposite corners.
  const glm::dvec3 first = surface.position({0, 0}), last = surface.position({columns - 1, rows - 1});
  for (const glm::dvec3& p : mesh.positions) {
    const double x = (p.x - first.x) / (last.x - first.x) * (columns - 1),
                 y = (p.z - first.z) / (last.z - first.z) * (rows - 1);
    const glm::ivec2 cell(std::lround(x), std::lround(y));
    if (std::abs(x - cell.x) > 1e-6 || std::abs(y - cell.y) > 1e-6) fault_ = "a vertex lies between cells";
    cells_.push_back(cell);
  }
  std::map<std::pair<int, int>, int> directed;
  for (const auto& polygon : mesh.polygons) {
    if (polygon.size() != 3) fault_ = "a polygon is no triangle";
    const glm::ivec2 a = cells_[polygon[0]], b = cells_[polygon[1]], c = cells_[polygon[2]];
    const double twice = -static_cast<double>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (twice <= 0) fault_ = "a triangle does not look up";
    area_ += twice / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::ivec2 p = cells_[polygon[k]], q = cells_[polygon[(k + 1) % 3]];
      if (++directed[{p.y * columns + p.x, q.y * columns + q.x}] > 1) fault_ = "two triangles have an edge one way";
    }
  }
  for (const auto& [edge, count] : directed) {
    if (directed.contains({edge.second, edge.first})) continue;
    const glm::ivec2 p(edge.first % columns, edge.first / columns), q(edge.second % columns, edge.second / columns);
    const bool border =
        (p.x == q.x && (p.x == 0 || p.x == columns - 1)) || (p.y == q.y && (p.y == 0 || p.y == rows - 1));
    if (!border) open_.insert(std::minmax(edge.first, edge.second));
  }
}

double MeshJudge::largest_deviation(const glm::dvec3& eye, double angle) const {
  double most = 0;
  for (const auto& polygon : mesh_.polygons) {
    const glm::dvec3 a = mesh_.positions[polygon[0]], b = mesh_.positions[polygon[1]], c = mesh_.positions[polygon[2]];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    glm::ivec2 low = cells_[polygon[0]], high = low;
    for (const auto v : polygon) low = glm::min(low, cells_[v]), high = glm::max(high, cells_[v]);
    for (int row = low.y; row <= high.y; ++row) {
      for (int column = low.x; column <= high.x; ++column) {
        if (!surface_.known({column, row})) continue;
        const glm::dvec3 p = surface_.position({column, row});
        // Within the triangle on the map, by the sides that p lies on.
        const auto side = [&](const glm::dvec3& s, const glm::dvec3& t) {
          return (t.z - s.z) * (p.x - s.x) - (t.x - s.x) * (p.z - s.z);
        };
        const double slack = 1e-12;
        if (side(a, b) < -slack || side(b, c) < -slack || side(c, a) < -slack) continue;
        const double height = a.y - (normal.x * (p.x - a.x) + normal.z * (p.z - a.z)) / normal.y;
        const double away = std::abs(height - p.y);
        most = std::max(most, angle > 0 ? away / (glm::length(eye - p) * angle) : away);
      }
    }
  }
  return most;
}

}  // namespace terrain_tests
