// Composition of packets from node to node, and arrays of which only some chips work.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "pixelflow/microcode/library.h"
#include "tests/pfman_shading/levels.h"
#include "tests/pixelflow_model/seed.h"

namespace region_tests {
namespace {

using namespace pixelflow;
using pfman_tests::all_levels;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;

constexpr int kLanes = 3 * kElements;
constexpr int kMostPackets = 3;

using Packets = std::vector<std::uint8_t>;  // kPacketBytes an element

/// What a node has: its packets lie in memory one after another.
Program sending(int number) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    for (int n = 0; n < kPacketBytes; ++n) {
      out.load_m(kPacketBytes * number + n);
      out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = n, .gate = Gate::None});
    }
    out.control(Control::Send);
  });
  return program;
}

/// Depths with few different bytes, so that all orders of bytes and equal depths occur.
Packets random_packets(std::mt19937_64& random, int elements) {
  Packets packets(static_cast<std::size_t>(elements * kPacketBytes));
  for (std::size_t n = 0; n < packets.size(); ++n) {
    const bool depth = n % kPacketBytes < kDepthBytes;
    packets[n] = static_cast<std::uint8_t>(depth ? (random() % 3) * 127 : random());
  }
  return packets;
}

std::uint32_t depth_of(const Packets& packets, std::size_t element) {
  std::uint32_t depth = 0;
  for (int n = kDepthBytes - 1; n >= 0; --n) {
    depth = depth << 8 | packets[element * kPacketBytes + static_cast<std::size_t>(n)];
  }
  return depth;
}

TEST(Composition, PassesOnTheClosestPixelOfSeveralNodes) {
  const std::uint64_t seed = seed_or(71);
  for (const auto& level : all_levels(kLanes)) {
    std::mt19937_64 random(seed);
    int ties = 0;
    for (int round = 0; round < 8; ++round) {
      const std::string where = replay(seed) + ", " + level.name + ", round " + std::to_string(round);
      const int nodes = 1 + round % 4, covered = 1 + static_cast<int>(random() % kLanes);
      level.array->cover(covered);
      std::vector<std::vector<Packets>> sent;  // by node, most upstream first; by packet
      std::vector<Packets> through(kMostPackets);
      for (int node = 0; node < nodes; ++node) {
        sent.emplace_back();
        for (int n = 0; n < kMostPackets; ++n) sent.back().push_back(random_packets(random, covered));
        for (int n = 0; n < kMostPackets; ++n) {
          Packets row(static_cast<std::size_t>(covered));
          for (int byte = 0; byte < kPacketBytes; ++byte) {
            for (std::size_t e = 0; e < row.size(); ++e) {
              row[e] = sent.back()[static_cast<std::size_t>(n)][e * kPacketBytes + static_cast<std::size_t>(byte)];
            }
            level.array->write(kPacketBytes * n + byte, row);
          }
        }
        for (std::size_t n = 0; n < kMostPackets; ++n) {
          if (node > 0) level.array->compose(n == 0 ? Compose::Closer : Compose::Repeat, through[n]);
          level.array->run(sending(static_cast<int>(n)));
          through[n].resize(static_cast<std::size_t>(covered * kPacketBytes));
          level.array->sent(through[n]);
        }
      }
      for (std::size_t e = 0; e < static_cast<std::size_t>(covered); ++e) {
        std::size_t winner = 0;
        for (std::size_t node = 1; node < sent.size(); ++node) {
          const std::uint32_t own = depth_of(sent[node][0], e), best = depth_of(sent[winner][0], e);
          if (own < best) winner = node;
          ties += own == best;
        }
        for (std::size_t n = 0; n < kMostPackets; ++n) {
          const auto at = static_cast<std::ptrdiff_t>(e * kPacketBytes);
          ASSERT_TRUE(
              std::equal(through[n].begin() + at, through[n].begin() + at + kPacketBytes, sent[winner][n].begin() + at))
              << where << ", element " << e << ", packet " << n;
        }
      }
    }
    EXPECT_GT(ties, 0) << replay(seed);
  }
}

TEST(Composition, ServesOneProgramAlone) {
  for (const auto& level : all_levels(kLanes)) {
    const Packets upstream(static_cast<std::size_t>(kLanes * kPacketBytes), 0);  // closer than everything
    Packets got(upstream.size());
    level.array->write(0, std::vector<std::uint8_t>(kLanes, 9));
    level.array->compose(Compose::Closer, upstream);
    Program nothing;
    append_instructions(nothing, [](Assembler& out) { out.set_m(1); });
    level.array->run(nothing);  // without a Send
    level.array->run(sending(0));
    level.array->sent(got);
    EXPECT_EQ(got[0], 0) << level.name;
    level.array->run(sending(0));
    level.array->sent(got);
    EXPECT_EQ(got[0], 9) << level.name;
  }
}

TEST(Composition, RefusesWhatNoPortCanDo) {
  const Packets packets(static_cast<std::size_t>(kLanes * kPacketBytes));
  for (const auto& level : all_levels(kLanes)) {
    EXPECT_THROW(level.array->compose(Compose::Own, packets), std::invalid_argument) << level.name;
    EXPECT_THROW(level.array->compose(Compose::Upstream, packets), std::invalid_argument) << level.name;
    EXPECT_THROW(level.array->compose(Compose::Closer, std::span(packets).first(32)), std::invalid_argument);
    level.array->compose(Compose::Closer, packets);
    Program twice = sending(0);
    append_instructions(twice, [](Assembler& out) { out.control(Control::Send); });
    EXPECT_THROW(level.array->run(twice), std::invalid_argument) << level.name;
  }
}

/// memory[k] := memory[k] + k for some k, and W and E left with something in them.
Program counting(int round) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    for (int at = 0; at < 3; ++at) {
      out.load_w(at, at);
      out.load_m(at);
      out.alu(Alu::Add, To::Memory, P::M, Q::Immediate, {.addr = at, .imm = at + 1, .gate = Gate::None});
    }
    for (int n = 0; n < round % 4; ++n) out.down();  // moves W's bytes about
    out.flag_of_memory(Flag::E, 0, 0);
  });
  return program;
}

/// An array that is covered in parts against one for each chip, which runs when the chip has covered elements.
TEST(CoveredElements, WorkAndTheOtherChipsRest) {
  constexpr int kManyLanes = 7 * kElements;  // more than one tile of the golden model
  const std::uint64_t seed = seed_or(72);
  for (auto& level : all_levels(kManyLanes)) {
    std::mt19937_64 random(seed);
    std::vector<std::unique_ptr<PixelArray>> chips;
    for (int n = 0; n < kManyLanes; n += kElements) chips.push_back(make_golden_array(Level::Model, kElements));
    std::uint64_t simulated = 0;
    for (int round = 0; round < 24; ++round) {
      const int covered = 1 + static_cast<int>(random() % kManyLanes);
      const int working = (covered + kElements - 1) / kElements;
      level.array->cover(covered);
      EXPECT_EQ(level.array->covered(), covered);
      std::vector<std::uint8_t> row(static_cast<std::size_t>(covered));
      for (std::uint8_t& byte : row) byte = static_cast<std::uint8_t>(random());
      level.array->write(2, row);
      const Program program = counting(round);
      level.array->run(program);
      simulated += program.cycles() * static_cast<std::uint64_t>(working * kElements);
      for (int chip = 0; chip < working; ++chip) {
        std::vector<std::uint8_t> part(kElements);
        PixelArray& array = *chips[static_cast<std::size_t>(chip)];
        array.read(2, part);
        const auto first = static_cast<std::size_t>(chip * kElements);
        std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(first), std::min(part.size(), row.size() - first),
                    part.begin());
        array.write(2, part);
        array.run(program);
      }
    }
    level.array->cover(kManyLanes);
    std::vector<std::uint8_t> row(kManyLanes), part(kElements);
    for (int chip = 0; chip < kManyLanes / kElements; ++chip) {
      for (int lane = 0; lane < kElements; ++lane) {
        ASSERT_EQ(level.array->registers(chip * kElements + lane),
                  chips[static_cast<std::size_t>(chip)]->registers(lane))
            << replay(seed) << ", " << level.name << ", chip " << chip << ", lane " << lane;
      }
      for (int address = 0; address < 3; ++address) {
        level.array->read(address, row);
        chips[static_cast<std::size_t>(chip)]->read(address, part);
        ASSERT_TRUE(std::equal(part.begin(), part.end(), row.begin() + chip * kElements))
            << replay(seed) << ", " << level.name << ", chip " << chip << ", address " << address;
      }
    }
    EXPECT_EQ(level.array->counters().element_cycles, level.array->counters().cycles * kManyLanes) << level.name;
    EXPECT_EQ(level.array->counters().simulated_element_cycles, simulated) << level.name;
  }
}

TEST(CoveredElements, HaveTheirPlacesAndNoOthers) {
  for (const auto& level : all_levels(kLanes)) {
    EXPECT_THROW(level.array->cover(0), std::invalid_argument) << level.name;
    EXPECT_THROW(level.array->cover(kLanes + 1), std::invalid_argument) << level.name;
    level.array->cover(300);
    std::vector<std::uint8_t> columns(300), rows(300);
    level.array->places(columns, rows);
    EXPECT_EQ(columns[299], 299 % kRegionWidth) << level.name;
    EXPECT_EQ(rows[299], 299 / kRegionWidth) << level.name;
    for (std::size_t n = 0; n < columns.size(); ++n) columns[n] = static_cast<std::uint8_t>(n % 100), rows[n] = 63;
    level.array->place(columns, rows);
    std::vector<std::uint8_t> others(300);
    level.array->places(others, rows);
    EXPECT_EQ(others, columns) << level.name;
    const std::vector<std::uint8_t> all(kLanes);
    EXPECT_THROW(level.array->write(0, all), std::invalid_argument) << level.name;
    EXPECT_THROW(level.array->place(all, all), std::invalid_argument) << level.name;
    level.array->cover(kLanes);
    columns.resize(kLanes), rows.resize(kLanes);
    level.array->places(columns, rows);
    EXPECT_EQ(columns[299], 99) << level.name;
    EXPECT_EQ(columns[300], 300 % kRegionWidth) << level.name;
  }
}

}  // namespace
}  // namespace region_tests
