// Frames to measure on, from a seed: the same seed, kind and size make the same frame on every machine.
#pragma once

#include <cstdint>
#include <ostream>

#include "scanline/frame.h"

namespace truth {

enum class FrameKind { kTriangles, kBoxes, kSheets, kStars };

/// Triangles of all sizes; boxes through one another (back faces are rejected); two wavy sheets through one another;
/// non-convex stars, some nested. `polygons` is a wish, the square frame has `size` lines.
scanline::Frame random_frame(FrameKind kind, std::uint64_t seed, int size, int polygons);

/// Boxes alone are solids; the other kinds are seen from both sides.
inline bool keeps_back_faces(FrameKind kind) { return kind != FrameKind::kBoxes; }

/// For the names of tests.
inline void PrintTo(FrameKind kind, std::ostream* out) {
  static constexpr const char* kNames[] = {"triangles", "boxes", "sheets", "stars"};
  *out << kNames[static_cast<int>(kind)];
}

}  // namespace truth
