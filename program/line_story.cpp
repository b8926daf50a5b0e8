#include "program/line_story.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace program {
namespace {

using vsg::DecisionKind;
using vsg::DepthOutcome;
using vsg::Event;
using vsg::EventKind;

constexpr std::string_view kTerms =
    R"(Words used here
  edge          a polygon's side; it enters on the first scan line that it reaches
  segment       the piece of a scan line that lies inside one polygon, between a left and a right edge;
                it is kept in a segment block, which is stepped from scan line to scan line
  X-sort list   the segments of this line by their left end; a segment is taken from it once
  active list   segments already taken that reach beyond the span in which they were taken
  span          pixels that are sorted in depth together; its ends are sample points, the places where an edge
                was visible on the line before
  depth test    the new segment against what is in front so far; both are clipped to what they have in common
                by halving, an add cycle for each step, until the order at both ends is known
  visible box   two or more segments of which none is known to hide the others, with their extent in X and Z
  implied edge  where two segments cross; from the next line on it is a sample point like any visible edge
)";

template <typename... Arguments>
void print(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

std::int64_t field(const Event& event, std::string_view name) {
  return event.fields[vsg::event_field(event.kind, name)];
}

std::string pixels(std::int64_t from, std::int64_t to) {
  return from == to ? fmt::format("pixel {}", from) : fmt::format("pixels {} to {}", from, to);
}

std::string polygon_name(std::int64_t polygon) {
  return polygon == 0 ? std::string("background") : fmt::format("polygon {}", polygon);
}

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string decimals(std::int64_t value, int fraction_bits) {
  return fmt::format("{:.2f}", std::ldexp(static_cast<double>(value), -fraction_bits));
}

}  // namespace

std::string LineStory::x(std::int64_t value) const { return decimals(value, parameters_.fraction_bits_x); }
std::string LineStory::z(std::int64_t value) const { return decimals(value, parameters_.fraction_bits_z); }

std::string LineStory::segment(std::int64_t block) const {
  const auto found = memory_.find(block);
  if (found == memory_.end()) return fmt::format("segment {}", block);
  const vsg::SegmentBlock& b = found->second;
  return fmt::format("polygon {} (segment {}: x {} to {}, z {} to {})", b.polygon, block, x(b.left.x), x(b.right.x),
                     z(b.left.z), z(b.right.z));
}

void LineStory::record(const Event& event) {
  if (event.line > line_) return;
  if (event.kind == EventKind::kBlockWritten) remember_block(event);
  if (event.line != line_) return;
  switch (event.kind) {
    case EventKind::kEdgeTaken: tell_edge(event); break;
    case EventKind::kBlockWritten: break;  // told by remember_block
    case EventKind::kDepthTest: tell_test(event); break;
    case EventKind::kDecision: tell_decision(event); break;
    case EventKind::kSampleStored: tell_sample(event); break;
    case EventKind::kOutputSegment: tell_output(event); break;
    case EventKind::kLineDone: references_ = field(event, "references"); break;
  }
}

void LineStory::remember_block(const Event& event) {
  const std::int64_t number = field(event, "block"), mask = field(event, "mask");
  vsg::SegmentBlock& b = memory_[number];
  const auto pointer = [&](std::string_view name) { return static_cast<std::int32_t>(field(event, name)); };
  if (mask & vsg::kGroupPolygon) b.polygon = pointer("polygon");
  if (mask & vsg::kGroupPolygonNext) b.polygon_next = pointer("polygon_next");
  if (mask & vsg::kGroupLeftLines) b.left_lines = pointer("left_lines");
  if (mask & vsg::kGroupRightLines) b.right_lines = pointer("right_lines");
  if (mask & vsg::kGroupLeft)
    b.left = {field(event, "left_x"), field(event, "left_dx"), field(event, "left_z"), field(event, "left_dz")};
  if (mask & vsg::kGroupRight)
    b.right = {field(event, "right_x"), field(event, "right_dx"), field(event, "right_z"), field(event, "right_dz")};
  if (mask & vsg::kGroupActive) b.implied = field(event, "implied") != 0;
  if (event.line == line_ && (mask & vsg::kGroupPolygon) && taken_.insert({number, b.implied}).second) {
    tell_block(event, b.implied);
  }
}

void LineStory::tell_edge(const Event& event) {
  ++edges_.count;
  print(edges_.lines, "  Edge {} enters for polygon {} at x = {}.\n", field(event, "edge"), field(event, "polygon"),
        x(field(event, "x")));
}

void LineStory::tell_block(const Event& event, bool implied) {
  const std::int64_t number = field(event, "block");
  if (implied) {
    print(spans_.lines,
          "    Block {} is taken from the free list: it becomes an implied edge, whose slope is known\n    when the "
          "crossing is found again on the next line.\n",
          number);
    return;
  }
  ++blocks_.count;
  print(blocks_.lines, "  Block {} becomes a segment of polygon {}.\n", number, field(event, "polygon"));
}

void LineStory::tell_test(const Event& event) {
  const std::int64_t cycles = field(event, "add_cycles"), box = field(event, "box_segments");
  add_cycles_ += cycles;
  if (field(event, "intersecting") != 0) {
    print(tests_, "    {} goes through the clipper again{} ({}).\n", segment(field(event, "segment")),
          box > 1 ? ", until the registers hold nothing but 0 or -1; then both ends close in on the crossing" : "",
          counted(cycles, "add cycle", "add cycles"));
    spans_.lines += std::exchange(tests_, {});
    return;
  }
  ++tests_count_;
  std::string verdict;
  switch (static_cast<DepthOutcome>(field(event, "outcome"))) {
    case DepthOutcome::kFirst: verdict = "the first in the span: in front so far"; break;
    case DepthOutcome::kHidden: verdict = "behind what is in front so far: hidden in this span"; break;
    case DepthOutcome::kReplaces: verdict = "in front of what was there: takes its place"; break;
    case DepthOutcome::kBoxed:
      verdict = fmt::format("neither in front nor behind over the whole span: boxed ({} segments, {}, z {} to {})", box,
                            pixels(field(event, "box_left"), field(event, "box_right")), z(field(event, "box_z_min")),
                            z(field(event, "box_z_max")));
      break;
  }
  print(tests_, "    {}, from the {} list:\n      {} ({}).\n", segment(field(event, "segment")),
        field(event, "from_x_sort") != 0 ? "X-sort" : "active", verdict, counted(cycles, "add cycle", "add cycles"));
}

void LineStory::tell_decision(const Event& event) {
  const std::int64_t left = field(event, "span_left"), right = field(event, "span_right");
  const std::int64_t new_right = field(event, "new_right");
  ++spans_.count;
  print(spans_.lines, "  Span of {}\n{}", pixels(left, right), std::exchange(tests_, {}));
  crossing_from_ = kNoCrossing;
  switch (static_cast<DecisionKind>(field(event, "decision"))) {
    case DecisionKind::kBackground: print(spans_.lines, "    Decision: nothing is here, background.\n"); break;
    case DecisionKind::kVisible: print(spans_.lines, "    Decision: one segment is in front, it is visible.\n"); break;
    case DecisionKind::kSubdivideAtEdge:
      print(spans_.lines,
            "    Decision: more than one may be visible, and an edge of theirs lies at pixel {}:\n"
            "    the span ends there for now, and {} are sorted again.\n",
            new_right, pixels(left, new_right));
      break;
    case DecisionKind::kSubdivideInMiddle:
      print(spans_.lines,
            "    Decision: {} segments may be visible and no edge of theirs lies inside:\n"
            "    the span is cut in the middle, and {} are sorted again.\n",
            field(event, "box_segments"), pixels(left, new_right));
      break;
    case DecisionKind::kIntersection:
      crossing_from_ = left;
      print(spans_.lines, "    Decision: two segments are left and no edge of theirs lies inside: they cross.\n");
      break;
  }
}

void LineStory::tell_sample(const Event& event) {
  ++samples_.count;
  const std::int64_t block = field(event, "block");
  const auto found = memory_.find(block);
  const bool implied = found != memory_.end() && found->second.implied;
  const std::string edge = implied
                               ? std::string("the implied edge")
                               : fmt::format("the {} edge of polygon {}", field(event, "side") == 0 ? "left" : "right",
                                             found != memory_.end() ? found->second.polygon : 0);
  print(samples_.lines, "  Pixel {}: {} (block {}), visible on this line, will be here.\n", field(event, "x"), edge,
        block);
}

void LineStory::tell_output(const Event& event) {
  const std::int64_t end = field(event, "x_end"), polygon = field(event, "polygon");
  // The segment in front on the left ends where the two cross; what comes out before it belongs to the span before.
  if (end >= crossing_from_) {
    print(spans_.lines, "    They cross at pixel {}: up to there polygon {} is visible.\n", end, polygon);
    crossing_from_ = kNoCrossing;
  }
  ++output_.count;
  print(output_.lines, "  {:>5} to {:>5}  {}\n", output_from_, end, polygon_name(polygon));
  output_from_ = end + 1;
}

std::string LineStory::text() const {
  std::string text;
  print(text, "Scan line {}\n\n{}\n", line_, kTerms);
  print(text, "1. The Segment Generator takes the edges that begin on this line\n{}\n",
        edges_.count ? edges_.lines : "  None begins here.\n");
  print(text, "2. Segment blocks taken from the free list\n{}\n",
        blocks_.count ? blocks_.lines : "  None: the segments of the line before are stepped to this one.\n");
  print(text, "3. The Depth Sorter goes from left to right, span by span\n{}\n", spans_.lines);
  print(text, "4. Sample points for the next line\n{}\n",
        samples_.count ? samples_.lines : "  None: no visible edge goes on.\n");
  print(text, "5. What is visible\n{}\n", output_.lines);
  print(text, "{}, {}, {}, {}.\n", counted(spans_.count, "span", "spans"),
        counted(tests_count_, "depth test", "depth tests"), counted(add_cycles_, "add cycle", "add cycles"),
        counted(references_, "reference to segment memory", "references to segment memory"));
  return text;
}

}  // namespace program
