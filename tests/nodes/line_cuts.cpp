#include "tests/nodes/line_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nodes {
namespace {

using scanline::FrameVertex;

bool faces_us(const scanline::Frame& frame, const std::vector<std::uint32_t>& polygon) {
  double clockwise = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const FrameVertex &a = frame.vertices[polygon[k] - 1], &b = frame.vertices[polygon[(k + 1) % polygon.size()] - 1];
    clockwise += b.x * a.y - a.x * b.y;
  }
  return clockwise > 0;
}

}  // namespace

double LineCut::slope() const { return std::abs((right_z - left_z) / (right - left)); }

LineCuts::LineCuts(const scanline::Frame& frame, int line) : cuts_(frame.polygons.size()) {
  struct Crossing {
    double x, z, slope;
  };
  std::vector<Crossing> crossings;
  for (std::size_t p = 0; p < frame.polygons.size(); ++p) {
    const std::vector<std::uint32_t>& polygon = frame.polygons[p];
    crossings.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const FrameVertex* low = &frame.vertices[polygon[k] - 1];
      const FrameVertex* high = &frame.vertices[polygon[(k + 1) % polygon.size()] - 1];
      if (low->y > high->y) std::swap(low, high);
      // An edge is there on the lines int(its least y) < line <= int(its greatest y).
      if (line <= std::floor(low->y) || line > std::floor(high->y)) continue;
      const double height = high->y - low->y, way = (line - low->y) / height;
      crossings.push_back(
          {low->x + way * (high->x - low->x), low->z + way * (high->z - low->z), (high->x - low->x) / height});
    }
    if (crossings.empty() || !faces_us(frame, polygon)) continue;
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x != b.x ? a.x < b.x : a.slope < b.slope; });
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const Crossing &a = crossings[k], &b = crossings[k + 1];
      if (a.x < b.x) cuts_[p].push_back({a.x, b.x, a.z, b.z});
    }
    if (!cuts_[p].empty()) polygons_.push_back(static_cast<std::uint32_t>(p + 1));
  }
}

const LineCut* LineCuts::covering(std::uint32_t polygon, int pixel) const {
  if (polygon == 0) return nullptr;
  for (const LineCut& cut : of(polygon)) {
    if (cut.covers(pixel)) return &cut;
  }
  return nullptr;
}

}  // namespace nodes
