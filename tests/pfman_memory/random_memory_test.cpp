// Random code before and after allocation: the same results, with everything that is not alive overwritten all the
// time. Then with mistakes, which have to show.
#include <gtest/gtest.h>

#include "pixelflow/compiler/lifetime.h"
#include "tests/pfman_memory/pixel_machine.h"
#include "tests/pfman_memory/random_code.h"
#include "tests/pixelflow_model/seed.h"

namespace pfman_tests {
namespace {

using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

struct Passes {
  bool drop = true, join = true, share = true;
};

struct Compiled {
  std::unique_ptr<RandomCode> random;
  pfman::MemoryMap map;
  bool fits = false;

  pfman::ir::Code& code() const { return random->builder.code; }
};

Compiled compile(std::uint64_t seed, const RandomShape& shape, const Passes& passes) {
  Compiled compiled;
  compiled.random = std::make_unique<RandomCode>(seed, shape);
  pfman::Diagnostics diagnostics;
  pfman::to_ssa(compiled.code(), diagnostics);
  pfman::merge_phis(compiled.code());
  if (passes.drop) pfman::drop_unused(compiled.code());
  if (passes.join) pfman::join_copies(compiled.code());
  compiled.map = pfman::allocate(compiled.code(), {.share = passes.share}, diagnostics);
  compiled.fits = !diagnostics.has_errors();
  return compiled;
}

/// The circumstances under which code is executed: some number of lights, some values.
Circumstances circumstances(std::uint64_t seed, int n) { return {mix(seed, static_cast<std::uint64_t>(n)), n % 4}; }

constexpr int kRuns = 8;

std::vector<std::uint8_t> expected(const pfman::ir::Code& code, std::uint64_t seed, int run) {
  return PixelMachine(code, circumstances(seed, run)).run();
}

bool agrees(const pfman::ir::Code& before, const Compiled& after, const pfman::MemoryMap& map, std::uint64_t seed) {
  const pfman::Lifetimes lifetimes(after.code());
  for (int run = 0; run < kRuns; ++run) {
    const auto now = PixelMachine(after.code(), circumstances(seed, run), map, lifetimes).run();
    if (now != expected(before, seed, run)) return false;
  }
  return true;
}

/// True where the code fits into the memory.
bool check(std::uint64_t seed, const RandomShape& shape, const Passes& passes) {
  SCOPED_TRACE(replay(seed));
  const RandomCode before(seed, shape);
  const Compiled after = compile(seed, shape, passes);
  if (!after.fits) return false;
  EXPECT_NO_THROW(check_operations(after.code(), after.map));
  EXPECT_TRUE(agrees(before.builder.code, after, after.map, seed));
  return true;
}

void check_many(const RandomShape& shape, const Passes& passes, int programs, int least_that_fit) {
  const std::uint64_t first = seed_or(1);
  int fit = 0;
  for (int n = 0; n < programs && !testing::Test::HasFailure(); ++n) {
    fit += check(first + static_cast<std::uint64_t>(n), shape, passes) ? 1 : 0;
  }
  EXPECT_GE(fit, least_that_fit) << "of " << programs << " programs";
}

TEST(RandomMemory, Straight) {
  check_many({.statements = 40, .loops = false, .branches = false, .lights = false}, {}, 400, 300);
}
TEST(RandomMemory, Branches) { check_many({.statements = 40, .loops = false, .lights = false}, {}, 400, 300); }
TEST(RandomMemory, Loops) { check_many({.statements = 30, .lights = false}, {}, 600, 400); }
TEST(RandomMemory, Stages) { check_many({.statements = 15}, {}, 600, 400); }
TEST(RandomMemory, LightShader) { check_many({.statements = 30, .light_shader = true}, {}, 300, 200); }
TEST(RandomMemory, Long) { check_many({.statements = 150}, {}, 30, 10); }
TEST(RandomMemory, CopiesKept) { check_many({.statements = 20}, {.join = false}, 200, 100); }
TEST(RandomMemory, UnusedKept) { check_many({.statements = 20}, {.drop = false, .join = false}, 200, 100); }
TEST(RandomMemory, NothingShared) {
  check_many({.statements = 6}, {.drop = false, .join = false, .share = false}, 400, 20);
}

}  // namespace
}  // namespace pfman_tests
