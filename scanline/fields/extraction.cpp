#include "scanline/fields/extraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "scanline/error.h"
#include "scanline/fields/cell_surface.h"
#include "scanline/fields/flat_merge.h"
#include "scanline/fields/geometry.h"
#include "scanline/fields/plane_fit.h"
#include "scanline/fields/root.h"
#include "scanline/polygon.h"

namespace scanline {
namespace {

using Key = std::uint64_t;

/// How far vertices keep from the walls of their cells, in cells: neighbours' never coincide.
constexpr double kMargin = 1e-3;

/// Flat within this share of a cell counts as flat: the rounding of roots and fits stays far below.
constexpr double kFlat = 1e-7;

/// A vertex outside its room is at most this far from the middle of its cell along each axis, in cells; and polygons
/// with such vertices face the way of the surface at their edge at least as much as this (a cosine).
constexpr double kFarthest = 2, kFacing = 0.5;

/// Part of a cell by which the lattice begins before the field's box. Sides of the box run through the middle of cells
/// or nearly so, and planes at simple fractions of it do not fall on corners, where inside and outside are a matter of
/// rounding.
constexpr double kLead = 0.6180339887498949;

constexpr glm::ivec3 unit(int axis) { return {axis == 0, axis == 1, axis == 2}; }
constexpr glm::ivec3 corner_offset(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

struct Lattice {
  Lattice(const Bounds& box, int cells) {
    const glm::dvec3 size = glm::max(box.high - box.low, 0.0);
    const double longest = std::max({size.x, size.y, size.z});
    for (int k = 0; k < 3; ++k) {
      // Cells fit each side by themselves; they are nearly cubes.
      const int along = std::max(1, static_cast<int>(std::lround(size[k] / longest * cells)));
      step[k] = size[k] > 0 ? size[k] / along : longest / cells;
      count[k] = along + 1;
      origin[k] = box.low[k] - kLead * step[k];
    }
  }

  Key key(const glm::ivec3& c) const { return (Key(c.z) * Key(count.y + 1) + Key(c.y)) * Key(count.x + 1) + Key(c.x); }
  glm::ivec3 corner(Key key) const {
    const Key row = key / Key(count.x + 1);
    return {key % Key(count.x + 1), row % Key(count.y + 1), row / Key(count.y + 1)};
  }
  glm::dvec3 point(const glm::dvec3& c) const { return origin + step * c; }

  glm::dvec3 origin{0}, step{1};
  glm::ivec3 count{1};  ///< of cells
};

struct Cell {
  glm::ivec3 place{0};
  std::uint8_t inside = 0, joined = 0;  ///< as cell_surface wants them
  CellSurface surface;
  std::uint32_t first_vertex = 0;
};

/// The polygon of a crossed edge, outside in front.
struct Quad {
  std::array<std::uint32_t, 4> vertices;
  int axis;           ///< of the edge
  double direction;   ///< 1: the edge leads outwards; -1: inwards
  glm::dvec3 normal;  ///< of the surface where it crosses the edge
};

class Extraction {
 public:
  Extraction(const Field& field, int cells) : field_(field), lattice_(field.bounds(), cells) {}

  Mesh run() {
    find_cells({0, 0, 0}, lattice_.count);
    std::sort(cells_.begin(), cells_.end(),
              [&](const Cell& a, const Cell& b) { return lattice_.key(a.place) < lattice_.key(b.place); });
    for (std::size_t k = 0; k < cells_.size(); ++k) index_.emplace(lattice_.key(cells_[k].place), k);
    complete_cells();
    resolve_faces();
    for (Cell& cell : cells_) make_vertices(cell);
    for (const Cell& cell : cells_) make_quads(cell);
    settle();
    for (const Quad& quad : quads_) add_quad(quad);
    merge_flat(mesh_, kFlat * std::min({lattice_.step.x, lattice_.step.y, lattice_.step.z}));
    return std::move(mesh_);
  }

 private:
  /// Blocks of cells that the surface cannot reach, by the distance from their middle, are left out as a whole.
  void find_cells(const glm::ivec3& low, const glm::ivec3& high) {
    const glm::dvec3 size = lattice_.step * glm::dvec3(high - low);
    const double middle = field_.distance(lattice_.point(glm::dvec3(low + high) / 2.0));
    if (std::abs(middle) > glm::length(size) / 2 * (1 + 1e-9)) return;
    if (high - low == glm::ivec3(1)) return add_cell(low);
    const glm::ivec3 half = (low + high) / 2;
    for (int part = 0; part < 8; ++part) {
      glm::ivec3 from = low, to = high;
      bool is_empty = false;
      for (int k = 0; k < 3; ++k) {
        const bool upper = part >> k & 1, whole = high[k] - low[k] == 1;
        is_empty |= upper && whole;
        if (whole) continue;
        (upper ? from : to)[k] = half[k];
      }
      if (!is_empty) find_cells(from, to);
    }
  }

  void add_cell(const glm::ivec3& place) {
    Cell cell{place, 0, 0, {}, 0};
    for (int k = 0; k < 8; ++k) cell.inside |= static_cast<std::uint8_t>(is_inside(place + corner_offset(k)) << k);
    if (cell.inside != 0 && cell.inside != 0xff) cells_.push_back(cell);
    // A field whose distances are far too small, as those of a fine repetition are, would lead into every cell.
    if (cells_.size() > kMostSurfaceCells || corners_.size() > 8 * kMostSurfaceCells) {
      throw UserError(
          {"", 0, 0, "the field's surface passes more than " + std::to_string(kMostSurfaceCells) + " cells"});
    }
  }

  /// All cells around a crossed edge are there by what distances mean; rounding shall not make an exception.
  void complete_cells() {
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell cell = cells_[k];
      for (int edge = 0; edge < 12; ++edge) {
        const int low = edge_corner(edge), high = low | 1 << edge / 4;
        if ((cell.inside >> low & 1) == (cell.inside >> high & 1)) continue;
        for (int j = 0; j < 4; ++j) {
          const glm::ivec3 place = around(cell.place + corner_offset(low), edge / 4, j);
          if (index_.contains(lattice_.key(place))) continue;
          index_.emplace(lattice_.key(place), cells_.size());
          add_cell(place);
        }
      }
    }
  }

  /// The place of one of the four cells around the edge that starts in a corner: the edge is its own number 4 axis + j.
  static glm::ivec3 around(const glm::ivec3& corner, int axis, int j) {
    return corner - (j & 1) * unit((axis + 1) % 3) - (j >> 1) * unit((axis + 2) % 3);
  }

  /// The lattice's own walls are outside, whatever the field says: the mesh is closed.
  bool is_inside(const glm::ivec3& corner) {
    const auto [entry, is_new] = corners_.try_emplace(lattice_.key(corner), false);
    if (is_new) {
      const bool wall =
          glm::any(glm::equal(corner, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(corner, lattice_.count));
      entry->second = !wall && field_.distance(lattice_.point(corner)) < 0;
    }
    return entry->second;
  }

  /// Decides for each ambiguous face which corners are connected across it: as the field has it in the face's middle.
  /// Where the surface would pass a face twice between the same two sheets, the two vertices would have two edges
  /// between them; the other way round at least one of the sheets falls into two.
  void resolve_faces() {
    for (Cell& cell : cells_) {
      for (int face = 0; face < 6; ++face) {
        if (!is_ambiguous(cell.inside, face)) continue;
        glm::dvec3 middle = glm::dvec3(cell.place) + 0.5;
        middle[face / 2] = cell.place[face / 2] + face % 2;
        const bool joined = field_.distance(lattice_.point(middle)) < 0;
        cell.joined |= static_cast<std::uint8_t>(joined << face);
      }
      cell.surface = cell_surface(cell.inside, cell.joined);
    }
    for (Cell& cell : cells_) {
      for (int face = 1; face < 6; face += 2) {
        if (!is_ambiguous(cell.inside, face)) continue;
        Cell& other = cell_at(cell.place + unit(face / 2));
        if (!is_one_sheet(cell, face) || !is_one_sheet(other, face - 1)) continue;
        cell.joined ^= static_cast<std::uint8_t>(1 << face);
        other.joined ^= static_cast<std::uint8_t>(1 << (face - 1));
        cell.surface = cell_surface(cell.inside, cell.joined);
        other.surface = cell_surface(other.inside, other.joined);
      }
    }
  }

  static bool is_one_sheet(const Cell& cell, int face) {
    const auto edges = face_edges(face);
    return std::all_of(edges.begin(), edges.end(),
                       [&](int e) { return cell.surface.sheet[e] == cell.surface.sheet[edges[0]]; });
  }

  /// One that holds a crossed edge: it is known.
  Cell& cell_at(const glm::ivec3& place) { return cells_[index_.at(lattice_.key(place))]; }

  const Crossing& crossing(const glm::ivec3& low, int axis) {
    const auto [entry, is_new] = crossings_.try_emplace(lattice_.key(low) * 3 + Key(axis));
    if (!is_new) return entry->second;
    const glm::dvec3 from = lattice_.point(low), to = lattice_.point(low + unit(axis));
    const bool inwards = !is_inside(low);
    const auto side = [&](double t) { return field_.distance(glm::mix(from, to, t)) * (inwards ? -1 : 1); };
    entry->second.point = glm::mix(from, to, root(side));
    entry->second.normal = field_.normal(entry->second.point);
    return entry->second;
  }

  /// Where a cell's vertices may be: within it, and in the near half of neighbours behind walls without a crossed edge.
  /// An edge of the solid that enters such a neighbour between its corners would be cut off otherwise. Seen along any
  /// crossed edge vertices still stay in their quadrants.
  Bounds room_of(const Cell& cell) const {
    glm::dvec3 low(kMargin), high(1 - kMargin);
    for (int face = 0; face < 6; ++face) {
      const auto edges = face_edges(face);
      const auto is_crossed = [&](int e) { return cell.surface.sheet[e] >= 0; };
      if (std::any_of(edges.begin(), edges.end(), is_crossed)) continue;
      (face % 2 == 0 ? low : high)[face / 2] += face % 2 - 0.5;
    }
    return {lattice_.point(glm::dvec3(cell.place) + low), lattice_.point(glm::dvec3(cell.place) + high)};
  }

  void make_vertices(Cell& cell) {
    const Bounds room = room_of(cell);
    cell.first_vertex = static_cast<std::uint32_t>(mesh_.positions.size());
    for (int sheet = 0; sheet < cell.surface.sheets; ++sheet) {
      std::vector<Crossing> planes;
      for (int edge = 0; edge < 12; ++edge) {
        if (cell.surface.sheet[edge] != sheet) continue;
        planes.push_back(crossing(cell.place + corner_offset(edge_corner(edge)), edge / 4));
      }
      const PlaneFit fit = fit_planes(planes, room);
      mesh_.positions.push_back(fit.point);
      if (!fit.meeting) continue;
      const glm::dvec3 way = glm::abs(*fit.meeting - lattice_.point(glm::dvec3(cell.place) + 0.5)) / lattice_.step;
      if (std::max({way.x, way.y, way.z}) > kFarthest) continue;
      if (std::abs(field_.distance(*fit.meeting)) >= std::abs(field_.distance(fit.point))) continue;
      moved_.emplace(static_cast<std::uint32_t>(mesh_.positions.size() - 1), *fit.meeting);
    }
  }

  /// The quads of the three edges that start in the cell's lowest corner: one vertex from each cell around an edge.
  void make_quads(const Cell& cell) {
    for (int axis = 0; axis < 3; ++axis) {
      if (cell.surface.sheet[4 * axis] < 0) continue;
      Quad quad{{}, axis, is_inside(cell.place) ? 1.0 : -1.0, crossing(cell.place, axis).normal};
      constexpr std::array<int, 4> kAround{3, 2, 0, 1};  // counter-clockwise, seen from the edge's end
      for (int k = 0; k < 4; ++k) {
        const int j = kAround[k];
        const Cell& beside = cell_at(around(cell.place, axis, j));
        quad.vertices[k] = beside.first_vertex + static_cast<std::uint32_t>(beside.surface.sheet[4 * axis + j]);
      }
      if (quad.direction < 0) std::reverse(quad.vertices.begin(), quad.vertices.end());
      quads_.push_back(quad);
    }
  }

  /// Vertices whose planes meet outside their room go there, unless a polygon would turn over: then those of that
  /// polygon come back, until none does.
  void settle() {
    std::vector<std::size_t> concerned;
    for (std::size_t k = 0; k < quads_.size(); ++k) {
      const auto& v = quads_[k].vertices;
      if (std::any_of(v.begin(), v.end(), [&](std::uint32_t n) { return moved_.contains(n); })) concerned.push_back(k);
    }
    for (auto& [vertex, place] : moved_) std::swap(mesh_.positions[vertex], place);
    bool is_settled = false;
    while (!is_settled) {
      is_settled = true;
      for (const std::size_t k : concerned) {
        if (!turns_over(quads_[k], 0) || !turns_over(quads_[k], 1)) continue;
        for (const std::uint32_t vertex : quads_[k].vertices) {
          const auto entry = moved_.find(vertex);
          if (entry == moved_.end()) continue;
          mesh_.positions[vertex] = entry->second;
          moved_.erase(entry);
          is_settled = false;
        }
      }
    }
    for (const glm::dvec3& p : mesh_.positions) normals_.push_back(field_.normal(p));
  }

  std::array<glm::dvec3, 4> corners(const Quad& quad) const {
    std::array<glm::dvec3, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = mesh_.positions[quad.vertices[k]];
    return p;
  }

  /// The triangles on both sides of the diagonal from corner `from`.
  std::array<std::array<glm::dvec3, 3>, 2> halves(const Quad& quad, int from) const {
    const auto p = corners(quad);
    return {{{p[from], p[from + 1], p[from + 2]}, {p[from], p[from + 2], p[(from + 3) % 4]}}};
  }

  /// True when a triangle of the quad, cut from corner `from`, faces away from the surface at the quad's edge, or has
  /// no area.
  bool turns_over(const Quad& quad, int from) const {
    for (const auto& p : halves(quad, from)) {
      const glm::dvec3 area = newell_vector(p);
      if (!has_area(p) || !(glm::dot(area, quad.normal) > kFacing * glm::length(area))) return true;
    }
    return false;
  }

  /// The same as seen along the edge, where an unmoved vertex is in its own quadrant: one of the diagonals at least
  /// lies inside, then.
  bool folds(const Quad& quad, int from) const {
    const bool has_moved =
        std::any_of(quad.vertices.begin(), quad.vertices.end(), [&](std::uint32_t v) { return moved_.contains(v); });
    if (has_moved) return turns_over(quad, from);
    for (const auto& p : halves(quad, from)) {
      if (!has_area(p) || !(newell_vector(p)[quad.axis] * quad.direction > 0)) return true;
    }
    return false;
  }

  void add_quad(const Quad& quad) {
    const auto& v = quad.vertices;
    const auto p = corners(quad);
    if (has_area(p) && unevenness(p) <= kPlanarTolerance && !crosses_itself(p)) return add_polygon(v);
    const auto error = [&](int k) { return std::abs(field_.distance((p[k] + p[k + 2]) / 2.0)); };
    const int from = folds(quad, 0) ? 1 : folds(quad, 1) ? 0 : error(1) < error(0) ? 1 : 0;
    add_polygon(std::array{v[from], v[from + 1], v[from + 2]});
    add_polygon(std::array{v[from], v[from + 2], v[(from + 3) % 4]});
  }

  void add_polygon(std::span<const std::uint32_t> vertices) {
    glm::dvec3 middle{0};
    for (const std::uint32_t v : vertices) middle += mesh_.positions[v] / static_cast<double>(vertices.size());
    if (mesh_.attributes.empty()) mesh_.attributes.push_back({"normal", 3, {}});
    for (const std::uint32_t v : vertices) {
      // On an edge of the solid every side has a normal of its own: the field's, a little way into the polygon.
      const glm::dvec3 aside = field_.normal(glm::mix(mesh_.positions[v], middle, 0.1));
      const glm::dvec3 normal = glm::dot(aside, normals_[v]) < 0.9 ? aside : normals_[v];
      mesh_.attributes[0].values.insert(mesh_.attributes[0].values.end(), {normal.x, normal.y, normal.z});
    }
    mesh_.polygons.emplace_back(vertices.begin(), vertices.end());
  }

  const Field& field_;
  Lattice lattice_;
  std::vector<Cell> cells_;  ///< those that the surface passes, in the order of their keys
  std::unordered_map<Key, std::size_t> index_;
  std::unordered_map<Key, bool> corners_;
  std::unordered_map<Key, Crossing> crossings_;
  std::map<std::uint32_t, glm::dvec3> moved_;  ///< vertices outside their rooms, and their places inside
  std::vector<Quad> quads_;
  std::vector<glm::dvec3> normals_;  ///< one a vertex
  Mesh mesh_;
};

}  // namespace

Mesh extract_surface(const Field& field, int cells) {
  const Bounds box = field.bounds();
  if (!is_finite(box) || !glm::any(glm::greaterThan(box.high, box.low))) return {};
  return Extraction(field, std::clamp(cells, kFewestCells, kMostCells)).run();
}

MeasuredSurface extract_within(const Field& field, double error) {
  MeasuredSurface best;
  best.error.largest = best.error.missed = kInfinite;
  for (int cells = 8; cells <= kMostCells; cells += cells / 2) {
    Mesh mesh;
    try {
      mesh = extract_surface(field, cells);
    } catch (const UserError&) {
      break;
    }
    if (mesh.polygons.empty()) continue;
    if (mesh.polygons.size() > kMostPolygons) break;
    const FieldError reached = measure(field, mesh);
    if (reached.worst() < best.error.worst()) best = {std::move(mesh), cells, reached};
    if (best.error.worst() <= error) break;
  }
  return best;
}

}  // namespace scanline
