// Arithmetic of uniform numbers: raw values as Raw holds them, with the results that the pixel processors' operations
// have. Fixed results are floored to the result's exponent and reduced modulo its size.
#pragma once

#include <cstdint>

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/compiler/tree.h"

namespace pfman {

/// Reduces to the type's size, extended to 64 bits by its sign.
std::uint64_t wrap(std::uint64_t raw, const Scalar& type);

/// Negate, Add to Remainder, BitAnd to BitXor, Complement: of numbers of the types a and b, giving d. All float or all
/// fixed.
std::uint64_t arithmetic(Node::Op op, std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b,
                         const Scalar& d);
/// Less, LessEqual, Equal, NotEqual: exact.
bool compare(Node::Op op, std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b);
/// Abs, Floor, Ceil, Round, SquareRoot.
std::uint64_t unary(Node::Op op, std::uint64_t x, const Scalar& a, const Scalar& d);
/// A function of one or two floats.
std::uint64_t math(pixelflow::Code code, std::uint64_t x, std::uint64_t y);
/// One to three coordinates: floats, or S(16,8).
std::uint64_t noise(const std::uint64_t* coordinates, int dimensions, bool is_float);
/// Of floats, or of fixed numbers of the types.
std::uint64_t cell_noise(const std::uint64_t* coordinates, const Scalar* types, int dimensions);
constexpr std::int64_t kMostOctaves = 16;  ///< that a shader may ask for
std::uint64_t turbulence(const std::uint64_t point[3], std::int64_t octaves);

float as_float(std::uint64_t raw);
std::uint64_t from_float(float value);  ///< every NaN as 0x7FC00000

}  // namespace pfman
