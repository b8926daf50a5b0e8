// The array of golden elements: tiles, counters, what is left out, what is refused.
#include "cmodel/pixelflow/golden_array.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tests/pixelflow_model/operations.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

constexpr std::uint8_t code(auto value) { return static_cast<std::uint8_t>(value); }

/// Instructions that belong to no operation.
Program bare(std::vector<Instruction> instructions) {
  const auto count = static_cast<std::uint32_t>(instructions.size());
  return {.instructions = std::move(instructions), .steps = {Step{.operation = {}, .first = 0, .count = count}}};
}

/// One operation that the instructions carry out: 2-byte sums byte by byte.
Program sum_of_two_bytes() {
  const auto byte = [](int n, std::vector<Instruction>& to) {
    const auto at = [n](int address) { return static_cast<std::uint8_t>(address + n); };
    to.push_back({.q = code(Q::Memory), .dest = code(To::M), .addr = at(kA)});
    to.push_back({.p = code(P::M),
                  .q = code(Q::Memory),
                  .cin = code(n == 0 ? Carry::Zero : Carry::C),
                  .dest = code(To::M),
                  .set_c = true,
                  .addr = at(kB)});
    to.push_back({.p = code(P::M), .q = code(Q::Immediate), .dest = code(To::Memory), .addr = at(kD)});
  };
  Program program;
  for (int n = 0; n < 2; ++n) byte(n, program.instructions);
  const Operation sum{.code = Code::Add,
                      .d = {.address = kD, .bytes = 2},
                      .a = {.address = kA, .bytes = 2},
                      .b = {.address = kB, .bytes = 2}};
  program.steps = {Step{.operation = sum, .first = 0, .count = 6}};
  return program;
}

TEST(GoldenArray, ElementsOfSeveralTilesKeepTheirOwnData) {
  constexpr int kLanes = 2 * PixelRow::kLanes + 77;
  const auto array = make_golden_array(Level::Model, kLanes);
  ASSERT_EQ(array->lanes(), kLanes);
  std::vector<std::uint8_t> values(kLanes), back(kLanes);
  for (int n = 0; n < kLanes; ++n) values[n] = static_cast<std::uint8_t>(n * 7 + n / 256);
  array->write(3, values);
  array->run(bare({{.q = code(Q::Memory), .dest = code(To::M), .addr = 3},
                   {.p = code(P::M),
                    .q = code(Q::Immediate),
                    .dest = code(To::Memory),
                    .gate = code(Gate::None),
                    .addr = 5,
                    .imm = 1}}));
  array->read(5, back);
  for (int n = 0; n < kLanes; ++n) {
    ASSERT_EQ(back[n], static_cast<std::uint8_t>(values[n] + 1)) << n;
    ASSERT_EQ(array->registers(n).m, values[n]) << n;
    ASSERT_FALSE(array->registers(n).e) << n;
  }
}

TEST(GoldenArray, PlacesAreThoseOfTheRegionUntilSetOtherwise) {
  const auto array = make_golden_array(Level::Macro, kRegionWidth * kRegionHeight);
  const Program take = bare({{.q = code(Q::Port), .dest = code(To::M), .imm = kPortX},
                             {.q = code(Q::Port), .dest = code(To::X), .imm = kPortY}});
  array->run(take);
  for (int n = 0; n < array->lanes(); ++n) {
    ASSERT_EQ(array->registers(n).m, n % kRegionWidth) << n;
    ASSERT_EQ(array->registers(n).x, n / kRegionWidth) << n;
  }
  std::vector<std::uint8_t> columns(static_cast<std::size_t>(array->lanes()), 9), rows(columns.size());
  for (std::size_t n = 0; n < rows.size(); ++n) rows[n] = static_cast<std::uint8_t>(n % 61);
  array->place(columns, rows);
  array->run(take);
  for (int n = 0; n < array->lanes(); ++n) {
    ASSERT_EQ(array->registers(n).m, 9) << n;
    ASSERT_EQ(array->registers(n).x, n % 61) << n;
  }
}

TEST(GoldenArray, BothLevelsLeaveTheSameBytesAndCountTheSameCycles) {
  const std::uint64_t seed = seed_or(20265);
  std::cout << replay(seed) << '\n';
  std::mt19937_64 random(seed);
  constexpr int kLanes = PixelRow::kLanes + 300;
  const auto a = hard_numbers(random, kLanes, 2), b = hard_numbers(random, kLanes, 2),
             old = hard_numbers(random, kLanes, 2);
  auto enable = hard_numbers(random, kLanes, 1);
  std::fill(enable.begin(), enable.begin() + 256, 0);  // four groups of 64 in which nothing is enabled
  Elements model(kLanes, Level::Model), macro(kLanes, Level::Macro);
  for (Elements* elements : {&model, &macro}) {
    elements->put(kA, 2, a);
    elements->put(kB, 2, b);
    elements->put(kD, 2, old);
    elements->enable(enable);
    elements->array().run(sum_of_two_bytes());
  }
  EXPECT_EQ(model.get(kD, 2), macro.get(kD, 2));
  const auto results = macro.get(kD, 2);
  for (std::size_t n = 0; n < a.size(); ++n) {
    ASSERT_EQ(results[n], enable[n] & 1 ? (a[n] + b[n]) & 0xFFFF : old[n]) << replay(seed) << ", element " << n;
  }
  const ArrayCounters of_model = model.array().counters(), of_macro = macro.array().counters();
  EXPECT_EQ(of_model.cycles, 7u);
  EXPECT_EQ(of_macro.cycles, 7u);
  EXPECT_EQ(of_macro.instructions, 7u);
  EXPECT_EQ(of_macro.element_cycles, 7u * kLanes);
  EXPECT_EQ(of_model.simulated_element_cycles, 7u * kLanes);
  EXPECT_EQ(of_macro.simulated_element_cycles, 7u * kLanes - 6u * 256);
}

TEST(GoldenArray, OperationsOfATileWithNothingEnabledCostCyclesOnly) {
  for (const Level level : {Level::Model, Level::Macro}) {
    constexpr int kLanes = 3 * PixelRow::kLanes;
    Elements elements(kLanes, level);
    std::vector<std::uint64_t> enable(kLanes, 0), ones(kLanes, 1);
    std::fill(enable.begin() + PixelRow::kLanes, enable.begin() + 2 * PixelRow::kLanes, 1);
    elements.put(kA, 2, ones);
    elements.put(kB, 2, ones);
    elements.enable(enable);
    elements.array().run(sum_of_two_bytes());
    const auto results = elements.get(kD, 2);
    for (std::size_t n = 0; n < results.size(); ++n) ASSERT_EQ(results[n], enable[n] ? 2u : 0u) << n;
    const ArrayCounters counters = elements.array().counters();
    EXPECT_EQ(counters.cycles, 7u);
    EXPECT_EQ(counters.element_cycles, 7u * kLanes);
    EXPECT_EQ(counters.simulated_element_cycles, 7u * kLanes - 6u * 2 * PixelRow::kLanes);
  }
}

// A comparison writes K whether the element is enabled or not; what follows may use it to enable.
TEST(GoldenArray, ComparisonsAreNotLeftOut) {
  Elements elements(100, Level::Macro);
  std::vector<std::uint64_t> values(100);
  std::iota(values.begin(), values.end(), 0);
  elements.put(kA, 1, values);
  elements.run({.code = Code::Less,
                .d = {},
                .a = {.address = kA, .bytes = 1},
                .b = {.bytes = 1, .uniform = true, .constant = 50}});
  for (int n = 0; n < 100; ++n) EXPECT_EQ(elements.condition(n), n < 50) << n;
}

TEST(GoldenArray, MultiplicationsCostTheDigitsOfTheirMultiplier) {
  for (const int bits : {1, 2, 4, 8}) {
    const auto array = make_golden_array(Level::Model, 10, bits);
    array->run(bare(
        {{.kind = Kind::Wide, .fn = code(Wide::Multiply), .q = code(Q::M)},
         {.kind = Kind::Wide, .fn = code(Wide::Multiply), .p = code(P::Immediate), .q = code(Q::M), .imm = 0x11}}));
    EXPECT_EQ(array->counters().cycles, static_cast<std::uint64_t>(8 / bits + (bits == 8 ? 1 : 2)));
    EXPECT_EQ(array->counters().instructions, 2u);
  }
}

TEST(GoldenArray, MistakesAreRefused) {
  EXPECT_THROW(make_golden_array(Level::Rtl, 10), std::invalid_argument);
  EXPECT_THROW(make_golden_array(Level::Model, 0), std::invalid_argument);
  EXPECT_THROW(make_golden_array(Level::Model, 10, 3), std::invalid_argument);
  const auto array = make_golden_array(Level::Macro, 10);
  std::vector<std::uint8_t> ten(10), nine(9);
  EXPECT_THROW(array->write(0, nine), std::invalid_argument);
  EXPECT_THROW(array->read(kMemoryBytes, ten), std::invalid_argument);
  EXPECT_THROW(array->write(-1, ten), std::invalid_argument);
  EXPECT_THROW(array->place(ten, nine), std::invalid_argument);
  EXPECT_THROW(array->registers(10), std::invalid_argument);
  Program gap = bare({{}, {}});
  gap.steps[0].first = 1;
  EXPECT_THROW(array->run(gap), std::invalid_argument);
  Program uncovered = bare({{}, {}});
  uncovered.steps[0].count = 1;
  EXPECT_THROW(array->run(uncovered), std::invalid_argument);
  uncovered.steps[0].count = 3;
  EXPECT_THROW(array->run(uncovered), std::invalid_argument);
  EXPECT_EQ(array->counters(), ArrayCounters{});
}

TEST(GoldenArray, OperationsWithWrongOperandsAreRefused) {
  const auto array = make_golden_array(Level::Macro, 10);
  const auto runs = [&](const Operation& o, std::uint8_t workspace = 0) {
    array->run(
        {.instructions = {}, .steps = {Step{.operation = o, .first = 0, .count = 0, .workspace_bytes = workspace}}});
  };
  const Operation good{
      .code = Code::Add, .d = {.address = kD}, .a = {.address = kA}, .b = {.address = kB}, .work = kWork};
  EXPECT_NO_THROW(runs(good, 8));
  const auto changed = [&](auto&& change) {
    Operation o = good;
    change(o);
    return o;
  };
  const auto refused = [&](auto&& change, std::uint8_t workspace = 8) {
    EXPECT_THROW(runs(changed(change), workspace), std::invalid_argument);
  };
  refused([](Operation& o) { o.code = Code::Count; });
  refused([](Operation& o) { o.d.bytes = 0; });
  refused([](Operation& o) { o.a.bytes = 9; });
  refused([](Operation& o) { o.b.address = 254; });
  refused([](Operation& o) { o.d.uniform = true; });
  refused([](Operation& o) { o.d.address = kA + 1; });  // overlaps a in part
  refused([](Operation& o) { o.work = kB - 1; });
  refused([](Operation&) {}, 255);
  refused([](Operation& o) { o.code = Code::FloatAdd, o.a.bytes = 3; });
  refused([](Operation& o) { o.code = Code::Sin, o.d.bytes = 8; });
  refused([](Operation& o) { o.code = Code::Wrap, o.scale = 65; });
  refused([](Operation& o) { o.code = Code::ShiftLeft, o.scale = -1; });
  refused([](Operation& o) { o.code = Code::Divide, o.scale = 13; });
  refused([](Operation& o) { o.code = Code::NoiseFloat, o.scale = 4; });
  refused([](Operation& o) { o.code = Code::NoiseFixed, o.scale = 1; });  // of 4 bytes
  EXPECT_NO_THROW(runs(changed([](Operation& o) { o.d.address = kA; }), 8));
  EXPECT_NO_THROW(runs(changed([](Operation& o) { o.b.uniform = true, o.b.address = 255; }), 8));
}

}  // namespace
}  // namespace pixelflow_tests
