#include "tests/nodes/node_differences.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

#include "tests/nodes/line_cuts.h"
#include "watkins/renderer.h"

namespace nodes {
namespace {

// What truncated slopes (18 fraction bits, stepped over many lines) may add to a difference of depths.
constexpr double kRounding = 1.0 / (1 << 18);
// A unit of the depth that is composed, in depths of the frame.
constexpr double kUnit = scanline::kDepthRange / 4294967295.0;

/// Which polygon of the whole frame each pixel of the picture shows, row by row.
std::vector<std::uint32_t> shown_by(const vsg::FrameAnswer& answer, const std::vector<std::uint32_t>* numbers) {
  const int width = answer.width - 2, height = answer.height - 1;
  std::vector<std::uint32_t> shown(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  int line = 0, pixel = 1;
  for (const vsg::VisibleSegment& segment : answer.segments) {
    if (segment.y != line) pixel = 1;
    line = segment.y;
    const std::uint32_t polygon = segment.polygon == 0 || !numbers ? segment.polygon : (*numbers)[segment.polygon - 1];
    for (; pixel <= segment.x_end; ++pixel) {
      const int column = pixel - 2, row = height - line;
      if (column < 0 || column >= width || row < 0 || row >= height) continue;
      shown[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] =
          polygon;
    }
  }
  return shown;
}

/// One scan line's pixels.
class LineJudge {
 public:
  LineJudge(const scanline::SceneFrame& frame, const scanline::Scene& scene, int line)
      : frame_(frame), scene_(scene), cuts_(frame.frame, line), slack_(kRounding * frame.frame.height) {}

  /// `nodes`: what each of them shows.
  Difference judge(int pixel, std::uint32_t one, std::uint32_t many, const std::vector<std::uint32_t>& nodes) const {
    const LineCut *a = cuts_.covering(one, pixel), *b = cuts_.covering(many, pixel);
    if (a && b && std::abs(a->depth(pixel) - b->depth(pixel)) <= kUnit) return Difference::kTie;
    std::vector<std::uint32_t> all = nodes;
    all.push_back(one);
    if (std::ranges::any_of(all, [&](std::uint32_t p) { return is_field(p); })) return Difference::kSurface;
    if (std::ranges::any_of(all, [&](std::uint32_t p) { return starts(p, pixel); })) return Difference::kStart;
    if (a && b && close(*a, *b, pixel)) return Difference::kDepth;
    if (a && b) {
      for (const std::uint32_t third : cuts_.polygons()) {
        const LineCut* c = cuts_.covering(third, pixel);
        if (c && close(*a, *c, pixel) && close(*b, *c, pixel)) return Difference::kChain;
      }
    }
    for (const std::uint32_t p : {one, many}) {
      if (p != 0 && std::ranges::any_of(
                        cuts_.of(p), [&](const LineCut& c) { return near(c.left, pixel) || near(c.right, pixel); })) {
        return Difference::kEdge;
      }
    }
    return Difference::kOther;
  }

  /// Whether what the picture shows is the closest of what the nodes show, the most upstream of equal ones. Polygons
  /// that do not cover the sample have no depth of their own there and are taken at their word.
  bool composed_right(int pixel, std::uint32_t shown, const std::vector<std::uint32_t>& nodes, float depth) const {
    const auto found = std::ranges::find(nodes, shown);
    if (shown == 0) return std::ranges::all_of(nodes, [](std::uint32_t p) { return p == 0; });
    if (found == nodes.end()) return false;
    const LineCut* own = is_field(shown) ? nullptr : cuts_.covering(shown, pixel);
    // The picture's channel is a float; where the polygon tells its depth, that is compared with it.
    const double rounding = depth * std::ldexp(1, -23) + 1e-6, bent = own ? bend(shown) : 0;
    if (own && std::abs(own->depth(pixel) - depth) > rounding + bent) return false;
    const double closest = own && bent < rounding ? own->depth(pixel) : depth - rounding;
    return std::ranges::all_of(nodes, [&](std::uint32_t p) {
      const LineCut* cut = p == 0 || is_field(p) ? nullptr : cuts_.covering(p, pixel);
      return !cut || p == shown || cut->depth(pixel) >= closest - kUnit - bend(p);
    });
  }

 private:
  bool is_field(std::uint32_t p) const {
    return p != 0 && scene_.objects[frame_.polygons[p - 1].object].field != nullptr;
  }
  /// By how much depths within a polygon depend on how it is cut into triangles: 0 but for uneven ones.
  double bend(std::uint32_t p) const {
    const std::vector<std::uint32_t>& corners = frame_.frame.polygons[p - 1];
    const auto at = [&](std::size_t k) { return frame_.frame.vertices[corners[k] - 1]; };
    const auto area = [](const auto& a, const auto& b, const auto& c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    std::size_t third = 2;
    for (std::size_t k = 3; k < corners.size(); ++k) {
      if (std::abs(area(at(0), at(1), at(k))) > std::abs(area(at(0), at(1), at(third)))) third = k;
    }
    const auto a = at(0), b = at(1), c = at(third);
    const double all = area(a, b, c);
    double largest = 0;
    for (std::size_t k = 2; k < corners.size() && all != 0; ++k) {
      const auto d = at(k);
      const double plane = (area(d, b, c) * a.z + area(a, d, c) * b.z + area(a, b, d) * c.z) / all;
      largest = std::max(largest, std::abs(d.z - plane));
    }
    return 2 * largest;
  }
  bool starts(std::uint32_t p, int pixel) const {
    if (p == 0 || cuts_.covering(p, pixel)) return false;
    return std::ranges::any_of(cuts_.of(p), [&](const LineCut& c) { return pixel <= c.left && c.left < pixel + 1; });
  }
  bool close(const LineCut& a, const LineCut& b, int pixel) const {
    return std::abs(a.depth(pixel) - b.depth(pixel)) <= (a.slope() + b.slope()) * (1 + slack_) + 2 * slack_;
  }
  bool near(double x, int pixel) const { return std::abs(x - pixel) <= 1 + slack_; }

  const scanline::SceneFrame& frame_;
  const scanline::Scene& scene_;
  LineCuts cuts_;
  double slack_;
};

}  // namespace

std::int64_t Comparison::total() const { return std::accumulate(differing.begin(), differing.end(), std::int64_t{0}); }

Pictures render(const scanline::Scene& scene, const std::string& scene_file, int nodes, int threads) {
  watkins::RenderOptions options;
  options.generator.vsg = "model";
  options.pixels.level = "macro";
  options.threads = threads;
  options.channels = true;
  const double moment = scene.first_frame;
  Pictures pictures;
  pictures.nodes = nodes;
  watkins::VisibleFrame alone = watkins::Renderer(scene, scene_file, options).find_visible(moment);
  pictures.one = shown_by(alone.answers[0], nullptr);
  pictures.frame = std::move(alone.frames[0]);

  options.rendering_nodes = nodes;
  watkins::Renderer renderer(scene, scene_file, options);
  watkins::VisibleFrame visible = renderer.find_visible(moment);
  for (std::size_t k = 0; k < visible.answers.size(); ++k) {
    pictures.each.push_back(shown_by(visible.answers[k], visible.numbers.empty() ? nullptr : &visible.numbers[k]));
  }
  watkins::RenderedFrame rendered = renderer.shade(std::move(visible));
  pictures.composed = std::move(rendered.picture.channels->polygon);
  pictures.depths = std::move(rendered.picture.channels->depth);
  return pictures;
}

Comparison compare(const scanline::Scene& scene, const Pictures& pictures) {
  Comparison result;
  const auto note = [&](const char* what, int column, int row, std::size_t at) {
    if (!result.first.empty()) return;
    std::ostringstream text;
    text << what << " at column " << column << ", row " << row << ": polygon " << pictures.one[at] << " with one node, "
         << pictures.composed[at] << " with " << pictures.nodes << ", which show";
    for (const auto& node : pictures.each) text << ' ' << node[at];
    result.first = text.str();
  };
  std::vector<std::uint32_t> each(pictures.each.size());
  std::size_t at = 0;
  for (int row = 0; row < scene.height; ++row) {
    const LineJudge judge(pictures.frame, scene, scene.height - row);
    for (int column = 0; column < scene.width; ++column, ++at) {
      const int pixel = column + 2;
      const std::uint32_t one = pictures.one[at], many = pictures.composed[at];
      for (std::size_t k = 0; k < each.size(); ++k) each[k] = pictures.each[k][at];
      ++result.pixels;
      result.covered += one != 0 || many != 0;
      if (!judge.composed_right(pixel, many, each, pictures.depths[at])) {
        ++result.composed_wrong;
        note("composed wrong", column, row, at);
      }
      if (one == many) continue;
      const Difference kind = judge.judge(pixel, one, many, each);
      ++result.differing[static_cast<std::size_t>(kind)];
      if (kind == Difference::kOther) note("no reason", column, row, at);
    }
  }
  return result;
}

}  // namespace nodes
