#include "program/generator_options.h"

#include "program/refuse.h"
#include "scanline/golden_generator.h"
#ifdef VSG_HAVE_RTL
#include "tb/verilated_generator.h"
#endif

namespace program {
bool has_rtl() {
#ifdef VSG_HAVE_RTL
  return true;
#else
  return false;
#endif
}

void add_generator_options(CLI::App& command, GeneratorOptions& options, const std::string& preferred) {
  options.vsg = has_rtl() ? preferred : "model";
  command.add_option("--vsg", options.vsg, "Who does the work: the golden model or the verilated RTL")
      ->check(CLI::IsMember({"model", "rtl"}).description(""))
      ->capture_default_str()
      ->type_name("model|rtl")
      ->group("Machine");
  command.add_flag("--lockstep", options.lockstep, "Run the golden model beside the RTL and compare every transaction")
      ->group("Machine");
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

vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const scanline::Frame& frame,
                          const std::string& name, bool keep_back_faces, const vsg::EventSink& events) {
  return generate(generator, scanline::make_blocks(frame, generator.parameters(), keep_back_faces), name, events);
}

vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const vsg::FrameBlocks& blocks,
                          const std::string& name, const vsg::EventSink& events) {
  try {
    return generator.generate(blocks, events);
  } catch (const vsg::FrameError& stop) {
    refuse(stop.what(), name);
  }
}

}  // namespace program
