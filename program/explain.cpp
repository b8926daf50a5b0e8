// vsg explain: what the processor decided on one scan line, for a person to read.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "program/commands.h"
#include "program/generator_options.h"
#include "program/line_story.h"
#include "program/output_file.h"
#include "program/refuse.h"

namespace program {
namespace {

struct ExplainOptions {
  std::string frame;
  GeneratorOptions generator;
  int line = 0;
  bool keep_back_faces = false;
};

void run_explain(const ExplainOptions& options) {
  const auto generator = watkins::make_generator(options.generator, {});
  const scanline::Frame frame = scanline::read_frame_file(options.frame);
  if (options.line < 1 || options.line > frame.height) {
    refuse(fmt::format("--line {}: {} has scan lines 1 to {}", options.line, options.frame, frame.height));
  }
  LineStory story(options.line, generator->parameters());
  generate(*generator, frame, options.frame, options.keep_back_faces,
           [&story](const vsg::Event& event) { story.record(event); });
  write_standard_output(story.text());
}

}  // namespace

void add_explain(CLI::App& app, const std::string& command_line) {
  auto* command = app.add_subcommand("explain", "What the processor decided on one scan line, step by step");
  command->group("Steps of the machine");
  const auto options = std::make_shared<ExplainOptions>();
  command->add_option("FILE.frame", options->frame, "Frame file")->required();
  command->add_option("--line", options->line, "Scan line; 1 is the lowest")->required()->type_name("Y");
  add_generator_options(*command, options->generator, "model");
  options->generator.replay = command_line;
  command->add_flag("--keep-back-faces", options->keep_back_faces, "Polygons that face away are visible too")
      ->group("Machine");
  command->callback([options] { run_explain(*options); });
}

}  // namespace program
