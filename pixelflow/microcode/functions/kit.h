// The steps that the mathematical functions are made of, on numbers in element memory, least significant byte first.
// Each one is the microcode of a step of the same name in cmodel/pixelflow/native/bits.h. Cycles stand beside them (n
// bytes).
//
// "Field" is an exponent as it stands in a float32, e + 127. Registers are free for use; flags change as said.
#pragma once

#include <cstdint>
#include <span>

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/microcode/assembler.h"

namespace pixelflow::functions {

/// A factor of a product: bytes in memory, or a constant.
struct Factor {
  int address = 0;
  int bytes = 4;
  bool uniform = false;
  std::uint64_t constant = 0;
};
inline Factor in_memory(int address, int bytes) { return {.address = address, .bytes = bytes}; }
inline Factor constant(std::uint64_t value, int bytes) { return {.bytes = bytes, .uniform = true, .constant = value}; }

class Kit {
 public:
  explicit Kit(Assembler& assembler) : a(assembler) {}

  Assembler& a;

  // Whole numbers.
  void put(int to, std::uint64_t value, int n, Gate gate = Gate::E);  ///< n
  void copy(int to, int from, int n, Gate gate = Gate::E);            ///< 2n; from low to high
  void load(int from, int n = 4);                                     ///< bytes of W, the others zero: n, or n + 1
  void store(int to);                                                 ///< W: 4
  void add(int to, int from, int value);                              ///< to := from + value, a byte; C := carry: 2
  void add_byte(int to, int from, int other, bool subtract = false);  ///< bytes; C: 3
  void negate_if(int number, int n, int top = -1);  ///< K: two's complement; `top`: a byte of sign above
  void subtract_from(int to, std::uint64_t value, int n,
                     int number);  ///< to := value - number: 2n

  // Flags. K keeps for later in a byte of memory.
  void keep_flags(int to) { a.alu(Alu::Or, To::Memory, P::Zero, Q::Flags, {.addr = to}); }  ///< 0 0 0 E K S Z C
  static constexpr int kKeptC = 0;
  static constexpr int kKeptK = 3;
  void k_from(int address, int bit, bool invert = false, FlagOp op = FlagOp::Move) {
    a.flag_of_memory(Flag::K, address, bit, invert, op);
  }
  void k_if_zero(int from, int n, bool invert = false);      ///< K := number = 0: n + 1
  void k_if_at_least(int byte, int value);                   ///< K := byte >= value: 3
  void k_if_magnitude_at_least(int x, std::uint32_t value);  ///< K := |float bits| >= value: 9
  void k_if_number_at_least(int one, int other, int n);      ///< K := one >= other: 2n + 1

  // Products: to := value +- floor(x y / 256^drop), `keep` bytes. `to` may be y where x has at
  // most drop bytes.
  enum class Finish { None, Plus, Minus };
  void multiply(int to, Factor x, Factor y, int drop, int keep, Finish finish = Finish::None, std::uint64_t value = 0);
  /// p := c[0] +- z (c[1] +- z (...)), 4 bytes, z in Q0.32 at `z`; signs[i] says how step i joins
  /// c[i], '-' or '+'.
  void horner(int p, int z, std::span<const std::uint32_t> c, const char* signs);

  // Shifts by the element's own count.
  void shift_right_word(int to, int from,
                        int count);                       ///< 4 bytes by any count of a byte; zero beyond 31
  void shift_right_number(int number, int n, int count);  ///< n bytes by any count of a byte
  void shift_left_small(int number, int n);               ///< by X modulo 8
  /// Moves left until the top bit is set; count := places, 63 (31 for 4 bytes) where the number is
  /// 0.
  void normalise(int number, int n, int count);
  /// W normalised in place; X comes down by the places.

  // Parts of a float32.
  void load_field(int x);  ///< X := exponent field: 2
  /// number := significand * 2^8 with bit 31 set, without regard to subnormals: 5
  void significand(int to, int x);
  /// The same of any finite float: normalised; field16 := its exponent field, 2 bytes, negative
  /// below the normal ones.
  void split(int to, int field16, int x);

  /// quotient := floor(W 256^bytes / divisor), W < divisor, bytes of quotient from high to low; W
  /// and K go on.
  void divide_start() { a.flag(Flag::K, Bit::One); }
  void divide_byte(int quotient, int divisor);  ///< 43

  /// result := W rounded to nearest even, exponent field X, sign S: 13. A carry into the exponent
  /// is taken along.
  void round_normal(int result);
  /// The same of 4 bytes with bit 31 set and a field of 2 bytes: subnormals, zero and infinity
  /// too. The sign is bit 7 of a byte. `count` is workspace.
  void round_any(int result, int number, int field16, int count, int sign);

 private:
  void pack(int result);
};

}  // namespace pixelflow::functions
