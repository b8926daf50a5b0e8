#include "pixelflow/compiler/types.h"

#include <algorithm>

namespace pfman {

Scalar join(const Scalar& a, const Scalar& b) {
  if (a.is_float || b.is_float) return Scalar::floating();
  const bool is_signed = a.is_signed || b.is_signed;
  const int exponent = std::max(a.exponent, b.exponent);
  const int size = std::max(a.magnitude(), b.magnitude()) + exponent + (is_signed ? 1 : 0);
  return Scalar::fixed(is_signed, std::max(1, size), exponent);
}

std::string spelling(const Scalar& scalar) {
  if (scalar.is_float) return "float";
  if (scalar == Scalar::boolean()) return "bool";
  if (scalar == Scalar::integer()) return "int";
  return (scalar.is_signed ? "signed fixed<" : "fixed<") + std::to_string(scalar.size) + "," +
         std::to_string(scalar.exponent) + ">";
}

std::string spelling(const Type& type) {
  if (type.is_void) return "void";
  std::string text = spelling(type.scalar);
  for (int n = 0; n < type.rank; ++n) {
    text += "[" + std::to_string(type.dimensions[static_cast<std::size_t>(n)]) + "]";
  }
  return text;
}

}  // namespace pfman
