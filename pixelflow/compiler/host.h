// The microprocessor's part: uniform expressions, evaluated with the bits that the pixel processors would give
// (Olano and Lastra 1998, sections 6.1.2 and 6.1.6).
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Scalars of a value in row-major order: raw integers extended to 64 bits by their sign, or the 32 bits of a float.
using Raw = std::vector<std::uint64_t>;

/// What went wrong while uniform code ran: an index out of range, a shift count, an endless loop.
struct UniformError : std::runtime_error {
  UniformError(Location place, const std::string& text) : std::runtime_error(text), where(place) {}
  Location where;
};

/// A C++ function that shaders may call, all of whose parameters and result are uniform: output arguments are written
/// in place; returns the result's raw value (empty for void).
using UniformFunction = Raw (*)(std::vector<Raw>& arguments);

/// Uniform variables and their values.
class Environment {
 public:
  Raw& operator[](const Variable* variable) { return values_[variable]; }
  friend bool operator==(const Environment& a, const Environment& b) { return a.values_ == b.values_; }

  /// Counts operations on numbers, so that nested loops end. Throws UniformError when there have been too many.
  void count(std::uint64_t operations, Location where);

 private:
  std::map<const Variable*, Raw> values_;
  std::uint64_t operations_ = 0;
};

/// The value of a sized uniform tree; assignments in it change the environment. Throws UniformError.
Raw evaluate(const Node& node, Environment& environment);

/// Raw values between types by the language's conversion rules.
std::uint64_t convert(std::uint64_t raw, const Scalar& from, const Scalar& to, bool saturate = false);
/// A number given from outside (a scene, the command line), to the nearest: fixed rounds half up and saturates, float
/// to nearest even.
std::uint64_t from_double(double value, const Scalar& to);
double to_double(std::uint64_t raw, const Scalar& from);

}  // namespace pfman
