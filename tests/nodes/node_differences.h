// Several rendering nodes against one: each node's Visible Segment Generator sees fewer polygons, and what they show is
// composed by depth. Where that changes a pixel, there has to be a reason.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"

namespace nodes {

/// Why a pixel shows another polygon than with one node; in the order in which they are tried.
enum class Difference : std::uint8_t {
  kTie,      ///< both have the same 32 bits of depth: the node upstream wins
  kSurface,  ///< a distance field's polygon: nodes compare what it stands for, the generator its polygons
  kStart,    ///< a polygon shown begins right of the sample, inside the pixel that follows: it fills the first pixel of
             ///< a span, with one node or with its own, and has no depth there of its own
  kDepth,    ///< both cover the pixel, their depths differ by no more than one pixel's worth of both slopes: the
             ///< generator leaves that open, composition does not
  kChain,    ///< the same by way of a third polygon
  kEdge,     ///< an edge of one of the two lies within a pixel: slopes are truncated
  kOther,    ///< none of these: an error of ours
};
constexpr std::array<std::string_view, 7> kDifferenceNames{"tie",   "surface", "start", "depth",
                                                           "chain", "edge",    "other"};

struct Comparison {
  std::int64_t pixels = 0, covered = 0;  ///< covered: with one node or with several
  std::array<std::int64_t, kDifferenceNames.size()> differing{};
  /// Pixels that do not show the closest of what the nodes show, by depths computed apart from the program's.
  std::int64_t composed_wrong = 0;
  std::string first;  ///< of those that must not be: `other`, and those composed wrong

  std::int64_t total() const;
  std::int64_t of(Difference kind) const { return differing[static_cast<std::size_t>(kind)]; }
};

/// What the pixels of a picture show, row by row: polygons of the whole frame, 0 for the background.
struct Pictures {
  int nodes = 1;
  scanline::SceneFrame frame;                    ///< with all polygons
  std::vector<std::uint32_t> one;                ///< with one rendering node
  std::vector<std::vector<std::uint32_t>> each;  ///< of several, the most upstream first
  std::vector<std::uint32_t> composed;           ///< the picture of all of them
  std::vector<float> depths;                     ///< its channel Z
};

/// Renders the scene's first frame with one and with `nodes` rendering nodes, a sample a pixel.
Pictures render(const scanline::Scene& scene, const std::string& scene_file, int nodes, int threads);

Comparison compare(const scanline::Scene& scene, const Pictures& pictures);

}  // namespace nodes
