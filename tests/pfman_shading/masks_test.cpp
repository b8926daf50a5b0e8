// Masks against the execution of each pixel on its own, at every level of modelling: varying conditions, loops that
// pixels leave, pixels of other shaders in between.
#include <gtest/gtest.h>

#include <algorithm>

#include "pixelflow/compiler/generate.h"
#include "pixelflow/compiler/memory_layout.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/masked_code.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pfman::kMaskAt;
using pfman::kShaderIdAt;
using pixelflow::kMemoryBytes;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;
const std::vector<int> kIds = {2, 0x301, 0x102};

/// Pixel memory: a row an address.
using Memory = std::vector<std::vector<std::uint8_t>>;

Memory random_memory(std::mt19937_64& random) {
  Memory memory(kMemoryBytes, std::vector<std::uint8_t>(kLanes));
  for (auto& row : memory) {
    for (std::uint8_t& byte : row) byte = static_cast<std::uint8_t>(random());
  }
  // Half of the pixels belong to the shader; some of the others have one byte of an ID in common with it.
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const int id = random() % 2 ? kIds[random() % kIds.size()] : static_cast<int>(random() % 4 * 0x100 + random() % 4);
    memory[kShaderIdAt][lane] = static_cast<std::uint8_t>(id);
    memory[kShaderIdAt + 1][lane] = static_cast<std::uint8_t>(id >> 8);
    memory[kMaskAt][lane] = 0;
  }
  return memory;
}

/// What one pixel's bytes must be afterwards; only the state is compared of the shader's own.
void check_lane(const Memory& before, const Memory& after, std::size_t lane, const MaskedProgram& program, bool runs,
                const std::string& where) {
  ASSERT_EQ(after[kMaskAt][lane], 0) << where;
  if (!runs) {
    for (std::size_t address = 0; address < kMemoryBytes; ++address) {
      ASSERT_EQ(after[address][lane], before[address][lane]) << where << ", another shader's byte " << address;
    }
    return;
  }
  State expected;
  for (std::size_t n = 0; n < kBytes; ++n) expected[n] = before[kStateAt + n][lane];
  program.execute(expected);
  for (std::size_t n = 0; n < kBytes; ++n) {
    ASSERT_EQ(after[kStateAt + n][lane], expected[n]) << where << ", byte " << n;
  }
}

Memory run(const pfman::Stream& stream, const Memory& memory, pixelflow::PixelArray& array) {
  for (int address = 0; address < kMemoryBytes; ++address)
    array.write(address, memory[static_cast<std::size_t>(address)]);
  for (const auto& part : stream.parts) array.run(part.program);
  Memory after = memory;
  for (int address = 0; address < kMemoryBytes; ++address)
    array.read(address, after[static_cast<std::size_t>(address)]);
  return after;
}

bool is_in(const std::vector<int>& ids, int id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

/// `ids` empty: the shader runs everywhere.
void compare(std::uint64_t seed, int programs, int depth, const std::vector<int>& ids,
             const std::vector<LevelArray>& levels, int* deepest) {
  for (int n = 0; n < programs; ++n) {
    std::mt19937_64 random(seed + static_cast<std::uint64_t>(n));
    const MaskedProgram program(random, depth);
    *deepest = std::max(*deepest, program.compiled().code.mask_bits);
    const pfman::Streams streams =
        pfman::generate(program.compiled(), {.uniforms = {}, .bound_varying = {}, .shader_ids = ids, .lights = 0});
    const Memory memory = random_memory(random);
    for (const LevelArray& level : levels) {
      const Memory after = run(streams.pre, memory, *level.array);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const int id = memory[kShaderIdAt][lane] | memory[kShaderIdAt + 1][lane] << 8;
        check_lane(memory, after, lane, program, ids.empty() || is_in(ids, id),
                   replay(seed + static_cast<std::uint64_t>(n)) + ", " + level.name + ", lane " + std::to_string(lane));
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(Masks, AreEachPixelsOwnExecution) {
  int deepest = 0;
  compare(seed_or(1000), 150, 3, {}, all_levels(), &deepest);
}

TEST(Masks, SpareOtherShadersPixels) {
  int deepest = 0;
  compare(seed_or(2000), 75, 3, {kIds[0]}, all_levels(), &deepest);
  if (HasFatalFailure()) return;
  compare(seed_or(3000), 75, 3, kIds, all_levels(), &deepest);
}

TEST(Masks, GoBeyondTheSharedByte) {
  int deepest = 0;
  compare(seed_or(4000), 40, 6, kIds, all_levels(), &deepest);
  EXPECT_GT(deepest, 8) << "no program nests deeply enough";
}

TEST(Masks, HoldInManyPrograms) {
  int deepest = 0;
  std::vector<LevelArray> model;
  model.push_back({"model", pixelflow::make_golden_array(pixelflow::Level::Model, kLanes)});
  compare(seed_or(5000), 2500, 4, {kIds[1]}, model, &deepest);
  if (HasFatalFailure()) return;
  compare(seed_or(9000), 2500, 4, {}, model, &deepest);
}

/// A stream without one of the instructions that write the flag or a mask byte must not pass: the comparison would see
/// nothing otherwise.
TEST(Masks, NeedEveryInstruction) {
  const std::uint64_t seed = seed_or(7000);
  std::mt19937_64 random(seed);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Model, kLanes);
  int planted = 0, caught = 0;
  for (int n = 0; n < 60; ++n) {
    const MaskedProgram program(random, 3);
    const pfman::Streams streams =
        pfman::generate(program.compiled(), {.uniforms = {}, .bound_varying = {}, .shader_ids = kIds, .lights = 0});
    const Memory memory = random_memory(random);
    const Memory right = run(streams.pre, memory, *array);
    const auto& instructions = streams.pre.parts.at(0).program.instructions;
    for (std::size_t at = 0; at < instructions.size(); ++at) {
      const bool flag = instructions[at].kind == pixelflow::Kind::Flag;
      const bool mask = pixelflow::writes_memory(instructions[at]) && instructions[at].addr == kMaskAt;
      if (!flag && !mask) continue;
      pfman::Stream faulty = streams.pre;
      faulty.parts[0].program.instructions[at] = {.kind = pixelflow::Kind::Control};
      ++planted;
      caught += run(faulty, memory, *array) != right;
    }
  }
  // Some are without effect: a branch that no pixel takes, a loop that none leaves.
  EXPECT_GT(planted, 300);
  EXPECT_GT(caught * 10, planted * 6) << replay(seed) << ": " << caught << " of " << planted << " faults seen";
}

}  // namespace
}  // namespace pfman_tests
