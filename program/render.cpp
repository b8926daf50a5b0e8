// vsg render: scene file to picture, or a sequence of them.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/commands.h"
#include "program/generator_options.h"
#include "program/image_file.h"
#include "program/number_pair.h"
#include "program/output_file.h"
#include "program/pixel_options.h"
#include "program/progress.h"
#include "program/refuse.h"
#include "program/render_statistics.h"
#include "program/scene_options.h"
#include "watkins/parallel.h"
#include "watkins/renderer.h"

namespace program {
namespace {

const std::string kFrameNumber = "%04d";

struct Options {
  SceneOptions scene;
  watkins::RenderOptions render;
  int shading_nodes = 4;  ///< of which --stats tells
  std::string image, frames, show, stats;
};

/// The moments that --frames names, or the scene's first.
struct Moments {
  int first = 0, count = 1;
};

std::optional<Moments> parse_frames(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto range = parse_pair(text, "-");
  if (!range || range->second < range->first) {
    refuse("--frames wants A-B with A <= B, such as 1-24, not '" + text + "'");
  }
  return Moments{range->first, range->second - range->first + 1};
}

/// IMAGE with the frame's number in place of %04d.
std::string image_name(const Options& options, int moment) {
  std::string name = options.image;
  const std::size_t at = name.find(kFrameNumber);
  if (at == std::string::npos) return name;
  std::string number = std::to_string(moment);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return name.replace(at, kFrameNumber.size(), number);
}

void check_options(const Options& options, const std::optional<Moments>& moments) {
  watkins::check_generator_options(options.render.generator);
  watkins::check_pixel_options(options.render.pixels);
  const std::size_t at = options.image.find(kFrameNumber);
  const bool numbered = at != std::string::npos && options.image.find('%', at + 1) == std::string::npos;
  if (moments && !numbered) refuse("--frames needs the number's place in IMAGE, once: picture-%04d.png");
  if (!moments && at != std::string::npos) refuse("IMAGE holds " + kFrameNumber + ", but there is no --frames A-B");
  if (moments && moments->count > 1 && !options.render.generator.trace.empty()) {
    refuse("--trace writes the waveform of one frame: name one with --frames A-A");
  }
  if (options.render.generator.frame_coherence && !moments) {
    refuse("--frame-coherence uses the frame before: it needs a sequence, --frames A-B");
  }
  if (options.render.channels && !options.show.empty()) refuse("--channels and --show exclude each other");
}

/// --lockstep means every RTL that works: at least one has to.
void choose_lockstep(Options& options) {
  watkins::GeneratorOptions& generator = options.render.generator;
  watkins::PixelOptions& pixels = options.render.pixels;
  if (!generator.lockstep || !watkins::has_rtl()) return;
  if (generator.vsg != "rtl" && pixels.level != "rtl") {
    refuse("--lockstep compares RTL with the golden model: it needs --vsg rtl or --pe rtl");
  }
  pixels.lockstep = pixels.level == "rtl";
  pixels.replay = generator.replay;
  if (pixels.lockstep && generator.vsg != "rtl") generator.lockstep = false;
}

/// A place that cannot be written is found before the work begins, for every frame: those that are finished when a
/// later one fails remain.
void check_places(const Options& options, const Moments& moments) {
  const std::string& trace = options.render.generator.trace;
  for (int i = 0; i < moments.count; ++i) {
    const std::string image = image_name(options, moments.first + i);
    refuse_same_file({options.scene.file, image, options.stats, trace});
    OutputFile{image};
  }
  if (!trace.empty()) OutputFile{trace};
}

/// Writes the picture of one moment to a file that is not committed yet.
nlohmann::ordered_json write_frame(const Options& options, const watkins::RenderedFrame& frame,
                                   const std::vector<std::string>& shaders, int moment, const OutputFile& image) {
  const auto begin = std::chrono::steady_clock::now();
  write_image(image.partial(), frame.picture, shaders);
  const std::chrono::duration<double> writing = std::chrono::steady_clock::now() - begin;
  return options.stats.empty() ? nlohmann::ordered_json()
                               : frame_statistics(moment, frame, options.shading_nodes, writing.count());
}

/// The statistics of all frames.
void write_statistics(const Options& options, const scanline::Scene& scene,
                      const std::vector<nlohmann::ordered_json>& frames, OutputFile& file) {
  nlohmann::ordered_json all;
  all["scene"] = options.scene.file;
  all["size"] = {scene.width, scene.height};
  all["samples"] = options.render.samples;
  all["frames"] = frames;
  file.write(all.dump(1) + "\n");
  file.commit();
}

/// Makes and writes the pictures, one after another; visible segments of several moments at once.
void render_frames(Options& options, const scanline::Scene& scene, const Moments& moments, OutputFile* stats) {
  const std::vector<std::string> shaders = scanline::shader_names(scene);
  std::optional<OutputFile> trace;
  if (!options.render.generator.trace.empty()) {
    trace.emplace(options.render.generator.trace);
    options.render.generator.trace = trace->partial();
  }
  watkins::Renderer renderer(scene, options.scene.file, options.render);
  WarningPrinter warnings(options.scene.quiet);
  warnings.print(renderer.shader_warnings());
  // With coherence each frame waits for what the one before found.
  std::optional<scanline::EdgeHistory> history;
  if (options.render.generator.frame_coherence) history.emplace();
  const int at_once = history ? 1 : std::clamp(options.render.threads, 1, moments.count);

  std::vector<nlohmann::ordered_json> statistics;
  Progress progress("steps", moments.count * renderer.steps(), options.scene.quiet);
  renderer.on_step = [&] { progress.advance(); };
  for (int first = 0; first < moments.count; first += at_once) {
    const int count = std::min(at_once, moments.count - first);
    std::vector<std::optional<watkins::VisibleFrame>> visible(static_cast<std::size_t>(count));
    try {
      watkins::for_each_index(count, at_once, [&](int i) {
        visible[static_cast<std::size_t>(i)] =
            renderer.find_visible(moments.first + first + i, history ? &*history : nullptr);
      });
    } catch (const vsg::LockstepError&) {
      if (trace) trace->commit();  // the waveform up to the mismatch is what it was asked for
      throw;
    }
    for (int i = 0; i < count; ++i) {
      const int moment = moments.first + first + i;
      OutputFile image(image_name(options, moment));
      const watkins::RenderedFrame frame = renderer.shade(std::move(*visible[static_cast<std::size_t>(i)]));
      warnings.print(frame.warnings);
      statistics.push_back(write_frame(options, frame, shaders, moment, image));
      // Before the last picture: where statistics cannot be written, it is not there either.
      if (stats && first + i + 1 == moments.count) write_statistics(options, scene, statistics, *stats);
      image.commit();
    }
  }
  if (trace) trace->commit();
}

void run_render(Options options) {
  const std::optional<Moments> sequence = parse_frames(options.frames);
  check_options(options, sequence);
  options.render.show = scanline::show_named(options.show);
  check_image_format(options.image, options.render.channels);
  check_places(options, sequence.value_or(Moments{}));
  std::optional<OutputFile> stats;
  if (!options.stats.empty()) stats.emplace(options.stats);

  const scanline::Scene scene = read_scene(options.scene);
  const std::int64_t samples = options.render.samples;
  check_picture_size(scene.width * samples, scene.height * samples);
  render_frames(options, scene, sequence.value_or(Moments{scene.first_frame, 1}), stats ? &*stats : nullptr);
}

}  // namespace

void add_render(CLI::App& app, const std::string& command_line) {
  auto* command = app.add_subcommand("render", "A scene to a picture, its visible surfaces found by the machine");
  command->group("Pictures");
  const auto options = std::make_shared<Options>();
  options->render.threads = watkins::machine_threads();

  add_scene_options(*command, options->scene);
  command
      ->add_option("--frames", options->frames,
                   "Frames A to B of the scene's sequence; IMAGE holds a %04d; when a frame fails, finished ones\n"
                   "remain [one picture]")
      ->type_name("A-B")
      ->group("Scene");

  command->add_option("-o,--output", options->image, "The picture; its suffix decides the format")
      ->required()
      ->type_name("IMAGE")
      ->group("Picture");
  command->add_option("--samples", options->render.samples, "N x N samples a pixel, averaged")
      ->check(CLI::Range(1, watkins::kMostSamples).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Picture");
  command->add_flag("--channels", options->render.channels, "EXR also holds depth, polygon, shader and normal")
      ->group("Picture");
  command
      ->add_option("--show", options->show, "A false-colour picture of where the processor worked (docs/pictures.md)")
      ->check(CLI::IsMember({"segments", "samples", "tests", "references"}).description(""))
      ->type_name("segments|samples|tests|references")
      ->group("Picture");

  add_generator_options(*command, options->render.generator, "rtl");
  options->render.generator.replay = command_line;
  command
      ->add_flag(
          "--frame-coherence", options->render.generator.frame_coherence,
          "In a sequence, sample at edges that were visible in the frame before (golden model, then the default)")
      ->group("Machine");
  command->add_option("--trace", options->render.generator.trace, "Write the waveform of the RTL")
      ->type_name("FILE.fst")
      ->group("Machine");
  add_pixel_options(*command, options->render.pixels);
  command
      ->add_option("--rendering-nodes", options->render.rendering_nodes,
                   "Nodes that share the polygons; their pixels are composed by depth")
      ->check(CLI::Range(1, watkins::kMostRenderingNodes).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Machine");
  command
      ->add_option("--shading-nodes", options->shading_nodes,
                   "Nodes that share the regions; the picture does not depend on it")
      ->check(CLI::Range(1, watkins::kMostShadingNodes).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Machine");
  command
      ->add_flag("--traced", options->render.traced,
                 "A sphere tracer finds what is visible instead: a reference for scenes of distance fields")
      ->group("Machine");
  command
      ->add_option("--threads", options->render.threads,
                   "Threads for frames and shading; the picture does not depend on it")
      ->check(CLI::Range(1, watkins::kMostThreads).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Machine");

  command->add_option("--stats", options->stats, "Write counters, scan lines and times")
      ->type_name("FILE.json")
      ->group("Reports");
  command->callback([options, command] {
    watkins::GeneratorOptions& generator = options->render.generator;
    if (generator.frame_coherence && command->count("--vsg") == 0) generator.vsg = "model";  // the only one that has it
    choose_lockstep(*options);
    run_render(*options);
  });
}

}  // namespace program
