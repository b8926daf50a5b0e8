// Packets in and out of the array at every level of modelling.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "pixelflow/microcode/library.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

constexpr int kLanes = 2 * kElements;
constexpr int kEnableAt = 100, kAt = 10, kArrivedAt = 50;

std::vector<std::uint8_t> random_bytes(std::mt19937_64& random, std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// Where enabled: the packet becomes bytes of memory, leaves, and is changed once more after it was sent.
Program sending() {
  Program program;
  append_instructions(program, [](Assembler& out) {
    out.flag_of_memory(Flag::E, kEnableAt, 0);
    for (int n = 0; n < kPacketBytes; ++n) {
      out.load_m(kAt + n);
      out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = n});
    }
    out.control(Control::Send);
    out.alu(Alu::Or, To::Port, P::Zero, Q::Immediate, {.addr = 3, .imm = 0x5A});
  });
  return program;
}

Program receiving() {
  Program program;
  append_instructions(program, [](Assembler& out) {
    out.control(Control::WaitInbound);
    for (int n = 0; n < kPacketBytes; ++n) {
      out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = kArrivedAt + n, .imm = n});
    }
    out.control(Control::FreeInbound);
  });
  return program;
}

TEST(ArrayPorts, SendWhatTheElementsHold) {
  const std::uint64_t seed = seed_or(31);
  for (const auto& level : pfman_tests::all_levels(kLanes)) {
    std::mt19937_64 random(seed);
    std::vector<std::uint8_t> expected(kLanes * kPacketBytes), packets(expected.size(), 1);
    level.array->sent(packets);
    EXPECT_EQ(packets, expected) << "nothing was sent yet";
    for (int round = 0; round < 3; ++round) {
      const auto enabled = random_bytes(random, kLanes);
      level.array->write(kEnableAt, enabled);
      for (int n = 0; n < kPacketBytes; ++n) {
        const auto row = random_bytes(random, kLanes);
        level.array->write(kAt + n, row);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (enabled[lane] & 1) expected[lane * kPacketBytes + static_cast<std::size_t>(n)] = row[lane];
        }
      }
      level.array->run(sending());
      level.array->sent(packets);
      ASSERT_EQ(packets, expected) << replay(seed) << ", " << level.name << ", round " << round;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (enabled[lane] & 1) expected[lane * kPacketBytes + 3] = 0x5A;
      }
    }
  }
}

TEST(ArrayPorts, TakeWhatIsLoaded) {
  const std::uint64_t seed = seed_or(32);
  for (const auto& level : pfman_tests::all_levels(kLanes)) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 3; ++round) {
      const auto enabled = random_bytes(random, kLanes);
      level.array->write(kEnableAt, enabled);
      const std::vector<std::uint8_t> before(kLanes, 7);
      for (int n = 0; n < kPacketBytes; ++n) level.array->write(kArrivedAt + n, before);
      const auto packets = random_bytes(random, kLanes * kPacketBytes);
      level.array->run(sending());  // sets the flag
      level.array->load(packets);
      level.array->run(receiving());
      std::vector<std::uint8_t> row(kLanes);
      for (int n = 0; n < kPacketBytes; ++n) {
        level.array->read(kArrivedAt + n, row);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          const int expected = enabled[lane] & 1 ? packets[lane * kPacketBytes + static_cast<std::size_t>(n)] : 7;
          ASSERT_EQ(row[lane], expected) << replay(seed) << ", " << level.name << ", lane " << lane << ", byte " << n;
        }
      }
    }
  }
}

TEST(ArrayPorts, CountTheSameCyclesAtAllLevels) {
  std::vector<std::uint64_t> cycles;
  for (const auto& level : pfman_tests::all_levels(kLanes)) {
    level.array->run(sending());
    level.array->load(std::vector<std::uint8_t>(kLanes * kPacketBytes));
    level.array->run(receiving());
    cycles.push_back(level.array->counters().cycles);
    EXPECT_EQ(cycles.back(), cycles.front()) << level.name;
    EXPECT_EQ(cycles.back(), sending().cycles() + receiving().cycles());
  }
}

TEST(ArrayPorts, RefuseOtherNumbersOfBytes) {
  std::vector<std::uint8_t> bytes(kLanes * kPacketBytes - 1);
  for (const auto& level : pfman_tests::all_levels(kLanes)) {
    EXPECT_THROW(level.array->load(bytes), std::invalid_argument) << level.name;
    EXPECT_THROW(level.array->sent(bytes), std::invalid_argument) << level.name;
  }
}

}  // namespace
}  // namespace pixelflow_tests
