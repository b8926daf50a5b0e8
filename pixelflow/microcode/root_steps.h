// A square root, a bit at a time, non-restoring: the steps that run in W.
//
// The radicand A lies in [0, 1). With P the root so far, the remainder R = 2^i (A - P^2) after bit i obeys R := 2R - T
// where R is not negative, R := 2R + T where it is. Z = 2P + 2 * 2^-i goes along: with b = 2^-i, T is Z + b and the
// next Z is Z + 2b where R is not negative, Z - b and Z - 2b where it is. V = ~R is kept instead of R, so that one
// flag, K = (R < 0), steers all three through AddSub. R has two bits before its point, so that W holds the first 30
// bits of a root. The byte of Z in work lies in X, those above it in the workspace.
#pragma once

#include "pixelflow/microcode/assembler.h"

namespace pixelflow {

class RootSteps {
 public:
  static constexpr int kMost = 30;  ///< bits of a root that W has room for

  /// `z`: four bytes of workspace for Z; `t`: one byte. `fraction_bits` of the radicand. Of these `feeding` (0, 2 or 3)
  /// come in from the top of X, complemented, and byte 3 of Z must be 0; otherwise X must be 0. `exact`: V is ~R after
  /// the last of the steps to bit 30.
  RootSteps(Assembler& a, int z, int t, int fraction_bits, int feeding, bool exact)
      : a_(a), z_(z), t_(t), fraction_bits_(fraction_bits), feeding_(feeding), exact_(exact) {}

  /// Finds bit 2^-step; steps run from 1 up.
  void step(int step);

 private:
  void double_v(int step);

  Assembler& a_;
  int z_, t_, fraction_bits_, feeding_;
  bool exact_;
  long long excess_ = 1;
};

}  // namespace pixelflow
