// Several rendering nodes: each is responsible for an effectively random subset of the polygons (Olano and Lastra 1998,
// section 5.1).
#pragma once

#include <cstdint>
#include <vector>

#include "scanline/scene_frame.h"

namespace watkins {

/// The frames of `nodes` rendering nodes. Who gets a polygon depends on the object and the polygon of its mesh, so that
/// a polygon's pieces, and its fellows in the next frame, stay with one node. `numbers`: for each node, the number that
/// each of its polygons has in the whole frame; empty for one node, which has them all.
std::vector<scanline::SceneFrame> share_polygons(scanline::SceneFrame whole, int nodes,
                                                 std::vector<std::vector<std::uint32_t>>& numbers);

}  // namespace watkins
