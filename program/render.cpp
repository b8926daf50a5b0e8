// vsg render: scene file to picture, or a sequence of them.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/answer_json.h"
#include "program/commands.h"
#include "program/image_file.h"
#include "program/number_pair.h"
#include "program/output_file.h"
#include "program/parallel.h"
#include "program/picture_maker.h"
#include "program/progress.h"
#include "program/refuse.h"
#include "program/scene_options.h"
#include "scanline/flat_shader.h"

namespace program {
namespace {

constexpr int kMostSamples = 64, kMostThreads = 256;
const std::string kFrameNumber = "%04d";

struct RenderOptions {
  SceneOptions scene;
  PictureOptions picture;
  std::string image, frames, show, stats, pixel_processors;
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
std::string image_name(const RenderOptions& options, int moment) {
  std::string name = options.image;
  const std::size_t at = name.find(kFrameNumber);
  if (at == std::string::npos) return name;
  std::string number = std::to_string(moment);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return name.replace(at, kFrameNumber.size(), number);
}

void check_options(const RenderOptions& options, const std::optional<Moments>& moments) {
  if (!options.pixel_processors.empty()) {
    refuse("--pe " + options.pixel_processors + ": this program has no pixel processors; shading is done by the host");
  }
  check_generator_options(options.picture.generator);
  const std::size_t at = options.image.find(kFrameNumber);
  const bool numbered = at != std::string::npos && options.image.find('%', at + 1) == std::string::npos;
  if (moments && !numbered) refuse("--frames needs the number's place in IMAGE, once: picture-%04d.png");
  if (!moments && at != std::string::npos) refuse("IMAGE holds " + kFrameNumber + ", but there is no --frames A-B");
  if (moments && moments->count > 1 && !options.picture.generator.trace.empty()) {
    refuse("--trace writes the waveform of one frame: name one with --frames A-A");
  }
  if (options.picture.generator.frame_coherence && !moments) {
    refuse("--frame-coherence uses the frame before: it needs a sequence, --frames A-B");
  }
  if (options.picture.channels && !options.show.empty()) refuse("--channels and --show exclude each other");
}

/// A place that cannot be written is found before the work begins, for every frame: those that are finished when a
/// later one fails remain.
void check_places(const RenderOptions& options, const Moments& moments) {
  const std::string& trace = options.picture.generator.trace;
  for (int i = 0; i < moments.count; ++i) {
    const std::string image = image_name(options, moments.first + i);
    refuse_same_file({options.scene.file, image, options.stats, trace});
    OutputFile{image};
  }
  if (!trace.empty()) OutputFile{trace};
}

nlohmann::ordered_json frame_statistics(int moment, const MadePicture& made, double writing) {
  nlohmann::ordered_json frame;
  frame["frame"] = moment;
  frame["counters"] = counters_json(made.answer.counters);
  frame["depth_tests"] = made.answer.depth_tests;
  frame["samples_stored"] = made.answer.samples_stored;
  frame["subdivisions"] = made.answer.subdivisions;
  frame["intersections"] = made.answer.intersections;
  frame["stale_samples"] = made.answer.stale_samples;
  frame["unclosed_polygons"] = made.answer.unclosed_polygons;
  frame["coherence_samples"] = made.answer.coherence_samples;
  add_rtl_counts(frame, made.answer);
  auto& references = frame["lines"]["references"] = nlohmann::ordered_json::array();
  for (const vsg::LineCounts& line : made.answer.lines) references.push_back(line.references);
  auto& segments = frame["lines"]["segments"] = nlohmann::ordered_json::array();
  for (const vsg::LineCounts& line : made.answer.lines) segments.push_back(line.segments);
  frame["times"] = {{"pre_frame", made.times.pre_frame},
                    {"visible_segments", made.times.visible_segments},
                    {"shading", made.times.shading},
                    {"writing", writing}};
  return frame;
}

/// Makes and writes the picture of one moment.
nlohmann::ordered_json render_frame(const RenderOptions& options, const scanline::Scene& scene, int moment,
                                    Progress& progress, WarningPrinter& warnings, scanline::EdgeHistory* history) {
  OutputFile image(image_name(options, moment));
  PictureOptions picture_options = options.picture;
  std::optional<OutputFile> trace;
  if (!picture_options.generator.trace.empty()) {
    trace.emplace(picture_options.generator.trace);
    picture_options.generator.trace = trace->partial();
  }
  const MadePicture made = [&] {
    try {
      return make_picture(
          scene, options.scene.file, moment, picture_options, [&](int) { progress.advance(); }, history);
    } catch (const vsg::LockstepError&) {
      if (trace) trace->commit();  // the waveform up to the mismatch is what it was asked for
      throw;
    }
  }();
  warnings.print(made.warnings);
  const auto begin = std::chrono::steady_clock::now();
  write_image(image.partial(), made.picture, scanline::shader_names(scene));
  image.commit();
  if (trace) trace->commit();
  const std::chrono::duration<double> writing = std::chrono::steady_clock::now() - begin;
  return options.stats.empty() ? nlohmann::ordered_json() : frame_statistics(moment, made, writing.count());
}

void run_render(RenderOptions options) {
  const std::optional<Moments> sequence = parse_frames(options.frames);
  check_options(options, sequence);
  options.picture.show = scanline::show_named(options.show);
  check_image_format(options.image, options.picture.channels);
  check_places(options, sequence.value_or(Moments{}));
  std::optional<OutputFile> stats;
  if (!options.stats.empty()) stats.emplace(options.stats);

  const scanline::Scene scene = read_scene(options.scene);
  scanline::check_shaders(scene);
  const std::int64_t samples = options.picture.samples;
  check_picture_size(scene.width * samples, scene.height * samples);

  const Moments moments = sequence.value_or(Moments{scene.first_frame, 1});
  // With coherence each frame waits for what the one before found.
  std::optional<scanline::EdgeHistory> history;
  if (options.picture.generator.frame_coherence) history.emplace();
  const int frame_threads = history ? 1 : std::min(options.picture.threads, moments.count);
  options.picture.threads /= frame_threads;
  std::vector<nlohmann::ordered_json> statistics(moments.count);
  WarningPrinter warnings(options.scene.quiet);
  {
    Progress progress("lines", moments.count * (scene.height * samples + 1), options.scene.quiet);
    for_each_index(moments.count, frame_threads, [&](int i) {
      statistics[i] =
          render_frame(options, scene, moments.first + i, progress, warnings, history ? &*history : nullptr);
    });
  }
  if (stats) {
    nlohmann::ordered_json all;
    all["scene"] = options.scene.file;
    all["size"] = {scene.width, scene.height};
    all["samples"] = samples;
    all["frames"] = statistics;
    stats->write(all.dump(1) + "\n");
    stats->commit();
  }
}

}  // namespace

void add_render(CLI::App& app, const std::string& command_line) {
  auto* command = app.add_subcommand("render", "A scene to a picture, its visible surfaces found by the machine");
  command->group("Pictures");
  const auto options = std::make_shared<RenderOptions>();
  options->picture.threads = machine_threads();

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
  command->add_option("--samples", options->picture.samples, "N x N samples a pixel, averaged")
      ->check(CLI::Range(1, kMostSamples).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Picture");
  command->add_flag("--channels", options->picture.channels, "EXR also holds depth, polygon, shader and normal")
      ->group("Picture");
  command
      ->add_option("--show", options->show, "A false-colour picture of where the processor worked (docs/pictures.md)")
      ->check(CLI::IsMember({"segments", "samples", "tests", "references"}).description(""))
      ->type_name("segments|samples|tests|references")
      ->group("Picture");

  add_generator_options(*command, options->picture.generator, "rtl");
  options->picture.generator.replay = command_line;
  command
      ->add_flag("--frame-coherence", options->picture.generator.frame_coherence,
                 "In a sequence, sample at edges that were visible in the frame before (golden model, then the default)")
      ->group("Machine");
  command->add_option("--trace", options->picture.generator.trace, "Write the waveform of the RTL")
      ->type_name("FILE.fst")
      ->group("Machine");
  // Not in the help while there is nothing to choose from; refused with a reason.
  command->add_option("--pe", options->pixel_processors)->group("");
  command
      ->add_option("--threads", options->picture.threads,
                   "Threads for frames and shading; the picture does not depend on it")
      ->check(CLI::Range(1, kMostThreads).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Machine");

  command->add_option("--stats", options->stats, "Write counters, scan lines and times")
      ->type_name("FILE.json")
      ->group("Reports");
  command->callback([options, command] {
    if (options->picture.generator.frame_coherence && command->count("--vsg") == 0) {
      options->picture.generator.vsg = "model";  // the only one that has it
    }
    run_render(*options);
  });
}

}  // namespace program
