// What frame-to-frame coherence (chapter IV) remembers of the frame before: which edges were visible on the scan line they
// entered on. Edges are known again by where they come from, as their numbers change when the clipper cuts otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <set>

#include "cmodel/vsg/answer.h"
#include "scanline/scene_frame.h"

namespace scanline {

class EdgeHistory {
 public:
  /// Marks the edges of a frame that were visible in the frame before.
  void mark(const SceneFrame& frame, vsg::FrameBlocks& blocks) const;

  /// Remembers which edges the processor found visible.
  void remember(const SceneFrame& frame, const vsg::FrameBlocks& blocks, const vsg::FrameAnswer& answer);

 private:
  /// Object, polygon of its mesh, piece of that polygon after clipping, edge of the piece.
  using Origin = std::array<std::uint32_t, 4>;
  static std::vector<Origin> origins(const SceneFrame& frame, const vsg::FrameBlocks& blocks);

  std::set<Origin> visible_;
};

}  // namespace scanline
