// The power of two that exponentials and pow share.
#pragma once

#include "pixelflow/microcode/functions/kit.h"

namespace pixelflow::functions {

struct PowerOfTwo {
  int exponent;  ///< 6 bytes: 5 of Q8.32 come in; the low 4 are the result
  int p;         ///< 4 bytes of workspace
  int count;     ///< a byte of workspace
  int sign;      ///< bit 7 of this byte is the result's sign
};

/// 2^exponent, rounded; 2^-exponent where K is set.
void write_power_of_two(Kit& k, const PowerOfTwo& at, bool fast);

}  // namespace pixelflow::functions
