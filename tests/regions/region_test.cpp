// Regions from the pixels of rendering nodes to colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <thread>

#include "tests/pixelflow_model/seed.h"
#include "tests/regions/scene.h"

namespace region_tests {
namespace {

using pfman::RegionNode;
using pfman::RegionPixels;
using pfman_tests::all_levels;
using pixelflow::Level;
using pixelflow::make_golden_array;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kWholeRegion = pixelflow::kRegionWidth * pixelflow::kRegionHeight;
const std::vector<int> kAllIds{kPlain, kWide, kWhere, kRed, kSecondRed, kSpots};

/// A pixel's place, (row, column).
using Place = std::pair<int, int>;
struct Closest {
  std::size_t source, pixel;
};

std::map<Place, Closest> closest(const std::vector<RegionPixels>& sources) {
  std::map<Place, Closest> result;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    for (std::size_t n = 0; n < sources[s].depth.size(); ++n) {
      const Place place{sources[s].rows[n], sources[s].columns[n]};
      const auto [at, added] = result.try_emplace(place, Closest{s, n});
      if (added) continue;
      if (sources[s].depth[n] < sources[at->second.source].depth[at->second.pixel]) at->second = {s, n};
    }
  }
  return result;
}

TEST(Regions, ShowTheClosestPixelOfAllNodes) {
  const std::uint64_t seed = seed_or(81);
  for (auto& level : all_levels(2 * pixelflow::kElements)) {
    std::mt19937_64 random(seed);
    Scene scene(std::move(level.array));
    for (int round = 0; round < 8; ++round) {
      const std::string where = replay(seed) + ", " + level.name + ", round " + std::to_string(round);
      std::vector<RegionPixels> sources;
      for (int n = 0; n <= round % 4; ++n) {
        // Nodes with packets of their own number; one that shows nothing in between.
        const bool wide = n % 2 == 0;
        sources.push_back(
            random_pixels(random, wide ? std::vector{kPlain, kWide} : std::vector{kPlain}, 3, wide ? 2 : 1));
        if (n == 1) sources.emplace_back();
      }
      const RegionNode::Result result = scene.work(sources);
      const auto expected = closest(sources);
      ASSERT_EQ(result.colors.size(), expected.size()) << where;
      std::size_t n = 0;
      for (const auto& [place, winner] : expected) {
        ASSERT_EQ(Place(result.rows[n], result.columns[n]), place) << where;
        ASSERT_EQ(result.source[n], winner.source) << where << ", pixel " << n;
        const RegionPixels& source = sources[winner.source];
        const std::uint8_t* const payload =
            source.payload.data() + winner.pixel * static_cast<std::size_t>(source.packets * pfman::kPacketPayload);
        const std::uint8_t* const color = payload + pfman::kShaderIdBytes + (payload[1] == kWide >> 8 ? 36 : 0);
        ASSERT_TRUE(std::equal(color, color + 3, result.colors[n].begin())) << where << ", pixel " << n;
        ++n;
      }
      EXPECT_EQ(result.counts.pixels, static_cast<int>(expected.size()));
      EXPECT_EQ(result.counts.sources, round % 4 + 1);
      EXPECT_EQ(result.counts.packets, 2);
    }
  }
}

/// The whole picture's samples come in: also at its right edge, where regions are covered in part.
TEST(Regions, KnowWhereTheyLieInThePicture) {
  const std::uint64_t seed = seed_or(82);
  std::mt19937_64 random(seed);
  Scene scene(make_golden_array(Level::Macro, kWholeRegion));
  for (const auto& [first_column, first_row] : {std::pair{0, 0}, {512, 448}, {256, 64}}) {
    const std::vector<RegionPixels> sources{random_pixels(random, {kWhere}, 200)};
    const RegionNode::Result result = scene.work(sources, first_column, first_row);
    for (std::size_t n = 0; n < result.colors.size(); ++n) {
      const double position[3] = {(first_column + result.columns[n]) / 640.0, 1 - (first_row + result.rows[n]) / 480.0,
                                  0.25 + 0.5 * sources[0].depth[n] / pfman::kFarthest};
      for (std::size_t c = 0; c < 3; ++c) {
        const double exact = std::clamp(position[c] * 256, 0.0, 255.0);
        // What lies at the edge of a grey level may fall to either side.
        ASSERT_GE(result.colors[n][c], std::floor(exact - 1e-4)) << replay(seed) << ", pixel " << n;
        ASSERT_LE(result.colors[n][c], std::floor(exact + 1e-4)) << replay(seed) << ", pixel " << n;
      }
    }
  }
}

void expect_same(const RegionNode::Result& a, const RegionNode::Result& b, const std::string& where) {
  EXPECT_EQ(a.columns, b.columns) << where;
  EXPECT_EQ(a.rows, b.rows) << where;
  EXPECT_EQ(a.colors, b.colors) << where;
  EXPECT_EQ(a.source, b.source) << where;
  EXPECT_TRUE(a.counts == b.counts) << where;
}

TEST(Regions, HaveTheSameColoursAndCountsAtAllLevels) {
  const std::uint64_t seed = seed_or(83);
  std::mt19937_64 random(seed);
  const std::vector<RegionPixels> sources{random_pixels(random, kAllIds, 4), random_pixels(random, kAllIds, 4)};
  std::vector<RegionNode::Result> results;
  for (auto& level : all_levels(2 * pixelflow::kElements)) {
    Scene scene(std::move(level.array));
    results.push_back(scene.work(sources, 128, 64));
    expect_same(results.back(), results.front(), replay(seed) + ", " + level.name);
  }
  const pfman::RegionCounts& counts = results.front().counts;
  EXPECT_EQ(counts.executions, 5) << "the two red surfaces are one";
  EXPECT_EQ(counts.shared, 2);
  for (const std::uint64_t cycles : {counts.compose, counts.receive, counts.pre_shade, counts.pre, counts.illum,
                                     counts.post, counts.lights, counts.send}) {
    EXPECT_GT(cycles, 0u);
  }
}

TEST(Regions, HaveTheSameColoursPackedAndInPlace) {
  const std::uint64_t seed = seed_or(84);
  std::mt19937_64 random(seed);
  const RegionPixels whole = random_pixels(random, kAllIds, 256);
  ASSERT_EQ(whole.depth.size(), static_cast<std::size_t>(kWholeRegion));
  RegionPixels part;
  part.packets = whole.packets;
  std::vector<std::size_t> chosen;
  const auto bytes = static_cast<std::ptrdiff_t>(whole.packets * pfman::kPacketPayload);
  for (std::size_t n = 0; n < whole.depth.size(); ++n) {
    if (random() % 20 != 0) continue;
    chosen.push_back(n);
    part.columns.push_back(whole.columns[n]);
    part.rows.push_back(whole.rows[n]);
    part.depth.push_back(whole.depth[n]);
    const auto first = whole.payload.begin() + static_cast<std::ptrdiff_t>(n) * bytes;
    part.payload.insert(part.payload.end(), first, first + bytes);
  }
  Scene scene(make_golden_array(Level::Macro, kWholeRegion));
  const RegionNode::Result in_place = scene.work({&whole, 1}), packed = scene.work({&part, 1});
  ASSERT_EQ(packed.colors.size(), chosen.size());
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    ASSERT_EQ(packed.colors[n], in_place.colors[chosen[n]]) << replay(seed) << ", pixel " << chosen[n];
  }
  EXPECT_EQ(packed.counts.shading(), in_place.counts.shading()) << "cycles do not depend on the number of pixels";
}

TEST(Regions, DoNotDependOnThreads) {
  const std::uint64_t seed = seed_or(85);
  std::mt19937_64 random(seed);
  constexpr std::size_t kRegions = 24;
  std::vector<RegionPixels> regions;
  for (std::size_t n = 0; n < kRegions; ++n) {
    std::vector<int> ids;
    for (const int id : kAllIds) {
      if (random() % 2) ids.push_back(id);
    }
    if (ids.empty()) ids.push_back(kPlain);
    regions.push_back(random_pixels(random, ids, static_cast<unsigned>(1 + random() % 8)));
  }
  std::vector<std::vector<RegionNode::Result>> results;
  std::vector<std::pair<int, int>> streams;
  for (const int threads : {1, 4}) {
    pfman::StreamCache cache;
    pfman::FrameShading frame(surfaces(), lamps(), nullptr, unit_view(), cache);
    std::vector<RegionNode::Result>& worked = results.emplace_back(kRegions);
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> all;
    for (int t = 0; t < threads; ++t) {
      all.emplace_back([&] {
        RegionNode node(make_golden_array(Level::Macro, kWholeRegion));
        for (std::size_t n = next++; n < kRegions; n = next++) {
          worked[n] = node.work(frame, 128 * static_cast<int>(n % 5), 64 * static_cast<int>(n / 5), {&regions[n], 1});
        }
      });
    }
    for (std::thread& thread : all) thread.join();
    streams.emplace_back(cache.made(), cache.reused());
  }
  for (std::size_t n = 0; n < kRegions; ++n) {
    expect_same(results[1][n], results[0][n], replay(seed) + ", region " + std::to_string(n));
  }
  EXPECT_EQ(streams[1], streams[0]) << replay(seed);
}

TEST(Regions, DoNotSeeWhatWasInMemoryBefore) {
  const std::uint64_t seed = seed_or(86);
  for (const Level level : {Level::Macro, Level::Model}) {
    std::mt19937_64 random(seed);
    const RegionPixels first = random_pixels(random, kAllIds, 20, pfman::kMostPackets);
    const RegionPixels second = random_pixels(random, {kForgetful, kSpots}, 20, 1);
    Scene used(make_golden_array(level, kWholeRegion)), fresh(make_golden_array(level, kWholeRegion));
    used.work({&first, 1});
    expect_same(used.work({&second, 1}), fresh.work({&second, 1}), replay(seed));
  }
}

TEST(Regions, WithoutPixelsCostNothing) {
  auto array = make_golden_array(Level::Macro, 256);
  const pixelflow::PixelArray& watched = *array;
  Scene scene(std::move(array));
  const std::vector<RegionPixels> nothing(3);
  for (const auto& result : {scene.work({}), scene.work(nothing)}) {
    EXPECT_TRUE(result.colors.empty() && result.columns.empty() && result.source.empty());
    EXPECT_TRUE(result.counts == pfman::RegionCounts{});
  }
  EXPECT_EQ(watched.counters().cycles, 0u);
}

TEST(Regions, KeepStreamsFromFrameToFrame) {
  const std::uint64_t seed = seed_or(87);
  std::mt19937_64 random(seed);
  pfman::StreamCache cache;
  RegionNode node(make_golden_array(Level::Macro, 256));
  const RegionPixels pixels = random_pixels(random, {kRed, kSpots, kPlain}, 4);
  std::vector<int> made;
  for (const double shine : {8.0, 8.0, 9.0}) {
    std::vector<pfman::Instance> all = surfaces();
    all[4].set("shine", {shine});
    pfman::FrameShading frame(std::move(all), lamps(), nullptr, unit_view(), cache);
    node.work(frame, 0, 0, {&pixels, 1});
    node.work(frame, 128, 0, {&pixels, 1});
    made.push_back(cache.made());
  }
  EXPECT_EQ(made[0], 5) << "three surfaces, two lights";
  EXPECT_EQ(made[1], made[0]);
  EXPECT_EQ(made[2], made[1] + 1) << "red no longer serves the second red's pixels";
}

/// The pixels of one surface.
RegionPixels only(const RegionPixels& pixels, int id) {
  RegionPixels result;
  result.packets = pixels.packets;
  const std::size_t stride = pixels.payload.size() / pixels.depth.size();
  for (std::size_t n = 0; n < pixels.depth.size(); ++n) {
    const auto payload = pixels.payload.begin() + static_cast<std::ptrdiff_t>(n * stride);
    if ((payload[0] | payload[1] << 8) != id) continue;
    result.columns.push_back(pixels.columns[n]);
    result.rows.push_back(pixels.rows[n]);
    result.depth.push_back(pixels.depth[n]);
    result.payload.insert(result.payload.end(), payload, payload + static_cast<std::ptrdiff_t>(stride));
  }
  return result;
}

/// Surfaces that share their lighting do so with those that are there, other ones in other regions; and keep what they
/// need for later apart from it.
TEST(Regions, GiveEachPixelWhatItWouldHaveAlone) {
  const std::uint64_t seed = seed_or(88);
  std::mt19937_64 random(seed);
  pfman::StreamCache cache;
  RegionNode node(make_golden_array(Level::Macro, 1024));
  for (const double shine : {8.0, 9.0, 8.0}) {  // the two red ones are one and the same, or not
    std::vector<pfman::Instance> all = surfaces();
    std::swap(all[3], all[5]);
    all[4].set("shine", {shine});
    pfman::FrameShading frame(std::move(all), lamps(), nullptr, unit_view(), cache);
    for (const std::vector<int>& ids : std::vector<std::vector<int>>{
             {kRed, kSpots}, {kSecondRed, kSpots}, {kRed, kSecondRed}, {kSpots, kPlain, kSecondRed, kRed}}) {
      const RegionPixels pixels = random_pixels(random, ids, 10);
      const RegionNode::Result together = node.work(frame, 0, 0, {&pixels, 1});
      EXPECT_EQ(together.counts.shared > 0, ids[0] == kSpots || ids[1] == kSpots || shine == 9);
      std::map<Place, std::array<std::uint8_t, 3>> alone;
      for (const int id : ids) {
        const RegionPixels its = only(pixels, id);
        const RegionNode::Result result = node.work(frame, 0, 0, {&its, 1});
        EXPECT_EQ(result.counts.shared, 0);
        for (std::size_t n = 0; n < result.colors.size(); ++n) {
          alone[{result.rows[n], result.columns[n]}] = result.colors[n];
        }
      }
      ASSERT_EQ(alone.size(), together.colors.size());
      for (std::size_t n = 0; n < together.colors.size(); ++n) {
        const Place place{together.rows[n], together.columns[n]};
        ASSERT_EQ(together.colors[n], alone.at(place))
            << replay(seed) << ", row " << place.first << ", column " << place.second;
      }
    }
  }
}

TEST(Regions, RefuseWhatIsNoRegion) {
  Scene scene(make_golden_array(Level::Macro, 256));
  const RegionPixels good{{1, 2}, {0, 0}, {5, 6}, 1, std::vector<std::uint8_t>(2 * pfman::kPacketPayload)};
  EXPECT_NO_THROW(scene.work({&good, 1}));
  const auto refuses = [&](const auto& change) {
    RegionPixels bad = good;
    change(bad);
    EXPECT_THROW(scene.work({&bad, 1}), std::invalid_argument);
  };
  refuses([](RegionPixels& p) { p.columns[1] = 128; });
  refuses([](RegionPixels& p) { p.rows[1] = 64; });
  refuses([](RegionPixels& p) { p.columns[1] = 1; });
  refuses([](RegionPixels& p) { p.rows[0] = 1; });
  refuses([](RegionPixels& p) { p.depth[0] = pfman::kFarthest; });
  refuses([](RegionPixels& p) { p.depth.pop_back(); });
  refuses([](RegionPixels& p) { p.payload.pop_back(); });
  refuses([](RegionPixels& p) { p.packets = 0; });
  refuses([](RegionPixels& p) { p.packets = pfman::kMostPackets + 1; });
  std::mt19937_64 random(1);
  const RegionPixels large = random_pixels(random, {kPlain}, 256);
  EXPECT_THROW(scene.work({&large, 1}), std::invalid_argument) << "more pixels than elements";
}

TEST(Regions, RefuseViewsThatAreNone) {
  pfman::StreamCache cache;
  const auto refuses = [&](const auto& change) {
    pfman::EyeSpace eye{true, 1, 10, 0, 0.1, 0, -0.1};
    change(eye);
    EXPECT_THROW(pfman::FrameShading(surfaces(), lamps(), nullptr, eye, cache), std::invalid_argument);
  };
  refuses([](pfman::EyeSpace& eye) { eye.near = 0; });
  refuses([](pfman::EyeSpace& eye) { eye.near = 10; });
  refuses([](pfman::EyeSpace& eye) { eye.far = std::nan(""); });
  refuses([](pfman::EyeSpace& eye) { eye.x0 = INFINITY; });
  refuses([](pfman::EyeSpace& eye) { eye.perspective = false, eye.near = 11; });
}

}  // namespace
}  // namespace region_tests
