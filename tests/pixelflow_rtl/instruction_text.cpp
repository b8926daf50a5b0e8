#include "tests/pixelflow_rtl/instruction_text.h"

#include <array>
#include <span>

namespace pixelflow_tests {
namespace {

using Names = std::span<const char* const>;

constexpr std::array kAlu = {"Add", "Sub", "ReverseSub", "AddSub", "AddIf",     "NegateIf",  "And",
                             "Or",  "Xor", "AndNot",     "Select", "ShiftLeft", "ShiftRight"};
constexpr std::array kWide = {"Clear", "Multiply", "ShiftRight", "ShiftLeft", "Divide"};
constexpr std::array kBit = {"One", "C", "Z", "S", "K", "E", "OfP", "OfQ", "WideZero"};
constexpr std::array kControl = {"Nop", "End", "WaitInbound", "FreeInbound", "Send"};
constexpr std::array kP = {"Zero", "M", "X", "W", "Immediate"};
constexpr std::array kQ = {"Memory", "Immediate", "M", "MemoryOrM", "ExponentLow", "ExponentHigh", "Port", "Flags"};
constexpr std::array kCarry = {"0", "1", "C", "K"};
constexpr std::array kWhen = {"Always", "K", "XBit", "Normalize"};
constexpr std::array kFill = {"0", "Sign", "C", "Jam"};
constexpr std::array kTo = {"None", "M", "X", "W", "Memory", "Port"};
constexpr std::array kFlag = {"C", "Z", "S", "K", "E"};
constexpr std::array kFlagOp = {"Move", "And", "Or", "Xor"};
constexpr std::array kGate = {"E", "E&K", "E&!K", "None"};

std::string name(Names names, unsigned code) {
  return code < names.size() ? names[code] : "unused" + std::to_string(code);
}

}  // namespace

std::string text(const pixelflow::Instruction& i) {
  using pixelflow::Kind;
  const bool shift = i.kind == Kind::Wide && (i.fn == 2 || i.fn == 3);
  std::string out;
  const auto add = [&out](const char* field, const std::string& value) {
    out += std::string(" ") + field + "=" + value;
  };
  switch (i.kind) {
    case Kind::Alu: out = "Alu " + name(kAlu, i.fn); break;
    case Kind::Wide: out = "Wide " + name(kWide, i.fn); break;
    case Kind::Flag: out = "Flag " + name(kBit, i.fn); break;
    case Kind::Control: return "Control " + name(kControl, i.fn);
  }
  if (shift) {
    add("when", name(kWhen, i.p));
    add("fill", name(kFill, i.cin));
  } else {
    add("P", name(kP, i.p));
    add("Q", name(kQ, i.q));
    add(i.kind == Kind::Flag ? "op" : "cin", name(i.kind == Kind::Flag ? Names(kFlagOp) : Names(kCarry), i.cin));
  }
  add("to", name(i.kind == Kind::Flag ? Names(kFlag) : Names(kTo), i.dest));
  add("gate", name(kGate, i.gate));
  if (i.at) add("at", std::to_string(i.at));
  if (i.addr) add("addr", std::to_string(i.addr));
  if (i.imm) add("imm", std::to_string(i.imm));
  if (i.z) add("z", std::to_string(i.z));
  if (i.set_c) out += " set_c";
  if (i.set_s) out += " set_s";
  if (i.down) out += " down";
  return out;
}

}  // namespace pixelflow_tests
