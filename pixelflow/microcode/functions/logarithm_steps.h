// The logarithm to base 2 that log, log2 and pow share.
#pragma once

#include "pixelflow/microcode/functions/kit.h"

namespace pixelflow::functions {

/// The workspace: what is left at the end comes first.
struct LogarithmPlaces {
  explicit LogarithmPlaces(int work) : value(work) {}
  int value;                    ///< 6 bytes, top bit set, or 0
  int field = value + 6;        ///< exponent of the value, + 127
  int flags = field + 1;        ///< K: negative
  int scratch = flags + 1;      ///< free afterwards
  int significand = scratch;    ///< 4
  int whole = significand + 4;  ///< 2: E
  int divisor = whole + 2;      ///< 4: m + 1
  int quotient = divisor + 4;   ///< 5: m - 1 (4), then s; then log2 m beside E (6)
  int w = quotient + 5;         ///< 4
  int p = w + 4;                ///< 5
  int below_one = p + 5;        ///< K: m was halved
  int places = below_one + 1;   ///< of s: s = quotient * 2^(-42 - places)
  int count = places + 1;
  static constexpr int kBytes = 35;
};

/// Of |x|, exact to 36 bits (pow) or by the cubic.
void write_logarithm_of(Kit& k, const LogarithmPlaces& at, int x);
void write_fast_logarithm_of(Kit& k, const LogarithmPlaces& at, int x);

}  // namespace pixelflow::functions
