// The blocks around the elements alone, against plain expectations; four elements a chip.
#include <gtest/gtest.h>
#include <verilated.h>

#include <deque>
#include <random>
#include <vector>

#include "Vcommunication_buffer.h"
#include "Vcomposition_port.h"
#include "Vinstruction_sequencer.h"
#include "Vstream_buffer.h"
#include "cmodel/pixelflow/instruction.h"
#include "tests/pixelflow_model/seed.h"

namespace pixelflow_tests {
namespace {

constexpr int kLanes = 4;

template <class Top>
class Block {
 public:
  Block() {
    top.rst_ni = 0;
    tick();
    top.rst_ni = 1;
    settle();
  }
  ~Block() {
    top.final();
    Verilated::threadContextp(&context_);
  }
  void settle() {
    top.clk_i = 0;
    top.eval();
  }
  void tick() {
    settle();
    top.clk_i = 1;
    top.eval();
    settle();
  }

 private:
  VerilatedContext context_;

 public:
  Top top{&context_};
};

// Packets are told apart by two words: depth, and a number in the last word.
struct Pixel {
  std::uint32_t depth, number;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

template <class Words>
void put(Words& words, const Pixel& pixel) {
  for (int w = 0; w < 8; ++w) words[w] = 0;
  words[0] = pixel.depth;
  words[7] = pixel.number;
}

class Composition : public testing::Test {
 protected:
  enum Mode { kOwn, kCloser, kUpstream, kRepeat };

  /// Offers both streams until one packet a lane has left, and gives them.
  std::vector<Pixel> transfer(Mode mode, const std::vector<Pixel>& own, const std::vector<Pixel>& upstream, bool gaps) {
    auto& top = block_.top;
    top.mode_i = mode;
    std::size_t next_own = 0, next_upstream = 0;
    std::vector<Pixel> out;
    for (int cycle = 0; cycle < 200 && out.size() < kLanes; ++cycle) {
      const auto chance = [&] { return !gaps || random_() % 2 == 0; };
      // What was offered stays until it is taken.
      own_held_ = next_own < own.size() && (own_held_ || chance());
      upstream_held_ = next_upstream < upstream.size() && (upstream_held_ || chance());
      top.own_valid_i = own_held_;
      top.upstream_valid_i = upstream_held_;
      if (own_held_) put(top.own_packet_i, own[next_own]);
      if (upstream_held_) put(top.upstream_packet_i, upstream[next_upstream]);
      top.ready_i = chance();
      block_.settle();
      if (top.valid_o && top.ready_i) out.push_back({top.packet_o[0], top.packet_o[7]});
      const bool takes_own = own_held_ && top.own_ready_o, takes_upstream = upstream_held_ && top.upstream_ready_o;
      block_.tick();
      if (takes_own) ++next_own, own_held_ = false;
      if (takes_upstream) ++next_upstream, upstream_held_ = false;
    }
    EXPECT_EQ(next_own, own.size());
    EXPECT_EQ(next_upstream, upstream.size());
    return out;
  }

  Block<Vcomposition_port> block_;
  std::mt19937_64 random_{seed_or(5)};
  bool own_held_ = false, upstream_held_ = false;

  const std::vector<Pixel> own_ = {{5, 1}, {0x80000000, 2}, {7, 3}, {0, 4}};
  const std::vector<Pixel> upstream_ = {{6, 11}, {1, 12}, {7, 13}, {0x01000000, 14}};
  const std::vector<Pixel> closer_ = {{5, 1}, {1, 12}, {7, 13}, {0, 4}};
};

TEST_F(Composition, PassesTheCloserOneAndTiesToUpstream) {
  EXPECT_EQ(transfer(kCloser, own_, upstream_, false), closer_);
}

TEST_F(Composition, KeepsTheOrderWithGapsInEveryStream) {
  for (int i = 0; i < 50; ++i) ASSERT_EQ(transfer(kCloser, own_, upstream_, true), closer_) << "transfer " << i;
}

TEST_F(Composition, TheFirstNodeHasNoUpstream) { EXPECT_EQ(transfer(kOwn, own_, {}, true), own_); }

TEST_F(Composition, ColoursOfOthersPassWithoutCompositing) {
  EXPECT_EQ(transfer(kUpstream, {}, upstream_, true), upstream_);
}

TEST_F(Composition, FurtherPacketsFollowTheFirst) {
  transfer(kCloser, own_, upstream_, true);
  const std::vector<Pixel> more = {{9, 21}, {9, 22}, {9, 23}, {9, 24}},
                           more_upstream = {{1, 31}, {1, 32}, {1, 33}, {1, 34}};
  EXPECT_EQ(transfer(kRepeat, more, more_upstream, true), (std::vector<Pixel>{{9, 21}, {1, 32}, {1, 33}, {9, 24}}));
}

TEST(CommunicationBuffer, TakesAPacketALaneAndThenNoneUntilItIsFree) {
  Block<Vcommunication_buffer> block;
  auto& top = block.top;
  for (int round = 0; round < 3; ++round) {
    for (int lane = 0; lane < kLanes; ++lane) {
      top.load_valid_i = 0;
      block.tick();
      EXPECT_FALSE(top.inbound_we_o);
      top.load_valid_i = 1;
      block.settle();
      EXPECT_TRUE(top.load_ready_o);
      EXPECT_TRUE(top.inbound_we_o);
      EXPECT_EQ(top.inbound_lane_o, lane);
      EXPECT_FALSE(top.arrived_o);
      block.tick();
    }
    EXPECT_TRUE(top.arrived_o);
    EXPECT_FALSE(top.load_ready_o);
    EXPECT_FALSE(top.inbound_we_o);
    block.tick();
    EXPECT_TRUE(top.arrived_o);
    top.free_i = 1;
    block.tick();
    top.free_i = 0;
    EXPECT_FALSE(top.arrived_o);
  }
}

TEST(CommunicationBuffer, GivesEveryLaneOnceInOrderWhateverTheReceiverDoes) {
  const std::uint64_t seed = seed_or(6);
  std::mt19937_64 random(seed);
  Block<Vcommunication_buffer> block;
  auto& top = block.top;
  for (int round = 0; round < 200; ++round) {
    EXPECT_FALSE(top.sending_o);
    top.send_i = 1;
    block.tick();
    top.send_i = 0;
    int read = -1;  // the lane whose packet is on offer
    int cycles = 0;
    std::vector<int> taken;
    for (; top.sending_o && cycles < 100; ++cycles) {
      top.own_ready_i = round == 0 || random() % 2 == 0;
      block.settle();
      const bool takes = top.own_valid_o && top.own_ready_i, reads = top.outbound_re_o;
      const int lane = top.outbound_lane_o;
      if (takes) taken.push_back(read);
      ASSERT_TRUE(!reads || !top.own_valid_o || takes) << replay(seed) << ": a packet on offer is overwritten";
      block.tick();
      if (reads) read = lane;
    }
    ASSERT_EQ(taken, (std::vector{0, 1, 2, 3})) << replay(seed) << ", round " << round;
    if (round == 0) {
      EXPECT_EQ(cycles, kLanes + 1);  // one a cycle, the first a cycle after it is asked for
    }
  }
}

TEST(StreamBuffer, GivesWordsInOrderAndRefusesWhenFull) {
  const std::uint64_t seed = seed_or(7);
  std::mt19937_64 random(seed);
  Block<Vstream_buffer> block;
  auto& top = block.top;
  std::deque<std::uint64_t> expected;
  bool was_full = false;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    // Long stretches of filling and of emptying.
    const bool fills = cycle / 64 % 2 == 0;
    const std::uint64_t word = random() & ((std::uint64_t{1} << pixelflow::kInstructionBits) - 1);
    top.valid_i = random() % 4 != 0 || fills;
    top.instruction_i = word;
    top.ready_i = fills ? random() % 8 == 0 : random() % 8 != 0;
    block.settle();
    ASSERT_EQ(top.valid_o != 0, !expected.empty()) << replay(seed);
    ASSERT_EQ(top.ready_o != 0, expected.size() < 16) << replay(seed);
    was_full |= expected.size() == 16;
    if (top.valid_o) {
      ASSERT_EQ(top.instruction_o, expected.front()) << replay(seed) << ", cycle " << cycle;
    }
    const bool takes = top.valid_i && top.ready_o, gives = top.valid_o && top.ready_i;
    block.tick();
    if (gives) expected.pop_front();
    if (takes) expected.push_back(word);
  }
  EXPECT_TRUE(was_full);
}

class Sequencer : public testing::Test {
 protected:
  using I = pixelflow::Instruction;

  void offer(const I& instruction) {
    block_.top.valid_i = 1;
    block_.top.instruction_i = pixelflow::pack(instruction);
    block_.settle();
  }
  void start() {
    block_.top.start_i = 1;
    block_.tick();
    block_.top.start_i = 0;
    block_.settle();
  }
  /// The digits of one instruction, in the cycles that it takes.
  std::vector<int> digits(const I& instruction) {
    offer(instruction);
    std::vector<int> out;
    for (bool last = false; !last && out.size() < 20;) {
      EXPECT_TRUE(block_.top.execute_o);
      out.push_back(block_.top.digit_o);
      last = block_.top.ready_o;
      block_.tick();
    }
    return out;
  }
  static I control(pixelflow::Control what) {
    return {.kind = pixelflow::Kind::Control, .fn = static_cast<std::uint8_t>(what)};
  }
  static I multiply(pixelflow::P p, int imm) {
    return {.kind = pixelflow::Kind::Wide,
            .fn = static_cast<std::uint8_t>(pixelflow::Wide::Multiply),
            .p = static_cast<std::uint8_t>(p),
            .imm = static_cast<std::uint8_t>(imm)};
  }

  Block<Vinstruction_sequencer> block_;
};

TEST_F(Sequencer, ZeroDigitsOfAnImmediateAreLeftOut) {
  using pixelflow::P;
  start();
  EXPECT_EQ(digits(multiply(P::Immediate, 0)), (std::vector{0}));
  EXPECT_EQ(digits(multiply(P::Immediate, 1)), (std::vector{0}));
  EXPECT_EQ(digits(multiply(P::Immediate, 0x80)), (std::vector{3}));
  EXPECT_EQ(digits(multiply(P::Immediate, 0x31)), (std::vector{0, 2}));
  EXPECT_EQ(digits(multiply(P::Immediate, 0xFF)), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(digits(multiply(P::X, 0)), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(digits({}), (std::vector{0}));
  EXPECT_EQ(block_.top.executed_o, 1u + 1 + 1 + 2 + 4 + 4 + 1);
  EXPECT_EQ(block_.top.instructions_o, 7u);
}

TEST_F(Sequencer, NothingIsTakenBeforeTheStartAndAfterTheEnd) {
  offer({});
  EXPECT_FALSE(block_.top.execute_o);
  EXPECT_FALSE(block_.top.done_o);
  start();
  EXPECT_EQ(digits(control(pixelflow::Control::End)).size(), 1u);
  EXPECT_TRUE(block_.top.done_o);
  offer({});
  EXPECT_FALSE(block_.top.execute_o);
  block_.tick();
  EXPECT_EQ(block_.top.executed_o, 1u);
  start();
  EXPECT_FALSE(block_.top.done_o);
  EXPECT_EQ(block_.top.executed_o, 0u);
  EXPECT_TRUE(block_.top.execute_o);
}

TEST_F(Sequencer, WaitsAreCountedByTheirCause) {
  auto& top = block_.top;
  start();
  top.valid_i = 0;
  block_.tick();
  block_.tick();
  EXPECT_EQ(top.stream_waits_o, 2u);

  offer(control(pixelflow::Control::WaitInbound));
  EXPECT_FALSE(top.ready_o);
  block_.tick();
  block_.tick();
  block_.tick();
  EXPECT_EQ(top.inbound_waits_o, 3u);
  top.arrived_i = 1;
  block_.settle();
  EXPECT_TRUE(top.ready_o);
  EXPECT_FALSE(top.free_o);
  block_.tick();

  top.sending_i = 1;
  offer(control(pixelflow::Control::Send));
  EXPECT_FALSE(top.send_o);
  block_.tick();
  offer({.dest = static_cast<std::uint8_t>(pixelflow::To::Port)});
  EXPECT_FALSE(top.execute_o);
  block_.tick();
  EXPECT_EQ(top.send_waits_o, 2u);
  top.sending_i = 0;
  offer(control(pixelflow::Control::Send));
  EXPECT_TRUE(top.send_o);
  block_.tick();
  offer(control(pixelflow::Control::FreeInbound));
  EXPECT_TRUE(top.free_o);
  block_.tick();
  EXPECT_EQ(top.executed_o, 3u);
  EXPECT_EQ(top.instructions_o, 3u);
}

}  // namespace
}  // namespace pixelflow_tests
