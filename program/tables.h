// The tables of Watkins's thesis: published figures beside those measured on the reconstructed objects in scenes/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cmodel/vsg/answer.h"
#include "program/table.h"
#include "scanline/frame.h"
#include "scanline/visible_segment_generator.h"

namespace program {

/// The folder that holds scenes/ and tables/: `chosen` (--data) if it is not empty, else watkins::data_folder(). Throws scanline::UserError when there is no such folder.
std::filesystem::path data_folder(const std::string& chosen);

/// The ten objects of chapter VII in the paper's order, as scenes/watkins names them.
const std::vector<std::string>& ten_objects();

/// Measures scenes: one machine, one data folder.
class SceneMeter {
 public:
  SceneMeter(std::filesystem::path data, scanline::VisibleSegmentGenerator& generator)
      : data_(std::move(data)), generator_(generator) {}

  const std::filesystem::path& data() const { return data_; }

  /// `scene` is relative to scenes/, without its suffix. Back faces are rejected, as the thesis did.
  vsg::FrameAnswer measure(const std::string& scene);

  /// The same with the first `polygons` polygons of the scene alone.
  vsg::FrameAnswer measure_part(const std::string& scene, std::size_t polygons);

  /// Segment references of frames `first` to `last` of a scene's sequence, by the golden model, with and without
  /// frame-to-frame coherence. A scene without a sequence stands still.
  std::int64_t sequence_references(const std::string& scene, int first, int last, bool coherence) const;

 private:
  scanline::Frame frame_of(const std::string& scene) const;
  vsg::FrameAnswer work(const scanline::Frame& frame, const std::string& scene);

  std::filesystem::path data_;
  scanline::VisibleSegmentGenerator& generator_;
};

/// Ten objects by thirteen rows; rows 10 and 11 also as the old listing counted, and clock cycles when RTL did the
/// work.
Table figure33(SceneMeter& meter);
/// Figure 33 as the thesis prints it: objects side by side, each row published, measured, ratio.
std::string figure33_text(const Table& table);

/// Penetration under six algorithms. Only the last, VSG6, is modelled here; the others are shown as published.
Table figure32(SceneMeter& meter);

/// Statements of the text.
Table claims(SceneMeter& meter);

/// Reads a file of tables/; throws scanline::UserError naming it when it is missing or malformed.
nlohmann::json read_table_file(const std::filesystem::path& path);

/// Prints table `name` (fig32, fig33, claims).
void run_tables(const std::string& name, bool json, SceneMeter& meter);

}  // namespace program
