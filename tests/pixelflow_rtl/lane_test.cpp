// A lane of the row form against the element's own module with its own memory: the same instructions in the same
// cycles, all registers compared in every one of them. And the places of a chip's elements.
#include <gtest/gtest.h>

#include <random>

#include "Vpixel_processor_r1.h"
#include "Vpixel_processor_r1___024root.h"
#include "Vpixel_processor_r2.h"
#include "Vpixel_processor_r2___024root.h"
#include "Vpixel_processor_r4.h"
#include "Vpixel_processor_r4___024root.h"
#include "Vpixel_processor_r8.h"
#include "Vpixel_processor_r8___024root.h"
#include "tb/pixelflow/pixel_chip.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/pixelflow_rtl/instruction_text.h"
#include "tests/pixelflow_rtl/random_streams.h"

namespace pixelflow_tests {
namespace {

using tb::ChipRow;

/// The element's module, beside lane `lane` of the chip.
template <class Module>
class Lane {
 public:
  Lane(tb::PixelChip& chip, int lane) : chip_(chip), lane_(lane) {
    auto& m = module();
    m.rst_ni = 0;
    tick();
    m.rst_ni = 1;
    auto& root = *m.rootp;
    for (int a = 0; a < pixelflow::kMemoryBytes; ++a)
      root.pixel_processor__DOT__memory__DOT__bytes_mem[a] = byte(ChipRow::Memory, a);
    for (int b = 0; b < pixelflow::kPacketBytes; ++b) outbound_[b] = byte(ChipRow::Outbound, b);
    root.pixel_processor__DOT__element__DOT__e_q = byte(ChipRow::E);
    root.pixel_processor__DOT__element__DOT__k_q = byte(ChipRow::K);
    root.pixel_processor__DOT__element__DOT__s_q = byte(ChipRow::S);
    root.pixel_processor__DOT__element__DOT__z_q = byte(ChipRow::Z);
    root.pixel_processor__DOT__element__DOT__c_q = byte(ChipRow::C);
    root.pixel_processor__DOT__element__DOT__m_q = byte(ChipRow::M);
    root.pixel_processor__DOT__element__DOT__x_q = byte(ChipRow::X);
    root.pixel_processor__DOT__element__DOT__w_q = chip_.wide()[lane];
    m.column_i = byte(ChipRow::Column);
    m.row_i = byte(ChipRow::Row);
  }

  ~Lane() { Verilated::threadContextp(&context_); }

  void cycle(const pixelflow::Instruction& instruction, int digit) {
    auto& m = module();
    m.execute_i = 1;
    m.instruction_i = pixelflow::pack(instruction);
    m.digit_i = static_cast<std::uint8_t>(digit);
    m.inbound_i = instruction.imm < pixelflow::kPacketBytes ? byte(ChipRow::Inbound, instruction.imm) : 0;
    m.clk_i = 0;
    m.eval();
    if (m.outbound_we_o) outbound_[instruction.addr] = m.wdata_o;
    tick();
  }

  std::string difference() {
    const auto& root = *module().rootp;
    const auto check = [](const char* name, unsigned module, unsigned row) {
      return module == row
                 ? std::string()
                 : std::string(name) + ": module " + std::to_string(module) + ", row " + std::to_string(row) + "; ";
    };
    return check("E", root.pixel_processor__DOT__element__DOT__e_q, byte(ChipRow::E)) +
           check("K", root.pixel_processor__DOT__element__DOT__k_q, byte(ChipRow::K)) +
           check("S", root.pixel_processor__DOT__element__DOT__s_q, byte(ChipRow::S)) +
           check("Z", root.pixel_processor__DOT__element__DOT__z_q, byte(ChipRow::Z)) +
           check("C", root.pixel_processor__DOT__element__DOT__c_q, byte(ChipRow::C)) +
           check("M", root.pixel_processor__DOT__element__DOT__m_q, byte(ChipRow::M)) +
           check("X", root.pixel_processor__DOT__element__DOT__x_q, byte(ChipRow::X)) +
           check("W", root.pixel_processor__DOT__element__DOT__w_q, chip_.wide()[lane_]);
  }

  void compare_memory() {
    for (int a = 0; a < pixelflow::kMemoryBytes; ++a) {
      ASSERT_EQ(module().rootp->pixel_processor__DOT__memory__DOT__bytes_mem[a], byte(ChipRow::Memory, a))
          << "address " << a;
    }
    for (int b = 0; b < pixelflow::kPacketBytes; ++b)
      ASSERT_EQ(outbound_[b], byte(ChipRow::Outbound, b)) << "packet byte " << b;
  }

 private:
  Module& module() { return *module_; }
  std::uint8_t byte(ChipRow row, int index = 0) { return chip_.row(row, index)[static_cast<std::size_t>(lane_)]; }
  void tick() {
    module().clk_i = 0;
    module().eval();
    module().clk_i = 1;
    module().eval();
  }

  tb::PixelChip& chip_;
  int lane_;
  VerilatedContext context_;
  std::unique_ptr<Module> module_ = std::make_unique<Module>(&context_);
  tb::Packet outbound_{};
};

void randomise(tb::PixelChip& chip, std::mt19937_64& random) {
  const auto fill = [&](ChipRow row, int index, int mask) {
    for (std::uint8_t& b : chip.row(row, index)) b = static_cast<std::uint8_t>(random() & static_cast<unsigned>(mask));
  };
  for (int a = 0; a < pixelflow::kMemoryBytes; ++a) fill(ChipRow::Memory, a, 255);
  for (int b = 0; b < pixelflow::kPacketBytes; ++b) {
    fill(ChipRow::Inbound, b, 255);
    fill(ChipRow::Outbound, b, 255);
  }
  for (const ChipRow row : {ChipRow::Column, ChipRow::Row, ChipRow::M, ChipRow::X}) fill(row, 0, 255);
  for (const ChipRow row : {ChipRow::E, ChipRow::K, ChipRow::S, ChipRow::Z, ChipRow::C}) fill(row, 0, 1);
  for (std::uint32_t& w : chip.wide()) w = static_cast<std::uint32_t>(random());
}

template <class Module>
void run(int lanes, int multiplier_bits) {
  const std::uint64_t seed = seed_or(4000 + static_cast<std::uint64_t>(multiplier_bits));
  std::printf("%s\n", replay(seed).c_str());
  std::mt19937_64 random(seed);
  const auto chip = tb::make_pixel_chip(lanes, multiplier_bits);
  int cycles = 0;
  for (int program = 0; program < 100; ++program) {
    chip->reset();
    randomise(*chip, random);
    const int lane = static_cast<int>(random() % static_cast<unsigned>(lanes));
    Lane<Module> module(*chip, lane);
    const auto stream = random_stream(random, 400, false);
    tb::ChipSurroundings around;
    std::string first;
    around.executed = [&](const pixelflow::Instruction& i, int digit, std::uint64_t cycle) {
      module.cycle(i, digit);
      ++cycles;
      if (!first.empty()) return;
      const std::string difference = module.difference();
      if (!difference.empty()) first = "cycle " + std::to_string(cycle) + ", " + text(i) + ": " + difference;
    };
    chip->run(stream, around);
    ASSERT_EQ(first, "") << replay(seed) << ", program " << program << ", lane " << lane;
    ASSERT_NO_FATAL_FAILURE(module.compare_memory()) << replay(seed) << ", program " << program << ", lane " << lane;
  }
  EXPECT_GE(cycles, 40000);
}

TEST(PixelLane, RowFormIsTheModuleOfTheElement) { run<Vpixel_processor_r2>(pixelflow::kElements, 2); }
TEST(PixelLane, RowFormIsTheModuleWithOneMultiplierBit) { run<Vpixel_processor_r1>(16, 1); }
TEST(PixelLane, RowFormIsTheModuleWithFourMultiplierBits) { run<Vpixel_processor_r4>(16, 4); }
TEST(PixelLane, RowFormIsTheModuleWithEightMultiplierBits) { run<Vpixel_processor_r8>(16, 8); }

TEST(PixelChip, ElementsStandWhereTheChipsNumberPutsThem) {
  const auto chip = tb::make_pixel_chip();
  for (const int number : {0, 1, 31}) {
    chip->reset(number);
    for (int lane = 0; lane < pixelflow::kElements; ++lane) {
      const int sample = number * pixelflow::kElements + lane;
      ASSERT_EQ(chip->row(ChipRow::Column)[lane], sample % pixelflow::kRegionWidth)
          << "chip " << number << ", lane " << lane;
      ASSERT_EQ(chip->row(ChipRow::Row)[lane], sample / pixelflow::kRegionWidth)
          << "chip " << number << ", lane " << lane;
    }
  }
  chip->place(200, 17, 63);
  EXPECT_EQ(chip->row(ChipRow::Column)[200], 17);
  EXPECT_EQ(chip->row(ChipRow::Row)[200], 63);
  EXPECT_EQ(chip->row(ChipRow::Column)[199], (31 * 256 + 199) % 128);
}

TEST(PixelChip, StreamsHaveOneEndAtTheirEnd) {
  const auto chip = tb::make_pixel_chip();
  const pixelflow::Instruction nop{.kind = pixelflow::Kind::Control};
  const pixelflow::Instruction end{.kind = pixelflow::Kind::Control,
                                   .fn = static_cast<std::uint8_t>(pixelflow::Control::End)};
  EXPECT_THROW(chip->run(std::vector{nop}), std::invalid_argument);
  EXPECT_THROW(chip->run(std::vector{end, nop}), std::invalid_argument);
  EXPECT_THROW(chip->run(std::vector<pixelflow::Instruction>{}), std::invalid_argument);
  EXPECT_EQ(chip->run(std::vector{nop, end}).executed, 2u);
  EXPECT_THROW(tb::make_pixel_chip(16, 2), std::invalid_argument);
  EXPECT_THROW(chip->row(ChipRow::Memory, 256), std::invalid_argument);
}

// Every factor times every factor, unsigned and signed.
TEST(PixelChip, ProductsOfAllPairsOfBytes) {
  const auto chip = tb::make_pixel_chip();
  for (int lane = 0; lane < 256; ++lane) chip->row(ChipRow::Memory, 0)[lane] = static_cast<std::uint8_t>(lane);
  for (int signs = 0; signs < 4; ++signs) {
    for (int factor = 0; factor < 256; ++factor) {
      std::ranges::fill(chip->wide(), 0x01FFFE80u);
      const std::vector<pixelflow::Instruction> stream = {
          {.kind = pixelflow::Kind::Wide,
           .fn = static_cast<std::uint8_t>(pixelflow::Wide::Multiply),
           .p = static_cast<std::uint8_t>(pixelflow::P::Immediate),
           .set_c = (signs & 1) != 0,
           .set_s = (signs & 2) != 0,
           .imm = static_cast<std::uint8_t>(factor)},
          {.kind = pixelflow::Kind::Control, .fn = static_cast<std::uint8_t>(pixelflow::Control::End)}};
      const auto counters = chip->run(stream);
      unsigned digits = 0;
      for (int bits = factor; bits != 0; bits >>= 2) digits += (bits & 3) != 0;
      ASSERT_EQ(counters.executed, std::max(digits, 1u) + 1) << "factor " << factor;
      const int a = signs & 1 ? static_cast<std::int8_t>(factor) : factor;
      for (int lane = 0; lane < 256; ++lane) {
        const int b = signs & 2 ? static_cast<std::int8_t>(lane) : lane;
        ASSERT_EQ(chip->wide()[lane], 0x01FFFE80u + static_cast<unsigned>(a * b)) << a << " times " << b;
      }
    }
  }
}

}  // namespace
}  // namespace pixelflow_tests
