// Driver of a verilated pixel_chip. A template, as each set of sizes is a class of its own.
#pragma once

#include <verilated.h>
#include <verilated_fst_c.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/pixelflow/pixel_chip.h"

namespace tb {

template <class Top>
class PixelChipDriver final : public PixelChip {
 public:
  explicit PixelChipDriver(int multiplier_bits, const std::filesystem::path& trace = {})
      : multiplier_bits_(multiplier_bits) {
    context_.traceEverOn(!trace.empty());
    top_ = std::make_unique<Top>(&context_);
    if (!trace.empty()) {
      trace_ = std::make_unique<VerilatedFstC>();
      top_->trace(trace_.get(), 99);
      trace_->open(trace.c_str());
    }
    lanes_ = static_cast<int>(std::size(top_->rootp->pixel_chip__DOT__elements__DOT__m_q.m_storage));
    reset(0);
  }
  ~PixelChipDriver() override {
    if (trace_) trace_->close();
    top_->final();
    // Verilator takes the scopes of a model from the context used last, which may be another chip's.
    Verilated::threadContextp(&context_);
  }

  int lanes() const override { return lanes_; }
  int multiplier_bits() const override { return multiplier_bits_; }

  void reset(int chip) override {
    top_->chip_i = static_cast<std::uint8_t>(chip);
    top_->ready_i = 1;
    top_->rst_ni = 0;
    tick();
    tick();
    top_->rst_ni = 1;
    tick();
  }

  void place(int lane, std::uint8_t column, std::uint8_t row) override {
    top_->place_i = 1;
    top_->place_lane_i = static_cast<std::uint8_t>(lane);
    top_->place_column_i = column;
    top_->place_row_i = row;
    tick();
    top_->place_i = 0;
  }

  std::span<std::uint8_t> row(ChipRow which, int index) override {
    auto& root = *top_->rootp;
    switch (which) {
      case ChipRow::Memory: return indexed(root.pixel_chip__DOT__elements__DOT__memory_q, index);
      case ChipRow::Inbound: return indexed(root.pixel_chip__DOT__elements__DOT__inbound_q, index);
      case ChipRow::Outbound: return indexed(root.pixel_chip__DOT__elements__DOT__outbound_q, index);
      case ChipRow::Column: return root.pixel_chip__DOT__elements__DOT__column_q.m_storage;
      case ChipRow::Row: return root.pixel_chip__DOT__elements__DOT__row_q.m_storage;
      case ChipRow::M: return root.pixel_chip__DOT__elements__DOT__m_q.m_storage;
      case ChipRow::X: return root.pixel_chip__DOT__elements__DOT__x_q.m_storage;
      case ChipRow::E: return root.pixel_chip__DOT__elements__DOT__e_q.m_storage;
      case ChipRow::K: return root.pixel_chip__DOT__elements__DOT__k_q.m_storage;
      case ChipRow::S: return root.pixel_chip__DOT__elements__DOT__s_q.m_storage;
      case ChipRow::Z: return root.pixel_chip__DOT__elements__DOT__z_q.m_storage;
      case ChipRow::C: return root.pixel_chip__DOT__elements__DOT__c_q.m_storage;
    }
    throw std::invalid_argument("no such row of a chip");
  }
  std::span<std::uint32_t> wide() override { return top_->rootp->pixel_chip__DOT__elements__DOT__w_q.m_storage; }

  void set_compose(Compose mode) override { top_->compose_i = static_cast<std::uint8_t>(mode); }

  ChipCounters run(std::span<const pixelflow::Instruction> stream, const ChipSurroundings& around) override {
    const auto is_end = [](const pixelflow::Instruction& i) {
      return i.kind == pixelflow::Kind::Control && i.fn == static_cast<std::uint8_t>(pixelflow::Control::End);
    };
    if (stream.empty() || std::find_if(stream.begin(), stream.end(), is_end) != std::prev(stream.end())) {
      throw std::invalid_argument("a stream has one End, its last instruction");
    }
    words_.resize(stream.size());
    std::transform(stream.begin(), stream.end(), words_.begin(), pixelflow::pack);

    std::size_t next = 0;
    top_->stream_valid_i = 0;
    top_->start_i = 1;
    tick();
    top_->start_i = 0;
    const bool alone =
        !around.load && !around.upstream && !around.receiver_ready && !around.received && !around.executed;
    std::uint64_t idle = 0, clocks = 0;
    for (std::uint64_t cycle = 0; !top_->done_o || top_->sending_o || top_->valid_o; ++cycle) {
      top_->stream_valid_i = next < words_.size() && (!around.stream_offered || around.stream_offered());
      if (top_->stream_valid_i) {
        top_->stream_instruction_i = words_[next];
        next += top_->stream_ready_o;
      }
      const std::uint64_t before = top_->executed_o;
      clocks += !top_->done_o;
      bool moved = false;  // a packet came in or left
      if (alone) {
        moved = top_->valid_o && top_->ready_i;
        tick();
      } else {
        moved = tick_among(around, cycle);
      }
      idle = moved || top_->executed_o != before ? 0 : idle + 1;
      if (idle > kPatience) {
        throw std::runtime_error("the chip waits in vain: cycle " + std::to_string(cycle) + ", " +
                                 std::to_string(top_->instructions_o) + " instructions done");
      }
    }
    top_->stream_valid_i = 0;
    return {top_->executed_o,   top_->stream_waits_o, top_->inbound_waits_o,
            top_->send_waits_o, top_->instructions_o, clocks};
  }

 private:
  void settle() { top_->eval(); }
  void tick() {
    top_->clk_i = 0;
    top_->eval();
    if (trace_) trace_->dump(2 * time_);
    top_->clk_i = 1;
    top_->eval();
    if (trace_) trace_->dump(2 * time_ + 1);
    ++time_;
  }

  template <class Words>
  static void put(Words& words, const Packet& packet) {
    for (int w = 0; w < pixelflow::kPacketBytes / 4; ++w) {
      words[w] = 0;
      for (int b = 0; b < 4; ++b) words[w] |= static_cast<std::uint32_t>(packet[4 * w + b]) << (8 * b);
    }
  }

  /// A cycle with streams around: what is offered is set, then the answers are read before the clock edge. True where a
  /// packet came in or left.
  bool tick_among(const ChipSurroundings& around, std::uint64_t cycle) {
    const Packet* load = around.load ? around.load() : nullptr;
    const Packet* upstream = around.upstream ? around.upstream() : nullptr;
    if (load) put(top_->load_packet_i, *load);
    if (upstream) put(top_->upstream_packet_i, *upstream);
    top_->load_valid_i = load != nullptr;
    top_->upstream_valid_i = upstream != nullptr;
    top_->ready_i = !around.receiver_ready || around.receiver_ready();
    settle();
    const bool loaded = load && top_->load_ready_o;
    const bool taken = upstream && top_->upstream_ready_o;
    const bool sent = top_->valid_o && top_->ready_i;
    const bool executed = top_->trace_execute_o;
    const std::uint64_t word = top_->trace_instruction_o;
    const int digit = top_->trace_digit_o;
    Packet packet;
    for (int b = 0; b < pixelflow::kPacketBytes; ++b) {
      packet[b] = static_cast<std::uint8_t>(top_->packet_o[b / 4] >> (8 * (b % 4)));
    }
    tick();
    top_->load_valid_i = 0;
    top_->upstream_valid_i = 0;
    if (loaded && around.loaded) around.loaded();
    if (taken && around.upstream_taken) around.upstream_taken();
    if (sent && around.received) around.received(packet);
    if (executed && around.executed) around.executed(pixelflow::unpack(word), digit, cycle);
    return loaded || taken || sent;
  }

  template <class Rows>
  static std::span<std::uint8_t> indexed(Rows& rows, int index) {
    if (index < 0 || index >= static_cast<int>(std::size(rows.m_storage))) {
      throw std::invalid_argument("byte " + std::to_string(index) + " lies outside of the element's");
    }
    return rows.m_storage[index].m_storage;
  }

  VerilatedContext context_;
  std::unique_ptr<Top> top_;
  std::unique_ptr<VerilatedFstC> trace_;
  std::vector<std::uint64_t> words_;
  std::uint64_t time_ = 0;
  int lanes_ = 0;
  int multiplier_bits_;
};

}  // namespace tb
