// Which Visible Segment Generator does the work, as the command line chooses it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "scanline/frame.h"
#include "watkins/machines.h"

namespace program {

using watkins::GeneratorOptions;

/// Adds --vsg and --lockstep. `preferred` is what the command would rather use; a program without RTL has the model.
void add_generator_options(CLI::App& command, GeneratorOptions& options, const std::string& preferred);

/// Makes the blocks of a frame that `name` (a file) describes; what stops the processor becomes a scanline::UserError
/// that names it.
vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const scanline::Frame& frame,
                          const std::string& name, bool keep_back_faces, const vsg::EventSink& events = {});

}  // namespace program
