#include "scanline/terrain/elevation.h"

#include <algorithm>
#include <cmath>

namespace scanline {
namespace {

/// A height in the rectangle or one cell beyond it, where the line through the last two cells goes on.
double extended(const Elevation& e, int column, int row) {
  if (row < 0) return 2 * extended(e, column, 0) - extended(e, column, 1);
  if (row >= e.rows) return 2 * extended(e, column, e.rows - 1) - extended(e, column, e.rows - 2);
  if (column < 0) return 2.0 * e.at(0, row) - e.at(1, row);
  if (column >= e.columns) return 2.0 * e.at(e.columns - 1, row) - e.at(e.columns - 2, row);
  return e.at(column, row);
}

/// The weighted mean of differences; those that are not known are left out.
struct MeanSlope {
  double sum = 0, weights = 0;

  void add(double weight, double difference) {
    if (std::isnan(difference)) return;
    sum += weight * difference;
    weights += weight;
  }
  double over(double distance) const { return weights == 0 ? 0 : sum / (weights * distance); }
};

}  // namespace

glm::dvec2 gradient(const Elevation& elevation, int column, int row) {
  const double center = elevation.at(column, row);
  double around[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) around[j][i] = extended(elevation, column + i - 1, row + j - 1);
  }
  double h[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      h[j][i] = std::isnan(around[j][i]) ? 2 * center - around[2 - j][2 - i] : around[j][i];
    }
  }
  MeanSlope east, north;
  for (int k = 0; k < 3; ++k) {
    const double weight = k == 1 ? 2 : 1;
    east.add(weight, h[k][2] - h[k][0]);
    north.add(weight, h[0][k] - h[2][k]);
  }
  return {east.over(2 * elevation.cell_size.x), north.over(2 * elevation.cell_size.y)};
}

void fill_missing(Elevation& elevation) {
  const int columns = elevation.columns, rows = elevation.rows;
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  };
  const auto each_neighbour = [&](std::size_t cell, auto&& visit) {
    const int column = static_cast<int>(cell % static_cast<std::size_t>(columns));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(columns));
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, rows - 1); ++j) {
      for (int i = std::max(column - 1, 0); i <= std::min(column + 1, columns - 1); ++i) {
        if (i != column || j != row) visit(index(i, j));
      }
    }
  };
  const auto missing = [&](std::size_t cell) { return std::isnan(elevation.heights[cell]); };

  std::vector<bool> queued(elevation.heights.size());
  std::vector<std::size_t> ring, next;
  const auto queue = [&](std::size_t cell) {
    if (!missing(cell) || queued[cell]) return;
    queued[cell] = true;
    next.push_back(cell);
  };
  for (std::size_t cell = 0; cell < elevation.heights.size(); ++cell) {
    if (!missing(cell)) each_neighbour(cell, queue);
  }
  std::vector<float> found;
  while (!next.empty()) {
    ring.swap(next);
    next.clear();
    found.clear();
    for (const std::size_t cell : ring) {
      double sum = 0;
      int count = 0;
      each_neighbour(cell, [&](std::size_t neighbour) {
        if (missing(neighbour)) return;
        sum += elevation.heights[neighbour];
        ++count;
      });
      found.push_back(static_cast<float>(sum / count));
    }
    for (std::size_t k = 0; k < ring.size(); ++k) elevation.heights[ring[k]] = found[k];
    for (const std::size_t cell : ring) each_neighbour(cell, queue);
  }
}

}  // namespace scanline
