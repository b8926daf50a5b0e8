#include "tests/truth/comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/truth/visible_spans.h"

namespace truth {
namespace {

// What truncated slopes (18 fraction bits, stepped over many lines) may add to a difference of depths.
constexpr double kRounding = 1.0 / (1 << 18);

double slope(const Cut& cut) { return std::abs(CGAL::to_double((cut.right_z - cut.left_z) / (cut.right - cut.left))); }

class LineJudge {
 public:
  LineJudge(const std::vector<Cut>& cuts, int height) : cuts_(cuts), slack_(kRounding * height) {}

  Difference judge(int pixel, std::uint32_t shown, const std::vector<std::uint32_t>& right) const {
    const Cut* front = right.empty() ? nullptr : covering(right.front(), pixel);
    const Cut* ours = covering(shown, pixel);
    if (front && ours) {
      if (close(*front, *ours, pixel)) return Difference::kDepth;
      for (const Cut& third : cuts_) {
        if (third.covers(pixel) && close(third, *front, pixel) && close(third, *ours, pixel)) return Difference::kChain;
      }
    }
    for (const Cut& cut : cuts_) {
      if (cut.polygon != shown) continue;
      if (pixel <= cut.left && cut.left < pixel + 1) return Difference::kStart;
      if (pixel == 1 && 2 <= cut.left && cut.left < 3) return Difference::kLeft;
    }
    for (const Cut& cut : cuts_) {
      const bool one_of_them =
          cut.polygon == shown || std::find(right.begin(), right.end(), cut.polygon) != right.end();
      if (one_of_them && (near(cut.left, pixel) || near(cut.right, pixel))) return Difference::kEdge;
    }
    return Difference::kOther;
  }

 private:
  const Cut* covering(std::uint32_t polygon, int pixel) const {
    for (const Cut& cut : cuts_) {
      if (cut.polygon == polygon && cut.covers(pixel)) return &cut;
    }
    return nullptr;
  }
  bool close(const Cut& a, const Cut& b, int pixel) const {
    const double apart = std::abs(CGAL::to_double(a.depth_at(pixel) - b.depth_at(pixel)));
    return apart <= (slope(a) + slope(b)) * (1 + slack_) + 2 * slack_;
  }
  bool near(const Number& x, int pixel) const { return std::abs(CGAL::to_double(x) - pixel) <= 1 + slack_; }

  const std::vector<Cut>& cuts_;
  double slack_;
};

}  // namespace

std::int64_t Comparison::wrong_total() const { return std::accumulate(wrong.begin(), wrong.end(), std::int64_t{0}); }

Comparison& Comparison::operator+=(const Comparison& other) {
  pixels += other.pixels;
  covered += other.covered;
  ties += other.ties;
  for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i] += other.wrong[i];
  longest_run = std::max(longest_run, other.longest_run);
  return *this;
}

Comparison compare(const ExactFrame& frame, bool keep_back_faces, const std::vector<vsg::VisibleSegment>& answer) {
  Comparison result;
  const Cutter cutter(frame, keep_back_faces);
  auto segment = answer.begin();
  for (int line = 1; line <= frame.height; ++line) {
    std::vector<std::uint32_t> shown(static_cast<std::size_t>(frame.width) + 1, 0);
    for (int pixel = 1; segment != answer.end() && segment->y == line; ++segment) {
      for (; pixel <= std::min<int>(segment->x_end, frame.width); ++pixel) shown[pixel] = segment->polygon;
    }
    const std::vector<Cut> cuts = cutter.cuts(line);
    const LineJudge judge(cuts, frame.height);
    int run = 0;
    for (const VisibleSpan& span : visible_spans(cuts, frame.width)) {
      for (int pixel = span.first; pixel <= span.last; ++pixel) {
        ++result.pixels;
        result.covered += !span.polygons.empty();
        result.ties += span.polygons.size() > 1;
        const bool is_right = span.polygons.empty() ? shown[pixel] == 0
                                                    : std::find(span.polygons.begin(), span.polygons.end(),
                                                                shown[pixel]) != span.polygons.end();
        run = is_right ? 0 : run + 1;
        if (is_right) continue;
        ++result.wrong[static_cast<std::size_t>(judge.judge(pixel, shown[pixel], span.polygons))];
        result.longest_run = std::max(result.longest_run, run);
      }
    }
  }
  return result;
}

}  // namespace truth
