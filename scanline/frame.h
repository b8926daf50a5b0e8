// The frame: screen coordinates after all transformation, perspective and clipping (chapter II). What `vsg frame`
// writes, what `vsg segments` reads, and what `vsg render` goes on from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "cmodel/vsg/blocks.h"
#include "scanline/error.h"

namespace scanline {

struct FrameVertex {
  double x = 0, y = 0, z = 0;  ///< 1 <= x < width, 0 <= y < height, |z| < 2^16, a smaller z is nearer
};

struct Frame {
  int width = 0, height = 0;
  std::vector<FrameVertex> vertices;
  /// Vertex numbers from 1, three or more a polygon, clockwise when it faces the viewer.
  std::vector<std::vector<std::uint32_t>> polygons;
};

/// Reads a frame file (format: docs/formats.md). `name` is used in messages. Throws UserError.
Frame read_frame(std::istream& in, const std::string& name);
Frame read_frame_file(const std::filesystem::path& path);

/// Writes one; numbers round-trip exactly.
void write_frame(std::ostream& out, const Frame& frame);

/// Makes edge and polygon blocks (figure 4). Edges are numbered polygon by polygon and shared by the first two
/// different polygons that use a vertex pair. Throws UserError when the frame has more blocks than the machine's memories.
vsg::FrameBlocks make_blocks(const Frame& frame, const vsg::Parameters& parameters, bool keep_back_faces);

}  // namespace scanline
