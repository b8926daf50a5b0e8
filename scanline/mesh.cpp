#include "scanline/mesh.h"

#include <bit>
#include <cassert>

#include "scanline/polygon.h"

namespace scanline {

std::vector<std::uint32_t> first_corners(const PolygonList& polygons) {
  std::vector<std::uint32_t> first;
  first.reserve(polygons.size() + 1);
  std::uint32_t corners = 0;
  for (const auto& polygon : polygons) {
    first.push_back(corners);
    corners += static_cast<std::uint32_t>(polygon.size());
  }
  first.push_back(corners);
  return first;
}

std::size_t MeshBuilder::PositionHash::operator()(const std::array<double, 3>& p) const {
  std::uint64_t h = 0;
  for (const double value : p) {
    h = (h ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

MeshBuilder::MeshBuilder(std::vector<Attribute> attributes) {
  for (Attribute& a : attributes) {
    stride_ += a.components;
    mesh_.attributes.push_back({std::move(a.name), a.components, {}});
  }
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position) {
  // Adding zero turns -0 into +0: they are equal and must hash alike.
  const std::array<double, 3> key{position.x + 0.0, position.y + 0.0, position.z + 0.0};
  const auto [entry, is_new] = index_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (is_new) mesh_.positions.emplace_back(key[0], key[1], key[2]);
  return entry->second;
}

void MeshBuilder::polygon(std::span<const std::uint32_t> vertices, std::span<const double> corners) {
  assert(corners.size() == vertices.size() * static_cast<std::size_t>(stride_));
  std::vector<std::uint32_t> kept;
  std::vector<std::size_t> sources;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (vertices[k] == vertices[(k + 1) % vertices.size()]) continue;
    kept.push_back(vertices[k]);
    sources.push_back(k);
  }
  if (kept.size() < 3) return;
  std::vector<glm::dvec3> points;
  points.reserve(kept.size());
  for (const std::uint32_t v : kept) points.push_back(mesh_.positions[v]);
  // The halves of a bow tie may cancel to nothing, yet it covers something: the scene warns of it.
  if (!has_area(points) && !crosses_itself(points)) return;

  for (const std::size_t k : sources) {
    auto value = corners.begin() + static_cast<std::ptrdiff_t>(k) * stride_;
    for (MeshAttribute& a : mesh_.attributes) {
      a.values.insert(a.values.end(), value, value + a.components);
      value += a.components;
    }
  }
  mesh_.polygons.push_back(std::move(kept));
}

}  // namespace scanline
