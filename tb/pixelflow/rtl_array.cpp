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

  void cover(int elements) override {
    if (elements < 1 || elements > lanes_) {
      throw std::invalid_argument("1 to " + std::to_string(lanes_) + " elements of the array can work, not " +
                                  std::to_string(elements));
    }
    covered_ = elements;
    loaded_.clear();
    mode_ = Compose::Own;
  }
  int covered() const override { return covered_; }

  void write(int address, std::span<const std::uint8_t> bytes) override {
    check(bytes.size());
    for (std::size_t c = 0; c < working_chips(); ++c) {
      std::ranges::copy(part_of(bytes, c), chips_[c]->row(ChipRow::Memory, address).begin());
    }
  }
  void read(int address, std::span<std::uint8_t> bytes) const override {
    check(bytes.size());
    for (std::size_t c = 0; c < working_chips(); ++c) {
      const auto part = part_of(bytes, c);
      std::ranges::copy(chips_[c]->row(ChipRow::Memory, address).first(part.size()), part.begin());
    }
  }
  void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) override {
    check(columns.size());
    check(rows.size());
    for (int i = 0; i < covered_; ++i)
      chips_[i / pixelflow::kElements]->place(i % pixelflow::kElements, columns[i], rows[i]);
  }

  void places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const override {
    check(columns.size());
    check(rows.size());
    for (std::size_t c = 0; c < working_chips(); ++c) {
      const auto to_columns = part_of(columns, c), to_rows = part_of(rows, c);
      std::ranges::copy(chips_[c]->row(ChipRow::Column).first(to_columns.size()), to_columns.begin());
      std::ranges::copy(chips_[c]->row(ChipRow::Row).first(to_rows.size()), to_rows.begin());
    }
  }

  void run(const pixelflow::Program& program) override {
    stream_.assign(program.instructions.begin(), program.instructions.end());
    stream_.push_back({.kind = pixelflow::Kind::Control, .fn = static_cast<std::uint8_t>(Control::End)});
    const bool waits = count(Control::WaitInbound) > 0, sends = count(Control::Send) > 0;
    if (mode_ != Compose::Own && count(Control::Send) > 1) {
      throw std::invalid_argument("only one Send of a program can be composed");
    }
    const ChipCounters first = run_chip(0, waits, sends);
    for (std::size_t c = 1; c < working_chips(); ++c) {
      const ChipCounters other = run_chip(c, waits, sends);
      if (other.executed != first.executed || other.instructions != first.instructions) {
        throw std::logic_error("chip " + std::to_string(c) + " counts " + std::to_string(other.executed) +
                               " cycles, chip 0 " + std::to_string(first.executed));
      }
    }
    if (waits) loaded_.clear();
    if (sends) mode_ = Compose::Own;
    // The End that stops the chip is no part of the program.
    const std::uint64_t cycles = first.executed - 1;
    counters_.cycles += cycles;
    counters_.instructions += first.instructions - 1;
    counters_.element_cycles += cycles * static_cast<std::uint64_t>(lanes_);
    counters_.simulated_element_cycles += cycles * working_chips() * pixelflow::kElements;
  }

  void load(std::span<const std::uint8_t> packets) override {
    check_packets(packets.size());
    loaded_ = by_element(packets);
  }
  void compose(Compose closer_or_repeat, std::span<const std::uint8_t> upstream) override {
    if (closer_or_repeat != Compose::Closer && closer_or_repeat != Compose::Repeat) {
      throw std::invalid_argument("a program's packets are composed by Closer or Repeat");
    }
    check_packets(upstream.size());
    mode_ = closer_or_repeat;
    upstream_ = by_element(upstream);
  }
  void sent(std::span<std::uint8_t> packets) const override {
    check_packets(packets.size());
    for (std::size_t n = 0; n < static_cast<std::size_t>(covered_); ++n) {
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

  std::ptrdiff_t count(Control what) const {
    return std::ranges::count_if(stream_, [&](const pixelflow::Instruction& i) {
      return i.kind == pixelflow::Kind::Control && i.fn == static_cast<std::uint8_t>(what);
    });
  }

  std::size_t working_chips() const {
    return (static_cast<std::size_t>(covered_) + pixelflow::kElements - 1) / pixelflow::kElements;
  }
  /// What a chip has of a row of the covered elements.
  template <typename Byte>
  static std::span<Byte> part_of(std::span<Byte> row, std::size_t chip) {
    const std::size_t first = chip * pixelflow::kElements;
    return row.subspan(first, std::min<std::size_t>(pixelflow::kElements, row.size() - first));
  }
  /// A packet for each element that works, zeros where none is given.
  std::vector<Packet> by_element(std::span<const std::uint8_t> packets) const {
    std::vector<Packet> all(working_chips() * pixelflow::kElements);
    for (std::size_t n = 0; n < static_cast<std::size_t>(covered_); ++n) {
      std::ranges::copy(packets.subspan(n * pixelflow::kPacketBytes, pixelflow::kPacketBytes), all[n].begin());
    }
    return all;
  }

  /// Packets come in through the chip's load port while it waits for them, meet those from upstream in its composition
  /// port, and leave after a Send, an element a beat.
  ChipCounters run_chip(std::size_t chip, bool waits, bool sends) {
    ChipSurroundings around;
    const std::size_t first = chip * pixelflow::kElements;
    std::size_t next_in = 0, next_upstream = 0, next_out = 0;
    if (waits && !loaded_.empty()) {
      around.load = [&]() { return next_in < pixelflow::kElements ? &loaded_[first + next_in] : nullptr; };
      around.loaded = [&] { ++next_in; };
    }
    if (sends) {
      around.received = [&](const Packet& packet) { sent_[first + next_out++ % pixelflow::kElements] = packet; };
    }
    if (sends && mode_ != Compose::Own) {
      around.upstream = [&]() {
        return next_upstream < pixelflow::kElements ? &upstream_[first + next_upstream] : nullptr;
      };
      around.upstream_taken = [&] { ++next_upstream; };
    }
    chips_[chip]->set_compose(sends ? mode_ : Compose::Own);
    return chips_[chip]->run(stream_, around);
  }

  void check_packets(std::size_t size) const {
    const auto all = static_cast<std::size_t>(covered_) * pixelflow::kPacketBytes;
    if (size != all) {
      throw std::invalid_argument("the array's packets have " + std::to_string(all) + " bytes in all, not " +
                                  std::to_string(size));
    }
  }
  void check(std::size_t size) const {
    if (size != static_cast<std::size_t>(covered_)) {
      throw std::invalid_argument("a row of the array has " + std::to_string(covered_) + " bytes, not " +
                                  std::to_string(size));
    }
  }

  int lanes_, covered_ = lanes_;
  std::vector<std::unique_ptr<PixelChip>> chips_;
  std::vector<pixelflow::Instruction> stream_;
  std::vector<Packet> loaded_;   ///< by element; empty when nothing waits to be loaded
  std::vector<Packet> sent_;     ///< by element
  Compose mode_ = Compose::Own;  ///< of the next program with a Send
  std::vector<Packet> upstream_;
  pixelflow::ArrayCounters counters_;
};

}  // namespace

std::unique_ptr<pixelflow::PixelArray> make_rtl_array(int lanes) { return std::make_unique<RtlArray>(lanes); }

}  // namespace tb
