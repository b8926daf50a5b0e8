// Random instruction streams for the chip: mostly useful instructions on few addresses, so that results meet again as
// operands, and some words of any bits.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "cmodel/pixelflow/instruction.h"

namespace pixelflow_tests {

/// A stream of `length` instructions before its End. With `ports` it also waits for packets, frees and sends them, and
/// reads the inbound packet only while it is there; without, it reads the packet anywhere and never waits.
std::vector<pixelflow::Instruction> random_stream(std::mt19937_64& random, int length, bool ports);

}  // namespace pixelflow_tests
