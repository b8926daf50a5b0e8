// Random frames that look for trouble: slivers, shared edges, penetration, nested and coincident polygons, non-convex
// ones, coordinates at the borders of the frame and at the ends of the number range.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "scanline/frame.h"

namespace vsg_tests {

struct RandomFrame {
  scanline::Frame frame;
  std::string kinds;             ///< what it is made of, for messages
  bool keep_back_faces = false;
};

/// The frame of a seed: at most `lines` scan lines and 40 polygons. The same on every machine.
RandomFrame random_frame(std::uint64_t seed, int lines = 128);

}  // namespace vsg_tests
