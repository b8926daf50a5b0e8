#include "watkins/machines.h"

#include "scanline/error.h"
#include "scanline/golden_generator.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/lockstep_array.h"
#include "tb/pixelflow/rtl_array.h"
#include "tb/verilated_generator.h"
#endif

namespace watkins {
namespace {

[[noreturn]] void refuse(const std::string& message, const std::string& file = {}) {
  throw scanline::UserError({file, 0, 0, message});
}

}  // namespace

bool has_rtl() {
#ifdef VSG_HAVE_RTL
  return true;
#else
  return false;
#endif
}

void check_generator_options(const GeneratorOptions& options) {
  if (options.vsg == "rtl" && !has_rtl()) {
    refuse("--vsg rtl: this program was built without the RTL (configure with -DVSG_RTL=ON, which needs Verilator)");
  }
  if (options.lockstep && !has_rtl()) {
    refuse("--lockstep: this program was built without the RTL, there is nothing to compare the golden model with");
  }
  if (options.lockstep && options.vsg != "rtl") {
    refuse("--lockstep compares the RTL with the golden model: it needs --vsg rtl");
  }
  if (options.frame_coherence && options.vsg != "model") {
    refuse("--frame-coherence is an option of the golden model, the RTL has none: it needs --vsg model");
  }
  if (!options.trace.empty() && options.vsg != "rtl") {
    refuse("--trace writes the waveform of the RTL: it needs --vsg rtl");
  }
}

void check_pixel_options(const PixelOptions& options) {
  if (options.level != "rtl") return;
  if (!has_rtl()) {
    refuse("--pe rtl: this program was built without the RTL (configure with -DVSG_RTL=ON, which needs Verilator)");
  }
  if (options.multiplier_bits != pixelflow::kMultiplierBits) {
    refuse("--multiplier-bits: the RTL was built with " + std::to_string(pixelflow::kMultiplierBits) +
           " bits; another number needs --pe model or macro");
  }
}

std::unique_ptr<scanline::VisibleSegmentGenerator> make_generator(const GeneratorOptions& options,
                                                                  const vsg::Parameters& parameters) {
  check_generator_options(options);
#ifdef VSG_HAVE_RTL
  if (options.vsg == "rtl") {
    return std::make_unique<tb::VerilatedGenerator>(
        tb::VerilatedOptions{.lockstep = options.lockstep, .trace = options.trace, .replay = options.replay});
  }
#endif
  return std::make_unique<scanline::GoldenGenerator>(parameters);
}

vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const vsg::FrameBlocks& blocks,
                          const std::string& name, const vsg::EventSink& events) {
  try {
    return generator.generate(blocks, events);
  } catch (const vsg::FrameError& stop) {
    refuse(stop.what(), name);
  }
}

std::unique_ptr<pixelflow::PixelArray> make_array(const PixelOptions& options, int lanes) {
  check_pixel_options(options);
  if (options.level == "macro") {
    return pixelflow::make_golden_array(pixelflow::Level::Macro, lanes, options.multiplier_bits);
  }
#ifdef VSG_HAVE_RTL
  if (options.level == "rtl") {
    return options.lockstep ? tb::make_lockstep_array(lanes, options.replay) : tb::make_rtl_array(lanes);
  }
#endif
  return pixelflow::make_golden_array(pixelflow::Level::Model, lanes, options.multiplier_bits);
}

}  // namespace watkins
