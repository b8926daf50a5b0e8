#include "scanline/fields/cell_surface.h"

#include <numeric>

namespace scanline {
namespace {

constexpr int kCorners = 4;

/// Around the face, in the order of its edges: edge k runs between corners k and k + 1.
std::array<int, kCorners> face_corners(int face) {
  const int axis = face / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = (face % 2) << axis;
  return {base, base | u, base | u | v, base | v};
}

bool is_inside(std::uint8_t inside, int corner) { return inside >> corner & 1; }

}  // namespace

std::array<int, 4> face_edges(int face) {
  const std::array<int, kCorners> corners = face_corners(face);
  std::array<int, 4> edges{};
  for (int k = 0; k < kCorners; ++k) {
    const int a = corners[k], b = corners[(k + 1) % kCorners], axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
    const int low = a & b;
    edges[k] = 4 * axis + ((low >> (axis + 1) % 3 & 1) | (low >> (axis + 2) % 3 & 1) << 1);
  }
  return edges;
}

bool is_ambiguous(std::uint8_t inside, int face) {
  const auto c = face_corners(face);
  return is_inside(inside, c[0]) == is_inside(inside, c[2]) && is_inside(inside, c[1]) == is_inside(inside, c[3]) &&
         is_inside(inside, c[0]) != is_inside(inside, c[1]);
}

CellSurface cell_surface(std::uint8_t inside, std::uint8_t joined) {
  // Edges that a face's arc connects belong to one sheet: the cycles are what is connected in the end.
  std::array<int, 12> leader{};
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int edge) {
    while (leader[edge] != edge) edge = leader[edge];
    return edge;
  };
  const auto connect = [&](int a, int b) {
    a = find(a);
    b = find(b);
    leader[a < b ? b : a] = a < b ? a : b;
  };
  for (int face = 0; face < 6; ++face) {
    const auto corners = face_corners(face);
    const auto edges = face_edges(face);
    if (is_ambiguous(inside, face)) {
      // Arcs go around the corners that stay apart: edges k and k + 1 meet in corner k + 1.
      const bool first_inside = is_inside(inside, corners[0]);
      const int apart = first_inside == static_cast<bool>(joined >> face & 1) ? 1 : 0;
      connect(edges[(apart + 3) % 4], edges[apart]);
      connect(edges[apart + 1], edges[apart + 2]);
      continue;
    }
    int crossed[2], count = 0;
    for (int k = 0; k < kCorners; ++k) {
      if (is_inside(inside, corners[k]) != is_inside(inside, corners[(k + 1) % kCorners])) crossed[count++] = edges[k];
    }
    if (count == 2) connect(crossed[0], crossed[1]);
  }
  CellSurface result;
  result.sheet.fill(-1);
  for (int edge = 0; edge < 12; ++edge) {
    const int low = edge_corner(edge), high = low | 1 << edge / 4;
    if (is_inside(inside, low) == is_inside(inside, high)) continue;
    const int first = find(edge);  // the lowest of the cycle, so numbered before the others
    result.sheet[edge] = static_cast<std::int8_t>(first == edge ? result.sheets++ : result.sheet[first]);
  }
  return result;
}

}  // namespace scanline
