// One texture lookup for all surfaces of the flag (Olano and Lastra 1998, section 6.1.5.3).
//
// Each surface's first stage ends or stands still with coordinates in memory. They go into the outbound packets, which
// the enable flag guards, so that one Send carries those of all surfaces and one answer comes back. No memory is
// needed.
#pragma once

#include <span>
#include <vector>

#include "pixelflow/compiler/generate.h"

namespace pfman {

/// Pixels of a shader that stands before its shared lookup.
struct TextureUser {
  const std::vector<int>* ids = nullptr;
  const Lookup* lookup = nullptr;  ///< shared
};

/// Puts the coordinates of one surface's pixels into their outbound packets, as own lookups do; afterwards the enable
/// flag is set in these pixels.
pixelflow::Program put_coordinates(const TextureUser& user);
/// Sends the packets.
pixelflow::Program send_coordinates();
/// Takes the answer, for all surfaces.
pixelflow::Program take_texels(std::span<const TextureUser> users);

}  // namespace pfman
