#include "watkins/renderer.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

#include "pixelflow/compiler/memory_layout.h"
#include "scanline/flat_shader.h"
#include "scanline/spans.h"
#include "watkins/parallel.h"
#include "watkins/polygon_share.h"
#include "watkins/region_builder.h"
#include "watkins/scene_shading.h"

namespace watkins {
namespace {

using pixelflow::kRegionHeight;
using pixelflow::kRegionWidth;
using scanline::Rgb8;

constexpr int kBandRows = 16;

/// Seconds since it was asked before.
class Stopwatch {
 public:
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

void add(pfman::RegionCounts& sum, const pfman::RegionCounts& region) {
  sum.pixels += region.pixels;
  sum.sources = std::max(sum.sources, region.sources);
  sum.packets = std::max(sum.packets, region.packets);
  sum.executions += region.executions;
  sum.shared += region.shared;
  sum.compose += region.compose;
  sum.receive += region.receive;
  sum.pre_shade += region.pre_shade;
  sum.pre += region.pre;
  sum.illum += region.illum;
  sum.post += region.post;
  sum.lights += region.lights;
  sum.send += region.send;
  sum.lookups += region.lookups;
}

}  // namespace

struct Renderer::Work {
  Work(const scanline::Scene& scene_, std::string scene_file_, RenderOptions options_)
      : scene(scene_),
        scene_file(std::move(scene_file_)),
        options(std::move(options_)),
        width(scene_.width * options.samples),
        height(scene_.height * options.samples),
        across((width + kRegionWidth - 1) / kRegionWidth),
        down((height + kRegionHeight - 1) / kRegionHeight),
        shading(std::make_unique<SceneShading>(scene_, scene_file, files)) {}

  const scanline::Scene& scene;
  const std::string scene_file;
  const RenderOptions options;
  const int width, height;  ///< samples
  const int across, down;   ///< regions
  ShadingFiles files;
  std::unique_ptr<const SceneShading> shading;
  pfman::StreamCache cache;

  /// An array with its node for every thread at work, made when all are busy.
  std::mutex mutex;
  std::vector<std::unique_ptr<pfman::RegionNode>> idle;
  std::unique_ptr<pfman::RegionNode> take() {
    {
      const std::lock_guard lock(mutex);
      if (!idle.empty()) {
        std::unique_ptr<pfman::RegionNode> node = std::move(idle.back());
        idle.pop_back();
        return node;
      }
    }
    return std::make_unique<pfman::RegionNode>(make_array(options.pixels, kRegionWidth * kRegionHeight));
  }
  void give_back(std::unique_ptr<pfman::RegionNode> node) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(node));
  }

  /// One region of a frame: what its nodes show, what the picture gets.
  struct Region {
    pfman::RegionCounts counts;
    scanline::FieldCost cost;
    int largest_map = 0;
    double surfaces = 0, shaded = 0;  ///< seconds
  };
  vsg::FrameBlocks make_blocks(const scanline::SceneFrame& frame, const vsg::Parameters& parameters) const;
  std::unique_ptr<pfman::FrameShading> frame_shading(double moment, const pfman::EyeSpace& eye);
  Region work_region(const RegionBuilder& builder, const VisibleFrame& visible, pfman::FrameShading& frame, int column,
                     int row, std::vector<Rgb8>& samples, scanline::PictureChannels* channels);
  void note_channels(const SurfacePoint& point, std::uint32_t polygon, int column, int row,
                     const RegionBuilder& builder, scanline::PictureChannels& channels) const;
  scanline::PictureChannels empty_channels() const;
  void show(const VisibleFrame& visible, scanline::Picture& picture) const;
  void number_shaders();
  std::vector<std::uint32_t> shader_numbers;  ///< of each object, in the order of scanline::shader_names
};

Renderer::Renderer(const scanline::Scene& scene, std::string scene_file, RenderOptions options) {
  check_generator_options(options.generator);
  check_pixel_options(options.pixels);
  const auto refuse = [](const std::string& message) { throw scanline::UserError({"", 0, 0, message}); };
  if (options.show && options.rendering_nodes != 1)
    refuse("--show tells of one rendering node: it needs --rendering-nodes 1");
  if (options.show && options.traced) refuse("--show tells of the Visible Segment Generator: it excludes --traced");
  if (options.generator.frame_coherence && options.rendering_nodes != 1) {
    refuse("--frame-coherence needs --rendering-nodes 1");
  }
  if (!options.generator.trace.empty() && options.rendering_nodes != 1) {
    refuse("--trace writes the waveform of one rendering node: it needs --rendering-nodes 1");
  }
  if (options.traced) {
    for (const scanline::Object& object : scene.objects) {
      if (object.field) continue;
      throw scanline::UserError({object.file, object.line, 0,
                                 "object '" + object.name + "' is no distance field: --traced finds nothing else"});
    }
  }
  work_ = std::make_unique<Work>(scene, std::move(scene_file), std::move(options));
  work_->number_shaders();
}

void Renderer::Work::number_shaders() {
  const std::vector<std::string> names = scanline::shader_names(scene);
  shader_numbers.clear();
  for (const scanline::Object& object : scene.objects) {
    const auto found = std::find(names.begin(), names.end(), object.shader.name);
    shader_numbers.push_back(static_cast<std::uint32_t>(found - names.begin()) + 1);
  }
}

void Renderer::scene_changed() {
  work_->shading = std::make_unique<SceneShading>(work_->scene, work_->scene_file, work_->files);
  work_->number_shaders();
}

Renderer::~Renderer() = default;

const std::string& Renderer::shader_warnings() const { return work_->shading->warnings(); }

std::int64_t Renderer::steps() const {
  const std::int64_t lines =
      work_->options.traced ? 0 : std::int64_t{work_->options.rendering_nodes} * (work_->height + 1);
  return lines + (work_->options.show ? 0 : std::int64_t{work_->across} * work_->down);
}

VisibleFrame Renderer::find_visible(double moment, scanline::EdgeHistory* history) const {
  const RenderOptions& options = work_->options;
  VisibleFrame visible;
  visible.moment = moment;
  if (options.traced) return visible;
  Stopwatch watch;
  scanline::SceneFrame whole = scanline::make_scene_frame(work_->scene, moment, work_->width, work_->height);
  visible.warnings = std::move(whole.warnings);
  visible.frames = share_polygons(std::move(whole), options.rendering_nodes, visible.numbers);
  visible.times.pre_frame = watch.lap();

  if (options.show) {
    visible.recorder = std::make_unique<scanline::WorkRecorder>(*options.show, work_->width, work_->height);
  }
  visible.answers.resize(visible.frames.size());
  for_each_index(static_cast<int>(visible.frames.size()), options.threads, [&](int n) {
    const scanline::SceneFrame& frame = visible.frames[static_cast<std::size_t>(n)];
    vsg::Parameters parameters;
    parameters.frame_coherence = history != nullptr;
    const auto generator = make_generator(options.generator, parameters);
    if (on_step) generator->on_line = [this](int) { on_step(); };
    vsg::FrameBlocks blocks = work_->make_blocks(frame, generator->parameters());
    if (history != nullptr) history->mark(frame, blocks);
    visible.answers[static_cast<std::size_t>(n)] =
        generate(*generator, blocks, work_->scene_file, visible.recorder ? visible.recorder->sink() : vsg::EventSink());
    if (history != nullptr) history->remember(frame, blocks, visible.answers[static_cast<std::size_t>(n)]);
  });
  visible.times.visible_segments = watch.lap();
  return visible;
}

/// A false-colour picture, shaded by the host.
void Renderer::Work::show(const VisibleFrame& visible, scanline::Picture& picture) const {
  const scanline::SpanList spans(visible.answers.front());
  const scanline::FlatShader flat(scene, visible.frames.front());
  const auto stage = scanline::make_show_stage(*visible.recorder, flat);
  const int bands = (picture.height() + kBandRows - 1) / kBandRows;
  for_each_index(bands, options.threads, [&](int band) {
    const int first_row = band * kBandRows;
    picture.shade_rows(*stage, spans, options.samples, first_row, std::min(kBandRows, picture.height() - first_row));
  });
}

scanline::PictureChannels Renderer::Work::empty_channels() const {
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  scanline::PictureChannels c;
  c.depth.assign(pixels, static_cast<float>(scanline::kDepthRange));
  for (auto* numbers : {&c.polygon, &c.shader}) numbers->assign(pixels, 0);
  for (auto* numbers : {&c.normal_x, &c.normal_y, &c.normal_z}) numbers->assign(pixels, 0);
  return c;
}

void Renderer::Work::note_channels(const SurfacePoint& point, std::uint32_t polygon, int column, int row,
                                   const RegionBuilder& builder, scanline::PictureChannels& c) const {
  const int n = options.samples, middle = n / 2;
  if (column % n != middle || row % n != middle) return;
  const std::size_t pixel =
      static_cast<std::size_t>(row / n) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(column / n);
  c.depth[pixel] = static_cast<float>(builder.screen_depth(point.w));
  c.polygon[pixel] = polygon;
  c.shader[pixel] = shader_numbers[point.object];
  c.normal_x[pixel] = static_cast<float>(point.normal.x);
  c.normal_y[pixel] = static_cast<float>(point.normal.y);
  c.normal_z[pixel] = static_cast<float>(point.normal.z);
}

/// What does not fit into the machine's memories is the scene's mistake.
vsg::FrameBlocks Renderer::Work::make_blocks(const scanline::SceneFrame& frame,
                                             const vsg::Parameters& parameters) const {
  try {
    return scanline::make_blocks(frame.frame, parameters, false);
  } catch (const scanline::UserError& error) {
    std::vector<scanline::Diagnostic> mistakes = error.diagnostics();
    for (scanline::Diagnostic& mistake : mistakes) {
      if (mistake.file.empty()) mistake.file = scene_file;
    }
    throw scanline::UserError(std::move(mistakes));
  }
}

std::unique_ptr<pfman::FrameShading> Renderer::Work::frame_shading(double moment, const pfman::EyeSpace& eye) {
  try {
    return std::make_unique<pfman::FrameShading>(shading->surfaces(moment), shading->lights(moment),
                                                 &shading->textures(), eye, cache);
  } catch (const std::invalid_argument& mistake) {  // surfaces and lights that do not fit each other
    throw scanline::UserError({scene_file, 0, 0, mistake.what()});
  }
}

Renderer::Work::Region Renderer::Work::work_region(const RegionBuilder& builder, const VisibleFrame& visible,
                                                   pfman::FrameShading& frame, int column, int row,
                                                   std::vector<Rgb8>& samples, scanline::PictureChannels* channels) {
  Region region;
  Stopwatch watch;
  const std::size_t nodes = options.traced ? 1 : visible.frames.size();
  std::vector<RegionBuilder::Visible> found;
  int packets = 1;
  bool covered = false;
  for (std::size_t k = 0; k < nodes; ++k) {
    found.push_back(builder.find(k, column, row));
    packets = std::max(packets, found.back().packets);
    covered = covered || !found.back().points.empty();
  }
  if (!covered) {
    for (const RegionBuilder::Visible& node : found) region.cost += node.cost;
    region.surfaces = watch.lap();
    return region;
  }
  std::vector<pfman::RegionPixels> sources;
  for (std::size_t k = 0; k < nodes; ++k) {
    sources.push_back(builder.pack(k, found[k], packets));
    region.cost += found[k].cost;
    for (const SurfacePoint& point : found[k].points) {
      region.largest_map = std::max(region.largest_map, shading->object(point.object).map_bytes);
    }
  }
  region.surfaces = watch.lap();

  std::unique_ptr<pfman::RegionNode> node = take();
  const pfman::RegionNode::Result result = node->work(frame, column, row, sources);
  give_back(std::move(node));
  region.counts = result.counts;
  std::vector<std::size_t> next(nodes, 0);
  for (std::size_t n = 0; n < result.colors.size(); ++n) {
    const int x = column + result.columns[n], y = row + result.rows[n];
    const auto& color = result.colors[n];
    samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = {
        color[0], color[1], color[2]};
    if (!channels) continue;
    const std::size_t source = result.source[n];
    // Both are in order of row and column: the pixel is not far from where the last one was.
    const RegionBuilder::Visible& shown = found[source];
    std::size_t& at = next[source];
    while (shown.rows[at] != result.rows[n] || shown.columns[at] != result.columns[n]) ++at;
    const SurfacePoint& point = shown.points[at];
    const bool whole = visible.numbers.empty();
    note_channels(point, point.polygon == 0 || whole ? point.polygon : visible.numbers[source][point.polygon - 1], x, y,
                  builder, *channels);
  }
  region.shaded = watch.lap();
  return region;
}

std::uint64_t busiest_node(const FrameCounts& counts, int nodes) {
  std::vector<std::uint64_t> cycles(static_cast<std::size_t>(nodes), 0);
  for (std::size_t n = 0; n < counts.region_cycles.size(); ++n) cycles[n % cycles.size()] += counts.region_cycles[n];
  return *std::max_element(cycles.begin(), cycles.end());
}

RenderedFrame Renderer::shade(VisibleFrame visible) {
  Work& work = *work_;
  const RenderOptions& options = work.options;
  RenderedFrame result{
      scanline::Picture(work.scene.width, work.scene.height), {}, std::move(visible.warnings), {}, visible.times};
  FrameCounts& counts = result.counts;
  counts.regions = work.across * work.down;
  counts.samples = std::int64_t{work.width} * work.height;
  if (options.show) {
    Stopwatch watch;
    work.show(visible, result.picture);
    result.times.shading = watch.lap();
    result.answers = std::move(visible.answers);
    return result;
  }

  const RegionBuilder builder(work.scene, *work.shading, visible, work.width, work.height, options.traced);
  const int made = work.cache.made(), reused = work.cache.reused();
  std::vector<Work::Region> regions(static_cast<std::size_t>(counts.regions));
  std::vector<Rgb8> samples(static_cast<std::size_t>(counts.samples), scanline::to_rgb8(work.scene.background));
  if (options.channels) result.picture.channels = work.empty_channels();
  const std::unique_ptr<pfman::FrameShading> frame = work.frame_shading(visible.moment, builder.eye_space());
  try {
    for_each_index(counts.regions, options.threads, [&](int n) {
      regions[static_cast<std::size_t>(n)] =
          work.work_region(builder, visible, *frame, n % work.across * kRegionWidth, n / work.across * kRegionHeight,
                           samples, result.picture.channels ? &*result.picture.channels : nullptr);
      if (on_step) on_step();
    });
  } catch (const pfman::UniformError& error) {
    throw work.shading->mistake(error);
  }
  result.picture.set_rows(samples, options.samples, 0, work.scene.height);

  for (const Work::Region& region : regions) {
    counts.fields += region.cost;
    result.times.surfaces += region.surfaces;
    result.times.shading += region.shaded;
    counts.region_cycles.push_back(region.counts.shading());
    if (region.counts.pixels == 0) continue;
    ++counts.covered_regions;
    counts.covered_samples += region.counts.pixels;
    add(counts.sum, region.counts);
    counts.largest_map = std::max(counts.largest_map, region.largest_map);
    counts.packet_bytes += std::int64_t{region.counts.packets} * kRegionWidth * kRegionHeight * pixelflow::kPacketBytes;
  }
  counts.streams_made = work.cache.made() - made;
  counts.streams_reused = work.cache.reused() - reused;
  result.answers = std::move(visible.answers);
  return result;
}

}  // namespace watkins
