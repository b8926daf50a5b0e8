// Digital elevation models: rectangles of heights, as the memo's digital terrain models (Strat 1978, "Shaded
// Perspective Images of Terrain").
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace scanline {

/// Heights in metres at the centres of cells, row 0 in the north, column 0 in the west; NaN where the height is
/// missing, never infinite.
struct Elevation {
  int columns = 0, rows = 0;
  glm::dvec2 cell_size{1};  ///< metres, to the east and to the south
  std::vector<float> heights;

  float at(int column, int row) const {
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
  }
  bool known(int column, int row) const { return at(column, row) == at(column, row); }
};

/// Slopes (rise over run) to the east and to the north in a cell, by Horn's weights of its eight neighbours. Beyond the
/// border heights go on as they come; a missing neighbour mirrors the one across from it, and differences that are not
/// known for all that are left out of the weighted mean. The cell itself is known, and there are two rows and columns
/// at least.
glm::dvec2 gradient(const Elevation& elevation, int column, int row);

/// Gives heights to missing cells, from the known ones inwards: each ring of cells gets the mean of the neighbours (of
/// eight) that were known before it. Nothing is done when no cell is known.
void fill_missing(Elevation& elevation);

}  // namespace scanline
