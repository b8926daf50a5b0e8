#include "pixelflow/compiler/instruction_text.h"

#include <array>

namespace pfman {
namespace {

using pixelflow::Instruction;
using pixelflow::Kind;

template <std::size_t N>
std::string word(const std::array<const char*, N>& words, unsigned code) {
  return code < N ? words[code] : "unused";
}

std::string hexadecimal(unsigned value) {
  constexpr char kDigits[] = "0123456789abcdef";
  return {kDigits[value >> 4 & 15], kDigits[value & 15]};
}

std::string memory(const Instruction& i) { return "memory[" + hexadecimal(i.addr) + "]"; }

std::string byte_of_w(const Instruction& i) { return "W" + std::to_string(i.at); }

std::string p_text(const Instruction& i) {
  switch (static_cast<pixelflow::P>(i.p)) {
    case pixelflow::P::M: return "M";
    case pixelflow::P::X: return "X";
    case pixelflow::P::W: return byte_of_w(i);
    case pixelflow::P::Immediate: return hexadecimal(i.imm);
    default: return "00";
  }
}

std::string q_text(const Instruction& i) {
  switch (static_cast<pixelflow::Q>(i.q)) {
    case pixelflow::Q::Memory: return memory(i);
    case pixelflow::Q::Immediate: return hexadecimal(i.imm);
    case pixelflow::Q::M: return "M";
    case pixelflow::Q::MemoryOrM: return "(K ? M : " + memory(i) + ")";
    case pixelflow::Q::ExponentLow: return "exponent_low";
    case pixelflow::Q::ExponentHigh: return "exponent_high";
    case pixelflow::Q::Port: return "port[" + hexadecimal(i.imm) + "]";
    default: return "flags";
  }
}

std::string gate_text(const Instruction& i) {
  constexpr std::array kGates = {"", " where E & K", " where E & !K", " everywhere"};
  return word(kGates, i.gate);
}

std::string alu_text(const Instruction& i) {
  using pixelflow::Alu;
  constexpr std::array kNames = {"add", "sub", "reverse_sub", "add_sub", "add_if",     "negate_if",  "and",
                                 "or",  "xor", "and_not",     "select",  "shift_left", "shift_right"};
  const auto fn = static_cast<Alu>(i.fn);
  std::string value;
  if (fn == Alu::Or && i.p == static_cast<std::uint8_t>(pixelflow::P::Zero)) {
    value = q_text(i);
  } else if (fn == Alu::Or && i.q == static_cast<std::uint8_t>(pixelflow::Q::Immediate) && i.imm == 0) {
    value = p_text(i);
  } else {
    value = word(kNames, i.fn) + "(" + p_text(i) + ", " + q_text(i) + ")";
    if (i.cin != 0) value += std::string(" carry ") + "01CK"[i.cin & 3];
  }
  std::string text;
  switch (static_cast<pixelflow::To>(i.dest)) {
    case pixelflow::To::M: text = "M := " + value; break;
    case pixelflow::To::X: text = "X := " + value; break;
    case pixelflow::To::W: text = byte_of_w(i) + " := " + value; break;
    case pixelflow::To::Memory: text = memory(i) + " := " + value + gate_text(i); break;
    case pixelflow::To::Port: text = "port[" + hexadecimal(i.addr) + "] := " + value + gate_text(i); break;
    default: text = value;
  }
  if (i.set_c) text += ", C";
  if (i.z == static_cast<std::uint8_t>(pixelflow::ZMode::Set)) text += ", Z";
  if (i.z == static_cast<std::uint8_t>(pixelflow::ZMode::And)) text += ", Z and";
  if (i.set_s) text += ", S";
  if (i.down) text += ", W down";
  return text;
}

std::string flag_text(const Instruction& i) {
  constexpr std::array kFlags = {"C", "Z", "S", "K", "E"};
  constexpr std::array kSources = {"1", "C", "Z", "S", "K", "E"};
  constexpr std::array kOps = {"", " and ", " or ", " xor "};
  const auto bit = static_cast<pixelflow::Bit>(i.fn);
  std::string source;
  if (bit == pixelflow::Bit::OfP || bit == pixelflow::Bit::OfQ) {
    source = "bit " + std::to_string(i.imm & 7) + " of " + (bit == pixelflow::Bit::OfP ? p_text(i) : q_text(i));
  } else {
    source = bit == pixelflow::Bit::WideZero ? "(W = 0)" : word(kSources, i.fn);
  }
  const std::string to = word(kFlags, i.dest);
  return to + " := " + (i.cin != 0 ? to + word(kOps, i.cin) : "") + (i.set_c ? "not " : "") + source;
}

}  // namespace

std::string instruction_text(const Instruction& instruction) {
  constexpr std::array kWide = {"W := 0", "multiply", "shift W right", "shift W left", "divide"};
  constexpr std::array kControl = {"nop", "end", "wait for packets", "free packets", "send packets"};
  switch (instruction.kind) {
    case Kind::Alu: return alu_text(instruction);
    case Kind::Flag: return flag_text(instruction);
    case Kind::Wide: return word(kWide, instruction.fn);
    default: return word(kControl, instruction.fn);
  }
}

bool takes_scale(pixelflow::Code code) {
  using pixelflow::Code;
  switch (code) {
    case Code::Multiply:
    case Code::Divide:
    case Code::ShiftLeft:
    case Code::ShiftRight:
    case Code::SquareRoot:
    case Code::Wrap:
    case Code::Saturate:
    case Code::FixedToFloat:
    case Code::FloatToFixed:
    case Code::NoiseFixed:
    case Code::NoiseFloat: return true;
    default: return false;
  }
}

}  // namespace pfman
