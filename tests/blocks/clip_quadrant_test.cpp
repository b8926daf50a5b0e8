#include <gtest/gtest.h>

#include "Vsorter_bench.h"
#include "cmodel/vsg/clipper.h"
#include "tests/blocks/bench.h"
#include "tests/blocks/random.h"

namespace blocks {
namespace {

TEST(ClipQuadrant, LoadsAndHalvesAsTheGoldenModel) {
  Random random(1);
  Bench<Vsorter_bench> bench;
  vsg::ClipQuadrant golden;
  int steps = 0;
  for (int cycle = 0; cycle < 50000; ++cycle) {
    const bool load = random.once_in(16), step = random.between(0, 7) != 0;
    const std::int64_t x_left = random.word(x_format().bits), x_right = random.word(x_format().bits);
    const std::int64_t z_min = random.word(z_format().bits), z_max = random.word(z_format().bits);
    const bool rising = random.coin();
    bench->quadrant_load_i = load;
    bench->quadrant_step_i = step;
    bench->quadrant_x_left_i = static_cast<std::uint64_t>(x_left);
    bench->quadrant_x_right_i = static_cast<std::uint64_t>(x_right);
    bench->quadrant_z_min_i = static_cast<std::uint64_t>(z_min);
    bench->quadrant_z_max_i = static_cast<std::uint64_t>(z_max);
    bench->quadrant_rising_i = rising;
    bench.tick();
    // A load wins over a step of the same cycle.
    if (load) {
      golden.load(x_left, x_right, z_min, z_max, rising);
    } else if (step) {
      golden.step();
      ++steps;
    }
    ASSERT_EQ(z_format().wrap(static_cast<std::int64_t>(bench->quadrant_z_min_o)), golden.z_min) << "cycle " << cycle;
    ASSERT_EQ(z_format().wrap(static_cast<std::int64_t>(bench->quadrant_z_max_o)), golden.z_max) << "cycle " << cycle;
    ASSERT_EQ(bench->quadrant_rising_o != 0, golden.rising) << "cycle " << cycle;
  }
  EXPECT_GT(steps, 0);
}

}  // namespace
}  // namespace blocks
