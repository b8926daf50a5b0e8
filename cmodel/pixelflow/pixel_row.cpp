#include "cmodel/pixelflow/pixel_row.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cmodel/pixelflow/pixel_row_alu.h"
#include "cmodel/pixelflow/pixel_row_state.h"
#include "cmodel/pixelflow/row_vectors.h"

namespace pixelflow {

using namespace vectors;

PixelRow::PixelRow(int lanes) : made_lanes_(lanes), lanes_(lanes), vectors_((lanes + kWidth - 1) / kWidth) {
  if (lanes < 1 || lanes > kLanes) {
    throw std::invalid_argument("a tile has 1 to " + std::to_string(kLanes) + " elements, not " +
                                std::to_string(lanes));
  }
  state_ = std::make_unique<State>();
}

PixelRow::PixelRow(PixelRow&&) noexcept = default;
PixelRow& PixelRow::operator=(PixelRow&&) noexcept = default;
PixelRow::~PixelRow() = default;

void PixelRow::resize(int lanes) {
  if (lanes < 1 || lanes > made_lanes_ || (lanes != made_lanes_ && lanes % kGroup != 0)) {
    throw std::invalid_argument("a tile of " + std::to_string(made_lanes_) + " elements cannot have " +
                                std::to_string(lanes));
  }
  // W's rows back to where they were at first: those who rest have not turned with the others.
  State& t = *state_;
  for (int at = 0; at < padded_lanes() && wide_first_ != 0; at += kWidth) {
    Bytes bytes[4];
    for (int n = 0; n < 4; ++n) bytes[n] = load(wide(n) + at);
    for (int n = 0; n < 4; ++n) store(t.w[n] + at, bytes[n]);
  }
  wide_first_ = 0;
  lanes_ = lanes;
  vectors_ = (lanes + kWidth - 1) / kWidth;
  enable_changed();
}

int PixelRow::padded_lanes() const { return vectors_ * kWidth; }
std::uint8_t* PixelRow::memory(int address) { return state_->memory[address]; }
const std::uint8_t* PixelRow::memory(int address) const { return state_->memory[address]; }
std::uint8_t* PixelRow::inbound(int index) { return state_->inbound[index]; }
std::uint8_t* PixelRow::outbound(int index) { return state_->outbound[index]; }
const std::uint8_t* PixelRow::outbound(int index) const { return state_->outbound[index]; }
std::uint8_t* PixelRow::columns() { return state_->column; }
const std::uint8_t* PixelRow::columns() const { return state_->column; }
std::uint8_t* PixelRow::rows() { return state_->row; }
const std::uint8_t* PixelRow::rows() const { return state_->row; }
const std::uint8_t* PixelRow::enable() const { return state_->e; }
std::uint8_t* PixelRow::condition() { return state_->k; }
std::uint8_t* PixelRow::wide(int byte) const { return state_->w[(wide_first_ + byte) & 3]; }

const PixelRow::EnabledGroups& PixelRow::enabled_groups() const {
  static_assert(kGroup == kWidth);
  if (enabled_known_) return enabled_;
  enabled_ = {0, 0};
  for (int first = 0, group = 0; first < lanes_; first += kGroup, ++group) {
    const std::uint8_t* const e = state_->e + first;
    const auto size = static_cast<std::size_t>(std::min(kGroup, lanes_ - first));
    if (std::memchr(e, 0xFF, size) != nullptr) enabled_.any |= 1u << group;
    if (std::memchr(e, 0x00, size) == nullptr) enabled_.all |= 1u << group;
  }
  enabled_known_ = true;
  return enabled_;
}

Registers PixelRow::registers(int lane) const {
  const State& t = *state_;
  Registers r{t.e[lane] != 0, t.k[lane] != 0, t.s[lane] != 0, t.z[lane] != 0, t.c[lane] != 0, t.m[lane], t.x[lane], 0};
  for (int byte = 0; byte < 4; ++byte) r.w |= static_cast<std::uint32_t>(wide(byte)[lane]) << (8 * byte);
  return r;
}

void PixelRow::set_registers(int lane, const Registers& r) {
  State& t = *state_;
  enable_changed();
  const auto mask = [](bool flag) { return static_cast<std::uint8_t>(flag ? 0xFF : 0); };
  t.e[lane] = mask(r.e), t.k[lane] = mask(r.k), t.s[lane] = mask(r.s), t.z[lane] = mask(r.z), t.c[lane] = mask(r.c);
  t.m[lane] = r.m, t.x[lane] = r.x;
  for (int byte = 0; byte < 4; ++byte) wide(byte)[lane] = static_cast<std::uint8_t>(r.w >> (8 * byte));
}

PixelRow::Source PixelRow::p_source(const Instruction& i) const {
  switch (static_cast<P>(i.p)) {
    case P::M: return {state_->m, kWidth};
    case P::X: return {state_->x, kWidth};
    case P::W: return {wide(i.at), kWidth};
    case P::Immediate: return {state_->immediate, 0};
    default: return {kZeros, 0};
  }
}

// The operands that several registers make up are put together in the scratch row.
PixelRow::Source PixelRow::q_source(const Instruction& i) const {
  State& t = *state_;
  const Source memory = reads_memory(i) && i.addr < kMemoryBytes ? Source{t.memory[i.addr], kWidth} : Source{kZeros, 0};
  const auto made = [&](auto&& vector) {
    for (int at = 0; at < padded_lanes(); at += kWidth) store(t.scratch + at, vector(at));
    return Source{t.scratch, kWidth};
  };
  switch (static_cast<Q>(i.q)) {
    case Q::Memory: return memory;
    case Q::Immediate: return {t.immediate, 0};
    case Q::M: return {t.m, kWidth};
    case Q::MemoryOrM:
      return made(
          [&](int at) { return select(load(t.k + at), load(t.m + at), load(memory.row + (memory.stride ? at : 0))); });
    case Q::ExponentLow: return made([&](int at) { return shift_left(load(t.x + at), 7); });
    case Q::ExponentHigh:
      return made([&](int at) { return shift_right(load(t.x + at), 1) | (load(t.s + at) & std::uint8_t{0x80}); });
    case Q::Port:
      if (i.imm < kPacketBytes) return {t.inbound[i.imm], kWidth};
      if (i.imm == kPortX) return {t.column, kWidth};
      if (i.imm == kPortY) return {t.row, kWidth};
      return {kZeros, 0};
    case Q::Flags:
      return made([&](int at) {
        return (load(t.e + at) & std::uint8_t{16}) | (load(t.k + at) & std::uint8_t{8}) |
               (load(t.s + at) & std::uint8_t{4}) | (load(t.z + at) & std::uint8_t{2}) |
               (load(t.c + at) & std::uint8_t{1});
      });
  }
  return {kZeros, 0};
}

void PixelRow::step(const Instruction& instruction) {
  std::memset(state_->immediate, instruction.imm, kWidth);
  switch (instruction.kind) {
    case Kind::Alu: step_alu(instruction); break;
    case Kind::Wide: step_wide(instruction); break;
    case Kind::Flag: step_flag(instruction); break;
    case Kind::Control: break;
  }
}

void PixelRow::run(std::span<const Instruction> instructions) {
  for (const Instruction& instruction : instructions) step(instruction);
}

void PixelRow::move_down() {
  const std::uint8_t* const top = wide(3);
  std::uint8_t* const next = wide(0);  // becomes the top byte
  for (int at = 0; at < padded_lanes(); at += kWidth) store(next + at, top_bit(load(top + at)));
  wide_first_ = (wide_first_ + 1) & 3;
}

void PixelRow::step_alu(const Instruction& i) {
  State& t = *state_;
  const Source p = p_source(i), q = q_source(i);
  AluRows a{.vectors = vectors_, .p = p.row, .p_stride = p.stride, .q = q.row, .q_stride = q.stride};
  a.k = t.k;
  switch (static_cast<Carry>(i.cin)) {
    case Carry::Zero: a.cin = kZeros, a.cin_stride = 0; break;
    case Carry::One: a.cin = kOnes, a.cin_stride = 0; break;
    case Carry::C: a.cin = t.c, a.cin_stride = kWidth; break;
    case Carry::K: a.cin = t.k, a.cin_stride = kWidth; break;
  }

  const To to = static_cast<To>(i.dest);
  alignas(kWidth) std::uint8_t nowhere[kWidth];
  const auto result_to = [&](std::uint8_t* row) { a.result = row, a.result_stride = kWidth; };
  a.result = nowhere, a.result_stride = 0;
  if (to == To::M) result_to(t.m);
  if (to == To::X) result_to(t.x);
  if (to == To::W) result_to(i.down ? t.scratch : wide(i.at));
  if (to == To::Memory && i.addr < kMemoryBytes) result_to(t.memory[i.addr]);
  if (to == To::Port && i.addr < kPacketBytes) result_to(t.outbound[i.addr]);
  a.e = t.e;
  a.gate = to == To::Memory || to == To::Port ? static_cast<Gate>(i.gate) : Gate::None;

  const ZMode z = static_cast<ZMode>(i.z);
  const bool set_z = z == ZMode::Set || z == ZMode::And;
  a.set_c = i.set_c;
  a.set_zs = set_z || i.set_s;
  a.c_out = i.set_c ? t.c : nowhere, a.c_stride = i.set_c ? kWidth : 0;
  a.s_out = i.set_s ? t.s : nowhere, a.s_stride = i.set_s ? kWidth : 0;
  a.z_out = set_z ? t.z : nowhere, a.z_stride = set_z ? kWidth : 0;
  a.z_in = z == ZMode::And ? t.z : kOnes, a.z_in_stride = z == ZMode::And ? kWidth : 0;
  run_alu(i.fn, a);

  if (i.down) {
    move_down();
    if (to == To::W) std::memcpy(wide(i.at), t.scratch, static_cast<std::size_t>(padded_lanes()));
  }
}

void PixelRow::step_flag(const Instruction& i) {
  if (i.dest >= 5) return;
  State& t = *state_;
  std::uint8_t* const flags[] = {t.c, t.z, t.s, t.k, t.e};
  std::uint8_t* const flag = flags[i.dest];
  if (flag == t.e) enable_changed();
  const Bytes invert = fill<Bytes>(i.set_c ? 0xFF : 0);
  const auto put = [&](auto&& source) {
    const auto all = [&](auto&& combine) {
      for (int v = 0; v < vectors_; ++v) {
        std::uint8_t* const to = flag + v * kWidth;
        store(to, combine(load(to), source(v) ^ invert));
      }
    };
    switch (static_cast<FlagOp>(i.cin)) {
      case FlagOp::Move: all([](Bytes, Bytes bit) { return bit; }); break;
      case FlagOp::And: all([](Bytes old, Bytes bit) { return old & bit; }); break;
      case FlagOp::Or: all([](Bytes old, Bytes bit) { return old | bit; }); break;
      case FlagOp::Xor: all([](Bytes old, Bytes bit) { return old ^ bit; }); break;
    }
  };
  const auto put_row = [&](Source row) { put([row](int v) { return load(row.row + v * row.stride); }); };
  const auto put_bit = [&](Source row) {
    const Bytes bit = fill<Bytes>(1 << (i.imm & 7));
    put([row, bit](int v) { return ~is_zero(load(row.row + v * row.stride) & bit); });
  };
  switch (static_cast<Bit>(i.fn)) {
    case Bit::One: put_row({kOnes, 0}); break;
    case Bit::C: put_row({t.c, kWidth}); break;
    case Bit::Z: put_row({t.z, kWidth}); break;
    case Bit::S: put_row({t.s, kWidth}); break;
    case Bit::K: put_row({t.k, kWidth}); break;
    case Bit::E: put_row({t.e, kWidth}); break;
    case Bit::OfP: put_bit(p_source(i)); break;
    case Bit::OfQ: put_bit(q_source(i)); break;
    case Bit::WideZero:
      put([&t](int v) {
        const int at = v * kWidth;
        return is_zero(load(t.w[0] + at) | load(t.w[1] + at) | load(t.w[2] + at) | load(t.w[3] + at));
      });
      break;
    default: put_row({kZeros, 0}); break;
  }
}

}  // namespace pixelflow
