// Edge and polygon blocks of a frame (chapter II, figure 4). Doubles end here: what follows is integer.
#include <cmath>
#include <unordered_map>

#include "cmodel/vsg/fixed.h"
#include "scanline/frame.h"

namespace scanline {
namespace {

using Wide = __int128;

/// Twice the signed area on the screen; positive when the vertices run clockwise (x right, y up).
double clockwise_area(const Frame& frame, const std::vector<std::uint32_t>& polygon) {
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const FrameVertex& a = frame.vertices[polygon[k] - 1];
    const FrameVertex& b = frame.vertices[polygon[(k + 1) % polygon.size()] - 1];
    area -= (a.x - b.x) * (a.y + b.y);
  }
  return area;
}

/// A coordinate and its increment a scan line, as the edge block holds them.
struct Stepped {
  std::int64_t value = 0, step = 0;
};

/// `distance`: from the lower end up to the first scan line. A nearly horizontal edge crosses one line at most, so a step
/// that does not fit the word is clamped after the value at that line is known: nothing is added to it again.
Stepped stepped(double low, double high, double rise, double distance, const vsg::WordFormat& format) {
  const double one = std::ldexp(1.0, format.fraction);
  const auto step = static_cast<Wide>(((high - low) / rise) * one);
  const auto ahead = static_cast<Wide>(distance * one);
  const Wide value = static_cast<Wide>(low * one) + ((step * ahead) >> format.fraction);
  const Wide limit = format.greatest();
  const Wide clamped = step > limit ? limit : step < -limit - 1 ? -limit - 1 : step;
  return {static_cast<std::int64_t>(value), static_cast<std::int64_t>(clamped)};
}

vsg::EdgeBlock make_edge(const FrameVertex& a, const FrameVertex& b, std::uint32_t polygon, const vsg::Parameters& p) {
  const bool up = static_cast<std::int64_t>(a.y) < static_cast<std::int64_t>(b.y);
  const FrameVertex& low = up ? a : b;
  const FrameVertex& high = up ? b : a;
  vsg::EdgeBlock edge;
  edge.first_polygon = polygon;
  edge.first_line = static_cast<std::int32_t>(low.y) + 1;
  edge.lines = static_cast<std::int32_t>(high.y) - static_cast<std::int32_t>(low.y);
  if (edge.lines == 0) return edge;
  const double rise = high.y - low.y, distance = edge.first_line - low.y;
  const vsg::WordFormat x_format{p.integer_bits + p.fraction_bits_x, p.fraction_bits_x};
  const vsg::WordFormat z_format{p.integer_bits + p.fraction_bits_z, p.fraction_bits_z};
  const Stepped x = stepped(low.x, high.x, rise, distance, x_format);
  const Stepped z = stepped(low.z, high.z, rise, distance, z_format);
  edge.x = x.value, edge.dx = x.step, edge.z = z.value, edge.dz = z.step;
  return edge;
}

}  // namespace

vsg::FrameBlocks make_blocks(const Frame& frame, const vsg::Parameters& parameters, bool keep_back_faces) {
  vsg::FrameBlocks blocks;
  blocks.width = frame.width;
  blocks.height = frame.height;
  if (frame.polygons.size() > parameters.polygon_blocks) {
    throw UserError({"", 0, 0, "the frame has " + std::to_string(frame.polygons.size()) + " polygons, polygon memory holds " +
                                   std::to_string(parameters.polygon_blocks)});
  }
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> edges_of;  // vertex pair -> edge indices, in order
  for (std::size_t i = 0; i < frame.polygons.size(); ++i) {
    const auto& polygon = frame.polygons[i];
    const auto number = static_cast<std::uint32_t>(i + 1);
    blocks.polygons.push_back({keep_back_faces || clockwise_area(frame, polygon) > 0});
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      if (a == b) continue;
      auto& candidates = edges_of[std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)];
      vsg::EdgeBlock* shared = nullptr;
      for (const std::uint32_t e : candidates) {
        vsg::EdgeBlock& edge = blocks.edges[e];
        if (edge.second_polygon == 0 && edge.first_polygon != number) shared = &edge;
        if (shared != nullptr) break;
      }
      if (shared != nullptr) {
        shared->second_polygon = number;
        continue;
      }
      candidates.push_back(static_cast<std::uint32_t>(blocks.edges.size()));
      blocks.edges.push_back(make_edge(frame.vertices[a - 1], frame.vertices[b - 1], number, parameters));
    }
  }
  if (blocks.edges.size() > parameters.edge_blocks) {
    throw UserError({"", 0, 0, "the frame has " + std::to_string(blocks.edges.size()) + " edges, edge memory holds " +
                                   std::to_string(parameters.edge_blocks)});
  }
  return blocks;
}

}  // namespace scanline
