// Both machines together: a scene through the Visible Segment Generator, regions and pixel processors to a picture.
//
//   scene -> frame, one a rendering node -> visible segments -> spans -> pixels of regions -> composed -> shaded ->
//   picture
//
// What reaches a surface's varying parameters (docs/formats.md): px_material_normal, px_shader_texcoord,
// polygon_normal, field_visibility, field_reflection, and every other one from the attribute of its name at the corners
// of the mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/shading/region.h"
#include "scanline/edge_history.h"
#include "scanline/field_scene.h"
#include "scanline/picture.h"
#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "scanline/show.h"
#include "watkins/machines.h"

namespace watkins {

struct RenderOptions {
  GeneratorOptions generator;
  PixelOptions pixels;
  int samples = 1;          ///< samples x samples of them make a pixel
  int threads = 1;          ///< no bit depends on it
  int rendering_nodes = 1;  ///< each has a share of the polygons; 1 to kMostRenderingNodes
  /// A plain sphere tracer finds what is visible instead of the Visible Segment Generator: a reference for scenes of
  /// distance fields alone.
  bool traced = false;
  std::optional<scanline::Show> show;  ///< a false-colour picture instead; one rendering node
  bool channels = false;
};

// What the command line and the interface allow.
constexpr int kMostSamples = 64, kMostThreads = 256, kMostRenderingNodes = 64, kMostShadingNodes = 1024;

/// Seconds; of `surfaces` (what pixels show and send) and `shading` the sums over all threads.
struct StageTimes {
  double pre_frame = 0, visible_segments = 0, surfaces = 0, shading = 0;
};

/// What a picture cost the machines; the same at every level of modelling.
struct FrameCounts {
  int regions = 0;          ///< of the picture, in samples
  int covered_regions = 0;  ///< that something covers: only these are composed and shaded
  std::int64_t samples = 0, covered_samples = 0;
  pfman::RegionCounts sum;  ///< over the covered regions; `packets` and `sources` are the largest of a region
  int largest_map = 0;      ///< bytes of the largest transfer map in use, shader ID included; 142 are the budget
  std::vector<std::uint64_t> region_cycles;  ///< that a shading node spends on each region, row by row of regions
  int streams_made = 0, streams_reused = 0;  ///< by the frame; streams are kept from frame to frame
  std::int64_t packet_bytes = 0;             ///< from rendering to shading nodes, depth included
  scanline::FieldCost fields;
};

/// The visible segments of a moment, on their way to shading.
struct VisibleFrame {
  double moment = 0;
  std::vector<scanline::SceneFrame> frames;         ///< one a rendering node
  std::vector<std::vector<std::uint32_t>> numbers;  ///< of the nodes' polygons in the whole frame; empty for one node
  std::vector<vsg::FrameAnswer> answers;
  std::unique_ptr<scanline::WorkRecorder> recorder;  ///< with --show
  std::vector<scanline::Diagnostic> warnings;
  StageTimes times;
};

/// Cycles of the busiest of `nodes` shading nodes, each of which shades every nodes-th region (section 6.1).
std::uint64_t busiest_node(const FrameCounts& counts, int nodes);

struct RenderedFrame {
  scanline::Picture picture;
  std::vector<vsg::FrameAnswer> answers;  ///< one a rendering node
  std::vector<scanline::Diagnostic> warnings;
  FrameCounts counts;
  StageTimes times;
};

/// Renders moments of one scene. The scene must outlive it.
class Renderer {
 public:
  /// Compiles the scene's shaders and reads their images. `scene_file` is named in messages. Throws scanline::UserError
  /// with every mistake found.
  Renderer(const scanline::Scene& scene, std::string scene_file, RenderOptions options);
  ~Renderer();

  /// To be called when the scene is another, but for its size: what has been compiled, images and streams stay. Throws
  /// scanline::UserError as the constructor does; the renderer is then of no use any more.
  void scene_changed();

  /// Called after each scan line of a rendering node, and after each region; by any thread.
  std::function<void()> on_step;
  /// How often that will be, for one frame.
  std::int64_t steps() const;
  /// Warnings of the shaders, formatted.
  const std::string& shader_warnings() const;

  /// Pre-frame processing and the Visible Segment Generator. Several threads may call it for different moments. Throws
  /// scanline::UserError, vsg::LockstepError. `history`, for frame coherence: what is known of the frame before, and
  /// then of this one.
  VisibleFrame find_visible(double moment, scanline::EdgeHistory* history = nullptr) const;

  /// Regions and shading, on options.threads threads; one moment after the other. Throws scanline::UserError,
  /// vsg::LockstepError.
  RenderedFrame shade(VisibleFrame visible);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace watkins
