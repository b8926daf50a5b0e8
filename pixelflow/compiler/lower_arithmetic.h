// Arithmetic on lowered numbers: fixed point in the sizes that the passes have found, floats, comparisons.
#pragma once

#include "pixelflow/compiler/lower_emit.h"

namespace pfman {

class Arithmetic : public Emitter {
 protected:
  using Emitter::Emitter;

  // lower_fixed.cpp, lower_multiply.cpp, lower_divide.cpp, lower_round.cpp
  Term with_type(const Term& value, const Scalar& type);
  Term wrapped(const Term& value);
  Term needed(const Term& value, int bits);
  Term reduced(const Term& value, const Scalar& type);
  Term finished(const Term& value, const Scalar& type);
  Term shifted_left(const Term& value, int places, int bits);
  Term shifted_right(const Term& value, int places, int bits);
  Term aligned(const Term& value, int exponent, int bits);
  Term at_least(const Term& value, int exponent);
  Term extended(const Term& value, int bytes);
  Term fixed_convert(const Term& value, const Scalar& to);
  Term fixed_saturate(const Term& value, const Scalar& to);
  Term fixed_add(const Term& a, const Term& b, bool subtract, const Scalar& type);
  Term fixed_bitwise(Op op, const Term& a, const Term& b, const Scalar& type);
  Term fixed_complement(const Term& value, const Scalar& type);
  Term fixed_abs(const Term& value, const Scalar& type);
  Term fixed_round(Op op, const Term& value, const Scalar& type);
  Term fixed_square_root(const Term& value, const Scalar& type);
  Term fixed_multiply(const Term& a, const Term& b, const Scalar& type);
  int power_of_two(const Term& value) const;
  Term joined(const ir::Operand& upper, const ir::Operand& lower, int places, const Scalar& type);
  Term product(const Term& a, const Term& b, int places, const Scalar& full, int bits);
  Term fixed_divide(const Term& a, const Term& b, const Scalar& type);
  Term scaled_quotient(const Term& a, const Term& b, int places, int bits);
  Term shifted_quotient(const Term& a, const Term& b, int places, int bits);
  Term fixed_remainder(const Term& a, const Term& b, const Scalar& type);
  Term nonzero(const Term& value);

  // lower_float.cpp
  Term to_float(const Term& value);
  Term to_fixed(const Term& value, const Scalar& to);
  Term float_negate(const Term& value);
  Term float_abs(const Term& value);
  Term float_round(Op op, const Term& value);
  Term float_remainder(const Term& a, const Term& b);
  Term float_binary(Code code, const Term& a, const Term& b);

  // lower_compare.cpp
  ir::Operand compare_values(Op op, const Term& a, const Term& b, bool to_byte);  ///< none: K has it
  Term sign_of(const Term& value);
  Term logical_not(const Term& value);
  bool is_zero(const Term& value) const;
  Term convert(const Term& value, const Scalar& to, bool saturate);
  void store(const Term& target, const Term& value);
  /// A variable that holds them one after another; a single value `count` times.
  int gathered(const Terms& values, const Scalar& type, int count = 0);
};

// Types of raw numbers.
Scalar at_exponent(const Scalar& type, int exponent);  ///< the same range, more or fewer bits behind the point
bool fits(const Scalar& type, const Scalar& into);     ///< both of one exponent
Scalar contents_of(const Term& value);                 ///< all that its bytes can hold

}  // namespace pfman
