// The tile of vectors against the scalar element, which is written to be read.
#include "cmodel/pixelflow/pixel_row.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <stdexcept>

#include "tests/pixelflow_model/seed.h"

namespace pixelflow {
namespace {

using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

/// A tile and as many scalar elements, with the same random state.
class RowAndElements {
 public:
  RowAndElements(int lanes, std::uint64_t seed)
      : random_(seed), row_(lanes), elements_(static_cast<std::size_t>(lanes)) {
    for (int lane = 0; lane < lanes; ++lane) {
      PixelElement& element = elements_[static_cast<std::size_t>(lane)];
      for (int a = 0; a < kMemoryBytes; ++a) element.memory[a] = row_.memory(a)[lane] = byte();
      for (int b = 0; b < kPacketBytes; ++b) {
        element.inbound[b] = row_.inbound(b)[lane] = byte();
        element.outbound[b] = row_.outbound(b)[lane] = byte();
      }
      element.x_position = row_.columns()[lane] = byte();
      element.y_position = row_.rows()[lane] = byte();
      renew(lane);
    }
  }

  std::mt19937_64& random() { return random_; }

  /// Random registers again: a long random stream drives many of them to few values.
  void renew() {
    for (int lane = 0; lane < row_.lanes(); ++lane) renew(lane);
  }

  void step(const Instruction& instruction) {
    row_.step(instruction);
    for (PixelElement& element : elements_) element.step(instruction);
  }

  void compare_registers(const std::string& where) const {
    for (int lane = 0; lane < row_.lanes(); ++lane) {
      ASSERT_TRUE(row_.registers(lane) == elements_[static_cast<std::size_t>(lane)].registers)
          << where << ", lane " << lane;
    }
  }

  void compare_rows(const std::string& where) const {
    for (int lane = 0; lane < row_.lanes(); ++lane) {
      const PixelElement& element = elements_[static_cast<std::size_t>(lane)];
      for (int a = 0; a < kMemoryBytes; ++a) {
        ASSERT_EQ(row_.memory(a)[lane], element.memory[a]) << where << ", lane " << lane << ", address " << a;
      }
      for (int b = 0; b < kPacketBytes; ++b) {
        ASSERT_EQ(row_.outbound(b)[lane], element.outbound[b]) << where << ", lane " << lane << ", packet byte " << b;
      }
    }
  }

 private:
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }

  void renew(int lane) {
    const std::uint64_t bits = random_(), more = random_();
    Registers r{(bits & 1) != 0,
                (bits & 2) != 0,
                (bits & 4) != 0,
                (bits & 8) != 0,
                (bits & 16) != 0,
                static_cast<std::uint8_t>(bits >> 8),
                static_cast<std::uint8_t>(bits >> 16),
                static_cast<std::uint32_t>(more)};
    if ((bits >> 32 & 3) == 0) r.w >>= more >> 32 & 31;  // leading zeros, for the normalising shift
    if ((bits >> 34 & 3) == 0) r.x &= 15;
    row_.set_registers(lane, r);
    elements_[static_cast<std::size_t>(lane)].registers = r;
  }

  std::mt19937_64 random_;
  PixelRow row_;
  std::vector<PixelElement> elements_;
};

// Every field takes every value of its bits, also those that name nothing.
TEST(PixelRow, RandomWordsDoWhatTheElementDoes) {
  const std::uint64_t seed = seed_or(20261);
  std::cout << replay(seed) << '\n';
  RowAndElements both(100, seed);
  for (int n = 0; n < 60000; ++n) {
    if (n % 16 == 0) both.renew();
    const Instruction instruction = unpack(both.random()());
    both.step(instruction);
    const std::string where =
        replay(seed) + ", instruction " + std::to_string(n) + ", word " + std::to_string(pack(instruction));
    ASSERT_NO_FATAL_FAILURE(both.compare_registers(where));
    if (n % 256 == 0) {
      ASSERT_NO_FATAL_FAILURE(both.compare_rows(where));
    }
  }
  both.compare_rows(replay(seed));
}

// Every combination of kind, function, operands, carry and destination, which random words would reach too seldom.
TEST(PixelRow, EveryCombinationOfCodesDoesWhatTheElementDoes) {
  const std::uint64_t seed = seed_or(20262);
  std::cout << replay(seed) << '\n';
  RowAndElements both(64, seed);
  for (int codes = 0; codes < 1 << 17; ++codes) {
    Instruction i = unpack(both.random()());
    i.kind = static_cast<Kind>(codes & 3);
    i.fn = static_cast<std::uint8_t>(codes >> 2 & 15);
    i.p = static_cast<std::uint8_t>(codes >> 6 & 7);
    i.q = static_cast<std::uint8_t>(codes >> 9 & 7);
    i.cin = static_cast<std::uint8_t>(codes >> 12 & 3);
    i.dest = static_cast<std::uint8_t>(codes >> 14 & 7);
    if (i.kind == Kind::Control) continue;
    if (codes % 16 == 0) both.renew();
    both.step(i);
    const std::string where = replay(seed) + ", codes " + std::to_string(codes) + ", word " + std::to_string(pack(i));
    ASSERT_NO_FATAL_FAILURE(both.compare_registers(where));
    if (codes % 1024 == 0) {
      ASSERT_NO_FATAL_FAILURE(both.compare_rows(where));
    }
  }
  both.compare_rows(replay(seed));
}

TEST(PixelRow, ProductsOfAllPairsOfBytes) {
  PixelRow row(256);
  for (int lane = 0; lane < 256; ++lane) row.memory(0)[lane] = static_cast<std::uint8_t>(lane);
  for (int signs = 0; signs < 4; ++signs) {
    for (int factor = 0; factor < 256; ++factor) {
      for (int lane = 0; lane < 256; ++lane) row.set_registers(lane, {.w = 0x01FFFE80u + static_cast<unsigned>(lane)});
      row.step({.kind = Kind::Wide,
                .fn = static_cast<std::uint8_t>(Wide::Multiply),
                .p = static_cast<std::uint8_t>(P::Immediate),
                .set_c = (signs & 1) != 0,
                .set_s = (signs & 2) != 0,
                .imm = static_cast<std::uint8_t>(factor)});
      for (int lane = 0; lane < 256; ++lane) {
        const int a = signs & 1 ? static_cast<std::int8_t>(factor) : factor;
        const int b = signs & 2 ? static_cast<std::int8_t>(lane) : lane;
        ASSERT_EQ(row.registers(lane).w, 0x01FFFE80u + static_cast<unsigned>(lane) + static_cast<unsigned>(a * b))
            << a << " x " << b;
      }
    }
  }
}

TEST(PixelRow, PartOfATile) {
  for (const int lanes : {1, 63, 64, 65, 1000, PixelRow::kLanes}) {
    PixelRow row(lanes);
    EXPECT_EQ(row.lanes(), lanes);
    const auto groups = static_cast<unsigned>((lanes + PixelRow::kGroup - 1) / PixelRow::kGroup);
    const std::uint32_t every = (1u << groups) - 1, last = 1u << (groups - 1);
    EXPECT_EQ(row.enabled_groups().any, 0u);
    row.step({.kind = Kind::Flag, .dest = static_cast<std::uint8_t>(Flag::E)});  // E := 1 in all
    EXPECT_EQ(row.enabled_groups().any, every);
    EXPECT_EQ(row.enabled_groups().all, every);
    row.step({.dest = static_cast<std::uint8_t>(To::M)});
    row.step({.q = static_cast<std::uint8_t>(Q::Immediate),
              .dest = static_cast<std::uint8_t>(To::Memory),
              .addr = 9,
              .imm = 77});
    EXPECT_EQ(row.memory(9)[0], 77);
    EXPECT_EQ(row.memory(9)[lanes - 1], 77);
    Registers r = row.registers(lanes - 1);
    r.e = false;
    row.set_registers(lanes - 1, r);
    EXPECT_EQ(row.enabled_groups().all, every & ~last);
    EXPECT_EQ(row.enabled_groups().any, lanes % PixelRow::kGroup == 1 ? every & ~last : every);
  }
  EXPECT_THROW(PixelRow(0), std::invalid_argument);
  EXPECT_THROW(PixelRow(-5), std::invalid_argument);
  EXPECT_THROW(PixelRow(PixelRow::kLanes + 1), std::invalid_argument);
}

}  // namespace
}  // namespace pixelflow
