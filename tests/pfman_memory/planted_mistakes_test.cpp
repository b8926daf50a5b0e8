// Mistakes of the kind that lifetimes and allocation could make, planted: executing the code with them must show.
#include <gtest/gtest.h>

#include <iostream>
#include <stdexcept>

#include "pixelflow/compiler/lifetime.h"
#include "tests/pfman_memory/pixel_machine.h"
#include "tests/pfman_memory/random_code.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pixelflow::Code;
using Kind = CodeBuilder::Kind;

/// True where the code does not compute the same on its variables and in the memory that a map gives it. `lifetimes`
/// says what is overwritten.
bool shows(const pfman::ir::Code& code, const pfman::MemoryMap& map, const pfman::Lifetimes& lifetimes) {
  for (std::uint64_t run = 0; run < 16; ++run) {
    const Circumstances circumstances{mix(7, run), static_cast<int>(run % 4)};
    const auto expected = PixelMachine(code, circumstances).run();
    try {
      if (PixelMachine(code, circumstances, map, lifetimes).run() != expected) return true;
    } catch (const std::logic_error&) {  // a workspace on an operand
      return true;
    }
  }
  return false;
}

bool shows(const pfman::ir::Code& code, const pfman::MemoryMap& map) {
  return shows(code, map, pfman::Lifetimes(code));
}

/// x is read again in the next iteration, t written in between.
CodeBuilder loop_code() {
  CodeBuilder b("loop");
  const int p = b.parameter("p", 2), x = b.variable("x", 2), t = b.variable("t", 2), c = b.variable("c", 2);
  b.operate(Code::Add, b.use(x), b.use(p), b.literal(3, 1));
  b.put(c, 1);
  const int loop = b.begin_loop();
  b.code.code.back().uniform = b.uniform_literal(0);
  b.loop_test(loop, b.uniform_literal(0));
  b.operate(Code::Add, b.use(c), b.use(c), b.use(x));
  b.operate(Code::Sub, b.use(t), b.use(c), b.literal(5, 1));
  b.operate(Code::Add, b.use(c), b.use(c), b.use(t));
  b.loop_next(loop);
  b.end_loop(loop);
  b.code.color = {c};
  return b;
}

TEST(PlantedMistakes, NoneWithoutOne) {
  CodeBuilder b = loop_code();
  pfman::Diagnostics diagnostics;
  EXPECT_FALSE(shows(b.code, pfman::allocate(b.code, {}, diagnostics)));
}

TEST(PlantedMistakes, TheLoopsWayBack) {
  CodeBuilder right = loop_code(), wrong = loop_code();
  wrong.code.code[static_cast<std::size_t>(wrong.size() - 1)].kind = Kind::EndIf;
  pfman::Diagnostics diagnostics;
  // The loop's head still names its end for the test to leave by.
  for (auto& instruction : wrong.code.code) {
    if (instruction.kind == Kind::LoopTest) instruction.kind = Kind::Uniform;
  }
  const pfman::MemoryMap map = pfman::allocate(wrong.code, {}, diagnostics);
  EXPECT_TRUE(shows(right.code, map, pfman::Lifetimes(wrong.code)));
}

TEST(PlantedMistakes, TheWayOfAMaskedContinue) {
  const auto code = [](bool right) {
    CodeBuilder b("continue");
    const int p = b.parameter("p", 2), bit = b.parameter("bit", 1), x = b.variable("x", 2), t = b.variable("t", 2),
              c = b.variable("c", 2);
    b.operate(Code::Add, b.use(x), b.use(p), b.literal(3, 1));
    b.put(c, 1);
    const int loop = b.begin_loop(false, true);
    b.code.code.back().uniform = b.uniform_literal(0);
    b.loop_test(loop, b.uniform_literal(0));
    const int branch = b.begin_if(Kind::IfMasked, b.use(bit));
    b.jump(right ? Kind::ContinueMasked : Kind::BreakMasked, loop);
    b.end_if(branch);
    b.put(x, 4);
    b.operate(Code::Sub, b.use(t), b.use(c), b.literal(5, 1));
    b.operate(Code::Add, b.use(c), b.use(c), b.use(t));
    b.loop_next(loop);
    b.operate(Code::Add, b.use(c), b.use(c), b.use(x));
    b.end_loop(loop);
    b.code.color = {c};
    return b;
  };
  const CodeBuilder right = code(true);
  CodeBuilder wrong = code(false);
  pfman::Diagnostics diagnostics;
  const pfman::MemoryMap map = pfman::allocate(wrong.code, {}, diagnostics);
  EXPECT_TRUE(shows(right.code, map, pfman::Lifetimes(wrong.code)));
}

TEST(PlantedMistakes, WhatLightsMustLeave) {
  CodeBuilder b("lights");
  const int p = b.parameter("p", 2), x = b.variable("x", 2), c = b.variable("c", 2);
  b.operate(Code::Add, b.use(x), b.use(p), b.literal(1, 1));
  b.stage(1);
  b.stage(2);
  b.operate(Code::Add, b.use(c), b.use(x), b.literal(1, 1));
  b.code.color = {c};
  pfman::Diagnostics diagnostics;
  pfman::MemoryMap map = pfman::allocate(b.code, {}, diagnostics);
  EXPECT_FALSE(shows(b.code, map));
  map.high_water -= 1;
  EXPECT_TRUE(shows(b.code, map));
}

TEST(PlantedMistakes, AWorkspaceThatIsTaken) {
  CodeBuilder b("workspace");
  const int x = b.float_variable("x"), y = b.float_variable("y"), c = b.float_variable("c");
  b.put(x, 1);
  b.put(y, 2);
  b.operate(Code::FloatMultiply, b.use(c), b.use(x), b.use(x));
  b.operate(Code::FloatAdd, b.use(c), b.use(c), b.use(y));
  b.code.color = {c};
  pfman::Diagnostics diagnostics;
  const pfman::MemoryMap map = pfman::allocate(b.code, {}, diagnostics);
  EXPECT_FALSE(shows(b.code, map));
  b.code.code[2].work = map.address[static_cast<std::size_t>(y)];
  EXPECT_TRUE(shows(b.code, map));
}

/// One interference dropped: two variables that are alive at once lie on each other. Not every value that is lost is
/// needed, but nearly all are.
TEST(PlantedMistakes, AnInterferenceThatIsMissing) {
  const std::uint64_t first = pixelflow_tests::seed_or(1);
  int planted = 0, shown = 0;
  for (std::uint64_t seed = first; seed < first + 60; ++seed) {
    RandomCode random(seed, {.statements = 12});
    pfman::ir::Code& code = random.builder.code;
    pfman::Diagnostics diagnostics;
    pfman::to_ssa(code, diagnostics);
    pfman::merge_phis(code);
    pfman::drop_unused(code);
    pfman::join_copies(code);
    const pfman::MemoryMap map = pfman::allocate(code, {}, diagnostics);
    if (diagnostics.has_errors()) continue;
    const pfman::Lifetimes lifetimes(code);
    const int variables = static_cast<int>(code.variables.size());
    for (int n = 0; n < 10; ++n) {
      const int a =
          static_cast<int>(mix(seed, static_cast<std::uint64_t>(2 * n)) % static_cast<std::uint64_t>(variables));
      const int b =
          static_cast<int>(mix(seed, static_cast<std::uint64_t>(2 * n + 1)) % static_cast<std::uint64_t>(variables));
      if (!lifetimes.interfere(a, b) || code.variables[static_cast<std::size_t>(a)].address) continue;
      pfman::MemoryMap wrong = map;
      wrong.address[static_cast<std::size_t>(a)] = map.address[static_cast<std::size_t>(b)];
      ++planted;
      shown += shows(code, wrong, lifetimes) ? 1 : 0;
    }
  }
  std::cout << shown << " of " << planted << " planted mistakes show\n";
  ASSERT_GT(planted, 50) << pixelflow_tests::replay(first);
  EXPECT_GT(2 * shown, planted) << pixelflow_tests::replay(first);
}

}  // namespace
}  // namespace pfman_tests
