// The instruction word of the pixel processors: the codes and fields of rtl/pixelflow/pixelflow_pkg.sv, under the same
// names. docs/pixel_processor.md says what each does.
#pragma once

#include <cstdint>

#include "pixelflow_parameters.h"

namespace pixelflow {

enum class Kind : std::uint8_t { Alu, Wide, Flag, Control };

enum class Alu : std::uint8_t {
  Add,
  Sub,
  ReverseSub,
  AddSub,
  AddIf,
  NegateIf,
  And,
  Or,
  Xor,
  AndNot,
  Select,
  ShiftLeft,
  ShiftRight
};
enum class Wide : std::uint8_t { Clear, Multiply, ShiftRight, ShiftLeft, Divide };
enum class Bit : std::uint8_t { One, C, Z, S, K, E, OfP, OfQ, WideZero };
enum class Control : std::uint8_t { Nop, End, WaitInbound, FreeInbound, Send };

enum class P : std::uint8_t { Zero, M, X, W, Immediate };
enum class Q : std::uint8_t { Memory, Immediate, M, MemoryOrM, ExponentLow, ExponentHigh, Port, Flags };
enum class Carry : std::uint8_t { Zero, One, C, K };
enum class When : std::uint8_t { Always, K, XBit, Normalize };
enum class Fill : std::uint8_t { Zero, Sign, C, Jam };
enum class To : std::uint8_t { None, M, X, W, Memory, Port };
enum class Flag : std::uint8_t { C, Z, S, K, E };
enum class FlagOp : std::uint8_t { Move, And, Or, Xor };
enum class Gate : std::uint8_t { E, EAndK, EAndNotK, None };
enum class ZMode : std::uint8_t { Keep, Set, And };

/// What `imm` names when Q is the port: bytes 0 to kPacketBytes - 1 of the inbound packet, then the element's place.
constexpr int kPortX = 0x80;
constexpr int kPortY = 0x81;

/// One instruction; every element of the array executes it. The fields that a kind does not use are zero, and fields
/// are held as numbers because several have a second name in another kind.
struct Instruction {
  Kind kind = Kind::Alu;
  std::uint8_t fn = 0;    ///< Alu, Wide, Bit or Control, by `kind`
  std::uint8_t p = 0;     ///< P; When in a shift
  std::uint8_t q = 0;     ///< Q
  std::uint8_t cin = 0;   ///< Carry; Fill in a shift; FlagOp in a flag instruction
  std::uint8_t dest = 0;  ///< To; Flag in a flag instruction
  std::uint8_t gate = 0;  ///< Gate
  bool set_c = false;     ///< C := carry out; multiplier is signed; divide: take the quotient bit; flag: invert
  std::uint8_t z = 0;     ///< ZMode
  bool set_s = false;     ///< S := sign; multiplicand is signed; divide: shift the next bit in
  std::uint8_t at = 0;    ///< byte of W; log2 of a shift's distance; divide: bytes of the divisor - 1
  bool down = false;      ///< W := W >> 8, arithmetically, once R is taken
  std::uint8_t addr = 0;  ///< memory address; byte of the outbound packet
  std::uint8_t imm = 0;   ///< immediate byte; number of a bit; port

  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// Bits of the packed word, and its bits in the order of pixelflow_pkg::instruction_t.
constexpr int kInstructionBits = 42;
std::uint64_t pack(const Instruction& instruction);
Instruction unpack(std::uint64_t word);

/// Which digits of the multiplier a multiplication works off: bit d for digit d. All of them where the multiplier is X;
/// where it is an immediate the sequencer leaves the zero digits out, but for one when all are zero.
unsigned digits(const Instruction& instruction, int multiplier_bits);

/// Clock cycles that the array spends on the instruction, stalls apart.
int cycles(const Instruction& instruction, int multiplier_bits = kMultiplierBits);

/// True where the instruction reads, or writes, element memory. An instruction that names both reads zero (one port).
bool reads_memory(const Instruction& instruction);
bool writes_memory(const Instruction& instruction);

}  // namespace pixelflow
