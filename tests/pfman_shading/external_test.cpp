// Functions of C++ called by shaders, and functions of the language called by C++.
#include <gtest/gtest.h>

#include "pixelflow/compiler/generate.h"
#include "pixelflow/microcode/library.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pfman::ExternalArgument;
using pfman::Instance;
using pfman::PixelVariable;
using pfman::PixelWorkspace;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = pixelflow::kElements;

pixelflow::Operand operand(const PixelVariable& variable) {
  return {.address = variable.address, .bytes = variable.bytes, .is_signed = variable.kind == 1};
}

/// Uniform: gcd(a, b), and the steps that it took.
pfman::Raw greatest_divisor(std::vector<pfman::Raw>& arguments) {
  std::uint64_t a = arguments[0][0], b = arguments[1][0], steps = 0;
  for (; b != 0; ++steps) a = std::exchange(b, a % b);
  arguments[2] = {steps};
  return {a};
}

/// Varying: total += x factor for unsigned bytes; the product by way of the workspace. The factor may be either.
void add_product(pixelflow::Program& stream, const std::vector<ExternalArgument>& arguments,
                 const PixelWorkspace& workspace) {
  const pixelflow::Operand x = operand(*arguments[0].pixel), total = operand(*arguments[2].pixel);
  pixelflow::Operand factor{.bytes = 1, .uniform = true};
  if (arguments[1].pixel) {
    factor = operand(*arguments[1].pixel);
  } else {
    factor.constant = arguments[1].uniform[0];
  }
  const pixelflow::Operand product{.address = static_cast<std::uint8_t>(workspace.first), .bytes = 2};
  pixelflow::append(stream, {.code = pixelflow::Code::Multiply,
                             .d = product,
                             .a = x,
                             .b = factor,
                             .work = static_cast<std::uint8_t>(workspace.first + 2)});
  pixelflow::append(stream, {.code = pixelflow::Code::Add, .d = total, .a = total, .b = product});
}

TEST(Externals, AreCalledByShaders) {
  pfman::register_external("tests_greatest_divisor", greatest_divisor);
  pfman::register_external("tests_add_product", add_product, 16);
  const auto unit = compiled(R"(
extern "tests_greatest_divisor" uniform int divisor(uniform int a, uniform int b, output uniform int steps);
extern "tests_add_product" void add_product(fixed<8,0> x, fixed<8,0> factor, output fixed<16,0> total);
surface s(output varying fixed<16,8> px_shader_color[3], varying fixed<8,0> x = 0, uniform int a = 12, uniform int b = 18)
{
    uniform int steps;
    uniform int d = divisor(a, b, steps);
    fixed<16,0> total = steps;
    if (x % 2 == 1) add_product(x, 3, total);
    add_product(x, x, total);
    fixed<8,0> shown = total >> 8;
    px_shader_color = { total / 256, shown / 256, d / 256 };
})");
  for (const LevelArray& level : all_levels()) {
    Instance instance(unit->shaders[0], 1);
    instance.make_ordinary("x");
    pfman::ShadingNode node({instance}, {}, nullptr);
    std::mt19937_64 random(seed_or(61));
    Region before(kLanes);
    before.fill(random);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      before.put_id(lane, static_cast<int>(random() % 2));
      before.put(lane, 2, 1, lane);
    }
    const Region after = shaded(node, before, *level.array);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (before.get(lane, 0, 2) == 0) continue;
      const int x = static_cast<int>(lane), total = 3 + (x % 2 ? 3 * x : 0) + x * x;
      EXPECT_EQ(after.colour(lane, 0), std::min(total, 255)) << level.name << ", " << x;
      EXPECT_EQ(after.colour(lane, 1), total >> 8 & 0xFF) << level.name << ", " << x;
      EXPECT_EQ(after.colour(lane, 2), 6);
    }
  }
}

TEST(Externals, HaveToBeRegistered) {
  const auto unit = compiled(R"(
extern "tests_nobody" void nobody(output float x);
surface s(output varying fixed<8,8> px_shader_color[3]) {
    float x = 1;
    nobody(x);
    px_shader_color = { x, x, x };
})");
  try {
    pfman::generate(unit->shaders[0], {});
    FAIL() << "an unknown function was called";
  } catch (const pfman::UniformError& mistake) {
    EXPECT_STREQ(mistake.what(), "external function 'nobody' is not registered as 'tests_nobody'");
    EXPECT_EQ(mistake.where.line, 5u);
  }
}

constexpr char kFunctions[] = R"(
const fixed<8,0> limit = 100;
fixed<16,0> collatz(fixed<16,0> start, uniform int steps, output fixed<8,0> odd)
{
    fixed<16,0> x = start;
    uniform int i;
    odd = odd + 1;
    for (i = 0; i < steps; i++) {
        if (x == 1) break;
        if (x % 2 == 1) { x = 3 * x + 1; odd++; }
        else x = x >> 1;
    }
    if (x > limit) { if (x > 2 * limit) x = limit; else x = x - limit; }
    return x;
}
uniform float twice(uniform float x) { return 2 * x; }
fixed<8,8> seen(float s) { return texture(1, s, s)[0]; }
surface s(output varying fixed<8,8> px_shader_color[3]) { px_shader_color = { 0, 0, 0 }; }
)";

struct Collatz {
  int value, odd;
};
Collatz collatz(int start, int steps, int odd) {
  int x = start;
  odd = (odd + 1) & 0xFF;
  for (int i = 0; i < steps && x != 1; ++i) {
    if (x % 2) {
      x = (3 * x + 1) & 0xFFFF;
      odd = (odd + 1) & 0xFF;
    } else {
      x >>= 1;
    }
  }
  if (x > 100) x = x > 200 ? 100 : x - 100;
  return {x, odd};
}

const PixelVariable kStart{.address = 100, .bytes = 2, .kind = 0, .exponent = 0, .count = 1};
const PixelVariable kOdd{.address = 110, .bytes = 1, .kind = 0, .exponent = 0, .count = 1};
const PixelVariable kResult{.address = 104, .bytes = 2, .kind = 0, .exponent = 0, .count = 1};

/// Pixels of other shaders are not enabled, and nothing of theirs changes; the mask byte's lower bits are the caller's.
TEST(Externals, AreFunctionsOfTheLanguage) {
  const std::uint64_t seed = seed_or(62);
  const auto unit = compiled(kFunctions);
  constexpr int kEnableAt = 200, kWorkAt = 140;
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    Region before(kLanes);
    before.fill(random);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      before.put(lane, pfman::kMaskAt, 1, before.get(lane, kEnableAt, 1) & 1 ? 5 : random() & 7);
      before.put(lane, kStart.address, 2, random() % 2 ? 1 + random() % 40 : random() & 0xFFFF);
    }
    pixelflow::Program program;
    pixelflow::append_instructions(
        program, [](pixelflow::Assembler& out) { out.flag_of_memory(pixelflow::Flag::E, kEnableAt, 0); });
    pfman::append_call(program, *unit, "collatz", {{kStart, {}}, {{}, {9}}, {kOdd, {}}, {kResult, {}}},
                       {.first = kWorkAt, .bytes = 40, .mask = 5, .free_mask_bit = 3});
    // The flag is what it was before the call.
    pixelflow::append_instructions(program, [](pixelflow::Assembler& out) { out.store_constant(77, 250); });
    before.write(*level.array);
    level.array->run(program);
    Region after = before;
    after.read(*level.array);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const bool enabled = before.get(lane, kEnableAt, 1) & 1;
      const Collatz expected = collatz(static_cast<int>(before.get(lane, kStart.address, 2)), 9,
                                       static_cast<int>(before.get(lane, kOdd.address, 1)));
      for (int address = 0; address < pixelflow::kMemoryBytes; ++address) {
        std::uint64_t byte = before.get(lane, address, 1);
        if (enabled && address == kResult.address) byte = static_cast<std::uint64_t>(expected.value & 0xFF);
        if (enabled && address == kResult.address + 1) byte = static_cast<std::uint64_t>(expected.value >> 8);
        if (enabled && address == kOdd.address) byte = static_cast<std::uint64_t>(expected.odd);
        if (enabled && address == 250) byte = 77;
        if (enabled && address >= kWorkAt && address < kWorkAt + 40) continue;
        ASSERT_EQ(after.get(lane, address, 1), byte)
            << replay(seed) << ", " << level.name << ", lane " << lane << ", byte " << address;
      }
    }
  }
}

/// A function of C++ that calls one of the language, within conditions of the shader.
std::unique_ptr<pfman::CompiledUnit>& functions() {
  static std::unique_ptr<pfman::CompiledUnit> unit = compiled(kFunctions);
  return unit;
}
void call_collatz(pixelflow::Program& stream, const std::vector<ExternalArgument>& arguments,
                  const PixelWorkspace& workspace) {
  pfman::append_call(stream, *functions(), "collatz", arguments, workspace);
}

TEST(Externals, CallBackIntoTheLanguage) {
  const std::uint64_t seed = seed_or(63);
  pfman::register_external("tests_call_collatz", call_collatz, 40);
  const auto unit = compiled(R"(
extern "tests_call_collatz" fixed<16,0> collatz(fixed<16,0> start, uniform int steps, output fixed<8,0> odd);
surface s(output varying fixed<16,8> px_shader_color[3], varying fixed<16,0> x = 0)
{
    fixed<8,0> odd = 0;
    fixed<16,0> y = x;
    uniform int i;
    for (i = 0; i < 2; i++) {
        if (y > 20) {
            if (x % 4 != 0) y = collatz(x, 5 + i, odd);
            else { y = collatz(x, 2, odd); if (y < 30) continue; }
        } else {
            y = y + 1;
            if (y > 15) break;
        }
        y = y + 2;
    }
    px_shader_color = { (y & 255) / 256, (y >> 8) / 256, odd / 256 };
})");
  for (const LevelArray& level : all_levels()) {
    std::mt19937_64 random(seed);
    Instance instance(unit->shaders[0], 1);
    instance.make_ordinary("x");
    pfman::ShadingNode node({instance}, {}, nullptr);
    Region before(kLanes);
    before.fill(random);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      before.put_id(lane, static_cast<int>(random() % 2));
      before.put(lane, 2, 2, random() % 2 ? random() % 40 : random() & 0xFFFF);
    }
    const Region after = shaded(node, before, *level.array);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (before.get(lane, 0, 2) == 0) continue;
      const int x = static_cast<int>(before.get(lane, 2, 2));
      Collatz c{x, 0};
      for (int i = 0; i < 2; ++i) {
        if (c.value > 20) {
          c = x % 4 != 0 ? collatz(x, 5 + i, c.odd) : collatz(x, 2, c.odd);
          if (x % 4 == 0 && c.value < 30) continue;
        } else {
          c.value += 1;
          if (c.value > 15) break;
        }
        c.value = (c.value + 2) & 0xFFFF;
      }
      ASSERT_EQ(after.colour(lane, 0), c.value & 0xFF) << replay(seed) << ", " << level.name << ", " << x;
      ASSERT_EQ(after.colour(lane, 1), c.value >> 8) << replay(seed) << ", " << level.name << ", " << x;
      ASSERT_EQ(after.colour(lane, 2), c.odd) << replay(seed) << ", " << level.name << ", " << x;
    }
  }
}

std::string refusal(const std::string& function, const std::vector<ExternalArgument>& arguments, int bytes = 60) {
  pixelflow::Program program;
  try {
    pfman::append_call(program, *functions(), function, arguments, {.first = 140, .bytes = bytes});
  } catch (const std::invalid_argument& mistake) {
    return mistake.what();
  }
  return "";
}

TEST(Externals, RefuseArgumentsThatDoNotFit) {
  PixelVariable wide = kOdd;
  wide.bytes = 2;
  const ExternalArgument start{kStart, {}}, steps{{}, {3}}, odd{kOdd, {}}, result{kResult, {}};
  EXPECT_EQ(refusal("collatz", {start, steps, odd, result}), "");
  EXPECT_EQ(refusal("collatz", {{{}, {7}}, steps, odd, result}), "");
  EXPECT_EQ(refusal("nowhere", {}), "there is no function 'nowhere'");
  EXPECT_EQ(refusal("collatz", {start, steps, odd}), "function 'collatz': takes 4 arguments, its result among them");
  EXPECT_EQ(refusal("collatz", {start, start, odd, result}), "function 'collatz': 'steps' is uniform");
  EXPECT_EQ(refusal("collatz", {start, steps, {wide, {}}, result}), "function 'collatz': 'odd' is fixed<8,0>");
  EXPECT_EQ(refusal("collatz", {start, steps, {{}, {1}}, result}),
            "function 'collatz': 'odd' is an output and lies in pixel memory");
  EXPECT_EQ(refusal("collatz", {start, {{}, {1, 2}}, odd, result}), "function 'collatz': 'steps' has 1 numbers");
  EXPECT_EQ(refusal("collatz", {start, steps, odd, steps}), "function 'collatz': the result lies in pixel memory");
  EXPECT_EQ(refusal("collatz", {start, steps, odd, result}, 3).substr(0, 26), "function 'collatz': needs ");
  const ExternalArgument real{PixelVariable{.address = 100, .bytes = 4, .kind = 2}, {}};
  const ExternalArgument pure{PixelVariable{.address = 104, .bytes = 1, .kind = 0, .exponent = 8}, {}};
  EXPECT_EQ(refusal("seen", {real, pure}), "function 'seen': textures are looked up by shaders only");
  EXPECT_EQ(refusal("twice", {{{}, {0x3F800000}}, real}), "");
}

}  // namespace
}  // namespace pfman_tests
