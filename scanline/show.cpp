#include "scanline/show.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "scanline/spans.h"

namespace scanline {
namespace {

using vsg::DecisionKind;
using vsg::EventKind;

constexpr std::array<Rgb8, 9> kHeat = {{{0, 0, 0},
                                        {24, 24, 96},
                                        {32, 64, 192},
                                        {0, 144, 208},
                                        {0, 176, 96},
                                        {160, 208, 0},
                                        {255, 176, 0},
                                        {255, 64, 0},
                                        {255, 255, 255}}};

constexpr std::array<Rgb8, 5> kSampleColors = {{{0, 0, 0},        // no sample point
                                                {255, 255, 255},  // end of a span that was settled
                                                {255, 208, 0},    // subdivided at an edge
                                                {0, 160, 255},    // subdivided in the middle
                                                {255, 48, 48}}};  // two segments cross
constexpr int kDim = 3;  // the picture under the sample points has a third of its brightness

// Field numbers, looked up once.
const std::size_t kTestLeft = vsg::event_field(EventKind::kDepthTest, "span_left");
const std::size_t kTestRight = vsg::event_field(EventKind::kDepthTest, "span_right");
const std::size_t kDecisionKind = vsg::event_field(EventKind::kDecision, "decision");
const std::size_t kDecisionLeft = vsg::event_field(EventKind::kDecision, "span_left");
const std::size_t kDecisionRight = vsg::event_field(EventKind::kDecision, "span_right");
const std::size_t kDecisionNewRight = vsg::event_field(EventKind::kDecision, "new_right");
const std::size_t kOutputEnd = vsg::event_field(EventKind::kOutputSegment, "x_end");
const std::size_t kDecisionReferences = vsg::event_field(EventKind::kDecision, "references");

Rgb8 darker(Rgb8 c, int divisor) {
  return {static_cast<std::uint8_t>(c.r / divisor), static_cast<std::uint8_t>(c.g / divisor),
          static_cast<std::uint8_t>(c.b / divisor)};
}

class SegmentsStage final : public ShaderStage {
 public:
  void shade(const SpanBand& band, std::span<Rgb8> pixels) const override {
    for (const Span& span : band.spans) {
      const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(span.row - band.first_row) * band.width;
      const Rgb8 color = number_color(span.polygon);
      std::fill(row + span.begin, row + span.end, color);
      if (span.polygon != 0) row[span.end - 1] = darker(color, 2);
    }
  }
};

class SamplesStage final : public ShaderStage {
 public:
  SamplesStage(const WorkRecorder& recorder, const ShaderStage& picture) : recorder_(recorder), picture_(picture) {}
  void shade(const SpanBand& band, std::span<Rgb8> pixels) const override {
    picture_.shade(band, pixels);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const int row = band.first_row + static_cast<int>(i) / band.width;
      const SamplePoint sample = recorder_.sample(row, static_cast<int>(i) % band.width);
      pixels[i] = sample == SamplePoint::kNone ? darker(pixels[i], kDim) : kSampleColors[static_cast<int>(sample)];
    }
  }

 private:
  const WorkRecorder& recorder_;
  const ShaderStage& picture_;
};

class HeatStage final : public ShaderStage {
 public:
  explicit HeatStage(const WorkRecorder& recorder) : recorder_(recorder) {}
  void shade(const SpanBand& band, std::span<Rgb8> pixels) const override {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const int row = band.first_row + static_cast<int>(i) / band.width;
      pixels[i] = heat_color(recorder_.count(row, static_cast<int>(i) % band.width));
    }
  }

 private:
  const WorkRecorder& recorder_;
};

}  // namespace

std::optional<Show> show_named(std::string_view name) {
  if (name == "segments") return Show::kSegments;
  if (name == "samples") return Show::kSamples;
  if (name == "tests") return Show::kTests;
  if (name == "references") return Show::kReferences;
  return std::nullopt;
}

WorkRecorder::WorkRecorder(Show show, int width, int height) : show_(show), width_(width), height_(height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  if (show == Show::kTests || show == Show::kReferences) counts_.assign(pixels, 0);
  if (show == Show::kSamples) samples_.assign(pixels, SamplePoint::kNone);
}

void WorkRecorder::record(const vsg::Event& event) {
  if (event.kind == EventKind::kDepthTest && show_ == Show::kTests) {
    add(event.line, event.fields[kTestLeft], event.fields[kTestRight], 1);
  } else if (event.kind == EventKind::kDecision) {
    record_decision(event);
  } else if (event.kind == EventKind::kOutputSegment && event.fields[kOutputEnd] >= crossing_from_) {
    // The segment in front on the left ends where the two cross.
    mark(event.line, event.fields[kOutputEnd], SamplePoint::kIntersection);
    crossing_from_ = kNothing;
  }
}

void WorkRecorder::record_decision(const vsg::Event& event) {
  const std::int64_t left = event.fields[kDecisionLeft], right = event.fields[kDecisionRight];
  if (show_ == Show::kReferences) {
    const std::int64_t references = event.fields[kDecisionReferences];
    add(event.line, left, right, references - std::exchange(references_, references));
  }
  if (show_ != Show::kSamples) return;
  crossing_from_ = kNothing;
  switch (static_cast<DecisionKind>(event.fields[kDecisionKind])) {
    case DecisionKind::kBackground:
    case DecisionKind::kVisible: mark(event.line, right, SamplePoint::kSpanEnd); break;
    case DecisionKind::kSubdivideAtEdge: mark(event.line, event.fields[kDecisionNewRight], SamplePoint::kEdge); break;
    case DecisionKind::kSubdivideInMiddle:
      mark(event.line, event.fields[kDecisionNewRight], SamplePoint::kMiddle);
      break;
    case DecisionKind::kIntersection:
      mark(event.line, right, SamplePoint::kSpanEnd);
      crossing_from_ = left;
      break;
  }
}

void WorkRecorder::add(int line, std::int64_t left, std::int64_t right, std::int64_t count) {
  if (line < 1 || line > height_) return;
  const std::int64_t begin = std::max<std::int64_t>(left - kGuardColumns, 0);
  const std::int64_t end = std::min<std::int64_t>(right - kGuardColumns, width_ - 1);
  for (std::int64_t column = begin; column <= end; ++column) {
    counts_[index(height_ - line, static_cast<int>(column))] += static_cast<std::uint32_t>(count);
  }
}

void WorkRecorder::mark(int line, std::int64_t column, SamplePoint sample) {
  column -= kGuardColumns;
  if (line < 1 || line > height_ || column < 0 || column >= width_) return;
  SamplePoint& point = samples_[index(height_ - line, static_cast<int>(column))];
  point = std::max(point, sample);
}

std::unique_ptr<ShaderStage> make_show_stage(const WorkRecorder& recorder, const ShaderStage& picture) {
  switch (recorder.show()) {
    case Show::kSegments: return std::make_unique<SegmentsStage>();
    case Show::kSamples: return std::make_unique<SamplesStage>(recorder, picture);
    case Show::kTests:
    case Show::kReferences: break;
  }
  return std::make_unique<HeatStage>(recorder);
}

Rgb8 heat_color(std::uint32_t count) {
  return kHeat[std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(count)), kHeat.size() - 1)];
}

Rgb8 number_color(std::uint32_t number) {
  if (number == 0) return {0, 0, 0};
  // Neighbouring numbers get unlike colours; none is dark, so that a polygon is never taken for background.
  std::uint32_t h = number * 0x9e3779b1u;
  h ^= h >> 15;
  h *= 0x85ebca77u;
  h ^= h >> 13;
  const auto part = [](std::uint32_t bits) { return static_cast<std::uint8_t>(80 + (bits & 0xff) * 175 / 255); };
  return {part(h), part(h >> 8), part(h >> 16)};
}

}  // namespace scanline
