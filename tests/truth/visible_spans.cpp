#include "tests/truth/visible_spans.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Envelope_diagram_1.h>
#include <CGAL/envelope_2.h>

#include <algorithm>
#include <cmath>

namespace truth {
namespace {

using Traits = CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, std::uint32_t>;
using Diagram = CGAL::Envelope_diagram_1<Traits>;

// The greatest whole number that is less than x (strictly) or at most x.
int whole_below(const Number& x, bool strictly) {
  int n = static_cast<int>(std::floor(CGAL::to_double(x)));
  while (Number(n + 1) < x || (!strictly && Number(n + 1) == x)) ++n;
  while (Number(n) > x || (strictly && Number(n) == x)) --n;
  return n;
}

// Where an end or a crossing falls on the sample itself the envelope's cells do not say whose the pixel is.
std::vector<std::uint32_t> nearest_at(const std::vector<Cut>& cuts, int pixel) {
  std::vector<std::uint32_t> nearest;
  Number least;
  for (const Cut& cut : cuts) {
    if (!cut.covers(pixel)) continue;
    const Number depth = cut.depth_at(pixel);
    if (!nearest.empty() && depth > least) continue;
    if (nearest.empty() || depth < least) nearest.clear();
    least = depth;
    nearest.push_back(cut.polygon);
  }
  return nearest;
}

class SpanList {
 public:
  explicit SpanList(int width) : width_(width) {}

  void add(int last, std::vector<std::uint32_t> polygons) {
    last = std::min(last, width_);
    if (last <= at_) return;
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    if (!spans_.empty() && spans_.back().polygons == polygons) {
      spans_.back().last = last;
    } else {
      spans_.push_back({at_ + 1, last, std::move(polygons)});
    }
    at_ = last;
  }
  std::vector<VisibleSpan> take() { return std::move(spans_); }

 private:
  int width_, at_ = 0;
  std::vector<VisibleSpan> spans_;
};

}  // namespace

std::vector<VisibleSpan> visible_spans(const std::vector<Cut>& cuts, int width) {
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const Cut& cut : cuts) {
    const Kernel::Segment_2 segment({cut.left, cut.left_z}, {cut.right, cut.right_z});
    curves.emplace_back(segment, cut.polygon);
  }
  Diagram envelope;
  CGAL::lower_envelope_x_monotone_2(curves.begin(), curves.end(), envelope);

  SpanList spans(width);
  auto edge = envelope.leftmost();
  while (edge != envelope.rightmost()) {
    const auto vertex = edge->right();
    const Number& x = vertex->point().x();
    std::vector<std::uint32_t> polygons;
    for (auto curve = edge->curves_begin(); curve != edge->curves_end(); ++curve) polygons.push_back(curve->data());
    spans.add(whole_below(x, true), std::move(polygons));
    const int on_vertex = whole_below(x, false);
    spans.add(on_vertex, nearest_at(cuts, on_vertex));
    edge = vertex->right();
  }
  spans.add(width, {});
  return spans.take();
}

}  // namespace truth
