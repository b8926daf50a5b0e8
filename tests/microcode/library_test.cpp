// What the library refuses, and what it tells of itself.
#include "pixelflow/microcode/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/microcode/machine.h"

using namespace pixelflow;

namespace {

Operation add(int d, int a, int b) {
  Operation o;
  o.code = Code::Add;
  o.d.address = static_cast<std::uint8_t>(d);
  o.a.address = static_cast<std::uint8_t>(a);
  o.b.address = static_cast<std::uint8_t>(b);
  return o;
}

/// The message of the refusal; empty where the operation is taken.
std::string refusal(const Operation& o) {
  Program program;
  try {
    append(program, o);
  } catch (const std::invalid_argument& mistake) {
    EXPECT_TRUE(program.instructions.empty());
    EXPECT_TRUE(program.steps.empty());
    return mistake.what();
  }
  return "";
}

TEST(Library, RefusesNumbersThatOverlapInPart) {
  EXPECT_EQ(refusal(add(20, 30, 40)), "");
  EXPECT_EQ(refusal(add(30, 30, 30)), "");
  EXPECT_NE(refusal(add(31, 30, 40)).find("d overlaps a"), std::string::npos);
  EXPECT_NE(refusal(add(42, 30, 40)).find("d overlaps b"), std::string::npos);
}

TEST(Library, RefusesWhatLeavesTheMemory) {
  EXPECT_EQ(refusal(add(252, 30, 40)), "");
  EXPECT_NE(refusal(add(253, 30, 40)).find("d leaves the memory"), std::string::npos);
  EXPECT_NE(refusal(add(20, 254, 40)).find("a leaves the memory"), std::string::npos);
  Operation noise;
  noise.code = Code::NoiseFloat;
  noise.scale = 3;
  noise.a.address = 246;
  noise.work = 100;
  EXPECT_NE(refusal(noise).find("a leaves the memory"), std::string::npos);
}

TEST(Library, RefusesAWorkspaceThatTouchesOperandsOrEnds) {
  Operation o = add(20, 30, 40);
  o.code = Code::FloatMultiply;
  o.work = 60;
  EXPECT_EQ(refusal(o), "");
  o.work = 38;
  EXPECT_NE(refusal(o).find("workspace overlaps b"), std::string::npos);
  o.work = 250;
  EXPECT_NE(refusal(o).find("bytes of workspace from 250 on"), std::string::npos);
}

TEST(Library, RefusesSizesAndScalesThatItDoesNotKnow) {
  Operation o = add(20, 30, 40);
  o.a.bytes = 9;
  EXPECT_NE(refusal(o).find("1 to 8"), std::string::npos);
  o.a.bytes = 3;
  o.code = Code::FloatAdd;
  EXPECT_NE(refusal(o).find("is a float and has 4 bytes"), std::string::npos);
  o = add(20, 30, 40);
  o.code = Code::ShiftRight;
  o.scale = 65;
  EXPECT_NE(refusal(o).find("0 to 64"), std::string::npos);
  for (const int code : {static_cast<int>(Code::Count), 255}) {
    o = add(20, 30, 40);
    o.code = static_cast<Code>(code);
    EXPECT_NE(refusal(o).find("has no microcode"), std::string::npos);
    EXPECT_EQ(workspace_bytes(o), 0);
  }
  o = add(20, 30, 40);
  o.a.uniform = o.b.uniform = true;
  EXPECT_NE(refusal(o).find("both operands are uniform"), std::string::npos);
}

TEST(Library, APlaneIsLinearInTheElementsPlace) {
  std::mt19937_64 random(pixelflow_test::seed());
  int most = 0;
  for (int round = 0; round < 2000; ++round) {
    const int bytes = 1 + static_cast<int>(random() % 8);
    const auto a = static_cast<std::int64_t>(pixelflow_test::hard_number(random, 64));
    const auto b = static_cast<std::int64_t>(pixelflow_test::hard_number(random, 64));
    const auto c = static_cast<std::int64_t>(pixelflow_test::hard_number(random, 64));
    Program program;
    append_plane(program, 20, bytes, a, b, c);
    if (bytes == 4) most = std::max(most, static_cast<int>(program.cycles(2)));
    pixelflow_test::Machine machine;
    machine.element.x_position = static_cast<std::uint8_t>(random() % kRegionWidth);
    machine.element.y_position = static_cast<std::uint8_t>(random() % kRegionHeight);
    machine.run(program);
    const std::uint64_t want = static_cast<std::uint64_t>(a) * machine.element.x_position +
                               static_cast<std::uint64_t>(b) * machine.element.y_position +
                               static_cast<std::uint64_t>(c);
    ASSERT_EQ(machine.get(20, bytes), bytes == 8 ? want : want & ((1ull << (8 * bytes)) - 1))
        << a << " " << b << " " << c;
  }
  EXPECT_EQ(most, 39);  // of 32 bits: clear, the place, eight products of four digits, four stores
  Program program;
  EXPECT_THROW(append_plane(program, 253, 4, 1, 1, 1), std::invalid_argument);
}

TEST(Library, StepsCoverTheInstructions) {
  Program program;
  append_instructions(program, [](Assembler& a) { a.flag(Flag::E, Bit::One); });
  for (int code = 0; code < static_cast<int>(Code::Count); ++code) {
    Operation o = add(20, 30, 60);
    o.code = static_cast<Code>(code);
    o.scale = o.code == Code::Wrap || o.code == Code::Saturate ? 8 : 1;
    if (o.code == Code::NoiseFixed) o.a.bytes = o.d.bytes = 2;
    o.work = 100;
    append(program, o);
    EXPECT_STRNE(name(o.code), "operation") << code;
    EXPECT_EQ(program.steps.back().workspace_bytes, workspace_bytes(o));
  }
  std::uint32_t next = 0;
  for (const Step& step : program.steps) {
    EXPECT_EQ(step.first, next);
    EXPECT_GT(step.count, 0u);
    next += step.count;
  }
  EXPECT_EQ(next, program.instructions.size());
  EXPECT_GE(program.cycles(1), program.cycles(2));
  EXPECT_GE(program.cycles(2), program.cycles(8));
}

}  // namespace
