#include "cmodel/pixelflow/pixel_element.h"

namespace pixelflow {
namespace {

bool bit(std::uint32_t value, int number) { return value >> number & 1u; }

std::uint32_t fill_bits(bool fill, int distance) { return fill ? ~(0xFFFFFFFFu >> distance) : 0u; }

}  // namespace

std::uint8_t PixelElement::operand_p(const Instruction& i) const {
  switch (static_cast<P>(i.p)) {
    case P::M: return registers.m;
    case P::X: return registers.x;
    case P::W: return static_cast<std::uint8_t>(registers.w >> (8 * i.at));
    case P::Immediate: return i.imm;
    default: return 0;
  }
}

std::uint8_t PixelElement::operand_q(const Instruction& i) const {
  const Registers& r = registers;
  const std::uint8_t read = reads_memory(i) && i.addr < kMemoryBytes ? memory[i.addr] : 0;
  switch (static_cast<Q>(i.q)) {
    case Q::Memory: return read;
    case Q::Immediate: return i.imm;
    case Q::M: return r.m;
    case Q::MemoryOrM: return r.k ? r.m : read;
    case Q::ExponentLow: return static_cast<std::uint8_t>(r.x << 7);
    case Q::ExponentHigh: return static_cast<std::uint8_t>((r.s ? 0x80 : 0) | r.x >> 1);
    case Q::Port:
      if (i.imm < kPacketBytes) return inbound[i.imm];
      if (i.imm == kPortX) return x_position;
      if (i.imm == kPortY) return y_position;
      return 0;
    case Q::Flags: return static_cast<std::uint8_t>(r.e << 4 | r.k << 3 | r.s << 2 | r.z << 1 | r.c);
  }
  return 0;
}

void PixelElement::step(const Instruction& instruction) {
  switch (instruction.kind) {
    case Kind::Alu: step_alu(instruction); break;
    case Kind::Wide: step_wide(instruction); break;
    case Kind::Flag: step_flag(instruction); break;
    case Kind::Control: break;
  }
}

void PixelElement::step_alu(const Instruction& i) {
  Registers& r = registers;
  std::uint8_t p = operand_p(i);
  std::uint8_t q = operand_q(i);
  bool cin = false;
  switch (static_cast<Carry>(i.cin)) {
    case Carry::Zero: break;
    case Carry::One: cin = true; break;
    case Carry::C: cin = r.c; break;
    case Carry::K: cin = r.k; break;
  }

  std::uint8_t result = 0;
  bool carry = false;
  bool adds = false;
  switch (static_cast<Alu>(i.fn)) {
    case Alu::Add: adds = true; break;
    case Alu::Sub: adds = true, q = static_cast<std::uint8_t>(~q); break;
    case Alu::ReverseSub: adds = true, p = static_cast<std::uint8_t>(~p); break;
    case Alu::AddSub: adds = true, q = r.k ? static_cast<std::uint8_t>(~q) : q; break;
    case Alu::AddIf: adds = true, q = r.k ? q : 0; break;
    case Alu::NegateIf: adds = true, p = r.k ? static_cast<std::uint8_t>(~p) : p; break;
    case Alu::And: result = p & q; break;
    case Alu::Or: result = p | q; break;
    case Alu::Xor: result = p ^ q; break;
    case Alu::AndNot: result = static_cast<std::uint8_t>(p & ~q); break;
    case Alu::Select: result = r.k ? p : q; break;
    case Alu::ShiftLeft:
      result = static_cast<std::uint8_t>(q << 1 | cin);
      carry = bit(q, 7);
      break;
    case Alu::ShiftRight:
      result = static_cast<std::uint8_t>(cin << 7 | q >> 1);
      carry = bit(q, 0);
      break;
    default: break;
  }
  bool sign = bit(result, 7);
  if (adds) {
    const unsigned sum = p + q + cin;
    result = static_cast<std::uint8_t>(sum);
    carry = bit(sum, 8);
    sign = bit(p, 7) ^ bit(q, 7) ^ carry;  // of the sum with one bit more: right where eight bits overflow
  }

  bool gated = r.e;
  switch (static_cast<Gate>(i.gate)) {
    case Gate::E: break;
    case Gate::EAndK: gated = r.e && r.k; break;
    case Gate::EAndNotK: gated = r.e && !r.k; break;
    case Gate::None: gated = true; break;
  }
  std::uint32_t w = r.w;
  if (i.down) w = static_cast<std::uint32_t>(static_cast<std::int32_t>(w) >> 8);
  switch (static_cast<To>(i.dest)) {
    case To::M: r.m = result; break;
    case To::X: r.x = result; break;
    case To::W: w = (w & ~(0xFFu << (8 * i.at))) | static_cast<std::uint32_t>(result) << (8 * i.at); break;
    case To::Memory:
      if (gated && i.addr < kMemoryBytes) memory[i.addr] = result;
      break;
    case To::Port:
      if (gated && i.addr < kPacketBytes) outbound[i.addr] = result;
      break;
    default: break;
  }
  r.w = w;
  if (i.set_c) r.c = carry;
  if (static_cast<ZMode>(i.z) == ZMode::Set) r.z = result == 0;
  if (static_cast<ZMode>(i.z) == ZMode::And) r.z = r.z && result == 0;
  if (i.set_s) r.s = sign;
}

void PixelElement::step_wide(const Instruction& i) {
  Registers& r = registers;
  const int distance = 1 << i.at;
  bool happens = true;
  switch (static_cast<When>(i.p)) {
    case When::Always: break;
    case When::K: happens = r.k; break;
    case When::XBit: happens = bit(r.x, i.imm & 7); break;
    case When::Normalize: happens = r.w >> (32 - distance) == 0 && r.x > distance; break;
    default: happens = false; break;
  }
  switch (static_cast<Wide>(i.fn)) {
    case Wide::Clear: r.w = 0; break;
    case Wide::Multiply: {
      const std::uint8_t a = static_cast<P>(i.p) == P::Immediate ? i.imm : r.x;
      const std::uint8_t b = operand_q(i);
      const int multiplier = i.set_c ? static_cast<std::int8_t>(a) : a;
      const int multiplicand = i.set_s ? static_cast<std::int8_t>(b) : b;
      r.w += static_cast<std::uint32_t>(multiplier * multiplicand);
      break;
    }
    case Wide::ShiftRight: {
      if (!happens) break;
      const bool dropped = (r.w & ((1u << distance) - 1)) != 0;
      bool fill = false;
      if (static_cast<Fill>(i.cin) == Fill::Sign) fill = bit(r.w, 31);
      if (static_cast<Fill>(i.cin) == Fill::C) fill = r.c;
      r.w = r.w >> distance | fill_bits(fill, distance);
      if (static_cast<Fill>(i.cin) == Fill::Jam && dropped) r.w |= 1;
      break;
    }
    case Wide::ShiftLeft:
      if (!happens) break;
      r.w <<= distance;
      if (static_cast<When>(i.p) == When::Normalize) r.x = static_cast<std::uint8_t>(r.x - distance);
      break;
    case Wide::Divide: {
      const bool quotient = !(r.s ^ r.k ^ r.c);
      const bool next = bit(r.x, 7);
      if (i.set_c || i.set_s) r.x = static_cast<std::uint8_t>(r.x << 1 | (i.set_c && quotient));
      if (i.set_c) r.k = quotient;
      if (i.set_s) {
        r.s = bit(r.w, 8 * i.at + 7);
        r.w = r.w << 1 | next;
      }
      break;
    }
    default: break;
  }
}

void PixelElement::step_flag(const Instruction& i) {
  Registers& r = registers;
  bool source = false;
  switch (static_cast<Bit>(i.fn)) {
    case Bit::One: source = true; break;
    case Bit::C: source = r.c; break;
    case Bit::Z: source = r.z; break;
    case Bit::S: source = r.s; break;
    case Bit::K: source = r.k; break;
    case Bit::E: source = r.e; break;
    case Bit::OfP: source = bit(operand_p(i), i.imm & 7); break;
    case Bit::OfQ: source = bit(operand_q(i), i.imm & 7); break;
    case Bit::WideZero: source = r.w == 0; break;
    default: break;
  }
  source ^= i.set_c;
  bool* const flags[] = {&r.c, &r.z, &r.s, &r.k, &r.e};
  if (i.dest >= 5) return;
  bool& flag = *flags[i.dest];
  switch (static_cast<FlagOp>(i.cin)) {
    case FlagOp::Move: flag = source; break;
    case FlagOp::And: flag = flag && source; break;
    case FlagOp::Or: flag = flag || source; break;
    case FlagOp::Xor: flag = flag ^ source; break;
  }
}

}  // namespace pixelflow
