#include "scanline/fields/triangle_tree.h"

#include <algorithm>
#include <numeric>

#include "scanline/polygon.h"

namespace scanline {
namespace {

constexpr std::uint32_t kLeaf = 4;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts off one ear after the other.
void triangulate(const std::vector<std::uint32_t>& polygon, const Mesh& mesh, std::vector<Triangle>& triangles) {
  std::vector<glm::dvec3> points;
  for (const std::uint32_t v : polygon) points.push_back(mesh.positions[v]);
  const glm::dvec3 normal = newell_vector(points), size = glm::abs(normal);
  int dropped = size.x > size.y ? 0 : 1;
  if (size.z > size[dropped]) dropped = 2;
  int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(u, v);
  const auto flat = [&](std::size_t k) { return glm::dvec2(points[k][u], points[k][v]); };

  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  const auto cut = [&](std::size_t k) {
    const std::size_t n = left.size();
    triangles.push_back({polygon[left[(k + n - 1) % n]], polygon[left[k]], polygon[left[(k + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  };
  while (left.size() > 3) {
    const std::size_t n = left.size();
    const auto is_ear = [&](std::size_t k) {
      const std::size_t before = left[(k + n - 1) % n], here = left[k], after = left[(k + 1) % n];
      const glm::dvec2 a = flat(before), b = flat(here), c = flat(after);
      if (!(turn(a, b, c) > 0)) return false;
      return std::none_of(left.begin(), left.end(), [&](std::size_t other) {
        if (polygon[other] == polygon[before] || polygon[other] == polygon[here] || polygon[other] == polygon[after]) {
          return false;
        }
        const glm::dvec2 p = flat(other);
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
      });
    };
    std::size_t ear = 0;
    while (ear < n && !is_ear(ear)) ++ear;
    cut(ear < n ? ear : 1);  // none: the polygon touches or crosses itself
  }
  cut(1);
}

}  // namespace

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& polygon : mesh.polygons) {
    if (polygon.size() == 3) {
      triangles.push_back({polygon[0], polygon[1], polygon[2]});
    } else if (polygon.size() > 3) {
      triangulate(polygon, mesh, triangles);
    }
  }
  return triangles;
}

TriangleTree::TriangleTree(std::vector<glm::dvec3> positions, std::vector<Triangle> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  if (triangles_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<glm::dvec3> centers;
  for (const Triangle& t : triangles_) {
    centers.push_back((positions_[t[0]] + positions_[t[1]] + positions_[t[2]]) / 3.0);
  }
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()), centers);
}

std::array<glm::dvec3, 3> TriangleTree::corners(std::uint32_t triangle) const {
  const Triangle& t = triangles_[triangle];
  return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
}

void TriangleTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, std::vector<glm::dvec3>& centers) {
  Bounds box{glm::dvec3(kInfinite), glm::dvec3(-kInfinite)}, middles = box;
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const glm::dvec3& p : corners(order_[k])) {
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
    middles.low = glm::min(middles.low, centers[order_[k]]);
    middles.high = glm::max(middles.high, centers[order_[k]]);
  }
  nodes_[node].box = box;
  if (end - begin <= kLeaf) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const glm::dvec3 spread = middles.high - middles.low;
  int axis = spread.y > spread.x ? 1 : 0;
  if (spread.z > spread[axis]) axis = 2;
  // Half of them on each side, whatever their places: the depth is bounded. Equal ones by number, for the same tree.
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centers[a][axis] != centers[b][axis] ? centers[a][axis] < centers[b][axis] : a < b;
                   });
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = first;
  nodes_.resize(nodes_.size() + 2);
  build(first, begin, half, centers);
  build(first + 1, half, end, centers);
}

std::optional<TriangleTree::Nearest> TriangleTree::nearest(const glm::dvec3& point, double limit) const {
  std::optional<Nearest> best;
  if (nodes_.empty()) return best;
  double least2 = limit * limit;
  const auto distance2 = [&](std::uint32_t node) {
    const glm::dvec3 outside = from_box(nodes_[node].box, point);
    return glm::dot(outside, outside);
  };
  struct Waiting {
    std::uint32_t node;
    double distance2;
  };
  std::array<Waiting, 64> stack;  // one a level: the tree is balanced
  std::size_t height = 0;
  stack[height++] = {0, distance2(0)};
  while (height > 0) {
    const Waiting next = stack[--height];
    if (next.distance2 > least2) continue;
    const Node& node = nodes_[next.node];
    if (node.count == 0) {
      Waiting near{node.first, distance2(node.first)}, far{node.first + 1, distance2(node.first + 1)};
      if (far.distance2 < near.distance2) std::swap(near, far);
      stack[height++] = far;
      stack[height++] = near;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const TrianglePoint place = nearest_on_triangle(corners(order_[k]), point);
      const double d2 = glm::dot(point - place.point, point - place.point);
      if (d2 > least2 || (best && d2 == least2)) continue;
      least2 = d2;
      best = Nearest{order_[k], place, 0};
    }
  }
  if (best) best->distance = glm::length(point - best->place.point);
  return best;
}

}  // namespace scanline
