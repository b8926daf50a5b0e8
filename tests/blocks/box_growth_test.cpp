// The growth of the visible box against a reference that says what should come out: it picks the values from lists.
#include <gtest/gtest.h>

#include <algorithm>

#include "Vsorter_bench.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

/// One line at both clip points, as its two quadrants hold it.
struct Clipped {
  std::int64_t min[2], max[2];  ///< at the left, at the right
  bool behind[2];
  bool rising;
  int low() const { return rising ? 0 : 1; }  ///< the clip point at which its least Z lies
};

struct Growth {
  vsg::VisibleBox box;
  std::array<std::int64_t, kCandidateFields> candidate;  ///< block, polygon, X left, right, Z left, right, edge inside
  std::int64_t left, right;
  bool same, left_le, right_ge;
  Clipped news, old;
};

Growth random_growth(Random& random) {
  Growth g;
  const auto pixel = [&random] { return random.between(-3, 260); };
  const auto z = [&random] { return random.word(z_format().bits); };
  const int greatest = static_cast<int>(bench_parameters().segment_blocks);
  const auto block = [&random, greatest] { return static_cast<std::int32_t>(random.between(1, greatest)); };
  vsg::VisibleBox& b = g.box;
  b.segments = static_cast<int>(random.between(1, 9));
  b.x_left = random.word(x_format().bits), b.x_right = random.word(x_format().bits);
  b.z_min = z(), b.z_max = z();
  b.left = pixel(), b.right = pixel(), b.edge = pixel();
  b.front = block(), b.other = block(), b.front_polygon = block(), b.other_polygon = block();
  b.rising = random.coin();
  b.halvings = random.between(0, 1 << 20);
  g.candidate = {block(), block(), random.word(x_format().bits), random.word(x_format().bits), z(), z(), pixel()};
  g.left = pixel(), g.right = pixel();
  g.same = random.coin(), g.left_le = random.coin(), g.right_ge = random.coin();
  for (Clipped* line : {&g.news, &g.old}) {
    for (int side = 0; side < 2; ++side) {
      line->min[side] = z(), line->max[side] = z();
      line->behind[side] = random.once_in(3);
    }
    line->rising = random.coin();
  }
  g.news.rising = g.candidate[4] < g.candidate[5];
  return g;
}

vsg::VisibleBox reference(const Growth& g) {
  vsg::VisibleBox b = g.box;
  ++b.segments;
  const int low = g.news.low(), high = 1 - low;
  if (!g.same) {
    b.z_min = std::min({b.z_min, g.candidate[4], g.candidate[5]});
    b.z_max = std::max({b.z_max, g.candidate[4], g.candidate[5]});
  } else if (g.news.rising == g.old.rising) {
    // Parallel: at the low end the minimum of the line in front, at the high end the maximum of the line behind.
    if (g.news.behind[low] || g.old.behind[low]) b.z_min = (g.news.behind[low] ? g.old : g.news).min[low];
    if (g.news.behind[high] || g.old.behind[high]) b.z_max = (g.news.behind[high] ? g.news : g.old).max[high];
  } else {
    b.z_min = std::min(g.news.min[low], g.old.min[high]);
    b.z_max = std::max(g.news.max[high], g.old.max[low]);
  }
  if (g.left_le) b.left = g.left;
  if (g.right_ge) b.right = g.right;
  b.edge = std::min(b.edge, g.candidate[6]);
  b.halvings = 0;
  const auto block = static_cast<std::int32_t>(g.candidate[0]), polygon = static_cast<std::int32_t>(g.candidate[1]);
  if (g.news.behind[0]) {
    b.other = block, b.other_polygon = polygon;
  } else {
    b.other = g.box.front, b.other_polygon = g.box.front_polygon;
    b.front = block, b.front_polygon = polygon;
  }
  return b;
}

TEST(BoxGrowth, EqualsTheReference) {
  Random random(2);
  Bench<Vsorter_bench> bench;
  int compared = 0;
  for (; compared < 20000; ++compared) {
    const Growth g = random_growth(random);
    set_fields(bench->growth_box_i, encode(g.box));
    set_fields(bench->growth_candidate_i, g.candidate);
    bench->growth_left_i = port(g.left);
    bench->growth_right_i = port(g.right);
    const bool relations[] = {g.same,        g.left_le,         g.right_ge,       g.news.rising,    g.old.rising,
                              g.news.behind[0], g.old.behind[0], g.news.behind[1], g.old.behind[1]};
    unsigned bits = 0;
    for (int i = 0; i < 9; ++i) bits |= static_cast<unsigned>(relations[i]) << i;
    bench->growth_relations_i = static_cast<std::uint16_t>(bits);
    const std::array<std::int64_t, 8> z = {g.news.min[0], g.news.max[0], g.news.min[1], g.news.max[1],
                                           g.old.min[0],  g.old.max[0],  g.old.min[1],  g.old.max[1]};
    set_fields(bench->growth_z_i, z);
    bench.settle();
    ASSERT_EQ(encode(decode_box(fields_of<kBoxFields>(bench->growth_box_o))), encode(reference(g))) << "case " << compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace blocks
