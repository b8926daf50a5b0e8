#include "program/generator_options.h"

namespace program {

void add_generator_options(CLI::App& command, GeneratorOptions& options, const std::string& preferred) {
  options.vsg = watkins::has_rtl() ? preferred : "model";
  command.add_option("--vsg", options.vsg, "Who does the work: the golden model or the verilated RTL")
      ->check(CLI::IsMember({"model", "rtl"}).description(""))
      ->capture_default_str()
      ->type_name("model|rtl")
      ->group("Machine");
  command.add_flag("--lockstep", options.lockstep, "Run the golden model beside the RTL and compare every transaction")
      ->group("Machine");
}

vsg::FrameAnswer generate(scanline::VisibleSegmentGenerator& generator, const scanline::Frame& frame,
                          const std::string& name, bool keep_back_faces, const vsg::EventSink& events) {
  return watkins::generate(generator, scanline::make_blocks(frame, generator.parameters(), keep_back_faces), name,
                           events);
}

}  // namespace program
