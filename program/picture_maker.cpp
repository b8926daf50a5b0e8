#include "program/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "program/parallel.h"
#include "scanline/flat_shader.h"
#include "scanline/spans.h"

namespace program {
namespace {

constexpr int kBandRows = 16;

/// Seconds since it was asked before.
class Stopwatch {
 public:
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

void shade(scanline::Picture& picture, const scanline::ShaderStage& stage, const scanline::SpanList& spans,
           const PictureOptions& options) {
  const int bands = (picture.height() + kBandRows - 1) / kBandRows;
  for_each_index(bands, options.threads, [&](int band) {
    const int first_row = band * kBandRows;
    picture.shade_rows(stage, spans, options.samples, first_row, std::min(kBandRows, picture.height() - first_row));
  });
}

}  // namespace

MadePicture make_picture(const scanline::Scene& scene, const std::string& scene_file, double moment,
                         const PictureOptions& options, std::function<void(int)> on_line,
                         scanline::EdgeHistory* history) {
  MadePicture made(scene.width, scene.height);
  const int width = scene.width * options.samples, height = scene.height * options.samples;
  Stopwatch watch;

  scanline::SceneFrame frame = scanline::make_scene_frame(scene, moment, width, height);
  made.warnings = std::move(frame.warnings);
  made.times.pre_frame = watch.lap();

  std::optional<scanline::WorkRecorder> recorder;
  if (options.show) recorder.emplace(*options.show, width, height);
  {
    vsg::Parameters parameters;
    parameters.frame_coherence = history != nullptr;
    const auto generator = make_generator(options.generator, parameters);
    generator->on_line = std::move(on_line);
    vsg::FrameBlocks blocks = scanline::make_blocks(frame.frame, generator->parameters(), false);
    if (history != nullptr) history->mark(frame, blocks);
    made.answer = generate(*generator, blocks, scene_file, recorder ? recorder->sink() : vsg::EventSink());
    if (history != nullptr) history->remember(frame, blocks, made.answer);
  }
  made.times.visible_segments = watch.lap();

  const scanline::SpanList spans(made.answer);
  const scanline::FlatShader flat(scene, frame);
  if (recorder) {
    shade(made.picture, *scanline::make_show_stage(*recorder, flat), spans, options);
  } else {
    shade(made.picture, flat, spans, options);
  }
  if (options.channels) made.picture.channels = scanline::make_channels(scene, frame, spans, options.samples);
  made.times.shading = watch.lap();
  return made;
}

}  // namespace program
