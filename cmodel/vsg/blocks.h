// The blocks of figure 4 that pre-frame processing hands to the Visible Segment Generator, and what comes out of it.
//
// Fixed point: X has `fraction_bits_x` fraction bits, Z `fraction_bits_z` (18 by default); both are signed words of
// `integer_bits` + fraction bits, kept sign extended in 64. Scan line n samples at y = n, line 1 is the lowest.
// Polygons, edges and segment blocks are numbered from 1; 0 stands for none.
#pragma once

#include <cstdint>
#include <vector>

#include "vsg_parameters.h"  // made by the build from rtl/vsg/vsg_parameters.svh

namespace vsg {

/// Widths and sizes of one machine. The defaults are those of the RTL.
struct Parameters {
  int fraction_bits_x = kFractionBitsX;
  int fraction_bits_z = kFractionBitsZ;
  int integer_bits = kIntegerBits;
  std::uint32_t segment_blocks = kSegmentBlocks;
  std::uint32_t edge_blocks = kEdgeBlocks;
  std::uint32_t polygon_blocks = kPolygonBlocks;
  int memory_cycle_ns = kMemoryCycleNs;
  /// Chapter IV: edges that were visible where they entered in the frame before are sample points there. Golden model only.
  bool frame_coherence = false;
};

/// Polygon block (figure 4). The fields reserved for the processor live in the processor.
struct PolygonBlock {
  bool front = false;  ///< its vertices run clockwise on the screen (or back faces are kept)
};

/// Edge block (figure 4). `x` and `z` are the values at scan line `first_line`.
struct EdgeBlock {
  std::uint32_t first_polygon = 0;   ///< the polygon that brought the edge
  std::uint32_t second_polygon = 0;  ///< the polygon that shares it, or 0; it enters first
  std::int32_t first_line = 0;       ///< int(Y min) + 1
  std::int32_t lines = 0;            ///< scan lines on which the edge is present; 0: horizontal, rejected
  std::int64_t x = 0, dx = 0;        ///< X at first_line and its increment a scan line
  std::int64_t z = 0, dz = 0;
  bool visible_before = false;       ///< visible, in the frame before, on the line it entered on (frame coherence)
};

/// All that the processor is given for one frame.
struct FrameBlocks {
  int width = 0, height = 0;
  std::vector<PolygonBlock> polygons;
  std::vector<EdgeBlock> edges;
};

/// One entry of the output: `polygon` is visible on line `y` up to and including pixel `x_end`, from where the
/// entry before it ended (from pixel 1 for the first of a line). Polygon 0 is background.
struct VisibleSegment {
  std::int32_t y = 0;
  std::int32_t x_end = 0;
  std::uint32_t polygon = 0;
  bool operator==(const VisibleSegment&) const = default;
};

}  // namespace vsg
