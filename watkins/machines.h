// Which machines do the work: levels of modelling of the Visible Segment Generator and of the pixel processors.
#pragma once

#include <memory>
#include <string>

#include "cmodel/pixelflow/pixel_array.h"
#include "scanline/frame.h"
#include "scanline/visible_segment_generator.h"

namespace watkins {

/// True when the verilated RTL is part of this library.
bool has_rtl();

struct GeneratorOptions {
  std::string vsg = has_rtl() ? "rtl" : "model";  ///< "model" or "rtl"
  bool lockstep = false;                          ///< the golden model beside the RTL
  std::string trace;                              ///< waveform file, or empty
  std::string replay;                             ///< the command line that repeats the run
  bool frame_coherence = false;  ///< use what was visible in the frame before (chapter IV; golden model)
};

struct PixelOptions {
  std::string level = has_rtl() ? "rtl" : "model";   ///< "rtl", "model" or "macro"
  int multiplier_bits = pixelflow::kMultiplierBits;  ///< golden model; the RTL has its own
  bool lockstep = false;                             ///< the golden model beside the RTL, compared after every program
  std::string replay;                                ///< the command line that repeats the run
};

/// Throws scanline::UserError when the options contradict each other or this library has no RTL.
void check_generator_options(const GeneratorOptions& options);
void check_pixel_options(const PixelOptions& options);

/// Throws as check_generator_options does. `parameters` are the golden model's; the RTL has its own.
std::unique_ptr<scanline::VisibleSegmentGenerator> make_generator(const GeneratorOptions& options,
                                                                  const vsg::Parameters& parameters);

/// Works the blocks of a frame that `name` (a file) describes; what stops the processor becomes a scanline::UserError
/// that names it.
vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const vsg::FrameBlocks& blocks,
                          const std::string& name, const vsg::EventSink& events = {});

/// Throws as check_pixel_options does. `lanes`: a multiple of a chip's elements, up to a region's.
std::unique_ptr<pixelflow::PixelArray> make_array(const PixelOptions& options, int lanes);

}  // namespace watkins
