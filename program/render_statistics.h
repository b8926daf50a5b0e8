// What `vsg render --stats` writes of a frame.
#pragma once

#include <nlohmann/json.hpp>

#include "watkins/renderer.h"

namespace program {

/// Counters of the Visible Segment Generator (summed over the rendering nodes, lines of all of them), of regions and
/// shading nodes, and what they would mean for the real machines. `writing`: seconds.
nlohmann::ordered_json frame_statistics(int moment, const watkins::RenderedFrame& frame, int shading_nodes,
                                        double writing);

}  // namespace program
