#include "scanline/clipper.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace scanline {
namespace {

/// Planes 0 to 5: near, far, left, right, bottom, top. Near comes first: after it every w is positive.
constexpr int kAxis[Clipper::kPlanes] = {2, 2, 0, 0, 1, 1};
constexpr double kSide[Clipper::kPlanes] = {-1, 1, -1, 1, -1, 1};

/// Where a chain of inside vertices starts or ends on the plane.
struct LineCrossing {
  double place = 0;
  std::size_t chain = 0;
  bool end = false;
};

/// Puts crossings at the same place in an order in which starts and ends alternate, beginning with an end or a start.
bool alternate(std::vector<LineCrossing>& crossings, bool end_first) {
  bool wanted = end_first;
  for (std::size_t i = 0; i < crossings.size(); ++i, wanted = !wanted) {
    std::size_t j = i;
    while (j < crossings.size() && crossings[j].place == crossings[i].place && crossings[j].end != wanted) ++j;
    if (j == crossings.size() || crossings[j].place != crossings[i].place) return false;
    std::swap(crossings[i], crossings[j]);
  }
  return true;
}

void remove_repeats(ClipLoop& loop) {
  const auto same = [](const ClipCorner& a, const ClipCorner& b) { return a.vertex == b.vertex; };
  loop.erase(std::unique(loop.begin(), loop.end(), same), loop.end());
  while (loop.size() > 1 && same(loop.front(), loop.back())) loop.pop_back();
}

}  // namespace

std::size_t Clipper::CutHash::operator()(const Cut& cut) const {
  std::uint64_t h = (std::uint64_t{cut.low} << 32 | cut.high) * 8 + cut.plane;
  h *= 0x9e3779b97f4a7c15u;
  return h ^ h >> 32;
}

Clipper::Clipper(std::vector<glm::dvec4> clip, std::vector<glm::dvec3> world, std::vector<double> corners, int stride)
    : clip_(std::move(clip)),
      world_(std::move(world)),
      corners_(std::move(corners)),
      stride_(static_cast<std::size_t>(stride)),
      corner_count_(stride > 0 ? static_cast<std::uint32_t>(corners_.size() / stride_) : 0) {
  assert(clip_.size() == world_.size());
  below_.resize(clip_.size());
  not_above_.resize(clip_.size());
  for (std::uint32_t v = 0; v < clip_.size(); ++v) {
    for (std::uint32_t plane = 0; plane < kPlanes; ++plane) {
      const double d = distance(v, plane);
      below_[v] = static_cast<std::uint8_t>(below_[v] | (d < 0) << plane);
      not_above_[v] = static_cast<std::uint8_t>(not_above_[v] | (d <= 0) << plane);
    }
  }
}

double Clipper::distance(std::uint32_t vertex, std::uint32_t plane) const {
  const glm::dvec4& p = clip_[vertex];
  return p.w - kSide[plane] * p[kAxis[plane]];
}

const std::vector<ClipLoop>& Clipper::clip(std::span<const std::uint32_t> polygon, std::uint32_t first_corner) {
  unsigned crossed = 0, missed = (1u << kPlanes) - 1;
  for (const std::uint32_t v : polygon) {
    crossed |= below_[v];
    missed &= not_above_[v];
  }
  if (missed & crossed) {
    loops_.clear();
    return loops_;
  }
  loops_.resize(1);  // most polygons lie inside: the loop's memory serves again
  ClipLoop& loop = loops_[0];
  loop.clear();
  for (std::uint32_t k = 0; k < polygon.size(); ++k) loop.push_back({polygon[k], first_corner + k});
  for (std::uint32_t plane = 0; plane < kPlanes; ++plane) {
    if (!(crossed >> plane & 1)) continue;
    next_loops_.clear();
    for (const ClipLoop& l : loops_) clip_loop(l, plane, next_loops_);
    std::swap(loops_, next_loops_);
  }
  return loops_;
}

void Clipper::clip_loop(const ClipLoop& loop, std::uint32_t plane, std::vector<ClipLoop>& result) {
  const std::size_t n = loop.size();
  bool outside = false;
  std::size_t start = n;  // an inside corner after one that is not
  std::vector<bool> inside(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double d = distance(loop[k].vertex, plane);
    inside[k] = d > 0;
    outside |= d < 0;
  }
  if (!outside) {
    result.push_back(loop);
    return;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (inside[k] && !inside[(k + n - 1) % n]) start = k;
  }
  if (start == n) return;

  // Chains of inside corners, each between the points where the outline comes in and goes out.
  std::vector<ClipLoop> chains;
  for (std::size_t i = 0; i < n; ++i) {
    const ClipCorner &before = loop[(start + i + n - 1) % n], &here = loop[(start + i) % n];
    const bool was_inside = inside[(start + i + n - 1) % n], is_inside = inside[(start + i) % n];
    if (is_inside && !was_inside) chains.push_back({crossing(here, before, plane)});
    if (!is_inside && was_inside) chains.back().push_back(crossing(before, here, plane));
    if (is_inside) chains.back().push_back(here);
  }
  // The walk began after an outside corner and so ends at one: every chain is closed.
  const std::vector<std::size_t> next = link(chains);
  std::vector<bool> used(chains.size());
  for (std::size_t first = 0; first < chains.size(); ++first) {
    ClipLoop piece;
    for (std::size_t c = first; !used[c]; c = next[c]) {
      used[c] = true;
      piece.insert(piece.end(), chains[c].begin(), chains[c].end());
    }
    remove_repeats(piece);
    if (piece.size() >= 3) result.push_back(std::move(piece));
  }
}

ClipCorner Clipper::crossing(const ClipCorner& inside, const ClipCorner& outside, std::uint32_t plane) {
  if (distance(outside.vertex, plane) == 0) return outside;
  const bool inside_is_low = inside.vertex < outside.vertex;
  const ClipCorner &low = inside_is_low ? inside : outside, &high = inside_is_low ? outside : inside;
  const double d_low = distance(low.vertex, plane), d_high = distance(high.vertex, plane);
  const double t = d_low / (d_low - d_high);

  const auto [entry, is_new] =
      cuts_.try_emplace({low.vertex, high.vertex, plane}, static_cast<std::uint32_t>(clip_.size()));
  if (is_new) {
    glm::dvec4 p = glm::mix(clip_[low.vertex], clip_[high.vertex], t);
    p[kAxis[plane]] = kSide[plane] * p.w;
    clip_.push_back(p);
    world_.push_back(glm::mix(world_[low.vertex], world_[high.vertex], t));
  }
  if (stride_ > 0) {
    for (std::size_t i = 0; i < stride_; ++i) {
      corners_.push_back(glm::mix(corners_[low.corner * stride_ + i], corners_[high.corner * stride_ + i], t));
    }
  }
  return {entry->second, corner_count_++};
}

/// For each chain the one that continues its outline along the plane.
std::vector<std::size_t> Clipper::link(const std::vector<ClipLoop>& chains) const {
  std::vector<std::size_t> next(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) next[c] = (c + 1) % chains.size();
  if (chains.size() < 2) return next;

  // The crossings lie on a line: their order along the coordinate in which they are spread most is their order on it.
  const auto projected = [&](const ClipCorner& c) { return glm::dvec3(clip_[c.vertex]) / clip_[c.vertex].w; };
  glm::dvec3 least = projected(chains[0].front()), most = least;
  for (const ClipLoop& chain : chains) {
    for (const glm::dvec3& p : {projected(chain.front()), projected(chain.back())}) {
      least = glm::min(least, p);
      most = glm::max(most, p);
    }
  }
  const glm::dvec3 spread = most - least;
  int axis = spread.x >= spread.y ? 0 : 1;
  if (spread.z > spread[axis]) axis = 2;
  std::vector<LineCrossing> crossings;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    crossings.push_back({projected(chains[c].front())[axis], c, false});
    crossings.push_back({projected(chains[c].back())[axis], c, true});
  }
  std::sort(crossings.begin(), crossings.end(), [](const LineCrossing& a, const LineCrossing& b) {
    return std::pair(a.place, 2 * a.chain + a.end) < std::pair(b.place, 2 * b.chain + b.end);
  });
  // Along the line the polygon's inside begins at crossings of one kind and stops at the other. Where that cannot be
  // had, the polygon crosses itself or is far from planar: the pieces then hang together in the order of the outline.
  if (alternate(crossings, true) || alternate(crossings, false)) {
    for (std::size_t i = 0; i < crossings.size(); i += 2) {
      const LineCrossing &a = crossings[i], &b = crossings[i + 1];
      next[a.end ? a.chain : b.chain] = a.end ? b.chain : a.chain;
    }
  }
  return next;
}

}  // namespace scanline
