// Parts that the float routines share: taking a number apart, and rounding and putting one together. IEEE single, round
// to nearest even, subnormals exact, one NaN (Olano and Lastra 1998, section 6.1.3: integer operations and shifts).
#pragma once

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/microcode/assembler.h"

namespace pixelflow {

/// A float taken apart in the workspace: a mantissa of 24 bits whose top bit is set (all clear for zero), and the
/// biased exponent, less what normalising a subnormal took, in two bytes.
struct FloatPlace {
  int mantissa;  ///< three bytes
  int exponent;  ///< two bytes, signed
};

class FloatParts {
 public:
  FloatParts(Assembler& a, const Operation& o) : a_(a), o_(o), work_(o.work) {}

  static constexpr int kBytes = 20;  ///< workspace of an operation that uses all parts

  FloatPlace first() const { return {work_, work_ + 3}; }
  FloatPlace second() const { return {work_ + 5, work_ + 8}; }
  int nan() const { return work_ + 10; }  ///< bit 0: the result is NaN by its operands
  int exponent() const { return work_ + 11; }
  int scratch() const { return work_ + 12; }  ///< eight bytes

  /// Where the operand lies: its own place, or its constant written to `place`.
  int address(const Operand& operand, int place);

  /// Takes the number at `address` apart. S gets (by `to_s`) whether it is infinite or NaN; bit 0 of nan() is set by
  /// the first operand, added to by the second.
  void unpack(int address, const FloatPlace& to, bool is_first, FlagOp to_s);

  /// d := the number (-1)^sign W 2^... rounded. W: mantissa with its top bit set and a sticky lowest bit, or zero; X:M:
  /// biased exponent less one, signed; S: infinite by its operands; K of `nan()`. The sign is that of bit 7 of each
  /// address, combined.
  void finish(int sign_a, int sign_b, bool zero_is_nan);

  /// W rounded to 24 bits (from its top), with X the biased exponent less one and S the sign, packed to d. C is the
  /// carry.
  void pack();
  /// Where K: infinity with sign S.
  void store_infinity();
  /// Where K: NaN.
  void store_nan();
  /// Where d is subnormal: zero of its sign. Only the flushing form has this.
  void flush_result();
  /// X := X limited to 31, a count for align_right. Uses K.
  void limit_count();
  /// W's lowest bit := 1 where K.
  void jam();

 private:
  Assembler& a_;
  const Operation& o_;
  int work_;
};

}  // namespace pixelflow
