#include "scanline/terrain/terrain_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanline/error.h"

namespace scanline {
namespace {

double lowest(const Elevation& elevation) {
  double low = std::numeric_limits<double>::infinity();
  for (const float height : elevation.heights) {
    if (height < low) low = height;
  }
  return low;
}

/// Every step-th of `count`, and the last.
std::vector<int> chosen(int count, int step) {
  std::vector<int> places;
  for (int k = 0; k < count - 1; k += std::min(step, count - 1 - k)) places.push_back(k);
  places.push_back(count - 1);
  return places;
}

}  // namespace

TerrainSurface::TerrainSurface(Elevation elevation, double exaggeration, std::optional<double> unit,
                               std::optional<double> base)
    : elevation_(std::move(elevation)), exaggeration_(exaggeration) {
  const glm::dvec2 size = glm::dvec2(columns() - 1, rows() - 1) * elevation_.cell_size;
  unit_ = unit ? *unit : 1 / std::max(size.x, size.y);
  height_scale_ = exaggeration_ * unit_;
  base_ = base ? *base : lowest(elevation_);
}

glm::dvec3 TerrainSurface::position(const TerrainCell& cell) const {
  const double height = elevation_.at(cell.column, cell.row);
  return {(cell.column - (columns() - 1) / 2.0) * elevation_.cell_size.x * unit_, (height - base_) * height_scale_,
          (cell.row - (rows() - 1) / 2.0) * elevation_.cell_size.y * unit_};
}

std::vector<MeshBuilder::Attribute> TerrainSurface::attributes() {
  return {{"normal", 3}, {"uv", 2}, {"gradient", 2}, {"height", 1}};
}

std::array<double, TerrainSurface::kValues> TerrainSurface::values(const TerrainCell& cell) const {
  const glm::dvec2 slope = gradient(elevation_, cell.column, cell.row) * exaggeration_;
  // The normal of y = f(x, -z); the greatest part first, so that steep slopes do not overflow.
  const double most = std::max({std::abs(slope.x), std::abs(slope.y), 1.0});
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope.x / most, 1 / most, slope.y / most));
  return {normal.x,
          normal.y,
          normal.z,
          (cell.column + 0.5) / columns(),
          1 - (cell.row + 0.5) / rows(),
          slope.x,
          slope.y,
          elevation_.at(cell.column, cell.row)};
}

TerrainMesh::TerrainMesh(const TerrainSurface& surface) : surface_(surface) {
  for (const MeshBuilder::Attribute& a : TerrainSurface::attributes()) {
    mesh_.attributes.push_back({a.name, a.components, {}});
  }
}

std::uint32_t TerrainMesh::vertex(const TerrainCell& cell) {
  const std::size_t key = static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(surface_.columns()) +
                          static_cast<std::size_t>(cell.column);
  const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (is_new) {
    mesh_.positions.push_back(surface_.position(cell));
    values_.push_back(surface_.values(cell));
  }
  return entry->second;
}

void TerrainMesh::triangle(const TerrainCell& a, const TerrainCell& b, const TerrainCell& c) {
  if (!surface_.known(a) || !surface_.known(b) || !surface_.known(c)) return;
  // Rows count to the south: a positive value is counter-clockwise on the map.
  const std::int64_t area =
      std::int64_t{b.row - a.row} * (c.column - a.column) - std::int64_t{b.column - a.column} * (c.row - a.row);
  if (area == 0) return;
  const std::uint32_t corners[] = {vertex(a), vertex(area > 0 ? b : c), vertex(area > 0 ? c : b)};
  mesh_.polygons.emplace_back(std::begin(corners), std::end(corners));
  for (const std::uint32_t corner : corners) {
    const double* value = values_[corner].data();
    for (MeshAttribute& attribute : mesh_.attributes) {
      attribute.values.insert(attribute.values.end(), value, value + attribute.components);
      value += attribute.components;
    }
  }
}

Mesh terrain_grid(const TerrainSurface& surface, int step, const std::string& file) {
  const std::vector<int> columns = chosen(surface.columns(), step), rows = chosen(surface.rows(), step);
  if (2 * (columns.size() - 1) * (rows.size() - 1) > kMostTerrainPolygons) {
    throw UserError(
        {file, 0, 0,
         "the terrain has more than " + std::to_string(kMostTerrainPolygons) + " polygons at this resolution"});
  }
  TerrainMesh mesh(surface);
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      const TerrainCell nw{columns[i], rows[j]}, ne{columns[i + 1], rows[j]}, sw{columns[i], rows[j + 1]},
          se{columns[i + 1], rows[j + 1]};
      const bool falls = (i + j) % 2 == 0;
      mesh.triangle(nw, sw, falls ? se : ne);
      mesh.triangle(falls ? nw : sw, se, ne);
    }
  }
  return mesh.take();
}

}  // namespace scanline
