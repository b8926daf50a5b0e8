#include "watkins/polygon_share.h"

#include <utility>

namespace watkins {
namespace {

/// The finaliser of splitmix64: every bit of the result depends on every bit of the number.
std::uint64_t mixed(std::uint64_t n) {
  n += 0x9E37'79B9'7F4A'7C15;
  n = (n ^ (n >> 30)) * 0xBF58'476D'1CE4'E5B9;
  n = (n ^ (n >> 27)) * 0x94D0'49BB'1331'11EB;
  return n ^ (n >> 31);
}

}  // namespace

std::vector<scanline::SceneFrame> share_polygons(scanline::SceneFrame whole, int nodes,
                                                 std::vector<std::vector<std::uint32_t>>& numbers) {
  numbers.clear();
  std::vector<scanline::SceneFrame> frames;
  if (nodes == 1) {
    frames.push_back(std::move(whole));
    return frames;
  }
  frames.resize(static_cast<std::size_t>(nodes));
  numbers.resize(frames.size());
  for (scanline::SceneFrame& frame : frames) {
    frame.frame.width = whole.frame.width;
    frame.frame.height = whole.frame.height;
    frame.frame.vertices = whole.frame.vertices;
    frame.world = whole.world;
    frame.w = whole.w;
    frame.first_corner = {0};
    for (const scanline::FrameAttribute& a : whole.attributes) frame.attributes.push_back({a.name, a.components, {}});
  }
  for (std::size_t p = 0; p < whole.polygons.size(); ++p) {
    const scanline::PolygonOrigin& origin = whole.polygons[p];
    const std::size_t node = mixed(std::uint64_t{origin.object} << 32 | origin.polygon) % frames.size();
    scanline::SceneFrame& frame = frames[node];
    numbers[node].push_back(static_cast<std::uint32_t>(p) + 1);
    frame.polygons.push_back(origin);
    frame.first_corner.push_back(frame.first_corner.back() + whole.first_corner[p + 1] - whole.first_corner[p]);
    for (std::size_t k = 0; k < whole.attributes.size(); ++k) {
      const std::vector<double>& from = whole.attributes[k].values;
      const auto components = static_cast<std::ptrdiff_t>(whole.attributes[k].components);
      frame.attributes[k].values.insert(frame.attributes[k].values.end(),
                                        from.begin() + whole.first_corner[p] * components,
                                        from.begin() + whole.first_corner[p + 1] * components);
    }
    frame.frame.polygons.push_back(std::move(whole.frame.polygons[p]));
  }
  return frames;
}

}  // namespace watkins
