// vsg segments: a frame file to visible segments and counters.
#include <memory>
#include <string>

#include "program/answer_json.h"
#include "program/commands.h"
#include "program/generator_options.h"
#include "program/output_file.h"
#include "program/refuse.h"
#include "program/statistics_table.h"

namespace program {
namespace {

// Fewer leave no slope; with more, a word and the sum of two would come near the 64 bits that the model keeps them in.
constexpr int kFewestFractionBits = 1, kMostFractionBits = 40;

struct SegmentsOptions {
  std::string frame;
  GeneratorOptions generator;
  bool keep_back_faces = false, statistics = false;
  int fraction_bits = vsg::kFractionBitsX;
};

void run_segments(const SegmentsOptions& options) {
  vsg::Parameters parameters;
  if (options.fraction_bits != parameters.fraction_bits_x && options.generator.vsg != "model") {
    refuse("--fraction-bits: the width of the RTL is fixed when it is built; use --vsg model");
  }
  parameters.fraction_bits_x = parameters.fraction_bits_z = options.fraction_bits;
  const auto generator = watkins::make_generator(options.generator, parameters);
  const scanline::Frame frame = scanline::read_frame_file(options.frame);
  const vsg::FrameAnswer answer = generate(*generator, frame, options.frame, options.keep_back_faces);
  write_standard_output(options.statistics ? statistics_table(answer) : segments_json(answer));
}

}  // namespace

void add_segments(CLI::App& app, const std::string& command_line) {
  auto* command = app.add_subcommand("segments", "Visible segments and counters of a frame, as JSON");
  command->group("Steps of the machine");
  const auto options = std::make_shared<SegmentsOptions>();
  command->add_option("FILE.frame", options->frame, "Frame file")->required();
  add_generator_options(*command, options->generator, "model");
  options->generator.replay = command_line;
  command->add_option("--fraction-bits", options->fraction_bits, "Fraction bits of X and Z (golden model)")
      ->check(CLI::Range(kFewestFractionBits, kMostFractionBits).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group("Machine");
  command->add_flag("--keep-back-faces", options->keep_back_faces, "Polygons that face away are visible too")
      ->group("Machine");
  command
      ->add_flag("--statistics", options->statistics,
                 "Print the full statistics of the 1970 program as a table instead of JSON")
      ->group("Output");
  command->callback([options] { run_segments(*options); });
}

}  // namespace program
