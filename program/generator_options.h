// Which Visible Segment Generator does the work, as the command line chooses it.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "scanline/frame.h"
#include "scanline/visible_segment_generator.h"

namespace program {

/// True when the verilated RTL is part of this program.
bool has_rtl();

struct GeneratorOptions {
  std::string vsg;        ///< "model" or "rtl"
  bool lockstep = false;  ///< the golden model beside the RTL
  std::string trace;      ///< waveform file, or empty
  std::string replay;     ///< the command line that repeats the run
  bool frame_coherence = false;  ///< use what was visible in the frame before (chapter IV; golden model)
};

/// Adds --vsg and --lockstep. `preferred` is what the command would rather use; a program without RTL has the model.
void add_generator_options(CLI::App& command, GeneratorOptions& options, const std::string& preferred);

/// Throws scanline::UserError when the options contradict each other or this program has no RTL.
void check_generator_options(const GeneratorOptions& options);

/// Throws as check_generator_options does. `parameters` are the golden model's; the RTL has its own.
std::unique_ptr<scanline::VisibleSegmentGenerator> make_generator(const GeneratorOptions& options,
                                                                  const vsg::Parameters& parameters);

/// Works the blocks of a frame that `name` (a file) describes; what stops the processor becomes a scanline::UserError
/// that names it.
vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const vsg::FrameBlocks& blocks,
                          const std::string& name, const vsg::EventSink& events = {});

/// Makes the blocks of a frame that `name` (a file) describes; what stops the processor becomes a scanline::UserError that names it.
vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const scanline::Frame& frame,
                          const std::string& name, bool keep_back_faces, const vsg::EventSink& events = {});

}  // namespace program
