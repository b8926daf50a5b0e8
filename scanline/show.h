// False-colour pictures of where the processor worked (`vsg render --show`): shader stages that are made from the
// processor's events instead of from the scene. Scales are fixed, so that pictures can be compared.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "cmodel/vsg/events.h"
#include "scanline/shader_stage.h"

namespace scanline {

enum class Show {
  kSegments,    ///< every polygon in a colour of its own, the last pixel of every output segment darker
  kSamples,     ///< figure 8: the ends of the spans over a dim picture, coloured by what was decided there
  kTests,       ///< depth tests that took in a pixel
  kReferences,  ///< segment references made for the spans that took in a pixel; the first span of a line bears
                ///< those of making its segments
};

/// "segments", "samples", "tests", "references".
std::optional<Show> show_named(std::string_view name);

/// What a sample point is; of several on a pixel, the last of this list is shown.
enum class SamplePoint : std::uint8_t { kNone, kSpanEnd, kEdge, kMiddle, kIntersection };

/// Collects what a picture needs while the processor works.
class WorkRecorder {
 public:
  /// A picture of width x height, from a frame of (width + 2) x (height + 1).
  WorkRecorder(Show show, int width, int height);

  void record(const vsg::Event& event);
  vsg::EventSink sink() {
    return [this](const vsg::Event& event) { record(event); };
  }

  Show show() const { return show_; }
  int width() const { return width_; }
  std::uint32_t count(int row, int column) const { return counts_[index(row, column)]; }
  SamplePoint sample(int row, int column) const { return samples_[index(row, column)]; }

 private:
  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row) * width_ + column; }
  void add(int line, std::int64_t left, std::int64_t right, std::int64_t count);
  void mark(int line, std::int64_t column, SamplePoint sample);
  void record_decision(const vsg::Event& event);

  static constexpr std::int64_t kNothing = std::numeric_limits<std::int64_t>::max();

  const Show show_;
  const int width_, height_;
  std::int64_t references_ = 0;            // of the frame, up to the decision before
  std::int64_t crossing_from_ = kNothing;  // left end of a span whose crossing has not come out yet
  std::vector<std::uint32_t> counts_;
  std::vector<SamplePoint> samples_;
};

/// The stage that draws a recording; both must outlive it. `picture` is what kSamples draws over.
std::unique_ptr<ShaderStage> make_show_stage(const WorkRecorder& recorder, const ShaderStage& picture);

/// The colour of a count: black for none, then a step for each doubling (1, 2-3, 4-7, ... 128 and more).
Rgb8 heat_color(std::uint32_t count);

/// The colour of a polygon's number; background (0) is black.
Rgb8 number_color(std::uint32_t number);

}  // namespace scanline
