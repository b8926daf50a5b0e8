#include "scanline/fields/mesh_field.h"

#include <map>
#include <unordered_map>

#include "scanline/fields/geometry.h"
#include "scanline/fields/triangle_tree.h"

namespace scanline::fields {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

double volume(const std::vector<glm::dvec3>& positions, const std::vector<Triangle>& triangles) {
  double sum = 0;
  const glm::dvec3 origin = positions.empty() ? glm::dvec3(0) : positions[0];
  for (const Triangle& t : triangles) {
    sum += glm::dot(positions[t[0]] - origin, glm::cross(positions[t[1]] - origin, positions[t[2]] - origin));
  }
  return sum;
}

class MeshField final : public Field {
 public:
  explicit MeshField(TriangleTree tree)
      : tree_(std::move(tree)), vertex_normals_(tree_.positions().size(), glm::dvec3(0)) {
    const auto& triangles = tree_.triangles();
    const auto& positions = tree_.positions();
    std::unordered_map<std::uint64_t, glm::dvec3> edges;
    for (const Triangle& t : triangles) {
      face_normals_.push_back(
          unit_or(glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]), glm::dvec3(0)));
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
        edges[key(std::min(a, b), std::max(a, b))] += face_normals_.back();
        const glm::dvec3 to_b = unit_or(positions[b] - positions[a], glm::dvec3(0));
        const glm::dvec3 to_c = unit_or(positions[c] - positions[a], glm::dvec3(0));
        vertex_normals_[a] += face_normals_.back() * std::acos(std::clamp(glm::dot(to_b, to_c), -1.0, 1.0));
      }
    }
    for (const Triangle& t : triangles) {
      auto& normals = edge_normals_.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        normals[k] = edges.at(key(std::min(a, b), std::max(a, b)));
      }
    }
  }

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    const auto nearest = tree_.nearest(p);
    if (!nearest) return glm::length(from_box(tree_.bounds(), p));  // so far away that squares are infinite
    return glm::dot(p - nearest->place.point, surface_normal(*nearest)) < 0 ? -nearest->distance : nearest->distance;
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    const auto nearest = tree_.nearest(p);
    if (!nearest) return unit_or(p, {0, 1, 0});
    const glm::dvec3 of_surface = surface_normal(*nearest), away = p - nearest->place.point;
    // Next to the surface the difference is mostly rounding.
    const glm::dvec3 size = tree_.bounds().high - tree_.bounds().low;
    if (nearest->distance < 1e-9 * glm::length(size)) return unit_or(of_surface, {0, 1, 0});
    return unit_or(glm::dot(away, of_surface) < 0 ? -away : away, {0, 1, 0});
  }

  Bounds bounds() const override { return tree_.bounds(); }

 private:
  glm::dvec3 surface_normal(const TriangleTree::Nearest& nearest) const {
    const int feature = nearest.place.feature;
    if (feature == TrianglePoint::kFace) return face_normals_[nearest.triangle];
    if (feature < TrianglePoint::kA) return edge_normals_[nearest.triangle][feature - TrianglePoint::kEdgeAb];
    return vertex_normals_[tree_.triangles()[nearest.triangle][feature - TrianglePoint::kA]];
  }

  TriangleTree tree_;
  std::vector<glm::dvec3> face_normals_, vertex_normals_;
  std::vector<std::array<glm::dvec3, 3>> edge_normals_;
};

}  // namespace

std::string mesh_fault(const Mesh& mesh) {
  std::map<Edge, int> edges;
  for (const auto& polygon : mesh.polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  std::size_t open = 0;
  for (const auto& [edge, balance] : edges) open += balance != 0;
  if (mesh.polygons.empty()) return "the mesh has no polygon";
  if (open > 0) {
    return "the mesh is not closed: " + std::to_string(open) + " of its " + std::to_string(edges.size()) +
           " edges have no polygon on one side";
  }
  return {};
}

FieldPointer mesh_field(const Mesh& mesh) {
  std::vector<Triangle> triangles = triangles_of(mesh);
  if (volume(mesh.positions, triangles) < 0) {
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  }
  return std::make_shared<MeshField>(TriangleTree(mesh.positions, std::move(triangles)));
}

}  // namespace scanline::fields
