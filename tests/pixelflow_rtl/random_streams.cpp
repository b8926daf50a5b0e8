#include "tests/pixelflow_rtl/random_streams.h"

namespace pixelflow_tests {
namespace {

using namespace pixelflow;

/// Any word: every field takes every value of its bits.
Instruction any_word(std::mt19937_64& random) {
  Instruction i = unpack(random());
  if (i.kind == Kind::Control) i.fn = static_cast<std::uint8_t>(5 + i.fn % 11);  // those that do nothing
  return i;
}

Instruction useful(std::mt19937_64& random) {
  const auto below = [&random](unsigned n) { return static_cast<std::uint8_t>(random() % n); };
  Instruction i;
  i.addr = random() % 8 == 0 ? below(250) + 6 : below(12);
  i.imm = random() % 3 == 0 ? below(10) : below(255);
  i.at = below(4);
  const unsigned what = below(100);
  if (what < 60) {
    i.kind = Kind::Alu;
    i.fn = below(13);
    i.p = below(5);
    i.q = below(8);
    i.cin = below(4);
    i.dest = below(6);
    i.gate = below(4);
    i.set_c = below(2);
    i.z = below(3);
    i.set_s = below(2);
    i.down = below(4) == 0;
    if (i.q == static_cast<std::uint8_t>(Q::Port)) i.imm = below(4) == 0 ? kPortX + below(2) : below(kPacketBytes);
  } else if (what < 85) {
    i.kind = Kind::Wide;
    i.fn = below(16) == 0 ? 0 : 1 + below(4);
    i.p = below(4);
    i.cin = below(4);
    i.set_c = below(2);
    i.set_s = below(2);
    if (i.fn == static_cast<std::uint8_t>(Wide::Multiply)) {
      i.p = below(2) == 0 ? static_cast<std::uint8_t>(P::Immediate) : static_cast<std::uint8_t>(P::X);
      i.q = below(8);
      i.imm = below(4) == 0 ? 1 << below(8) : below(255);
    }
  } else if (what < 98) {
    i.kind = Kind::Flag;
    i.fn = below(9);
    i.p = below(5);
    i.q = below(8);
    i.cin = below(4);
    i.dest = below(5);
    i.set_c = below(2);
  } else {
    i.kind = Kind::Control;  // Nop
  }
  return i;
}

Instruction control(Control what) { return {.kind = Kind::Control, .fn = static_cast<std::uint8_t>(what)}; }

}  // namespace

std::vector<Instruction> random_stream(std::mt19937_64& random, int length, bool ports) {
  std::vector<Instruction> stream;
  bool arrived = false;
  while (static_cast<int>(stream.size()) < length) {
    if (ports && random() % 40 == 0) {
      if (random() % 3 == 0) {
        stream.push_back(control(Control::Send));
      } else {
        stream.push_back(control(arrived ? Control::FreeInbound : Control::WaitInbound));
        arrived = !arrived;
      }
      continue;
    }
    Instruction i = random() % 10 == 0 ? any_word(random) : useful(random);
    // The packet may change while it is free.
    if (ports && !arrived && i.q == static_cast<std::uint8_t>(Q::Port)) i.imm |= 0x80;
    stream.push_back(i);
  }
  stream.push_back(control(Control::End));
  return stream;
}

}  // namespace pixelflow_tests
