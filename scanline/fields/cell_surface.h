// How the surface passes through a cell of a lattice, known by which of its corners are inside: one sheet for every
// cycle of crossed edges, as dual marching cubes has it (Nielson 2004).
#pragma once

#include <array>
#include <cstdint>

namespace scanline {

/// Corner k of a cell is at (k & 1, k >> 1 & 1, k >> 2 & 1). Edge 4 a + j runs along axis a from the j-th of the four
/// corners that are low there, in the order of (a + 1, a + 2) = (0, 0), (1, 0), (0, 1), (1, 1).
constexpr int edge_corner(int edge) {
  const int axis = edge / 4, j = edge % 4;
  return (j & 1) << (axis + 1) % 3 | (j >> 1) << (axis + 2) % 3;
}

/// The four edges around a face, side by side. Face 2 a + s is the one across axis a at its low (0) or high (1) end.
std::array<int, 4> face_edges(int face);

/// True when two corners of the face on one diagonal are inside, and the two on the other are not.
bool is_ambiguous(std::uint8_t inside, int face);

struct CellSurface {
  int sheets = 0;
  std::array<std::int8_t, 12> sheet{};  ///< of each edge; -1: the surface does not cross it
};

/// `inside`: a bit a corner. `joined`: a bit a face; on an ambiguous one the corners inside are connected across the
/// face, otherwise those outside are.
CellSurface cell_surface(std::uint8_t inside, std::uint8_t joined);

}  // namespace scanline
