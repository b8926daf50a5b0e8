#include "program/shader_picture.h"

#include <memory>
#include <mutex>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/test_textures.h"
#include "program/progress.h"
#include "program/refuse.h"
#include "watkins/parallel.h"

namespace program {
namespace {

using pixelflow::kRegionHeight;
using pixelflow::kRegionWidth;

/// What a thread works with.
struct Worker {
  std::unique_ptr<pixelflow::PixelArray> array;
  pfman::ShadingNode node;
};

/// Workers that nobody has at the moment; made when all are busy.
class Workers {
 public:
  Workers(const pfman::Instance& surface, const std::vector<pfman::Instance>& lights,
          const pfman::TextureMemory& textures, const PixelOptions& pixels)
      : surface_(surface), lights_(lights), textures_(textures), pixels_(pixels) {}

  std::unique_ptr<Worker> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<Worker> worker = std::move(free_.back());
        free_.pop_back();
        return worker;
      }
    }
    return std::make_unique<Worker>(
        Worker{watkins::make_array(pixels_, kRegionWidth * kRegionHeight), {{surface_}, lights_, &textures_}});
  }
  void give_back(std::unique_ptr<Worker> worker) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(worker));
  }
  const std::vector<std::unique_ptr<Worker>>& all() const { return free_; }

 private:
  const pfman::Instance& surface_;
  const std::vector<pfman::Instance>& lights_;
  const pfman::TextureMemory& textures_;
  const PixelOptions& pixels_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> free_;
};

constexpr float kBackground[] = {30, 33, 38};

/// The means of samples x samples colours.
scanline::Picture averaged(const std::vector<float>& colors, int width, int height, int samples) {
  const auto row_length = static_cast<std::size_t>(width) * static_cast<std::size_t>(samples);
  std::vector<float> means;
  means.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      for (std::size_t c = 0; c < 3; ++c) {
        float sum = 0;
        for (int n = 0; n < samples * samples; ++n) {
          const auto x = static_cast<std::size_t>(column * samples + n % samples);
          const auto y = static_cast<std::size_t>(row * samples + n / samples);
          sum += colors[3 * (y * row_length + x) + c];
        }
        means.push_back(sum / static_cast<float>(samples * samples));
      }
    }
  }
  return scanline::Picture(width, height, std::move(means));
}

/// Colours of the pixels that show the surface; the others stay as they are.
void copy_colors(const pixelflow::PixelArray& array, const pfman::TestView& view, int first_column, int first_row,
                 std::vector<float>& colors) {
  const auto lanes = static_cast<std::size_t>(array.lanes());
  std::vector<std::uint8_t> low(lanes), high(lanes), component(lanes);
  array.read(pfman::kShaderIdAt, low);
  array.read(pfman::kShaderIdAt + 1, high);
  for (int c = 0; c < 3; ++c) {
    array.read(pfman::kColorAt + c, component);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const int column = first_column + static_cast<int>(lane) % kRegionWidth;
      const int row = first_row + static_cast<int>(lane) / kRegionWidth;
      if (column >= view.width || row >= view.height || (low[lane] == 0 && high[lane] == 0)) continue;
      colors[(static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(column)) *
                 3 +
             static_cast<std::size_t>(c)] = component[lane];
    }
  }
}

}  // namespace

ShaderPicture shade_picture(const pfman::TestView& picture_view, pfman::Instance surface,
                            std::vector<pfman::Instance> lights, const PixelOptions& pixels, int samples, int threads,
                            bool quiet) {
  pfman::TestView view = picture_view;
  view.width *= samples;
  view.height *= samples;
  const pfman::TestSurface test(view);
  const pfman::TextureMemory textures = pfman::test_textures();
  test.place(surface);
  try {
    pfman::ShadingNode({surface}, lights, &textures);
  } catch (const std::invalid_argument& mistake) {
    refuse(mistake.what());
  }

  const int across = (view.width + kRegionWidth - 1) / kRegionWidth;
  const int down = (view.height + kRegionHeight - 1) / kRegionHeight;
  std::vector<float> colors;
  const std::size_t numbers = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) * 3;
  while (colors.size() < numbers) colors.push_back(kBackground[colors.size() % 3]);
  Workers workers(surface, lights, textures, pixels);
  {
    Progress progress("regions", across * down, quiet);
    watkins::for_each_index(across * down, threads, [&](int region) {
      const int column = region % across * kRegionWidth, row = region / across * kRegionHeight;
      std::unique_ptr<Worker> worker = workers.take();
      test.fill(surface, column, row, *worker->array);
      worker->node.shade(*worker->array);
      copy_colors(*worker->array, view, column, row, colors);
      workers.give_back(std::move(worker));
      progress.advance();
    });
  }
  ShaderPicture result{averaged(colors, picture_view.width, picture_view.height, samples), {}, 0};
  for (const auto& worker : workers.all()) {
    const pfman::ShadingNode::Cycles& cycles = worker->node.cycles();
    result.cycles.pre += cycles.pre;
    result.cycles.illum += cycles.illum;
    result.cycles.post += cycles.post;
    result.cycles.lights += cycles.lights;
    result.cycles.lookups += cycles.lookups;
    result.regions += worker->node.executions();
  }
  return result;
}

}  // namespace program
