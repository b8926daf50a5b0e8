#include "scanline/fields/flat_merge.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_map>
#include <unordered_set>

#include "scanline/polygon.h"

namespace scanline {
namespace {

using Vertex = std::uint32_t;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Neighbours may turn by no more than this (a cosine), however small they are.
constexpr double kSameWay = 0.999;

/// Polygons of more sides than these do not lose their area with a vertex.
constexpr std::uint32_t kFew = 8;

std::uint64_t directed(Vertex from, Vertex to) { return std::uint64_t{from} << 32 | to; }

/// A corner of a polygon that is being made: `source` is the mesh's corner whose attributes it keeps.
struct LoopCorner {
  Vertex vertex;
  std::uint32_t source;
};
using Loop = std::vector<LoopCorner>;

/// A simple loop of vertices to which polygons are added.
class Patch {
 public:
  /// True when the polygon touches the loop along one path of edges and nowhere else; then it is part of the patch.
  bool add(const std::vector<Vertex>& polygon, std::uint32_t first_corner) {
    const std::size_t n = polygon.size();
    const auto vertex = [&](std::size_t k) { return polygon[k % n]; };
    const auto source = [&](std::size_t k) { return first_corner + static_cast<std::uint32_t>(k % n); };
    if (next_.empty()) {
      start_ = polygon[0];
      for (std::size_t k = 0; k < n; ++k) next_[vertex(k)] = {vertex(k + 1), source(k)};
      return true;
    }
    const auto is_shared = [&](std::size_t k) {
      const auto to = next_.find(vertex(k + 1));
      return to != next_.end() && to->second.vertex == vertex(k);
    };
    std::size_t shared = 0, paths = 0, from = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (!is_shared(k)) continue;
      ++shared;
      if (is_shared(k + n - 1)) continue;
      ++paths;
      from = k;
    }
    if (paths != 1) return false;
    for (std::size_t k = shared + 1; k < n; ++k) {
      if (next_.contains(vertex(from + k))) return false;
    }
    if (next_.size() + n < 2 * shared + 3) return false;  // less than a triangle would be left
    // From the end of the shared path the loop now takes the polygon's other edges, back to the path's beginning.
    for (std::size_t k = 1; k < shared; ++k) next_.erase(vertex(from + k));
    start_ = vertex(from);
    for (std::size_t k = shared; k < n; ++k) {
      next_.try_emplace(vertex(from + k), LoopCorner{kNone, source(from + k)});
      next_[vertex(from + k)].vertex = vertex(from + k + 1);
    }
    return true;
  }

  Loop loop() const {
    Loop result;
    Vertex v = start_;
    do {
      const LoopCorner& c = next_.at(v);
      result.push_back({v, c.source});
      v = c.vertex;
    } while (v != start_);
    return result;
  }

 private:
  Vertex start_ = 0;                             ///< a vertex of the loop
  std::unordered_map<Vertex, LoopCorner> next_;  ///< after each vertex of the loop the next one; and its own corner
};

class FlatMerge {
 public:
  FlatMerge(Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance), first_(first_corners(mesh.polygons)) {}

  void run() {
    gather_patches();
    absorb_slivers();
    straighten();
    rebuild();
  }

 private:
  std::vector<glm::dvec3> points(const Loop& loop) const {
    std::vector<glm::dvec3> result;
    for (const LoopCorner& c : loop) result.push_back(mesh_.positions[c.vertex]);
    return result;
  }

  void gather_patches() {
    const PolygonList& polygons = mesh_.polygons;
    std::unordered_map<std::uint64_t, std::uint32_t> owners;
    std::vector<glm::dvec3> normals;
    std::vector<glm::dvec3> corners;
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
      corners.clear();
      for (std::size_t k = 0; k < polygons[p].size(); ++k) {
        owners[directed(polygons[p][k], polygons[p][(k + 1) % polygons[p].size()])] = p;
        corners.push_back(mesh_.positions[polygons[p][k]]);
      }
      // Without area there is no normal: such a polygon joins no other.
      const glm::dvec3 normal = newell_vector(corners);
      normals.push_back(has_area(corners) ? normal / glm::length(normal) : glm::dvec3(0));
    }
    std::vector<bool> is_taken(polygons.size(), false);
    for (std::uint32_t seed = 0; seed < polygons.size(); ++seed) {
      if (is_taken[seed]) continue;
      const glm::dvec3 origin = mesh_.positions[polygons[seed][0]], normal = normals[seed];
      const auto is_flat = [&](std::uint32_t p) {
        if (p == seed) return true;
        if (!(glm::dot(normals[p], normal) > kSameWay)) return false;
        return std::all_of(polygons[p].begin(), polygons[p].end(), [&](Vertex v) {
          return std::abs(glm::dot(mesh_.positions[v] - origin, normal)) <= tolerance_;
        });
      };
      Patch patch;
      std::vector<std::uint32_t> members;
      std::deque<std::uint32_t> candidates{seed};
      while (!candidates.empty()) {
        const std::uint32_t p = candidates.front();
        candidates.pop_front();
        if (is_taken[p] || !is_flat(p) || !patch.add(polygons[p], first_[p])) continue;
        is_taken[p] = true;
        members.push_back(p);
        for (std::size_t k = 0; k < polygons[p].size(); ++k) {
          const auto beside = owners.find(directed(polygons[p][(k + 1) % polygons[p].size()], polygons[p][k]));
          if (beside != owners.end() && !is_taken[beside->second]) candidates.push_back(beside->second);
        }
      }
      add_patch(patch.loop(), members);
    }
  }

  /// Polygons of one plane; on their own where their outline would not do.
  void add_patch(Loop loop, const std::vector<std::uint32_t>& members) {
    if (members.size() > 1 && !crosses_itself(points(loop))) return loops_.push_back(std::move(loop));
    for (const std::uint32_t p : members) {
      Loop& own = loops_.emplace_back();
      for (std::size_t k = 0; k < mesh_.polygons[p].size(); ++k) {
        own.push_back({mesh_.polygons[p][k], first_[p] + static_cast<std::uint32_t>(k)});
      }
    }
  }

  /// Three vertices on one line, as they come about along an edge of the solid, are no polygon: the middle one becomes
  /// a vertex of the neighbour along the longest side.
  void absorb_slivers() {
    std::vector<std::size_t> slivers;
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      if (loops_[k].size() == 3 && !has_area(points(loops_[k]))) slivers.push_back(k);
    }
    if (slivers.empty()) return;
    std::unordered_map<std::uint64_t, std::size_t> owners;
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      for (std::size_t c = 0; c < loops_[k].size(); ++c) {
        owners[directed(loops_[k][c].vertex, loops_[k][(c + 1) % loops_[k].size()].vertex)] = k;
      }
    }
    for (const std::size_t k : slivers) {
      if (loops_[k].size() != 3) continue;  // became a neighbour's neighbour
      const auto p = points(loops_[k]);
      std::size_t longest = 0;
      const auto length = [&](std::size_t c) { return glm::length(p[(c + 1) % 3] - p[c]); };
      for (std::size_t c = 1; c < 3; ++c) {
        if (length(c) > length(longest)) longest = c;
      }
      const Vertex from = loops_[k][longest].vertex, to = loops_[k][(longest + 1) % 3].vertex;
      const Vertex middle = loops_[k][(longest + 2) % 3].vertex;
      const std::size_t neighbour = owners.at(directed(to, from));
      Loop& loop = loops_[neighbour];
      const auto place = [&](Vertex v) {
        return std::find_if(loop.begin(), loop.end(), [&](const LoopCorner& c) { return c.vertex == v; });
      };
      if (place(middle) == loop.end()) {
        const std::uint32_t source = place(to)->source;
        loop.insert(place(to) + 1, {middle, source});
        owners[directed(to, middle)] = owners[directed(middle, from)] = neighbour;
      } else if (loop.size() > 3 && owners.at(directed(from, middle)) == neighbour) {
        loop.erase(place(from));  // a spike of the neighbour, which runs along the line and back
        owners[directed(to, middle)] = neighbour;
      } else if (loop.size() > 3 && owners.at(directed(middle, to)) == neighbour) {
        loop.erase(place(to));
        owners[directed(middle, from)] = neighbour;
      } else {
        continue;
      }
      loops_[k].clear();
    }
    std::erase_if(loops_, [](const Loop& loop) { return loop.empty(); });
  }

  /// A vertex of two polygons alone, on a line between its neighbours, leaves both.
  void straighten() {
    // Corners as rings, so that a vertex leaves without a search.
    struct Ring {
      std::uint32_t polygon, previous, next;
    };
    std::vector<Ring> ring;
    std::vector<Vertex> vertex_of;
    std::vector<std::uint32_t> sides;
    std::vector<std::vector<std::uint32_t>> uses(mesh_.positions.size());
    std::unordered_set<std::uint64_t> edges;
    for (std::uint32_t p = 0; p < loops_.size(); ++p) {
      const auto n = static_cast<std::uint32_t>(loops_[p].size()), base = static_cast<std::uint32_t>(ring.size());
      sides.push_back(n);
      for (std::uint32_t k = 0; k < n; ++k) {
        ring.push_back({p, base + (k + n - 1) % n, base + (k + 1) % n});
        vertex_of.push_back(loops_[p][k].vertex);
        uses[loops_[p][k].vertex].push_back(base + k);
        edges.insert(directed(loops_[p][k].vertex, loops_[p][(k + 1) % n].vertex));
      }
    }
    std::vector<bool> is_gone(ring.size(), false);
    for (Vertex v = 0; v < uses.size(); ++v) {
      if (uses[v].size() != 2) continue;
      const std::uint32_t a = uses[v][0], b = uses[v][1];
      const Vertex before = vertex_of[ring[a].previous], after = vertex_of[ring[a].next];
      if (ring[a].polygon == ring[b].polygon || vertex_of[ring[b].next] != before ||
          vertex_of[ring[b].previous] != after) {
        continue;
      }
      if (sides[ring[a].polygon] <= 3 || sides[ring[b].polygon] <= 3) continue;
      if (edges.contains(directed(before, after)) || edges.contains(directed(after, before))) continue;
      if (!is_between(mesh_.positions[v], mesh_.positions[before], mesh_.positions[after])) continue;
      // A polygon no wider than the tolerance would be left without area.
      const auto keeps_area = [&](std::uint32_t c) {
        if (sides[ring[c].polygon] > kFew) return true;
        std::vector<glm::dvec3> rest;
        for (std::uint32_t k = ring[c].next; k != c; k = ring[k].next) rest.push_back(mesh_.positions[vertex_of[k]]);
        return has_area(rest);
      };
      if (!keeps_area(a) || !keeps_area(b)) continue;
      for (const std::uint32_t c : {a, b}) {
        ring[ring[c].previous].next = ring[c].next;
        ring[ring[c].next].previous = ring[c].previous;
        --sides[ring[c].polygon];
        is_gone[c] = true;
      }
      edges.insert({directed(before, after), directed(after, before)});
    }
    std::size_t c = 0;
    for (Loop& loop : loops_) {
      std::erase_if(loop, [&](const LoopCorner&) { return is_gone[c++]; });
    }
  }

  bool is_between(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) const {
    const glm::dvec3 line = b - a;
    const double length2 = glm::dot(line, line), t = glm::dot(p - a, line);
    if (!(length2 > 0) || t <= 0 || t >= length2) return false;
    return glm::length(p - a - line * (t / length2)) <= tolerance_;
  }

  void rebuild() {
    Mesh result;
    for (const MeshAttribute& a : mesh_.attributes) result.attributes.push_back({a.name, a.components, {}});
    std::vector<Vertex> numbers(mesh_.positions.size(), kNone);
    for (const Loop& loop : loops_) {
      std::vector<Vertex>& polygon = result.polygons.emplace_back();
      for (const LoopCorner& c : loop) {
        if (numbers[c.vertex] == kNone) {
          numbers[c.vertex] = static_cast<Vertex>(result.positions.size());
          result.positions.push_back(mesh_.positions[c.vertex]);
        }
        polygon.push_back(numbers[c.vertex]);
        for (std::size_t k = 0; k < mesh_.attributes.size(); ++k) {
          const auto n = static_cast<std::ptrdiff_t>(mesh_.attributes[k].components);
          const auto from = mesh_.attributes[k].values.begin() + n * static_cast<std::ptrdiff_t>(c.source);
          result.attributes[k].values.insert(result.attributes[k].values.end(), from, from + n);
        }
      }
    }
    mesh_ = std::move(result);
  }

  Mesh& mesh_;
  double tolerance_;
  std::vector<std::uint32_t> first_;
  std::vector<Loop> loops_;
};

}  // namespace

void merge_flat(Mesh& mesh, double tolerance) { FlatMerge(mesh, tolerance).run(); }

}  // namespace scanline
