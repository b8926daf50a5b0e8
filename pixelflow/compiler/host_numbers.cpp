#include "pixelflow/compiler/host_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "cmodel/pixelflow/native/functions.h"
#include "cmodel/pixelflow/native/noise.h"
#include "pixelflow/compiler/host.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using Wide = unsigned __int128;
using SignedWide = __int128;

constexpr std::uint32_t kNan = 0x7FC00000;

/// A raw value's number; sums and products of two of them have 128 bits as long as not both are unsigned.
SignedWide number(std::uint64_t raw, const Scalar& type) {
  return type.is_signed ? SignedWide{static_cast<std::int64_t>(raw)} : SignedWide{raw};
}

SignedWide shift_left(SignedWide value, int places) {
  return places >= 128 ? SignedWide{0} : static_cast<SignedWide>(static_cast<Wide>(value) << places);
}
SignedWide shift_right(SignedWide value, int places) { return value >> std::min(places, 127); }
/// value 2^places, floored.
SignedWide shift(SignedWide value, int places) {
  return places >= 0 ? shift_left(value, places) : shift_right(value, -places);
}

SignedWide floor_divide(SignedWide a, SignedWide b) {
  const SignedWide quotient = a / b;
  return quotient * b != a && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

std::uint64_t fixed_multiply(std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b, const Scalar& d) {
  const int places = d.exponent - a.exponent - b.exponent;
  if (a.is_signed || b.is_signed) return static_cast<std::uint64_t>(shift(number(x, a) * number(y, b), places));
  const Wide product = Wide{x} * y;
  if (places >= 0) return static_cast<std::uint64_t>(places >= 64 ? 0 : product << places);
  return static_cast<std::uint64_t>(-places >= 128 ? 0 : product >> -places);
}

std::uint64_t fixed_divide(std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b, const Scalar& d) {
  if (y == 0) return 0;
  const int places = d.exponent + b.exponent - a.exponent;
  if (!a.is_signed && !b.is_signed) {
    const Wide quotient = places >= 0 ? (Wide{x} << std::min(places, 64)) / y : Wide{x} / y;
    return static_cast<std::uint64_t>(places >= 0 ? quotient : quotient >> std::min(-places, 127));
  }
  if (places >= 0) {
    return static_cast<std::uint64_t>(floor_divide(shift_left(number(x, a), places), number(y, b)));
  }
  return static_cast<std::uint64_t>(shift_right(floor_divide(number(x, a), number(y, b)), -places));
}

std::uint64_t fixed_remainder(std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b, const Scalar& d) {
  if (y == 0) return 0;
  const int exponent = std::max(a.exponent, b.exponent);
  const SignedWide p = shift_left(number(x, a), exponent - a.exponent);
  const SignedWide q = shift_left(number(y, b), exponent - b.exponent);
  const SignedWide rest = p - q * floor_divide(p, q);
  return static_cast<std::uint64_t>(shift(rest, d.exponent - exponent));
}

std::uint64_t fixed_arithmetic(Node::Op op, std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b,
                               const Scalar& d) {
  const auto aligned = [&](std::uint64_t raw, const Scalar& type) {
    return static_cast<std::uint64_t>(shift(number(raw, type), d.exponent - type.exponent));
  };
  switch (op) {
    case Node::Op::Negate: return 0 - aligned(x, a);
    case Node::Op::Add: return aligned(x, a) + aligned(y, b);
    case Node::Op::Subtract: return aligned(x, a) - aligned(y, b);
    case Node::Op::Multiply: return fixed_multiply(x, a, y, b, d);
    case Node::Op::Divide: return fixed_divide(x, a, y, b, d);
    case Node::Op::Remainder: return fixed_remainder(x, a, y, b, d);
    case Node::Op::Complement: return ~aligned(x, a);
    case Node::Op::BitAnd: return aligned(x, a) & aligned(y, b);
    case Node::Op::BitOr: return aligned(x, a) | aligned(y, b);
    case Node::Op::BitXor: return aligned(x, a) ^ aligned(y, b);
    default: throw std::logic_error("no arithmetic of fixed numbers");
  }
}

float float_floor(float x) {
  if (!(std::fabs(x) < 8388608.0f)) return x;
  return std::floor(x) + 0.0f;  // a zero loses its sign
}

float float_arithmetic(Node::Op op, float x, float y) {
  switch (op) {
    case Node::Op::Negate: return -x;
    case Node::Op::Add: return x + y;
    case Node::Op::Subtract: return x - y;
    case Node::Op::Multiply: return x * y;
    case Node::Op::Divide: return x / y;
    case Node::Op::Remainder: {
      const float quotient = float_floor(x / y);
      const float product = y * quotient;
      return x - product;
    }
    default: throw std::logic_error("no arithmetic of floats");
  }
}

float float_unary(Node::Op op, float x) {
  switch (op) {
    case Node::Op::Abs: return std::fabs(x);
    case Node::Op::Floor: return float_floor(x);
    case Node::Op::Ceil: return std::fabs(x) < 8388608.0f ? std::ceil(x) + 0.0f : x;
    case Node::Op::Round: return float_floor(x + 0.5f);
    case Node::Op::SquareRoot: return std::sqrt(x);
    default: throw std::logic_error("no function of floats");
  }
}

std::uint64_t square_root(Wide value) {
  Wide root = 0;
  for (int bit = 64; bit >= 0; --bit) {
    const Wide next = root | Wide{1} << bit;
    if (bit == 64 ? false : next * next <= value) root = next;
  }
  return static_cast<std::uint64_t>(root);
}

std::uint64_t saturate_number(SignedWide value, const Scalar& to) {
  const SignedWide most = (SignedWide{1} << (to.size - to.sign_bits())) - 1;
  const SignedWide least = to.is_signed ? -most - 1 : SignedWide{0};
  return static_cast<std::uint64_t>(std::clamp(value, least, most));
}

/// floor(value) of a double within or beyond the type, saturated.
std::uint64_t saturate_double(double value, const Scalar& to) {
  if (std::isnan(value)) return 0;
  const double floored = std::floor(value);
  const double limit = std::ldexp(1.0, to.size - to.sign_bits());
  if (floored >= limit) return saturate_number((SignedWide{1} << 100), to);
  if (floored <= -limit) return saturate_number(-(SignedWide{1} << 100), to);
  return saturate_number(static_cast<SignedWide>(floored), to);
}

float fixed_to_float(std::uint64_t raw, const Scalar& from) {
  const SignedWide value = number(raw, from);
  // Below 2^53 a double holds number and scale exactly, so that a subnormal result is rounded once; above, the result
  // is normal.
  if (value > -(SignedWide{1} << 53) && value < (SignedWide{1} << 53)) {
    return static_cast<float>(std::ldexp(static_cast<double>(value), -from.exponent));
  }
  const float rounded = from.is_signed ? static_cast<float>(static_cast<std::int64_t>(raw)) : static_cast<float>(raw);
  return std::ldexp(rounded, -from.exponent);
}

}  // namespace

float as_float(std::uint64_t raw) { return std::bit_cast<float>(static_cast<std::uint32_t>(raw)); }

std::uint64_t from_float(float value) { return std::isnan(value) ? kNan : std::bit_cast<std::uint32_t>(value); }

std::uint64_t wrap(std::uint64_t raw, const Scalar& type) {
  if (type.size >= 64) return raw;
  const int unused = 64 - type.size;
  const std::uint64_t top = raw << unused;
  return type.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> unused) : top >> unused;
}

std::uint64_t arithmetic(Node::Op op, std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b,
                         const Scalar& d) {
  if (d.is_float) return from_float(float_arithmetic(op, as_float(x), as_float(y)));
  return wrap(fixed_arithmetic(op, x, a, y, b, d), d);
}

bool compare(Node::Op op, std::uint64_t x, const Scalar& a, std::uint64_t y, const Scalar& b) {
  const auto decide = [op](const auto& p, const auto& q) {
    switch (op) {
      case Node::Op::Less: return p < q;
      case Node::Op::LessEqual: return p <= q;
      case Node::Op::Equal: return p == q;
      case Node::Op::NotEqual: return p != q;
      default: throw std::logic_error("no comparison");
    }
  };
  if (a.is_float) return decide(as_float(x), as_float(y));
  const int exponent = std::max(a.exponent, b.exponent);
  return decide(shift_left(number(x, a), exponent - a.exponent), shift_left(number(y, b), exponent - b.exponent));
}

std::uint64_t unary(Node::Op op, std::uint64_t x, const Scalar& a, const Scalar& d) {
  if (a.is_float) return from_float(float_unary(op, as_float(x)));
  const SignedWide value = number(x, a);
  const auto aligned = [&](SignedWide n, int exponent) {
    return wrap(static_cast<std::uint64_t>(shift(n, d.exponent - exponent)), d);
  };
  switch (op) {
    case Node::Op::Abs: return aligned(value < 0 ? -value : value, a.exponent);
    case Node::Op::Floor: return a.exponent <= 0 ? aligned(value, a.exponent) : aligned(shift(value, -a.exponent), 0);
    case Node::Op::Ceil: return a.exponent <= 0 ? aligned(value, a.exponent) : aligned(-shift(-value, -a.exponent), 0);
    case Node::Op::Round:
      if (a.exponent <= 0) return aligned(value, a.exponent);
      if (a.exponent > 65) return 0;  // never beyond a half
      return aligned(shift(value + shift_left(1, a.exponent - 1), -a.exponent), 0);
    case Node::Op::SquareRoot:
      if (value <= 0) return 0;
      return aligned(static_cast<SignedWide>(square_root(static_cast<Wide>(shift(value, a.exponent)))), a.exponent);
    default: throw std::logic_error("no function of a fixed number");
  }
}

std::uint64_t math(pixelflow::Code code, std::uint64_t x, std::uint64_t y) {
  const std::string_view name = pixelflow::name(code);
  const auto p = static_cast<std::uint32_t>(x), q = static_cast<std::uint32_t>(y);
  std::uint32_t result = 0;
  for (const auto& function : pixelflow::native::unary_functions()) {
    if (function.name != name) continue;
    function.batch(&p, &result, 1);
    return result;
  }
  for (const auto& function : pixelflow::native::binary_functions()) {
    if (function.name != name) continue;
    function.batch(&p, &q, &result, 1);
    return result;
  }
  throw std::logic_error("no function " + std::string(name));
}

std::uint64_t noise(const std::uint64_t* coordinates, int dimensions, bool is_float) {
  if (is_float) {
    std::uint32_t point[3], result = 0;
    const std::uint32_t* rows[3];
    for (int n = 0; n < dimensions; ++n) {
      point[n] = static_cast<std::uint32_t>(coordinates[n]);
      rows[n] = &point[n];
    }
    pixelflow::native::noise_float(dimensions, rows, &result, 1);
    return result;
  }
  std::uint16_t point[3], result = 0;
  const std::uint16_t* rows[3];
  for (int n = 0; n < dimensions; ++n) {
    point[n] = static_cast<std::uint16_t>(coordinates[n]);
    rows[n] = &point[n];
  }
  pixelflow::native::noise_fixed(dimensions, rows, &result, 1);
  return result;
}

std::uint64_t cell_noise(const std::uint64_t* coordinates, const Scalar* types, int dimensions) {
  unsigned cell[3] = {0, 0, 0};
  for (int n = 0; n < dimensions; ++n) {
    cell[n] = static_cast<unsigned>(
        convert(types[n].is_float ? convert(coordinates[n], types[n], Scalar::integer()) : coordinates[n],
                types[n].is_float ? Scalar::integer() : types[n], Scalar::fixed(false, 8, 0)));
  }
  return pixelflow::native::noise_hash(cell[0], cell[1], cell[2]);
}

std::uint64_t turbulence(const std::uint64_t point[3], std::int64_t octaves) {
  float sum = 0.0f;
  for (std::int64_t i = 0; i < octaves; ++i) {
    std::uint64_t scaled[3];
    for (int n = 0; n < 3; ++n) {
      scaled[n] = from_float(as_float(point[n]) * std::ldexp(1.0f, static_cast<int>(i)));
    }
    const float twice = 2.0f * as_float(noise(scaled, 3, true));
    const float term = std::fabs(twice - 1.0f) * std::ldexp(1.0f, -static_cast<int>(i));
    sum = i == 0 ? term : sum + term;
  }
  return from_float(sum);
}

std::uint64_t convert(std::uint64_t raw, const Scalar& from, const Scalar& to, bool saturate) {
  if (from.is_float && to.is_float) return raw;
  if (to.is_float) return from_float(fixed_to_float(raw, from));
  if (from.is_float) {
    const double scaled = std::ldexp(static_cast<double>(as_float(raw)), to.exponent);
    return saturate_double(scaled, to);
  }
  const int places = to.exponent - from.exponent;
  if (!saturate) return wrap(static_cast<std::uint64_t>(shift(number(raw, from), places)), to);
  const SignedWide value = number(raw, from);
  if (value == 0) return 0;
  // Beyond 63 places to the left every number but zero is outside of every type.
  return saturate_number(places >= 64 ? (value < 0 ? -(SignedWide{1} << 100) : SignedWide{1} << 100)
                                      : shift(value, std::max(places, -127)),
                         to);
}

std::uint64_t from_double(double value, const Scalar& to) {
  if (to.is_float) return from_float(static_cast<float>(value));
  return saturate_double(std::ldexp(value, to.exponent) + 0.5, to);
}

double to_double(std::uint64_t raw, const Scalar& from) {
  if (from.is_float) return as_float(raw);
  return std::ldexp(static_cast<double>(number(raw, from)), -from.exponent);
}

}  // namespace pfman
