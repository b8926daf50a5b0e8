// What the commands that begin with a scene have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"

namespace program {

struct SceneOptions {
  std::string file;
  std::string size;  ///< WxH, or empty: the scene's own
  bool quiet = false;
};

/// Adds SCENE, --size and --quiet.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// Reads the scene; its width and height are then those of the picture. Throws scanline::UserError.
scanline::Scene read_scene(const SceneOptions& options);

/// Throws scanline::UserError when no frame is large enough for such a picture.
void check_picture_size(std::int64_t width, std::int64_t height);

/// Prints warnings on standard error, each once, however many frames of a sequence have it.
class WarningPrinter {
 public:
  explicit WarningPrinter(bool quiet) : quiet_(quiet) {}
  void print(const std::vector<scanline::Diagnostic>& warnings);
  /// Lines that are formatted already.
  void print(const std::string& lines);

 private:
  const bool quiet_;
  std::mutex mutex_;
  std::set<std::string> printed_;
};

}  // namespace program
