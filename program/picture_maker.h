// Scene to picture at one moment: pre-frame processing, Visible Segment Generator, spans, shading.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "program/generator_options.h"
#include "scanline/edge_history.h"
#include "scanline/picture.h"
#include "scanline/scene.h"
#include "scanline/show.h"

namespace program {

struct PictureOptions {
  GeneratorOptions generator;
  std::optional<scanline::Show> show;
  bool channels = false;
  int samples = 1;
  int threads = 1;
};

/// Seconds.
struct StageTimes {
  double pre_frame = 0, visible_segments = 0, shading = 0;
};

struct MadePicture {
  MadePicture(int width, int height) : picture(width, height) {}

  scanline::Picture picture;
  vsg::FrameAnswer answer;
  std::vector<scanline::Diagnostic> warnings;
  StageTimes times;
};

/// `scene_file` is named in messages. `on_line` is called after each scan line. Throws scanline::UserError,
/// vsg::LockstepError.
/// `history`, for frame coherence: what is known of the frame before, and then of this one.
MadePicture make_picture(const scanline::Scene& scene, const std::string& scene_file, double moment,
                         const PictureOptions& options, std::function<void(int)> on_line,
                         scanline::EdgeHistory* history = nullptr);

}  // namespace program
