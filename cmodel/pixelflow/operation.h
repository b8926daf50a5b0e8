// Arithmetic operations of the microcode library, as a record: what an operation does, where its operands lie, and
// where its workspace. The microcode turns it into instructions; the macro level computes it natively, lane by lane, to
// the same bytes.
#pragma once

#include <cstdint>

namespace pixelflow {

/// What is computed. d is the result, a and b the operands, in bytes of an element's memory, least significant first.
/// Fixed-point numbers have 1 to 8 bytes and are signed (two's complement) or not; floats are IEEE single, NaN always
/// 0x7FC00000.
enum class Code : std::uint8_t {
  // Fixed point. Values are raw integers; results are reduced modulo 2^(8 d.bytes), shorter operands extended by their
  // sign.
  Copy,  ///< d := a
  Add,
  Sub,         ///< d := a + b, a - b
  Multiply,    ///< d := floor(a b / 256^scale)
  Divide,      ///< d := floor(a 256^scale / b), 0 where b = 0
  Remainder,   ///< d := a - b floor(a / b), 0 where b = 0
  ShiftLeft,   ///< d := a 2^scale
  ShiftRight,  ///< d := floor(a / 2^scale)
  SquareRoot,  ///< d := floor(sqrt(a 2^scale)), 0 where a < 0
  Wrap,        ///< d := a reduced to `scale` bits, extended to d's bytes by d's sign
  Saturate,    ///< d := a limited to the numbers of `scale` bits, signed as d
  Less,
  LessEqual,
  Equal,  ///< K := a < b, a <= b, a = b
  // Float. Rounded to nearest even, subnormals exact (flushed to signed zero by the Flush form of the same operation).
  FloatAdd,
  FloatSub,
  FloatMultiply,
  FloatDivide,
  FloatSquareRoot,
  FloatLess,
  FloatLessEqual,
  FloatEqual,    ///< K := a < b, ...; false where one is NaN
  FixedToFloat,  ///< d := a 2^-scale, rounded to nearest even
  FloatToFixed,  ///< d := floor(a 2^scale), saturated to d; NaN gives 0
  // Functions of floats.
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Exp,
  Exp2,
  Log,
  Log2,
  InverseSquareRoot,
  FastSin,
  FastCos,
  FastTan,
  FastAsin,
  FastAcos,
  FastAtan,
  FastExp,
  FastExp2,
  FastLog,
  FastLog2,
  Atan2,
  FastAtan2,  ///< of a = y and b = x
  Pow,        ///< a to the power b
  // Noise of a point of `scale` coordinates, one after another from a: band limited, 0 to 1 (docs/pfman_library.md).
  NoiseFixed,  ///< coordinates S(16,8); d is U(16,16)
  NoiseFloat,
  Count
};

/// An operand in element memory, or a uniform constant that the instructions carry.
struct Operand {
  std::uint8_t address = 0;
  std::uint8_t bytes = 4;
  bool is_signed = false;
  bool uniform = false;
  std::uint64_t constant = 0;  ///< raw value, extended to 64 bits; of a float its 32 bits
};

struct Operation {
  Code code = Code::Copy;
  Operand d, a, b;
  int scale = 0;
  bool flush = false;     ///< float arithmetic: subnormal operands and results count as zeros of their sign
  std::uint8_t work = 0;  ///< first byte of the workspace; its size is workspace_bytes() of the microcode library
};

}  // namespace pixelflow
