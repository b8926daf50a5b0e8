#include "tb/pixelflow/lockstep_array.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "cmodel/vsg/answer.h"
#include "tb/pixelflow/rtl_array.h"

namespace tb {
namespace {

using pixelflow::Instruction;
using pixelflow::Program;

/// The last step with such an instruction, in words.
std::string last_step(const Program& program, const std::function<bool(const Instruction&)>& does) {
  for (std::size_t n = program.steps.size(); n-- > 0;) {
    const pixelflow::Step& step = program.steps[n];
    const auto first = program.instructions.begin() + step.first;
    if (!std::any_of(first, first + step.count, does)) continue;
    return "step " + std::to_string(n) + " of " + std::to_string(program.steps.size()) + " (instructions " +
           std::to_string(step.first) + " to " + std::to_string(step.first + step.count - 1) + ")";
  }
  return "no step";
}

bool is_send(const Instruction& i) {
  return i.kind == pixelflow::Kind::Control && i.fn == static_cast<std::uint8_t>(pixelflow::Control::Send);
}

bool sets_enable(const Instruction& i) {
  return i.kind == pixelflow::Kind::Flag && i.dest == static_cast<std::uint8_t>(pixelflow::Flag::E);
}

}  // namespace

LockstepArray::LockstepArray(std::unique_ptr<pixelflow::PixelArray> rtl, std::unique_ptr<pixelflow::PixelArray> golden,
                             std::string replay)
    : rtl_(std::move(rtl)), golden_(std::move(golden)), replay_(std::move(replay)) {
  if (rtl_->lanes() != golden_->lanes()) throw std::invalid_argument("arrays in lock-step have the same elements");
}

void LockstepArray::cover(int elements) {
  rtl_->cover(elements);
  golden_->cover(elements);
}

void LockstepArray::write(int address, std::span<const std::uint8_t> bytes) {
  rtl_->write(address, bytes);
  golden_->write(address, bytes);
}

void LockstepArray::place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) {
  rtl_->place(columns, rows);
  golden_->place(columns, rows);
}

void LockstepArray::load(std::span<const std::uint8_t> packets) {
  rtl_->load(packets);
  golden_->load(packets);
}

void LockstepArray::compose(pixelflow::Compose closer_or_repeat, std::span<const std::uint8_t> upstream) {
  rtl_->compose(closer_or_repeat, upstream);
  golden_->compose(closer_or_repeat, upstream);
}

void LockstepArray::run(const Program& program) {
  golden_->run(program);
  rtl_->run(program);
  compare_memory(program);
  compare_enable(program);
  compare_packets(program);
  compare_cycles();
  ++programs_;
}

void LockstepArray::compare_memory(const Program& program) {
  std::vector<std::uint8_t> golden(static_cast<std::size_t>(covered())), rtl(golden.size());
  for (int address = 0; address < pixelflow::kMemoryBytes; ++address) {
    golden_->read(address, golden);
    rtl_->read(address, rtl);
    if (golden == rtl) continue;
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(golden, rtl).in1 - golden.begin());
    const auto writes = [&](const Instruction& i) { return writes_memory(i) && i.addr == address; };
    differ("byte " + std::to_string(address) + " of memory", last_step(program, writes), static_cast<int>(at),
           golden[at], rtl[at]);
  }
  bytes_ += golden.size() * pixelflow::kMemoryBytes;
}

void LockstepArray::compare_enable(const Program& program) const {
  for (int lane = 0; lane < covered(); ++lane) {
    const bool golden = golden_->registers(lane).e, rtl = rtl_->registers(lane).e;
    if (golden != rtl) differ("the enable flag", last_step(program, sets_enable), lane, golden, rtl);
  }
}

void LockstepArray::compare_packets(const Program& program) {
  if (std::none_of(program.instructions.begin(), program.instructions.end(), is_send)) return;
  std::vector<std::uint8_t> golden(static_cast<std::size_t>(covered()) * pixelflow::kPacketBytes), rtl(golden.size());
  golden_->sent(golden);
  rtl_->sent(rtl);
  const auto [at, other] = std::ranges::mismatch(golden, rtl);
  if (at != golden.end()) {
    const auto n = static_cast<int>(at - golden.begin());
    differ("byte " + std::to_string(n % pixelflow::kPacketBytes) + " of the packet sent", last_step(program, is_send),
           n / pixelflow::kPacketBytes, *at, *other);
  }
  bytes_ += golden.size();
}

void LockstepArray::compare_cycles() const {
  const pixelflow::ArrayCounters golden = golden_->counters(), rtl = rtl_->counters();
  if (golden.cycles == rtl.cycles && golden.instructions == rtl.instructions) return;
  differ("counted so far: golden " + std::to_string(golden.cycles) + " cycles, " + std::to_string(golden.instructions) +
         " instructions; RTL " + std::to_string(rtl.cycles) + " cycles, " + std::to_string(rtl.instructions) +
         " instructions");
}

void LockstepArray::differ(const std::string& what, const std::string& step, int element, int golden, int rtl) const {
  std::vector<std::uint8_t> columns(static_cast<std::size_t>(covered())), rows(columns.size());
  golden_->places(columns, rows);
  const auto n = static_cast<std::size_t>(element);
  differ("element " + std::to_string(element) + " (column " + std::to_string(columns[n]) + ", row " +
         std::to_string(rows[n]) + "), " + what + ", last set by " + step + ": golden " + std::to_string(golden) +
         ", RTL " + std::to_string(rtl));
}

void LockstepArray::differ(const std::string& text) const {
  throw vsg::LockstepError("pixel processors, program " + std::to_string(programs_) + ": " + text +
                           (replay_.empty() ? "" : "\n  replay: " + replay_));
}

std::unique_ptr<pixelflow::PixelArray> make_lockstep_array(int lanes, std::string replay) {
  return std::make_unique<LockstepArray>(
      make_rtl_array(lanes), pixelflow::make_golden_array(pixelflow::Level::Model, lanes), std::move(replay));
}

}  // namespace tb
