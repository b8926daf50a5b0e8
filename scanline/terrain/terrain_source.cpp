#include "scanline/terrain/terrain_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scanline/error.h"

namespace scanline {
namespace {

/// The coarsest network has four squares along the shorter side: the last ones, which may lie beyond the border for the
/// most part, stay small.
int coarsest_square(int columns, int rows) {
  int square = 1;
  while (2 * square <= (std::min(columns, rows) - 1) / 4) square *= 2;
  return square;
}

int whole_squares(int cells, int square) { return (cells - 1 + square - 1) / square * square + 1; }

}  // namespace

TerrainSource::TerrainSource(TerrainSurface surface, double detail, std::string file)
    : surface_(std::move(surface)), detail_(detail), file_(std::move(file)) {
  square_ = coarsest_square(surface_.columns(), surface_.rows());
  width_ = whole_squares(surface_.columns(), square_);
  height_ = whole_squares(surface_.rows(), square_);
  deviation_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  each_diamond([&](const Diamond& d) {
    double most = 0;
    for (int k = 0; k < d.triangles; ++k) most = std::max(most, deviation(d.a, d.b, d.apexes[k]));
    // Rounded up, so that the bound on the screen holds.
    const auto rounded = static_cast<float>(most);
    deviation_[index(d.middle)] =
        rounded < most ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
  });
}

TerrainCell TerrainSource::cell(const Place& p) const {
  return {std::min(p.x, surface_.columns() - 1), std::min(p.y, surface_.rows() - 1)};
}

/// Calls `visit` for every pair of triangles that can be halved, those that come of others before these.
template <typename Visit>
void TerrainSource::each_diamond(Visit visit) const {
  const auto offer = [&](const Place& middle, const Place& a, const Place& b, const Place& c, const Place& d) {
    Diamond diamond{middle, a, b, {c, d}, 2};
    if (!inside(d)) diamond.triangles = 1;
    if (!inside(c)) {
      diamond.apexes[0] = d;
      diamond.triangles = 1;
    }
    visit(diamond);
  };
  for (int size = 2; size <= square_; size *= 2) {
    const int half = size / 2;
    // The sides of squares, which lie between the middles of two squares.
    for (int y = 0; y < height_; y += size) {
      for (int x = half; x < width_; x += size) {
        offer({x, y}, {x - half, y}, {x + half, y}, {x, y - half}, {x, y + half});
      }
    }
    for (int y = half; y < height_; y += size) {
      for (int x = 0; x < width_; x += size) {
        offer({x, y}, {x, y - half}, {x, y + half}, {x - half, y}, {x + half, y});
      }
    }
    // The diagonals of squares: either one in turn, as halving the next larger squares leaves them.
    for (int y = half; y < height_; y += size) {
      for (int x = half; x < width_; x += size) {
        const Place nw{x - half, y - half}, ne{x + half, y - half}, sw{x - half, y + half}, se{x + half, y + half};
        if ((x / size + y / size) % 2 == 0) {
          offer({x, y}, nw, se, ne, sw);
        } else {
          offer({x, y}, ne, sw, nw, se);
        }
      }
    }
  }
}

/// The largest distance in metres of height between a cell that the triangle covers and the triangle; 0 for one without
/// area.
double TerrainSource::deviation(const Place& pa, const Place& pb, const Place& pc) const {
  const TerrainCell a = cell(pa), b = cell(pb), c = cell(pc);
  const auto cross = [](const TerrainCell& o, const TerrainCell& p, int column, int row) {
    return std::int64_t{p.column - o.column} * (row - o.row) - std::int64_t{p.row - o.row} * (column - o.column);
  };
  const std::int64_t area = cross(a, b, c.column, c.row);
  if (area == 0) return 0;
  const std::int64_t sign = area > 0 ? 1 : -1;
  const Elevation& e = surface_.elevation();
  const double ha = e.at(a.column, a.row), hb = e.at(b.column, b.row), hc = e.at(c.column, c.row);
  const auto size = static_cast<double>(std::abs(area));

  double most = 0;
  bool some_known = false, some_missing = false;
  const auto [low_column, high_column] = std::minmax({a.column, b.column, c.column});
  const auto [low_row, high_row] = std::minmax({a.row, b.row, c.row});
  for (int row = low_row; row <= high_row; ++row) {
    for (int column = low_column; column <= high_column; ++column) {
      const std::int64_t wa = sign * cross(b, c, column, row), wb = sign * cross(c, a, column, row),
                         wc = sign * cross(a, b, column, row);
      if (wa < 0 || wb < 0 || wc < 0) continue;
      if (!e.known(column, row)) {
        some_missing = true;
        continue;
      }
      some_known = true;
      const double plane = (static_cast<double>(wa) * ha + static_cast<double>(wb) * hb + static_cast<double>(wc) * hc);
      most = std::max(most, std::abs(plane / size - e.at(column, row)));
    }
  }
  if (!some_missing) return most;
  return some_known ? std::numeric_limits<double>::infinity() : 0;
}

bool TerrainSource::too_coarse(const Diamond& diamond, const Viewer& viewer) const {
  const double metres = deviation_[index(diamond.middle)];
  if (metres == 0) return false;
  if (std::isinf(metres)) return true;
  const double deviation = metres * std::abs(surface_.height_scale());
  // Each comparison is written such that what is not a number asks for more polygons.
  if (!viewer.perspective) return !(deviation <= detail_ * viewer.pixel_size);
  const glm::dvec3 middle = surface_.position(cell(diamond.middle));
  double radius = 0;
  const auto reach = [&](const Place& p) {
    radius = std::max(radius, glm::length(surface_.position(cell(p)) - middle));
  };
  reach(diamond.a);
  reach(diamond.b);
  for (int k = 0; k < diamond.triangles; ++k) reach(diamond.apexes[k]);
  const double distance = glm::length(viewer.position - middle) - radius - deviation;
  return !(deviation <= detail_ * viewer.pixel_angle * distance);
}

/// For every vertex whether the triangles that it halves are halved: they are too coarse themselves, or triangles that
/// come of them are.
std::vector<bool> TerrainSource::find_halved(const Viewer& viewer) const {
  std::vector<bool> result(deviation_.size());
  each_diamond([&](const Diamond& d) {
    bool is_halved = too_coarse(d, viewer);
    for (int k = 0; !is_halved && k < d.triangles; ++k) {
      for (const Place& end : {d.a, d.b}) {
        // A triangle that comes of this one has its longest side between apex and end.
        const int x = d.apexes[k].x + end.x, y = d.apexes[k].y + end.y;
        if (x % 2 == 0 && y % 2 == 0) is_halved = is_halved || result[index({x / 2, y / 2})];
      }
    }
    result[index(d.middle)] = is_halved;
  });
  return result;
}

/// Calls `visit` for every triangle that is not halved, those without area included.
template <typename Visit>
void TerrainSource::each_triangle(const std::vector<bool>& halved, Visit visit) const {
  std::vector<Triangle> open;
  for (int y = 0; y + 1 < height_; y += square_) {
    for (int x = 0; x + 1 < width_; x += square_) {
      const Place nw{x, y}, ne{x + square_, y}, sw{x, y + square_}, se{x + square_, y + square_};
      if ((x / square_ + y / square_) % 2 == 0) {
        open.insert(open.end(), {{nw, se, ne}, {se, nw, sw}});
      } else {
        open.insert(open.end(), {{sw, ne, nw}, {ne, sw, se}});
      }
      while (!open.empty()) {
        const Triangle t = open.back();
        open.pop_back();
        const Place middle{(t.a.x + t.b.x) / 2, (t.a.y + t.b.y) / 2};
        const bool smallest = (t.a.x + t.b.x) % 2 != 0;
        if (!smallest && halved[index(middle)]) {
          open.insert(open.end(), {{t.apex, t.a, middle}, {t.b, t.apex, middle}});
        } else {
          visit(t);
        }
      }
    }
  }
}

Mesh TerrainSource::mesh(const Viewer& viewer) const {
  const std::vector<bool> halved = find_halved(viewer);
  std::size_t count = 0;
  each_triangle(halved, [&](const Triangle&) { ++count; });
  if (count > kMostTerrainPolygons) {
    throw UserError(
        {file_, 0, 0,
         "the terrain needs more than " + std::to_string(kMostTerrainPolygons) + " polygons: 'detail' must be larger"});
  }
  TerrainMesh mesh(surface_);
  each_triangle(halved, [&](const Triangle& t) { mesh.triangle(cell(t.a), cell(t.b), cell(t.apex)); });
  return mesh.take();
}

}  // namespace scanline
