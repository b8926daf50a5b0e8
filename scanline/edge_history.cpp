#include "scanline/edge_history.h"

namespace scanline {

std::vector<EdgeHistory::Origin> EdgeHistory::origins(const SceneFrame& frame, const vsg::FrameBlocks& blocks) {
  std::vector<Origin> result;
  result.reserve(blocks.edges.size());
  std::uint32_t polygon = 0, piece = 0, edge_of_polygon = 0;
  for (const vsg::EdgeBlock& edge : blocks.edges) {
    // Edges stand in the order of the polygons that brought them, pieces of a polygon side by side.
    for (; polygon != edge.first_polygon; edge_of_polygon = 0) {
      ++polygon;
      const bool same = polygon > 1 && frame.polygons[polygon - 1].object == frame.polygons[polygon - 2].object &&
                        frame.polygons[polygon - 1].polygon == frame.polygons[polygon - 2].polygon;
      piece = same ? piece + 1 : 0;
    }
    const PolygonOrigin& origin = frame.polygons[polygon - 1];
    result.push_back({origin.object, origin.polygon, piece, edge_of_polygon++});
  }
  return result;
}

void EdgeHistory::mark(const SceneFrame& frame, vsg::FrameBlocks& blocks) const {
  const std::vector<Origin> origin = origins(frame, blocks);
  for (std::size_t i = 0; i < origin.size(); ++i) blocks.edges[i].visible_before = visible_.contains(origin[i]);
}

void EdgeHistory::remember(const SceneFrame& frame, const vsg::FrameBlocks& blocks, const vsg::FrameAnswer& answer) {
  const std::vector<Origin> origin = origins(frame, blocks);
  visible_.clear();
  for (std::size_t i = 0; i < answer.edges_visible.size(); ++i) {
    if (answer.edges_visible[i]) visible_.insert(origin[i]);
  }
}

}  // namespace scanline
