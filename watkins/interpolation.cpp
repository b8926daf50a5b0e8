#include "watkins/interpolation.h"

#include <algorithm>
#include <cmath>

namespace watkins {
namespace {

using scanline::FrameVertex;

/// Twice the area, positive where a, b, c run counter-clockwise.
double area(const FrameVertex& a, const FrameVertex& b, const FrameVertex& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

PolygonSurface::PolygonSurface(const scanline::SceneFrame& frame, std::uint32_t polygon)
    : frame_(frame), corners_(frame.frame.polygons[polygon]), first_corner_(frame.first_corner[polygon]) {
  cut();
}

void PolygonSurface::add(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  const std::uint32_t index[3] = {i, j, k};
  const FrameVertex* v[3];
  for (int n = 0; n < 3; ++n) v[n] = &frame_.frame.vertices[corners_[index[n]] - 1];
  const double twice = area(*v[0], *v[1], *v[2]);
  if (twice == 0) return;
  Triangle t;
  for (int n = 0; n < 3; ++n) {
    const FrameVertex &p = *v[(n + 1) % 3], &q = *v[(n + 2) % 3];
    t.k[n] = index[n];
    t.a[n] = (p.y - q.y) / twice;
    t.b[n] = (q.x - p.x) / twice;
    t.c[n] = (p.x * q.y - p.y * q.x) / twice;
  }
  triangles_.push_back(t);
}

/// Ears are cut off one by one: polygons need not be convex.
void PolygonSurface::cut() {
  std::vector<std::uint32_t> left(corners_.size());
  for (std::uint32_t n = 0; n < left.size(); ++n) left[n] = n;
  const auto vertex = [&](std::uint32_t n) -> const FrameVertex& { return frame_.frame.vertices[corners_[n] - 1]; };
  double sum = 0;
  for (std::size_t n = 1; n + 1 < left.size(); ++n) sum += area(vertex(0), vertex(left[n]), vertex(left[n + 1]));
  const double way = sum < 0 ? -1 : 1;
  while (left.size() > 3) {
    std::size_t ear = left.size();
    for (std::size_t n = 0; n < left.size() && ear == left.size(); ++n) {
      const std::uint32_t before = left[(n + left.size() - 1) % left.size()], here = left[n],
                          after = left[(n + 1) % left.size()];
      const FrameVertex &a = vertex(before), &b = vertex(here), &c = vertex(after);
      if (way * area(a, b, c) <= 0) continue;
      const bool blocked = std::any_of(left.begin(), left.end(), [&](std::uint32_t other) {
        const FrameVertex& p = vertex(other);
        const bool corner = corners_[other] == corners_[before] || corners_[other] == corners_[here] ||
                            corners_[other] == corners_[after];
        return !corner && way * area(a, b, p) >= 0 && way * area(b, c, p) >= 0 && way * area(c, a, p) >= 0;
      });
      if (!blocked) ear = n;
    }
    // A polygon that crosses itself, or lies on a line, may have no ear: then any corner will do.
    if (ear == left.size()) ear = 0;
    const std::size_t count = left.size();
    add(left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (left.size() == 3) add(left[0], left[1], left[2]);
}

PolygonSurface::Point PolygonSurface::at(double x, double y) const {
  Point point;
  point.corner[0] = point.corner[1] = point.corner[2] = first_corner_;
  const FrameVertex& first = frame_.frame.vertices[corners_[0] - 1];
  point.w = frame_.w[corners_[0] - 1];
  point.z = first.z;
  // The triangle that the sample lies in, or is least outside of.
  const Triangle* best = nullptr;
  double best_inside = 0, share[3] = {1, 0, 0};
  for (const Triangle& t : triangles_) {
    double s[3];
    for (int n = 0; n < 3; ++n) s[n] = t.a[n] * x + t.b[n] * y + t.c[n];
    const double inside = std::min({s[0], s[1], s[2]});
    if (best && inside <= best_inside) continue;
    best = &t;
    best_inside = inside;
    std::copy_n(s, 3, share);
    if (inside >= 0) break;
  }
  if (!best) return point;  // edge-on
  double sum = 0;
  for (double& s : share) sum += s = std::max(s, 0.0);
  double z = 0, inverse_w = 0;
  for (int n = 0; n < 3; ++n) {
    const std::uint32_t vertex = corners_[best->k[n]] - 1;
    const double s = share[n] / sum;
    z += s * frame_.frame.vertices[vertex].z;
    point.weight[n] = s / frame_.w[vertex];
    inverse_w += point.weight[n];
    point.corner[n] = first_corner_ + best->k[n];
  }
  for (double& weight : point.weight) weight /= inverse_w;
  point.w = 1 / inverse_w;
  point.z = z;
  return point;
}

}  // namespace watkins
