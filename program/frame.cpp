// vsg frame: pre-frame processing alone, scene to frame file.
#include "scanline/frame.h"

#include <memory>
#include <sstream>
#include <string>

#include "program/commands.h"
#include "program/output_file.h"
#include "program/scene_options.h"

namespace program {
namespace {

struct FrameOptions {
  SceneOptions scene;
  std::string output;
  int moment = 0;
  bool has_moment = false;
};

void run_frame(const FrameOptions& options) {
  refuse_same_file({options.scene.file, options.output});
  OutputFile output(options.output);
  const scanline::Scene scene = read_scene(options.scene);
  const double moment = options.has_moment ? options.moment : scene.first_frame;
  const scanline::SceneFrame frame = scanline::make_scene_frame(scene, moment, scene.width, scene.height);
  WarningPrinter(options.scene.quiet).print(frame.warnings);
  std::ostringstream text;
  scanline::write_frame(text, frame.frame);
  output.write(text.view());
  output.commit();
}

}  // namespace

void add_frame(CLI::App& app) {
  auto* command = app.add_subcommand("frame", "Pre-frame processing alone: a scene to a frame file");
  command->group("Steps of the machine");
  const auto options = std::make_shared<FrameOptions>();
  add_scene_options(*command, options->scene);
  command->add_option("-o,--output", options->output, "The frame file to write")
      ->required()
      ->type_name("FILE.frame")
      ->group("Output");
  command->add_option("--frame", options->moment, "Moment of the sequence [the scene's first]")->group("Scene");
  command->callback([options, command] {
    options->has_moment = command->count("--frame") > 0;
    run_frame(*options);
  });
}

}  // namespace program
