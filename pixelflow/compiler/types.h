// Types of the language: scalars with their size in bits, arrays of them, and the rate at which they vary
// (Olano and Lastra 1998, section 3.1).
#pragma once

#include <array>
#include <string>

namespace pfman {

/// A fixed-point number of raw integer r has the value r 2^-exponent. Bottom-up sizes may exceed 64 bits; what is
/// stored and computed has 1 to 64.
struct Scalar {
  bool is_float = false;
  bool is_signed = false;  ///< fixed only
  int size = 32;           ///< bits, the sign included
  int exponent = 0;

  static Scalar floating() { return {true, true, 32, 0}; }
  static Scalar fixed(bool is_signed, int size, int exponent) { return {false, is_signed, size, exponent}; }
  static Scalar boolean() { return {false, false, 1, 0}; }
  static Scalar integer() { return {false, true, 32, 0}; }

  int sign_bits() const { return is_signed ? 1 : 0; }
  int magnitude() const { return size - exponent - sign_bits(); }  ///< |value| < 2^magnitude, but for the least signed
  int bytes() const { return (size + 7) / 8; }                     ///< in pixel memory
  friend bool operator==(const Scalar&, const Scalar&) = default;
};

/// The smallest fixed-point type that holds both.
Scalar join(const Scalar& a, const Scalar& b);

struct Type {
  Scalar scalar;
  bool is_void = false;
  bool varying = false;
  int rank = 0;  ///< 0 scalar, 1 or 2 dimensions
  std::array<int, 2> dimensions{1, 1};

  bool is_array() const { return rank > 0; }
  int count() const { return dimensions[0] * dimensions[1]; }  ///< scalars; row-major
  int bytes() const { return is_void ? 0 : count() * scalar.bytes(); }
  bool same_shape(const Type& other) const { return rank == other.rank && dimensions == other.dimensions; }
  friend bool operator==(const Type&, const Type&) = default;
};

/// As it is declared: "signed fixed<32,28>", "float[3]"; bool and int by those names.
std::string spelling(const Scalar& scalar);
std::string spelling(const Type& type);

}  // namespace pfman
