// The array at RTL level against the golden array of the level model: memory, registers and counters.
#include "tb/pixelflow/rtl_array.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tb/pixelflow/pixel_chip.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/pixelflow_rtl/random_streams.h"

namespace pixelflow_tests {
namespace {

using pixelflow::kMemoryBytes;

/// Random instructions without what needs packets, as one run without an operation.
pixelflow::Program random_program(std::mt19937_64& random) {
  pixelflow::Program program;
  program.instructions = random_stream(random, 300, false);
  program.instructions.pop_back();  // the End is the array's own
  for (pixelflow::Instruction& i : program.instructions) {
    if (i.q == static_cast<std::uint8_t>(pixelflow::Q::Port)) i.imm |= 0x80;
    if (i.kind == pixelflow::Kind::Alu && i.dest == static_cast<std::uint8_t>(pixelflow::To::Port)) i.dest = 0;
  }
  program.steps = {{.operation = {}, .first = 0, .count = static_cast<std::uint32_t>(program.instructions.size())}};
  return program;
}

TEST(RtlArray, IsTheGoldenArray) {
  constexpr int kLanes = 768;  // three chips
  const std::uint64_t seed = seed_or(8);
  std::mt19937_64 random(seed);
  const auto rtl = tb::make_rtl_array(kLanes);
  const auto golden = pixelflow::make_golden_array(pixelflow::Level::Model, kLanes);
  std::vector<std::uint8_t> row(kLanes), expected(kLanes);
  for (int program = 0; program < 20; ++program) {
    for (int a = 0; a < kMemoryBytes; ++a) {
      for (std::uint8_t& b : row) b = static_cast<std::uint8_t>(random());
      rtl->write(a, row);
      golden->write(a, row);
    }
    if (program == 10) {
      for (std::uint8_t& b : row) b = static_cast<std::uint8_t>(random() % 64);
      rtl->place(row, row);
      golden->place(row, row);
    }
    const auto p = random_program(random);
    rtl->run(p);
    golden->run(p);
    for (int a = 0; a < kMemoryBytes; ++a) {
      rtl->read(a, row);
      golden->read(a, expected);
      ASSERT_EQ(row, expected) << replay(seed) << ", program " << program << ", address " << a;
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      ASSERT_TRUE(rtl->registers(lane) == golden->registers(lane))
          << replay(seed) << ", program " << program << ", lane " << lane;
    }
    ASSERT_EQ(rtl->counters().cycles, golden->counters().cycles) << replay(seed);
    ASSERT_EQ(rtl->counters().instructions, golden->counters().instructions) << replay(seed);
  }
}

/// Composition that waits for packets that never come, and a stream that has no end.
TEST(PixelChip, ReportsWhatWouldWaitForEver) {
  using namespace pixelflow;
  const auto chip = tb::make_pixel_chip();
  const auto control = [](Control what) {
    return Instruction{.kind = Kind::Control, .fn = static_cast<std::uint8_t>(what)};
  };
  const std::vector<Instruction> sends{control(Control::Send), control(Control::End)};
  EXPECT_NO_THROW(chip->run(sends));
  chip->set_compose(tb::Compose::Closer);
  EXPECT_THROW(chip->run(sends), std::runtime_error);
  EXPECT_THROW(chip->run({}), std::invalid_argument);
  EXPECT_THROW(chip->run(std::vector{control(Control::Send)}), std::invalid_argument);
}

TEST(RtlArray, RefusesWhatItDoesNotHave) {
  EXPECT_THROW(tb::make_rtl_array(100), std::invalid_argument);
  EXPECT_THROW(tb::make_rtl_array(pixelflow::kRegionWidth * pixelflow::kRegionHeight + pixelflow::kElements),
               std::invalid_argument);
  EXPECT_THROW(tb::make_rtl_array(0), std::invalid_argument);
  const auto array = tb::make_rtl_array(256);
  EXPECT_THROW(array->write(0, std::vector<std::uint8_t>(255)), std::invalid_argument);
  EXPECT_THROW(array->write(256, std::vector<std::uint8_t>(256)), std::invalid_argument);
  EXPECT_THROW(array->registers(256), std::invalid_argument);
}

}  // namespace
}  // namespace pixelflow_tests
