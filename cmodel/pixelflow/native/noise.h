// Band-limited noise of points with one to three coordinates, with values from 0 to 1 (Olano and Lastra 1998, table 2): gradient
// noise on the integer lattice. There is no table to look gradients up in, since an element cannot address by its own data;
// sixteen bits of arithmetic on the lattice indices, taken modulo 256, choose one of sixteen directions.
//
// Both forms are integer arithmetic, so that they have the same bits everywhere:
//  fixed: coordinates S(16,8); fade weights U(8,8), floored; interpolations floored to 16 fraction bits; result U(16,16), floored.
//  float: coordinates floored to 24 fraction bits, modulo 256; t^2 and the fade weights U(32,32), floored; interpolations floored
//         to 28 fraction bits; the result is rounded to nearest even once. An infinity or NaN as a coordinate gives NaN.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pixelflow::native {

/// The lattice point's hash, 0 to 255; indices are taken modulo 256.
std::uint8_t noise_hash(unsigned i, unsigned j, unsigned k);

/// d[n] := noise of (coordinates[0][n], ...), `dimensions` (1 to 3) of them.
void noise_fixed(int dimensions, const std::uint16_t* const* coordinates, std::uint16_t* d, std::size_t n);
void noise_float(int dimensions, const std::uint32_t* const* coordinates, std::uint32_t* d, std::size_t n);

}  // namespace pixelflow::native
