#include "tb/pixelflow/rtl_array.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/pixelflow/pixel_chip.h"

namespace tb {
namespace {

class RtlArray final : public pixelflow::PixelArray {
 public:
  explicit RtlArray(int lanes) : lanes_(lanes), sent_(static_cast<std::size_t>(std::max(lanes, 0))) {
    constexpr int kMost = pixelflow::kRegionWidth * pixelflow::kRegionHeight;
    if (lanes <= 0 || lanes > kMost || lanes % pixelflow::kElements != 0) {
      throw std::invalid_argument("the array has whole chips of " + std::to_string(pixelflow::kElements) +
                                  " elements, up to " + std::to_string(kMost) + ", not " + std::to_string(lanes));
    }
    for (int chip = 0; chip < lanes / pixelflow::kElements; ++chip) {
      chips_.push_back(make_pixel_chip());
      chips_.back()->reset(chip);
    }
  }

  int lanes() const override { return lanes_; }

  void write(int address, std::span<const std::uint8_t> bytes) override {
    check(bytes.size());
    for (std::size_t c = 0; c < chips_.size(); ++c) {
      std::ranges::copy(bytes.subspan(c * pixelflow::kElements, pixelflow::kElements),
                        chips_[c]->row(ChipRow::Memory, address).begin());
    }
  }
  void read(int address, std::span<std::uint8_t> bytes) const override {
    check(bytes.size());
    for (std::size_t c = 0; c < chips_.size(); ++c) {
      std::ranges::copy(chips_[c]->row(ChipRow::Memory, address), bytes.begin() + c * pixelflow::kElements);
    }
  }
  void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) override {
    check(columns.size());
    check(rows.size());
    for (int i = 0; i < lanes_; ++i)
      chips_[i / pixelflow::kElements]->place(i % pixelflow::kElements, columns[i], rows[i]);
  }

  void run(const pixelflow::Program& program) override {
    stream_.assign(program.instructions.begin(), program.instructions.end());
    stream_.push_back({.kind = pixelflow::Kind::Control, .fn = static_cast<std::uint8_t>(pixelflow::Control::End)});
    const bool waits = has(Control::WaitInbound), sends = has(Control::Send);
    const ChipCounters first = run_chip(0, waits, sends);
    for (std::size_t c = 1; c < chips_.size(); ++c) {
      const ChipCounters other = run_chip(c, waits, sends);
      if (other.executed != first.executed || other.instructions != first.instructions) {
        throw std::logic_error("chip " + std::to_string(c) + " counts " + std::to_string(other.executed) +
                               " cycles, chip 0 " + std::to_string(first.executed));
      }
    }
    if (waits) loaded_.clear();
    // The End that stops the chip is no part of the program.
    counters_.cycles += first.executed - 1;
    counters_.instructions += first.instructions - 1;
    counters_.element_cycles = counters_.simulated_element_cycles =
        counters_.cycles * static_cast<std::uint64_t>(lanes_);
  }

  void load(std::span<const std::uint8_t> packets) override {
    check_packets(packets.size());
    loaded_.resize(static_cast<std::size_t>(lanes_));
    for (std::size_t n = 0; n < loaded_.size(); ++n) {
      std::ranges::copy(packets.subspan(n * pixelflow::kPacketBytes, pixelflow::kPacketBytes), loaded_[n].begin());
    }
  }
  void sent(std::span<std::uint8_t> packets) const override {
    check_packets(packets.size());
    for (std::size_t n = 0; n < sent_.size(); ++n) {
      std::ranges::copy(sent_[n], packets.begin() + n * pixelflow::kPacketBytes);
    }
  }

  pixelflow::Registers registers(int lane) const override {
    if (lane < 0 || lane >= lanes_) throw std::invalid_argument("the array has no element " + std::to_string(lane));
    PixelChip& chip = *chips_[lane / pixelflow::kElements];
    const int i = lane % pixelflow::kElements;
    const auto flag = [&](ChipRow row) { return chip.row(row)[i] != 0; };
    return {flag(ChipRow::E), flag(ChipRow::K),        flag(ChipRow::S),        flag(ChipRow::Z),
            flag(ChipRow::C), chip.row(ChipRow::M)[i], chip.row(ChipRow::X)[i], chip.wide()[i]};
  }

  pixelflow::ArrayCounters counters() const override { return counters_; }

 private:
  using Control = pixelflow::Control;

  bool has(Control what) const {
    return std::ranges::any_of(stream_, [&](const pixelflow::Instruction& i) {
      return i.kind == pixelflow::Kind::Control && i.fn == static_cast<std::uint8_t>(what);
    });
  }

  /// Packets come in through the chip's load port while it waits for them, and leave after a Send, an element a beat.
  ChipCounters run_chip(std::size_t chip, bool waits, bool sends) {
    ChipSurroundings around;
    const std::size_t first = chip * pixelflow::kElements;
    std::size_t next_in = 0, next_out = 0;
    if (waits && !loaded_.empty()) {
      around.load = [&]() { return next_in < pixelflow::kElements ? &loaded_[first + next_in] : nullptr; };
      around.loaded = [&] { ++next_in; };
    }
    if (sends) {
      around.received = [&](const Packet& packet) { sent_[first + next_out++ % pixelflow::kElements] = packet; };
    }
    return chips_[chip]->run(stream_, around);
  }

  void check_packets(std::size_t size) const {
    const auto all = static_cast<std::size_t>(lanes_) * pixelflow::kPacketBytes;
    if (size != all) {
      throw std::invalid_argument("the array's packets have " + std::to_string(all) + " bytes in all, not " +
                                  std::to_string(size));
    }
  }
  void check(std::size_t size) const {
    if (size != static_cast<std::size_t>(lanes_)) {
      throw std::invalid_argument("a row of the array has " + std::to_string(lanes_) + " bytes, not " +
                                  std::to_string(size));
    }
  }

  int lanes_;
  std::vector<std::unique_ptr<PixelChip>> chips_;
  std::vector<pixelflow::Instruction> stream_;
  std::vector<Packet> loaded_;  ///< by element; empty when nothing waits to be loaded
  std::vector<Packet> sent_;    ///< by element
  pixelflow::ArrayCounters counters_;
};

}  // namespace

std::unique_ptr<pixelflow::PixelArray> make_rtl_array(int lanes) { return std::make_unique<RtlArray>(lanes); }

}  // namespace tb
