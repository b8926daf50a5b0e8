// A frame as the oracle sees it: its own reader, its own numbers. Nothing here is shared with the golden model, the
// RTL or the maker of edge blocks, so that a misreading of theirs cannot be repeated.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstdint>
#include <istream>
#include <vector>

namespace truth {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;  ///< an exact rational

struct ExactFrame {
  int width = 0, height = 0;
  std::vector<std::array<double, 3>> vertices;       ///< doubles are exact: they are what the file says
  std::vector<std::vector<std::uint32_t>> polygons;  ///< vertex indices from 0
};

/// Reads a frame file; throws std::runtime_error with a line number when it cannot.
ExactFrame read_exact_frame(std::istream& in);

/// One polygon's part on a scan line: it covers the pixels p with left < p <= right, and its depth runs linearly.
struct Cut {
  std::uint32_t polygon = 0;  ///< from 1
  Number left, left_z, right, right_z;

  bool covers(int pixel) const { return left < pixel && pixel <= right; }
  Number depth_at(int pixel) const;
};

/// Cuts polygons with the planes of scan lines.
class Cutter {
 public:
  /// Polygons whose vertices do not run clockwise are left out unless `keep_back_faces`.
  Cutter(const ExactFrame& frame, bool keep_back_faces);

  /// All cuts of scan line `line`: an edge is present on the lines int(its least y) < line <= int(its greatest y);
  /// its crossings are paired from left to right.
  std::vector<Cut> cuts(int line) const;

 private:
  struct Shown {
    std::uint32_t polygon;
    int first_line, last_line;
  };

  const ExactFrame& frame_;
  std::vector<Shown> shown_;
};

}  // namespace truth
