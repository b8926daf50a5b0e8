#include "tests/pixelflow_rtl/chip_lockstep.h"

#include <algorithm>
#include <bit>
#include <deque>

#include "tests/pixelflow_rtl/instruction_text.h"
#include "tests/pixelflow_rtl/random_streams.h"

namespace pixelflow_tests {

using pixelflow::Control;
using pixelflow::Instruction;
using pixelflow::Kind;
using tb::ChipRow;
using tb::Compose;
using tb::Packet;

namespace {

std::uint32_t depth(const Packet& packet) {
  std::uint32_t value = 0;
  for (int b = pixelflow::kDepthBytes; b-- > 0;) value = value << 8 | packet[b];
  return value;
}

bool is(const Instruction& i, Control what) {
  return i.kind == Kind::Control && i.fn == static_cast<std::uint8_t>(what);
}

std::string values(unsigned rtl, unsigned model) {
  return ": RTL " + std::to_string(rtl) + ", model " + std::to_string(model);
}

}  // namespace

/// Packets that come to the chip, and those that must leave it.
class ChipLockstep::Ports {
 public:
  Ports(ChipLockstep& lockstep, std::uint64_t seed) : lockstep_(lockstep), random_(seed) {
    mode_ = static_cast<Compose>(random_() % 3 == 0 ? 0 : 1);
    patience_ = 1 + random_() % 4;
    lockstep_.chip_.set_compose(mode_);
  }

  tb::ChipSurroundings surroundings() {
    tb::ChipSurroundings around;
    around.stream_offered = [this] { return chance(); };
    around.load = [this]() -> const Packet* {
      if (!offered_load_ && chance()) offered_load_ = random_packet();
      return offered_load_ ? &*offered_load_ : nullptr;
    };
    around.loaded = [this] {
      loaded_.push_back(*offered_load_);
      offered_load_.reset();
    };
    around.upstream = [this]() -> const Packet* {
      if (!offered_upstream_ && chance()) offered_upstream_ = near_packet();
      return offered_upstream_ ? &*offered_upstream_ : nullptr;
    };
    around.upstream_taken = [this] {
      upstream_.push_back(*offered_upstream_);
      offered_upstream_.reset();
    };
    around.receiver_ready = [this] { return chance(); };
    around.received = [this](const Packet& packet) { receive(packet); };
    return around;
  }

  /// The program goes on after WaitInbound: all packets have come.
  void arrive() {
    const int lanes = lockstep_.golden_.lanes();
    if (static_cast<int>(loaded_.size()) < lanes) {
      throw Mismatch(lockstep_.place() + ": goes on after " + std::to_string(loaded_.size()) + " inbound packets of " +
                     std::to_string(lanes));
    }
    for (int lane = 0; lane < lanes; ++lane) {
      for (int b = 0; b < pixelflow::kPacketBytes; ++b) lockstep_.golden_.inbound(b)[lane] = loaded_.front()[b];
      loaded_.pop_front();
    }
  }

  void send() {
    for (int lane = 0; lane < lockstep_.golden_.lanes(); ++lane) {
      Packet packet;
      for (int b = 0; b < pixelflow::kPacketBytes; ++b) packet[b] = lockstep_.golden_.outbound(b)[lane];
      own_.push_back(packet);
    }
  }

  /// Everything that was to leave has left, and nothing else.
  void finish() const {
    if (!own_.empty()) throw Mismatch(std::to_string(own_.size()) + " packets were not sent");
    if (!upstream_.empty()) throw Mismatch(std::to_string(upstream_.size()) + " packets from upstream were lost");
  }

 private:
  bool chance() { return random_() % patience_ == 0; }
  Packet random_packet() {
    Packet packet;
    for (std::uint8_t& b : packet) b = static_cast<std::uint8_t>(random_());
    return packet;
  }
  /// Often of nearly the depth, or the same depth, of the own packet that it meets.
  Packet near_packet() {
    Packet packet = random_packet();
    if (upstream_.size() < own_.size() && random_() % 4 != 0) {
      const Packet& own = own_[upstream_.size()];
      std::copy_n(own.begin(), pixelflow::kDepthBytes, packet.begin());
      if (random_() % 2 == 0)
        packet[random_() % pixelflow::kDepthBytes] ^= static_cast<std::uint8_t>(1u << random_() % 8);
    }
    return packet;
  }

  void receive(const Packet& packet) {
    if (own_.empty()) throw Mismatch(lockstep_.place() + ": a packet that was not sent");
    Packet expected = own_.front();
    own_.pop_front();
    if (mode_ == Compose::Closer) {
      if (upstream_.empty()) throw Mismatch(lockstep_.place() + ": a packet that did not wait for upstream");
      if (depth(upstream_.front()) <= depth(expected)) expected = upstream_.front();
      upstream_.pop_front();
    }
    for (int b = 0; b < pixelflow::kPacketBytes; ++b) {
      if (packet[b] != expected[b]) {
        throw Mismatch(lockstep_.place() + ": packet " + std::to_string(lockstep_.packets_) +
                       " of the composition port, byte " + std::to_string(b) + values(packet[b], expected[b]));
      }
    }
    ++lockstep_.packets_;
  }

  ChipLockstep& lockstep_;
  std::mt19937_64 random_;
  Compose mode_;
  std::uint64_t patience_;
  std::optional<Packet> offered_load_, offered_upstream_;
  std::deque<Packet> loaded_, upstream_, own_;
};

ChipLockstep::ChipLockstep(tb::PixelChip& chip) : chip_(chip), golden_(chip.lanes()) {}

void ChipLockstep::randomise(std::mt19937_64& random) {
  const auto fill = [&](std::uint8_t* golden, ChipRow row, int index, std::uint8_t mask = 0xFF) {
    std::uint8_t* const rtl = chip_.row(row, index).data();
    for (int lane = 0; lane < chip_.lanes(); lane += 8) {
      const std::uint64_t bytes = random();
      for (int b = 0; b < 8; ++b) golden[lane + b] = rtl[lane + b] = static_cast<std::uint8_t>(bytes >> (8 * b)) & mask;
    }
  };
  for (int a = 0; a < pixelflow::kMemoryBytes; ++a) fill(golden_.memory(a), ChipRow::Memory, a);
  for (int b = 0; b < pixelflow::kPacketBytes; ++b) {
    fill(golden_.inbound(b), ChipRow::Inbound, b);
    fill(golden_.outbound(b), ChipRow::Outbound, b);
  }
  fill(golden_.columns(), ChipRow::Column, 0);
  fill(golden_.rows(), ChipRow::Row, 0);
  for (int lane = 0; lane < chip_.lanes(); ++lane) {
    const std::uint64_t bits = random(), more = random();
    pixelflow::Registers r{(bits & 1) != 0,
                           (bits & 2) != 0,
                           (bits & 4) != 0,
                           (bits & 8) != 0,
                           (bits & 16) != 0,
                           static_cast<std::uint8_t>(bits >> 8),
                           static_cast<std::uint8_t>(bits >> 16),
                           static_cast<std::uint32_t>(more)};
    if ((bits >> 32 & 3) == 0) r.w >>= more >> 32 & 31;  // leading zeros, for the normalising shift
    if ((bits >> 34 & 3) == 0) r.x &= 15;
    golden_.set_registers(lane, r);
    chip_.row(ChipRow::E)[lane] = r.e;
    chip_.row(ChipRow::K)[lane] = r.k;
    chip_.row(ChipRow::S)[lane] = r.s;
    chip_.row(ChipRow::Z)[lane] = r.z;
    chip_.row(ChipRow::C)[lane] = r.c;
    chip_.row(ChipRow::M)[lane] = r.m;
    chip_.row(ChipRow::X)[lane] = r.x;
    chip_.wide()[lane] = r.w;
  }
}

void ChipLockstep::run(std::uint64_t seed, const LockstepOptions& options) {
  std::mt19937_64 random(seed);
  stream_ = random_stream(random, options.length, options.ports);
  chip_.reset();
  chip_.set_compose(Compose::Own);
  randomise(random);

  at_ = 0;
  pending_ = pixelflow::digits(stream_[0], chip_.multiplier_bits());
  cycle_ = 0;
  std::optional<Ports> ports;
  tb::ChipSurroundings around;
  if (options.ports) {
    ports.emplace(*this, random());
    around = ports->surroundings();
  }
  if (options.every || options.ports) {
    around.executed = [&](const Instruction& i, int digit, std::uint64_t cycle) {
      after_cycle(i, digit, cycle, options.every, ports ? &*ports : nullptr);
    };
  }
  const tb::ChipCounters counters = chip_.run(stream_, around);
  if (options.every || options.ports) {
    if (at_ != stream_.size()) throw Mismatch("the chip is done after " + place());
  } else {
    golden_.run(stream_);
  }
  const std::string end = "after the last instruction, " + std::to_string(stream_.size());
  compare_registers(end);
  compare_rows(end);
  if (ports) ports->finish();

  std::uint64_t expected = 0;
  for (const Instruction& i : stream_) expected += pixelflow::cycles(i, chip_.multiplier_bits());
  const auto count = [&end](const char* name, std::uint64_t rtl, std::uint64_t model) {
    if (rtl != model)
      throw Mismatch(end + ", counter " + name + ": RTL " + std::to_string(rtl) + ", model " + std::to_string(model));
  };
  count("executed", counters.executed, expected);
  count("instructions", counters.instructions, stream_.size());
  count("clocks", counters.executed + counters.stream_waits + counters.inbound_waits + counters.send_waits,
        counters.clocks);
  instructions_ += stream_.size();
  cycles_ += expected;
}

std::string ChipLockstep::place() const {
  if (at_ >= stream_.size()) return "cycle " + std::to_string(cycle_) + ", past the last instruction";
  return "cycle " + std::to_string(cycle_) + ", instruction " + std::to_string(at_) + " (" + text(stream_[at_]) + ")";
}

void ChipLockstep::after_cycle(const Instruction& instruction, int digit, std::uint64_t cycle, bool compare,
                               Ports* ports) {
  cycle_ = cycle;
  if (at_ == stream_.size()) throw Mismatch(place() + ": the chip executes " + text(instruction));
  if (!(instruction == stream_[at_])) throw Mismatch(place() + ": the chip executes " + text(instruction));
  const bool multiplies =
      instruction.kind == Kind::Wide && instruction.fn == static_cast<std::uint8_t>(pixelflow::Wide::Multiply);
  if (multiplies) {
    const int expected = std::countr_zero(pending_);
    if (digit != expected)
      throw Mismatch(place() + ", digit" + values(static_cast<unsigned>(digit), static_cast<unsigned>(expected)));
    pending_ &= pending_ - 1;
    if (pending_ != 0) return;
  }
  step(instruction, ports);
  if (compare) {
    compare_registers(place());
    if (pixelflow::writes_memory(instruction)) {
      compare_row(ChipRow::Memory, instruction.addr, "memory", golden_.memory(instruction.addr), place());
    }
  }
  ++at_;
  if (at_ < stream_.size()) pending_ = pixelflow::digits(stream_[at_], chip_.multiplier_bits());
}

void ChipLockstep::step(const Instruction& instruction, Ports* ports) {
  golden_.step(instruction);
  if (ports == nullptr) return;
  if (is(instruction, Control::WaitInbound)) ports->arrive();
  if (is(instruction, Control::Send)) ports->send();
}

void ChipLockstep::compare_registers(const std::string& where) {
  const auto check = [&](int lane, const char* field, unsigned rtl, unsigned model) {
    if (rtl != model) throw Mismatch(where + ", lane " + std::to_string(lane) + ", " + field + values(rtl, model));
  };
  const auto e = chip_.row(ChipRow::E), k = chip_.row(ChipRow::K), s = chip_.row(ChipRow::S), z = chip_.row(ChipRow::Z),
             c = chip_.row(ChipRow::C), m = chip_.row(ChipRow::M), x = chip_.row(ChipRow::X);
  const auto w = chip_.wide();
  for (int lane = 0; lane < chip_.lanes(); ++lane) {
    const pixelflow::Registers r = golden_.registers(lane);
    const pixelflow::Registers rtl{e[lane] != 0, k[lane] != 0, s[lane] != 0, z[lane] != 0,
                                   c[lane] != 0, m[lane],      x[lane],      w[lane]};
    if (rtl == r) continue;
    check(lane, "E", rtl.e, r.e);
    check(lane, "K", rtl.k, r.k);
    check(lane, "S", rtl.s, r.s);
    check(lane, "Z", rtl.z, r.z);
    check(lane, "C", rtl.c, r.c);
    check(lane, "M", rtl.m, r.m);
    check(lane, "X", rtl.x, r.x);
    check(lane, "W", rtl.w, r.w);
  }
}

void ChipLockstep::compare_row(ChipRow row, int index, const char* name, const std::uint8_t* expected,
                               const std::string& where) {
  const auto rtl = chip_.row(row, index);
  const auto differs = std::mismatch(rtl.begin(), rtl.end(), expected);
  if (differs.first == rtl.end()) return;
  const auto lane = differs.first - rtl.begin();
  throw Mismatch(where + ", lane " + std::to_string(lane) + ", " + name + "[" + std::to_string(index) + "]" +
                 values(*differs.first, *differs.second));
}

void ChipLockstep::compare_rows(const std::string& where) {
  for (int a = 0; a < pixelflow::kMemoryBytes; ++a) compare_row(ChipRow::Memory, a, "memory", golden_.memory(a), where);
  for (int b = 0; b < pixelflow::kPacketBytes; ++b)
    compare_row(ChipRow::Outbound, b, "outbound packet", golden_.outbound(b), where);
}

}  // namespace pixelflow_tests
