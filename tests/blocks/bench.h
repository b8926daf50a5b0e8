// Clock and reset of a verilated bench, and its ports of several fields.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>

#include "tests/blocks/machine.h"
#include "tests/blocks/ports.h"

namespace blocks {

template <class Top>
class Bench {
 public:
  Bench() : top_(std::make_unique<Top>(&context_)) {
    top_->rst_ni = 0;
    tick();
    tick();
    top_->rst_ni = 1;
    top_->eval();
  }
  ~Bench() { top_->final(); }

  Top* operator->() { return top_.get(); }

  /// Outputs follow the inputs.
  void settle() { top_->eval(); }
  void tick() {
    top_->clk_i = 1;
    top_->eval();
    top_->clk_i = 0;
    top_->eval();
  }
  void start_frame() {
    top_->frame_start_i = 1;
    tick();
    top_->frame_start_i = 0;
    settle();
  }

 private:
  VerilatedContext context_;
  std::unique_ptr<Top> top_;
};

/// Cycles after which a block is said to hang.
constexpr int kMostCycles = 100000;

/// Field `i` of a port of 64-bit fields.
template <class Port>
std::int64_t field(const Port& port, int i) {
  return static_cast<std::int64_t>(std::uint64_t{port[2 * i]} | std::uint64_t{port[2 * i + 1]} << 32);
}
template <class Port>
void set_field(Port& port, int i, std::int64_t value) {
  port[2 * i] = static_cast<std::uint32_t>(value);
  port[2 * i + 1] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32);
}
template <std::size_t N, class Port>
std::array<std::int64_t, N> fields_of(const Port& port) {
  std::array<std::int64_t, N> values;
  for (std::size_t i = 0; i < N; ++i) values[i] = field(port, static_cast<int>(i));
  return values;
}
template <std::size_t N, class Port>
void set_fields(Port& port, const std::array<std::int64_t, N>& values) {
  for (std::size_t i = 0; i < N; ++i) set_field(port, static_cast<int>(i), values[i]);
}

template <class Port>
vsg::SamplePoint point_of(const Port& port) {
  return decode_point(fields_of<kPointFields>(port));
}
template <class Port>
void set_point(Port& port, const vsg::SamplePoint& point) {
  set_fields(port, encode(point));
}

/// What a block counts in this cycle.
template <class Port>
CountFields counts_of(const Port& port) {
  CountFields counts;
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = port[i];
  return counts;
}

/// The port of segment memory, answered from a machine's memory as rtl/vsg/segment_memory.sv answers: a word read is there
/// in the next cycle and stays until the next read.
class MemoryPort {
 public:
  /// In each cycle, when the outputs are settled.
  template <class Port>
  void take(const Port& request, Machine& machine) {
    const auto f = fields_of<kRequestFields>(request);
    if (f[0] == 0) return;
    const auto p = static_cast<vsg::SegmentPointer>(f[1]);
    const auto groups = static_cast<unsigned>(f[2]);
    if (groups == 0) {
      word_ = machine.memory.read(p);
    } else {
      machine.memory.write(p, groups, decode_word(f.data() + 3), machine.wiring.line);
    }
  }
  /// After the clock edge.
  template <class Port>
  void show(Port& word) const {
    set_fields(word, encode(word_));
  }

  /// Another user of the memory reads words of its own.
  void disturb() {
    word_.polygon = word_.polygon_next = word_.x_next = word_.active_next = 1;
    word_.left_lines = word_.right_lines = -1;
    word_.left.x = word_.left.dx = word_.right.x = word_.right.dx = -1;
  }

 private:
  vsg::SegmentBlock word_;
};

/// 32-bit ports of signed pixels.
inline std::int64_t pixel_of(std::uint32_t port) { return decode_pixel(port); }
inline std::uint32_t port(std::int64_t value) { return static_cast<std::uint32_t>(value); }

}  // namespace blocks
