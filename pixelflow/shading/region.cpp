#include "pixelflow/shading/region.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/interleaving.h"
#include "pixelflow/shading/region_programs.h"

namespace pfman {
namespace {

using pixelflow::kPacketBytes;
using pixelflow::kRegionHeight;
using pixelflow::kRegionWidth;
using pixelflow::PixelArray;

constexpr std::size_t kMostSources = 256;  // that Result::source tells apart

constexpr double kReach = 1e30;  // of the numbers of a view, and of their inverses: floats hold all of them

void check(const EyeSpace& eye) {
  for (const double value : {eye.near, eye.far, eye.x0, eye.dx, eye.y0, eye.dy}) {
    if (!(std::abs(value) <= kReach)) throw std::invalid_argument("a number of the view is out of reach");
  }
  if (eye.near >= eye.far || (eye.perspective && eye.near < 1 / kReach)) {
    throw std::invalid_argument("the near plane lies at " + std::to_string(eye.near) + ", the far plane at " +
                                std::to_string(eye.far));
  }
}

std::size_t place_of(const RegionPixels& pixels, std::size_t n) {
  return static_cast<std::size_t>(pixels.rows[n]) * kRegionWidth + pixels.columns[n];
}

void check(const RegionPixels& pixels) {
  const std::size_t count = pixels.depth.size();
  if (pixels.packets < 1 || pixels.packets > kMostPackets) {
    throw std::invalid_argument("a pixel has 1 to " + std::to_string(kMostPackets) + " packets, not " +
                                std::to_string(pixels.packets));
  }
  if (pixels.columns.size() != count || pixels.rows.size() != count ||
      pixels.payload.size() != count * static_cast<std::size_t>(pixels.packets * kPacketPayload)) {
    throw std::invalid_argument("columns, rows, depths and payloads of a region are those of different pixels");
  }
  for (std::size_t n = 0; n < count; ++n) {
    if (pixels.columns[n] >= kRegionWidth || pixels.rows[n] >= kRegionHeight) {
      throw std::invalid_argument("a pixel lies outside of its region");
    }
    if (n > 0 && place_of(pixels, n) <= place_of(pixels, n - 1)) {
      throw std::invalid_argument("the pixels of a region do not come in order of row and column");
    }
    if (pixels.depth[n] == kFarthest) throw std::invalid_argument("a pixel has the depth of the background");
  }
}

/// Which elements show something, and whose pixel is the closest.
struct Coverage {
  std::vector<int> element = std::vector<int>(kRegionWidth * kRegionHeight, -1);  ///< by place
  std::vector<std::uint8_t> columns, rows, winner;                                ///< by element
  int packets = 1, sources = 0;
};

Coverage cover(std::span<const RegionPixels> sources) {
  Coverage all;
  std::vector<std::uint32_t> closest(all.element.size(), kFarthest);
  std::vector<std::uint8_t> winner(all.element.size());
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const RegionPixels& pixels = sources[s];
    check(pixels);
    if (pixels.depth.empty()) continue;
    ++all.sources;
    all.packets = std::max(all.packets, pixels.packets);
    for (std::size_t n = 0; n < pixels.depth.size(); ++n) {
      const std::size_t place = place_of(pixels, n);
      if (pixels.depth[n] >= closest[place]) continue;
      closest[place] = pixels.depth[n];
      winner[place] = static_cast<std::uint8_t>(s);
    }
  }
  for (std::size_t place = 0; place < closest.size(); ++place) {
    if (closest[place] == kFarthest) continue;
    all.element[place] = static_cast<int>(all.winner.size());
    all.columns.push_back(static_cast<std::uint8_t>(place % kRegionWidth));
    all.rows.push_back(static_cast<std::uint8_t>(place / kRegionWidth));
    all.winner.push_back(winner[place]);
  }
  return all;
}

/// Through the load port of a rendering node: its pixels into their elements, the background into the others.
void load(const RegionPixels& pixels, const Coverage& coverage, PixelArray& array) {
  std::vector<std::size_t> elements;
  for (std::size_t n = 0; n < pixels.depth.size(); ++n) {
    elements.push_back(static_cast<std::size_t>(coverage.element[place_of(pixels, n)]));
  }
  std::vector<std::uint8_t> row(coverage.columns.size());
  for (int byte = 0; byte < pixelflow::kDepthBytes; ++byte) {
    std::fill(row.begin(), row.end(), std::uint8_t{0xFF});
    for (std::size_t n = 0; n < elements.size(); ++n) {
      row[elements[n]] = static_cast<std::uint8_t>(pixels.depth[n] >> 8 * byte);
    }
    array.write(kDepthAt + byte, row);
  }
  const auto own = static_cast<std::size_t>(pixels.packets * kPacketPayload);
  const auto all = static_cast<std::size_t>(coverage.packets * kPacketPayload);
  for (std::size_t byte = 0; byte < all; ++byte) {
    std::fill(row.begin(), row.end(), std::uint8_t{0});
    for (std::size_t n = 0; n < elements.size() && byte < own; ++n) row[elements[n]] = pixels.payload[n * own + byte];
    array.write(kShaderIdAt + static_cast<int>(byte), row);
  }
}

/// The programs that are the same for all regions.
struct Programs {
  Programs() {
    for (int n = 0; n < kMostPackets; ++n) {
      send.push_back(send_pixel(n));
      take.push_back(take_pixel(n));
      clear.push_back(clear_rest(n + 1));
    }
  }
  std::vector<pixelflow::Program> send, take, clear;  ///< by packet; clear: by packets in use - 1
  pixelflow::Program colors = send_colors();
};
const Programs& programs() {
  static const Programs all;
  return all;
}

std::uint64_t run(const pixelflow::Program& program, PixelArray& array) {
  const std::uint64_t before = array.counters().cycles;
  array.run(program);
  return array.counters().cycles - before;
}

}  // namespace

struct FrameShading::Shared {
  Interleaving interleaving;
  EyeSpace eye;
  StreamCache& cache;
};

FrameShading::FrameShading(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures,
                           const EyeSpace& eye, StreamCache& cache) {
  check(eye);
  shared_.reset(new Shared{Interleaving(std::move(surfaces), std::move(lights), textures), eye, cache});
}

FrameShading::~FrameShading() = default;

RegionNode::RegionNode(std::unique_ptr<PixelArray> array) : array_(std::move(array)) {}

RegionNode::Result RegionNode::work(FrameShading& frame, int first_column, int first_row,
                                    std::span<const RegionPixels> sources) {
  if (sources.size() > kMostSources) throw std::invalid_argument("more rendering nodes than can be told apart");
  Result result;
  Coverage coverage = cover(sources);
  RegionCounts& counts = result.counts;
  counts.pixels = static_cast<int>(coverage.columns.size());
  if (counts.pixels == 0) return result;
  counts.sources = coverage.sources;
  counts.packets = coverage.packets;
  array_->cover(counts.pixels);
  array_->place(coverage.columns, coverage.rows);

  // The rendering nodes, one after another: what left the last one arrives at the shading node.
  const std::size_t bytes = coverage.columns.size() * kPacketBytes;
  std::vector<std::vector<std::uint8_t>> packets(static_cast<std::size_t>(coverage.packets));
  for (const RegionPixels& pixels : sources) {
    if (pixels.depth.empty()) continue;
    load(pixels, coverage, *array_);
    for (std::size_t n = 0; n < packets.size(); ++n) {
      const bool most_upstream = packets[n].empty();
      if (!most_upstream) {
        array_->compose(n == 0 ? pixelflow::Compose::Closer : pixelflow::Compose::Repeat, packets[n]);
      }
      counts.compose += run(programs().send[n], *array_);
      packets[n].resize(bytes);
      array_->sent(packets[n]);
    }
  }

  const FrameShading::Shared& shared = *frame.shared_;
  for (std::size_t n = 0; n < packets.size(); ++n) {
    array_->load(packets[n]);
    counts.receive += run(programs().take[n], *array_);
  }
  counts.pre_shade += run(pre_shade(shared.eye, first_column, first_row), *array_);
  counts.pre_shade += run(programs().clear[packets.size() - 1], *array_);
  const Interleaving::Work work = shared.interleaving.shade(*array_, shared.cache);
  counts.pre = work.cycles.pre;
  counts.illum = work.cycles.illum;
  counts.post = work.cycles.post;
  counts.lights = work.cycles.lights;
  counts.lookups = work.cycles.lookups;
  counts.executions = work.executions;
  counts.shared = work.shared;
  counts.send = run(programs().colors, *array_);
  packets[0].resize(bytes);
  array_->sent(packets[0]);
  for (std::size_t n = 0; n < coverage.columns.size(); ++n) {
    const std::uint8_t* const packet = packets[0].data() + n * kPacketBytes;
    result.colors.push_back({packet[0], packet[1], packet[2]});
  }
  result.columns = std::move(coverage.columns);
  result.rows = std::move(coverage.rows);
  result.source = std::move(coverage.winner);
  return result;
}

}  // namespace pfman
