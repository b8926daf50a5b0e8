#include "program/tables.h"

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "program/commands.h"
#include "program/generator_options.h"
#include "program/output_file.h"
#include "program/pixel_options.h"
#include "program/pixelflow_tables.h"
#include "program/refuse.h"
#include "program/shader_tables.h"
#include "scanline/edge_history.h"
#include "scanline/golden_generator.h"
#include "scanline/scene_frame.h"
#include "watkins/data_folder.h"

namespace program {

std::filesystem::path data_folder(const std::string& chosen) {
  std::filesystem::path folder = !chosen.empty() ? std::filesystem::path(chosen) : watkins::data_folder();
  if (!std::filesystem::is_directory(folder / "tables") || !std::filesystem::is_directory(folder / "scenes")) {
    refuse("no folders 'tables' and 'scenes' here: name the project's folder with --data or VSG_DATA", folder.string());
  }
  return folder;
}

const std::vector<std::string>& ten_objects() {
  static const std::vector<std::string> names{"penetration", "e_s",    "low_area", "cube1",   "cube2",
                                              "shape1",      "shape2", "sheet",    "simple1", "simple2"};
  return names;
}

scanline::Frame SceneMeter::frame_of(const std::string& scene) const {
  const scanline::Scene read = scanline::read_scene_file(data_ / "scenes" / (scene + ".toml"));
  return scanline::make_scene_frame(read, read.first_frame, read.width, read.height).frame;
}

vsg::FrameAnswer SceneMeter::work(const scanline::Frame& frame, const std::string& scene) {
  return generate(generator_, frame, (data_ / "scenes" / (scene + ".toml")).string(), false);
}

vsg::FrameAnswer SceneMeter::measure(const std::string& scene) { return work(frame_of(scene), scene); }

vsg::FrameAnswer SceneMeter::measure_part(const std::string& scene, std::size_t polygons) {
  scanline::Frame frame = frame_of(scene);
  if (polygons < frame.polygons.size()) frame.polygons.resize(polygons);
  return work(frame, scene);
}

std::int64_t SceneMeter::sequence_references(const std::string& scene, int first, int last, bool coherence) const {
  const scanline::Scene read = scanline::read_scene_file(data_ / "scenes" / (scene + ".toml"));
  vsg::Parameters parameters;
  parameters.frame_coherence = coherence;
  scanline::GoldenGenerator model(parameters);
  scanline::EdgeHistory history;
  std::int64_t references = 0;
  for (int moment = first; moment <= last; ++moment) {
    const scanline::SceneFrame frame = scanline::make_scene_frame(read, moment, read.width, read.height);
    vsg::FrameBlocks blocks = scanline::make_blocks(frame.frame, parameters, false);
    history.mark(frame, blocks);
    const vsg::FrameAnswer answer = watkins::generate(model, blocks, scene);
    history.remember(frame, blocks, answer);
    references += answer.counters.segment_references;
  }
  return references;
}

nlohmann::json read_table_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) refuse("cannot read this file", path.string());
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& mistake) {
    refuse(mistake.what(), path.string());
  }
}

void run_tables(const std::string& name, bool json, SceneMeter& meter) {
  const Table table = name == "fig33" ? figure33(meter) : name == "fig32" ? figure32(meter) : claims(meter);
  const std::string text = json              ? table_json(table).dump(1) + "\n"
                           : name == "fig33" ? figure33_text(table)
                                             : table_text(table);
  write_standard_output(text);
}

namespace {

struct TablesOptions {
  std::string name, data;
  bool json = false;
  GeneratorOptions generator;
  PixelOptions pixels;
};

bool is_pixelflow(const std::string& name) { return name.starts_with("pixelflow"); }

void run_pixelflow_tables(const TablesOptions& options) {
  const auto array = watkins::make_array(options.pixels, pixelflow::kElements);
  const std::filesystem::path data = data_folder(options.data);
  const std::string& name = options.name;
  const bool of_shaders = name == "pixelflow1" || name == "pixelflow4";
  const Table table = name == "pixelflow1"   ? pixelflow1(*array, data)
                      : name == "pixelflow2" ? pixelflow2(*array, data / "tables")
                      : name == "pixelflow3" ? pixelflow3(*array, data / "tables")
                                             : pixelflow4(data);
  write_standard_output(options.json ? table_json(table).dump(1) + "\n"
                        : of_shaders ? shader_table_text(table)
                                     : pixelflow_text(table));
}

}  // namespace

void add_tables(CLI::App& app, const std::string& command_line) {
  CLI::App* command = app.add_subcommand("tables", "Published figures beside measured ones, row by row");
  command->group("Results of the thesis and the paper");
  const auto options = std::make_shared<TablesOptions>();
  command
      ->add_option(
          "name", options->name,
          "fig32, fig33: figures of the thesis; claims: statements of its text; pixelflow1, pixelflow4: cycles\n"
          "and memory of shaders; pixelflow2, pixelflow3: cycles of arithmetic and of functions")
      ->required()
      ->check(CLI::IsMember({"fig32", "fig33", "claims", "pixelflow1", "pixelflow2", "pixelflow3", "pixelflow4"})
                  .description(""))
      ->type_name("fig32|fig33|claims|pixelflow1|pixelflow2|pixelflow3|pixelflow4");
  command->add_flag("--json", options->json, "JSON instead of a table for people")->group("Output");
  command
      ->add_option("--data", options->data,
                   "The folder that holds scenes/ and tables/ (default: $VSG_DATA, else what is installed,\n"
                   "else the sources)")
      ->type_name("FOLDER")
      ->group("Input");
  add_generator_options(*command, options->generator, "rtl");
  options->generator.replay = command_line;
  add_pixel_options(*command, options->pixels);
  command->callback([options] {
    if (is_pixelflow(options->name)) {
      run_pixelflow_tables(*options);
      return;
    }
    const auto generator = watkins::make_generator(options->generator, {});
    SceneMeter meter(data_folder(options->data), *generator);
    run_tables(options->name, options->json, meter);
  });
}

}  // namespace program
