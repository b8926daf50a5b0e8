// Two arrays of pixel processors that do everything together: the verilated chips and the golden model.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"

namespace tb {

/// Compares after every program, in the elements that work: memory, E, what was sent, and the counted cycles. What it
/// gives is the first array's.
class LockstepArray final : public pixelflow::PixelArray {
 public:
  /// Throws std::invalid_argument for arrays of different sizes. `replay`: the command line that repeats the run.
  LockstepArray(std::unique_ptr<pixelflow::PixelArray> rtl, std::unique_ptr<pixelflow::PixelArray> golden,
                std::string replay);

  int lanes() const override { return rtl_->lanes(); }
  void cover(int elements) override;
  int covered() const override { return rtl_->covered(); }
  void write(int address, std::span<const std::uint8_t> bytes) override;
  void read(int address, std::span<std::uint8_t> bytes) const override { rtl_->read(address, bytes); }
  void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) override;
  void places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const override {
    rtl_->places(columns, rows);
  }
  /// Throws vsg::LockstepError for the first difference found: which step wrote last what differs, element, address,
  /// both values, and the replay.
  void run(const pixelflow::Program& program) override;
  void load(std::span<const std::uint8_t> packets) override;
  void compose(pixelflow::Compose closer_or_repeat, std::span<const std::uint8_t> upstream) override;
  void sent(std::span<std::uint8_t> packets) const override { rtl_->sent(packets); }
  pixelflow::Registers registers(int lane) const override { return rtl_->registers(lane); }
  pixelflow::ArrayCounters counters() const override { return rtl_->counters(); }

  /// What was found equal so far.
  std::uint64_t matched_programs() const { return programs_; }
  std::uint64_t matched_bytes() const { return bytes_; }  ///< of memory and packets

 private:
  void compare_cycles() const;
  void compare_memory(const pixelflow::Program& program);
  void compare_enable(const pixelflow::Program& program) const;
  void compare_packets(const pixelflow::Program& program);
  [[noreturn]] void differ(const std::string& what, const std::string& step, int element, int golden, int rtl) const;
  [[noreturn]] void differ(const std::string& text) const;

  std::unique_ptr<pixelflow::PixelArray> rtl_, golden_;
  std::string replay_;
  std::uint64_t programs_ = 0, bytes_ = 0;
};

/// The verilated chips, and the golden model of every instruction. `lanes` as for make_rtl_array().
std::unique_ptr<pixelflow::PixelArray> make_lockstep_array(int lanes, std::string replay);

}  // namespace tb
