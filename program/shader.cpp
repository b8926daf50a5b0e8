// vsg shader: a file of shaders compiled, described, and shown on a test surface.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/compiler/lifetime.h"
#include "pixelflow/compiler/listing.h"
#include "pixelflow/compiler/lower.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/test_surface.h"
#include "program/commands.h"
#include "program/image_file.h"
#include "program/number_pair.h"
#include "program/output_file.h"
#include "program/refuse.h"
#include "program/shader_file.h"
#include "program/shader_picture.h"
#include "watkins/parallel.h"

namespace program {
namespace {

constexpr int kMostThreads = 256, kMostPixels = 8192, kMostSamples = 16;
constexpr int kFirstId = 1;

struct ShaderOptions {
  std::string file, shader;
  std::vector<std::string> include_folders, macros, values;
  bool listing = false, memory_map = false;
  bool no_fuse = false, no_drop_unused = false, no_join_copies = false, no_share_memory = false;
  std::string dump;
  std::string image, on = "plane", size = "512x512";
  std::vector<std::string> lights;
  pfman::TestView view;
  PixelOptions pixels;
  int samples = 1, threads = 1;
  bool quiet = false;
};

pfman::Options compiler_options(const ShaderOptions& options) {
  pfman::Options result;
  result.fuse = !options.no_fuse;
  result.drop_unused = !options.no_drop_unused;
  result.join_copies = !options.no_join_copies;
  result.share_memory = !options.no_share_memory;
  for (const std::string& folder : options.include_folders) result.parse.include_folders.emplace_back(folder);
  for (const std::string& macro : options.macros) {
    const std::size_t equals = macro.find('=');
    const bool has_value = equals != std::string::npos;
    result.parse.macros[macro.substr(0, equals)] = has_value ? macro.substr(equals + 1) : "1";
  }
  return result;
}

/// The instance with what --set says of it.
pfman::Instance instance_of(const pfman::CompiledShader& shader, int id, const std::vector<std::string>& values) {
  pfman::Instance instance(shader, id);
  pfman::TestSurface::make_ordinary(instance);
  for (const std::string& value : values) {
    if (has_parameter(instance, value)) set_value(instance, value);
  }
  return instance;
}

/// Of an instance of a shader of this file, to which mistakes in its uniform code belong.
pfman::Streams streams_of(const pfman::Instance& instance, const ShaderFile& file) {
  const bool surface = instance.shader().shader->kind == pfman::Shader::Kind::Surface;
  try {
    return pfman::generate(instance.shader(), {.uniforms = instance.uniforms(),
                                               .bound_varying = instance.bound(),
                                               .shader_ids = surface ? std::vector{kFirstId} : std::vector<int>{},
                                               .lights = 1});
  } catch (const pfman::UniformError& error) {
    refuse_uniform(error, file.diagnostics);
  }
}

pfman::Streams streams_of(const pfman::CompiledShader& shader, const ShaderOptions& options, const ShaderFile& file) {
  return streams_of(instance_of(shader, kFirstId, options.values), file);
}

std::string counted(std::uint64_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

/// What a shader costs, in a few lines.
std::string summary(const pfman::CompiledShader& shader, const pfman::Streams& streams, const ShaderFile& file) {
  const bool surface = shader.shader->kind == pfman::Shader::Kind::Surface;
  std::string text = (surface ? "surface " : "light ") + shader.shader->name + " (" +
                     file.diagnostics.place(shader.shader->where) + ")\n";
  text += "  memory      " + counted(static_cast<std::uint64_t>(shader.map.peak_bytes), "byte") +
          " at most at one time, apart from the shared " + std::to_string(pfman::kCommunicationBytes);
  if (surface) {
    text += "; lights may use " + std::to_string(shader.map.high_water) + " and up\n";
    const pfman::TransferMap map = pfman::transfer_map(shader);
    text += "  transfer    " + counted(static_cast<std::uint64_t>(map.bytes), "byte") + ", " +
            counted(static_cast<std::uint64_t>(map.packets), "packet") + " a pixel\n";
  } else {
    text += "; needs " + std::to_string(shader.map.first_free) + " and up\n";
  }
  text += "  cycles      ";
  if (!shader.code.has_illuminance) {
    text += std::to_string(streams.pre.cycles()) + " a region\n";
  } else {
    const std::uint64_t illum = streams.illum.at(0).cycles();
    text += "pre-illum " + std::to_string(streams.pre.cycles()) + ", illum " + std::to_string(illum) +
            " a light, post-illum " + std::to_string(streams.post.cycles()) + ": " +
            std::to_string(streams.pre.cycles() + illum + streams.post.cycles()) + " a region with one light\n";
  }
  std::string operations;
  for (const auto& [name, count] : pfman::operation_counts(streams)) {
    operations += (operations.empty() ? "" : ", ") + name + " " + std::to_string(count);
  }
  return text + "  operations  " + operations + "\n";
}

/// The code after single assignment, which the compiler does not keep.
std::string dump_ssa(const pfman::CompiledShader& shader, const ShaderOptions& options, const ShaderFile& file) {
  pfman::Diagnostics said;
  pfman::ir::Code code = pfman::lower(*shader.tree, *shader.shader, {.fuse = !options.no_fuse}, said);
  pfman::to_ssa(code, said);
  return pfman::ir::dump(code, file.diagnostics);
}

std::string dump_shader(const pfman::CompiledShader& shader, const std::string& phase, const ShaderOptions& options,
                        const ShaderFile& file) {
  const auto lines = [&](std::uint32_t number, std::uint32_t line) {
    return line_text(file.diagnostics, number, line);
  };
  if (phase == "ssa") return dump_ssa(shader, options, file);
  if (phase == "lifetime") return pfman::dump(pfman::Lifetimes(shader.code), shader.code);
  if (phase == "memory-map") return pfman::dump(shader.map, shader.code);
  const pfman::Streams streams = streams_of(shader, options, file);
  if (phase == "listing") return pfman::listing(streams, file.diagnostics, lines);
  return pfman::cycles_text(streams, file.diagnostics, lines);
}

std::vector<const pfman::CompiledShader*> chosen_shaders(const ShaderFile& file, const ShaderOptions& options) {
  if (!options.shader.empty()) return {&file.shader(options.shader)};
  std::vector<const pfman::CompiledShader*> all;
  for (const pfman::CompiledShader& shader : file.unit->shaders) all.push_back(&shader);
  return all;
}

std::string report(const ShaderFile& file, const ShaderOptions& options) {
  if (options.dump == "ast") return pfman::dump(file.unit->syntax);
  if (options.dump == "types") return pfman::dump(file.unit->tree);
  std::vector<std::string> phases;
  if (options.listing) phases.push_back("listing");
  if (options.memory_map) phases.push_back("memory-map");
  if (!options.dump.empty()) phases.push_back(options.dump);
  const auto shaders = chosen_shaders(file, options);
  std::string text;
  for (const pfman::CompiledShader* shader : shaders) {
    if (phases.empty()) text += summary(*shader, streams_of(*shader, options, file), file);
    for (const std::string& phase : phases) {
      if (shaders.size() > 1 || phases.size() > 1) text += shader->shader->name + ", " + phase + "\n";
      text += dump_shader(*shader, phase, options, file);
    }
  }
  return text;
}

/// The lights of a picture and the files that hold them.
struct Lights {
  std::vector<std::unique_ptr<ShaderFile>> files;
  std::vector<pfman::Instance> instances;
};

/// "FILE.pfman", "FILE.pfman:NAME" or the name of a light in the surface's own file; then values, with spaces between.
void add_light(Lights& lights, const std::string& words, const ShaderFile& own, const pfman::Options& options) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t space = std::min(words.find(' ', at), words.size());
    if (space > at) parts.push_back(words.substr(at, space - at));
    at = space + 1;
  }
  if (parts.empty()) refuse("--light wants a light");
  const std::string place = parts[0];
  const ShaderFile* holder = &own;
  const pfman::CompiledShader* shader = own.unit->find(place);
  if (!shader) {
    const std::size_t colon = place.find(".pfman:");
    const std::string path = colon == std::string::npos ? place : place.substr(0, colon + 6);
    holder = lights.files.emplace_back(read_shader_file(path, options)).get();
    if (colon != std::string::npos) {
      shader = &holder->shader(place.substr(colon + 7));
    } else {
      for (const pfman::CompiledShader& other : holder->unit->shaders) {
        if (!shader && other.shader->kind == pfman::Shader::Kind::Light) shader = &other;
      }
    }
  }
  if (!shader || shader->shader->kind != pfman::Shader::Kind::Light) refuse("'" + place + "' is no light");
  pfman::Instance& light =
      lights.instances.emplace_back(pfman::Instance(*shader, static_cast<int>(lights.instances.size()) + 1));
  for (std::size_t n = 1; n < parts.size(); ++n) set_value(light, parts[n]);
  // While the picture is made, nobody knows any more which file a light is from.
  streams_of(light, *holder);
}

const pfman::CompiledShader& surface_of(const ShaderFile& file, const ShaderOptions& options) {
  for (const pfman::CompiledShader* shader : chosen_shaders(file, options)) {
    if (shader->shader->kind == pfman::Shader::Kind::Surface) return *shader;
  }
  refuse("a picture needs a surface, and there is none", file.name);
}

void make_shader_picture(const ShaderFile& file, const ShaderOptions& options) {
  const auto size = parse_pair(options.size, "xX");
  const auto fits = [&](int pixels) { return pixels >= 1 && pixels <= kMostPixels / options.samples; };
  if (!size || !fits(size->first) || !fits(size->second)) {
    refuse("--size wants WIDTHxHEIGHT, each from 1 to " + std::to_string(kMostPixels) + " samples, not '" +
           options.size + "'");
  }
  const auto shape = pfman::test_shape(options.on);
  if (!shape) refuse("--on wants plane, relief, sphere or pin, not '" + options.on + "'");
  pfman::TestView view = options.view;
  view.shape = *shape;
  view.width = size->first;
  view.height = size->second;
  check_image_format(options.image, false);
  refuse_same_file({options.file, options.image});
  OutputFile image(options.image);

  Lights lights;
  const pfman::Options compiler = compiler_options(options);
  for (const std::string& light : options.lights) add_light(lights, light, file, compiler);
  if (options.lights.empty()) {
    lights.files.push_back(default_light());
    lights.instances.emplace_back(lights.files.back()->unit->shaders.at(0), 1);
  }
  const pfman::CompiledShader& surface = surface_of(file, options);
  try {
    const ShaderPicture made =
        shade_picture(view, instance_of(surface, kFirstId, options.values), std::move(lights.instances), options.pixels,
                      options.samples, options.threads, options.quiet);
    write_image(image.partial(), made.picture, {});
  } catch (const pfman::UniformError& error) {
    refuse_uniform(error, file.diagnostics);
  }
  image.commit();
}

void check_values(const ShaderFile& file, const ShaderOptions& options) {
  for (const std::string& value : options.values) {
    const auto shaders = chosen_shaders(file, options);
    const bool known = std::any_of(shaders.begin(), shaders.end(), [&](const pfman::CompiledShader* shader) {
      return has_parameter(pfman::Instance(*shader), value);
    });
    if (!known) refuse("--set " + value + ": no shader has such a parameter", file.name);
  }
}

void run_shader(const ShaderOptions& options) {
  const std::unique_ptr<ShaderFile> file = read_shader_file(options.file, compiler_options(options));
  check_values(*file, options);
  const bool asked = options.listing || options.memory_map || !options.dump.empty();
  if (options.image.empty() || asked) write_standard_output(report(*file, options));
  if (!options.image.empty()) make_shader_picture(*file, options);
}

void add_report_options(CLI::App& command, ShaderOptions& options) {
  command.add_option("--shader", options.shader, "One shader of the file [all; for a picture the first surface]")
      ->type_name("NAME")
      ->group("Shader");
  command
      .add_option("--set", options.values,
                  "Value of a parameter, such as width=0.5 or color=1,0.5,0; varying ones are bound to it")
      ->type_name("NAME=N,N...")
      ->allow_extra_args(false)
      ->group("Shader");
  command.add_option("-I", options.include_folders, "Folder that #include searches after the file's own")
      ->type_name("FOLDER")
      ->allow_extra_args(false)
      ->group("Shader");
  command.add_option("-D", options.macros, "Macro of the preprocessor")
      ->type_name("NAME[=TEXT]")
      ->allow_extra_args(false)
      ->group("Shader");
  command.add_flag("--listing", options.listing, "Operations with addresses, cycles and lines instead of a summary")
      ->group("Reports");
  command.add_flag("--memory-map", options.memory_map, "What lies where in pixel memory")->group("Reports");
  command.add_option("--dump", options.dump, "What a pass of the compiler leaves behind")
      ->check(CLI::IsMember({"ast", "types", "ssa", "lifetime", "memory-map", "listing", "cycles"}).description(""))
      ->type_name("ast|types|ssa|lifetime|memory-map|listing|cycles")
      ->group("Reports");
  command.add_flag("--no-fuse", options.no_fuse, "Every step through memory")->group("Optimisation");
  command.add_flag("--no-drop-unused", options.no_drop_unused, "Keep code without effect")->group("Optimisation");
  command.add_flag("--no-join-copies", options.no_join_copies, "Keep copies")->group("Optimisation");
  command.add_flag("--no-share-memory", options.no_share_memory, "Every variable keeps bytes of its own")
      ->group("Optimisation");
}

void add_picture_options(CLI::App& command, ShaderOptions& options) {
  command.add_option("-o,--output", options.image, "Show the surface; the suffix decides the format")
      ->type_name("IMAGE")
      ->group("Picture");
  command.add_option("--on", options.on, "The shape that has the surface")
      ->check(CLI::IsMember({"plane", "relief", "sphere", "pin"}).description(""))
      ->capture_default_str()
      ->type_name("plane|relief|sphere|pin")
      ->group("Picture");
  command.add_option("--size", options.size, "Pixels")->capture_default_str()->type_name("WxH")->group("Picture");
  command.add_option("--samples", options.samples, "N x N samples a pixel, averaged")
      ->check(CLI::Range(1, kMostSamples).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Picture");
  command
      .add_option("--light", options.lights,
                  "A light of this file by its name, or FILE.pfman[:NAME]; values may follow in the same word:\n"
                  "\"point_light.pfman position=1,2,3\", in eye space: the eye at 0,0,0 looks along -z [a white one\n"
                  "from the upper left]")
      ->type_name("LIGHT")
      ->allow_extra_args(false)
      ->group("Picture");
  const auto number = [&](const char* name, double& value, const char* text, double least, double most) {
    command.add_option(name, value, text)
        ->capture_default_str()
        ->type_name("X")
        ->check([=](const std::string& word) {
          double x = 0;  // also refuses what is no number: no comparison with it holds
          if (CLI::detail::lexical_cast(word, x) && x >= least && x <= most) return std::string();
          return fmt::format("'{}' is not a number from {} to {}", word, least, most);
        })
        ->group("Picture");
  };
  number("--distance", options.view.distance, "Of the shape; at 1 a height of 2 fills the picture", 0.01, 1000);
  number("--turn", options.view.turn, "Degrees about the upright axis", -360, 360);
  number("--tilt", options.view.tilt, "Degrees about the level axis, the upper side away", -360, 360);
  number("--extent", options.view.extent, "Half of a plane's side", 0.001, 1000);
  add_pixel_options(command, options.pixels);
  command.add_option("--threads", options.threads, "Threads for regions; the picture does not depend on it")
      ->check(CLI::Range(1, kMostThreads).description(""))
      ->capture_default_str()
      ->type_name("N")
      ->group("Machine");
  command.add_flag("--quiet", options.quiet, "No progress bar")->group("Machine");
}

}  // namespace

void add_shader(CLI::App& app) {
  auto* command = app.add_subcommand("shader", "A pfman file to programs for the pixel processors, and to a picture");
  command->group("PixelFlow");
  const auto options = std::make_shared<ShaderOptions>();
  options->threads = watkins::machine_threads();
  command->add_option("FILE.pfman", options->file, "Surfaces and lights")->required();
  add_report_options(*command, *options);
  add_picture_options(*command, *options);
  command->callback([options] { run_shader(*options); });
}

}  // namespace program
