#include "program/scene_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <tuple>

#include "program/number_pair.h"
#include "program/refuse.h"
#include "scanline/scene_frame.h"

namespace program {

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE", options.file, "Scene file (TOML)")->required();
  command.add_option("--size", options.size, "Width and height of the picture [the scene's]")
      ->type_name("WxH")
      ->group("Scene");
  command.add_flag("--quiet", options.quiet, "No progress bar and no warnings")->group("Reports");
}

scanline::Scene read_scene(const SceneOptions& options) {
  int width = 0, height = 0;
  if (!options.size.empty()) {
    const auto size = parse_pair(options.size, "xX");
    if (!size) refuse("--size wants WxH, such as 640x480, not '" + options.size + "'");
    std::tie(width, height) = *size;
    check_picture_size(width, height);
  }
  scanline::Scene scene = scanline::read_scene_file(options.file);
  if (width > 0) {
    scene.width = width;
    scene.height = height;
  }
  check_picture_size(scene.width, scene.height);
  return scene;
}

void check_picture_size(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > scanline::kMostPictureWidth || height > scanline::kMostPictureHeight) {
    refuse(fmt::format("a picture is 1 to {} pixels wide and 1 to {} high, samples included; this one would be {} x {}",
                       scanline::kMostPictureWidth, scanline::kMostPictureHeight, width, height));
  }
}

void WarningPrinter::print(const std::vector<scanline::Diagnostic>& warnings) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  for (const scanline::Diagnostic& warning : warnings) {
    const std::string text = scanline::format(warning, "warning");
    if (printed_.insert(text).second) std::fprintf(stderr, "%s\n", text.c_str());
  }
}

void WarningPrinter::print(const std::string& lines) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  std::fputs(lines.c_str(), stderr);
}

}  // namespace program
