// A region on its way through the nodes (Olano and Lastra 1998, sections 5.1, 6.1.5.2 and 6.2.1): rendering nodes put
// their pixels into their elements' packets, the composition network keeps the closest, a shading node rebuilds
// positions, shades, and sends colours to the frame buffer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/instance.h"
#include "pixelflow/shading/stream_cache.h"
#include "pixelflow/shading/texture_memory.h"

namespace pfman {

/// Depth that no pixel has: the background's.
constexpr std::uint32_t kFarthest = 0xFFFF'FFFF;

/// The pixels of one region that one rendering node shows; index: pixel, in order of row, then column.
struct RegionPixels {
  std::vector<std::uint8_t> columns, rows;  ///< of the region's 128 x 64, row 0 at the top
  /// Linear on the screen: 0 in the near plane, kFarthest in the far plane, less than that for every pixel.
  std::vector<std::uint32_t> depth;
  int packets = 1;  ///< that every pixel sends, 1 to kMostPackets
  /// packets * kPacketPayload bytes a pixel: the element's memory from kShaderIdAt on. Shader ID and parameters by the
  /// transfer map of the pixel's shader, zero behind them.
  std::vector<std::uint8_t> payload;
};

/// How places on the screen and depths become positions in eye space: the eye at the origin, looking along -z.
/// Column and row are those of samples of the whole picture, row 0 at the top. How exact positions are is said in
/// region_programs.h.
struct EyeSpace {
  bool perspective = true;
  double near = 0.1, far = 100;
  /// x of the middle of column 0 and its step a column, y of row 0 and its (negative) step a row: at distance 1 from
  /// the eye in a perspective view, at all distances in an orthographic one.
  double x0 = 0, dx = 0, y0 = 0, dy = 0;
};

/// Counts of one region's work, cycles by the array's counters. They depend on the region's pixels alone, not on who
/// worked it, with which thread, or at which level.
struct RegionCounts {
  int pixels = 0;               ///< elements that something covers
  int sources = 0;              ///< rendering nodes that show something
  int packets = 0;              ///< a pixel, of the composition network from one node to the next
  int executions = 0;           ///< surfaces: instances with equal values run once
  int shared = 0;               ///< of these, with their light added up by a common stream
  std::uint64_t compose = 0;    ///< cycles of all rendering nodes: from memory into packets
  std::uint64_t receive = 0;    ///< shading node: from packets into memory
  std::uint64_t pre_shade = 0;  ///< positions
  std::uint64_t pre = 0, illum = 0, post = 0, lights = 0;
  std::uint64_t send = 0;     ///< colours into packets
  std::uint64_t lookups = 0;  ///< texture lookups, a region each

  /// What the shading node spends on the region.
  std::uint64_t shading() const { return receive + pre_shade + pre + illum + post + lights + send; }
  friend bool operator==(const RegionCounts&, const RegionCounts&) = default;
};

/// What all regions of a frame share: instances, lights, textures, the view, and the streams made for them. Regions are
/// worked by any number of threads at once.
class FrameShading {
 public:
  /// Throws std::invalid_argument as ShadingNode does, and for a view without depth or of numbers beyond 1e30.
  /// `textures` may be null; `cache` outlives the frame, and keeps its streams from frame to frame. Instances have the
  /// same order in every frame.
  FrameShading(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures,
               const EyeSpace& eye, StreamCache& cache);
  ~FrameShading();

 private:
  friend class RegionNode;
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

/// An array with its node's host: works regions one after another, first in the part of the rendering nodes, then as
/// the shading node (all nodes are alike).
class RegionNode {
 public:
  /// `array` has at least as many elements as the regions to come have pixels.
  explicit RegionNode(std::unique_ptr<pixelflow::PixelArray> array);

  struct Result {
    /// Places that something covers, in order of row and column, and their colours (U(8,8) each).
    std::vector<std::uint8_t> columns, rows;
    std::vector<std::array<std::uint8_t, 3>> colors;
    /// The rendering node whose pixel was the closest, by its index in `sources`.
    std::vector<std::uint8_t> source;
    RegionCounts counts;
  };
  /// `first_column`, `first_row`: the region's upper left sample in the picture, multiples of the region's size.
  /// `sources`: rendering nodes, the most upstream first; equal depths go to upstream. A pixel whose shader ID no
  /// surface has gets no colour in particular. Throws UniformError, and std::invalid_argument for pixels that are not
  /// as RegionPixels says or more than the array has elements for.
  Result work(FrameShading& frame, int first_column, int first_row, std::span<const RegionPixels> sources);

 private:
  std::unique_ptr<pixelflow::PixelArray> array_;
};

}  // namespace pfman
