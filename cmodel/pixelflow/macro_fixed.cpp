// Fixed-point arithmetic at the macro level: numbers of up to 64 bits, products and scaled dividends of up to 128.
#include <algorithm>
#include <cmath>

#include "cmodel/pixelflow/macro_kernels.h"

namespace pixelflow::macro {

void gather(const Operand& operand, const PixelRow& row, int first_lane, std::uint64_t* values) {
  if (operand.uniform) {
    std::fill_n(values, kGroup, constant_of(operand));
    return;
  }
  const int top = operand.bytes - 1;
  const std::uint8_t* const last = row.memory(operand.address + top) + first_lane;
  if (operand.is_signed) {
    for (int n = 0; n < kGroup; ++n) values[n] = static_cast<std::uint64_t>(static_cast<std::int8_t>(last[n]));
  } else {
    for (int n = 0; n < kGroup; ++n) values[n] = last[n];
  }
  for (int byte = top - 1; byte >= 0; --byte) {
    const std::uint8_t* const from = row.memory(operand.address + byte) + first_lane;
    for (int n = 0; n < kGroup; ++n) values[n] = values[n] << 8 | from[n];
  }
}

void scatter(const Operand& d, PixelRow& row, int first_lane, const std::uint64_t* values) {
  const std::uint8_t* const e = row.enable() + first_lane;
  for (int byte = 0; byte < d.bytes; ++byte) {
    std::uint8_t* const to = row.memory(d.address + byte) + first_lane;
    for (int n = 0; n < kGroup; ++n) {
      to[n] = static_cast<std::uint8_t>((to[n] & ~e[n]) | (static_cast<std::uint8_t>(values[n] >> (8 * byte)) & e[n]));
    }
  }
}

namespace {

using Wide = unsigned __int128;
using SignedWide = __int128;

std::uint64_t magnitude(std::uint64_t value, bool is_signed) {
  return is_signed && value >> 63 ? std::uint64_t{0} - value : value;
}
bool is_negative(std::uint64_t value, bool is_signed) { return is_signed && value >> 63; }
SignedWide extend(std::uint64_t value, bool is_signed) {
  return is_signed ? SignedWide{static_cast<std::int64_t>(value)} : static_cast<SignedWide>(value);
}

/// floor(a b / 2^shift), modulo 2^64.
std::uint64_t scaled_product(std::uint64_t a, bool a_signed, std::uint64_t b, bool b_signed, int shift) {
  if (!a_signed && !b_signed) {
    const Wide product = static_cast<Wide>(a) * b;
    return shift >= 128 ? 0 : static_cast<std::uint64_t>(product >> shift);
  }
  const SignedWide product = extend(a, a_signed) * extend(b, b_signed);
  return static_cast<std::uint64_t>(product >> std::min(shift, 127));
}

struct Quotient {
  std::uint64_t quotient, remainder;
};

/// floor(a 2^shift / b) modulo 2^64, and a 2^shift - b floor(...); zeros where b is zero.
Quotient floored_division(std::uint64_t a, bool a_signed, std::uint64_t b, bool b_signed, int shift) {
  if (b == 0) return {0, 0};
  const std::uint64_t divisor = magnitude(b, b_signed);
  const Wide dividend = static_cast<Wide>(magnitude(a, a_signed)) << shift;
  Wide quotient, remainder;
  if (dividend >> 64 == 0) {
    quotient = static_cast<std::uint64_t>(dividend) / divisor,
    remainder = static_cast<std::uint64_t>(dividend) % divisor;
  } else {
    quotient = dividend / divisor, remainder = dividend % divisor;
  }
  if (is_negative(a, a_signed) != is_negative(b, b_signed)) {
    quotient = Wide{0} - quotient - (remainder != 0 ? 1 : 0);
    if (remainder != 0) remainder = divisor - remainder;
  }
  const std::uint64_t r = static_cast<std::uint64_t>(remainder);
  return {static_cast<std::uint64_t>(quotient), is_negative(b, b_signed) ? std::uint64_t{0} - r : r};
}

std::uint64_t floored_root(Wide value) {
  if (value >> 52 == 0)
    return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(static_cast<std::uint64_t>(value))));
  std::uint64_t root = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const std::uint64_t more = root | std::uint64_t{1} << bit;
    if (static_cast<Wide>(more) * more <= value) root = more;
  }
  return root;
}

std::uint64_t wrapped(std::uint64_t value, int bits, bool is_signed) {
  const int unused = 64 - bits;
  const std::uint64_t top = value << unused;
  return is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(top) >> unused) : top >> unused;
}

std::uint64_t saturated(std::uint64_t value, bool value_signed, int bits, bool is_signed) {
  const SignedWide most = is_signed ? (SignedWide{1} << (bits - 1)) - 1 : (SignedWide{1} << bits) - 1;
  const SignedWide least = is_signed ? -most - 1 : 0;
  return static_cast<std::uint64_t>(std::clamp(extend(value, value_signed), least, most));
}

template <typename F>
void each_group(const Operation& o, PixelRow& row, F&& result) {
  alignas(64) std::uint64_t a[kGroup], b[kGroup] = {}, d[kGroup];
  const bool two = o.code == Code::Multiply || o.code == Code::Divide || o.code == Code::Remainder;
  each_enabled_group(row, [&](int at, bool) {
    gather(o.a, row, at, a);
    if (two) gather(o.b, row, at, b);
    for (int n = 0; n < kGroup; ++n) d[n] = result(a[n], b[n]);
    scatter(o.d, row, at, d);
  });
}

}  // namespace

void fixed(const Operation& o, PixelRow& row) {
  const bool a_signed = o.a.is_signed, b_signed = o.b.is_signed, d_signed = o.d.is_signed;
  const int scale = o.scale;
  using U = std::uint64_t;
  switch (o.code) {
    case Code::Multiply:
      // Products that fit in 64 bits, sign included, need no more.
      if (o.a.bytes + o.b.bytes <= 8) {
        const int shift = std::min(8 * scale, 63);
        if (8 * scale >= 64 && !a_signed && !b_signed) {
          each_group(o, row, [](U, U) { return U{0}; });
        } else if (a_signed || b_signed) {
          each_group(o, row, [=](U a, U b) { return static_cast<U>(static_cast<std::int64_t>(a * b) >> shift); });
        } else {
          each_group(o, row, [=](U a, U b) { return a * b >> shift; });
        }
      } else {
        each_group(o, row, [=](U a, U b) { return scaled_product(a, a_signed, b, b_signed, 8 * scale); });
      }
      break;
    case Code::Divide:
      each_group(o, row, [=](U a, U b) { return floored_division(a, a_signed, b, b_signed, 8 * scale).quotient; });
      break;
    case Code::Remainder:
      each_group(o, row, [=](U a, U b) { return floored_division(a, a_signed, b, b_signed, 0).remainder; });
      break;
    case Code::ShiftLeft: each_group(o, row, [=](U a, U) { return scale < 64 ? a << scale : 0; }); break;
    case Code::ShiftRight:
      if (a_signed) {
        each_group(o, row, [=](U a, U) { return static_cast<U>(static_cast<std::int64_t>(a) >> std::min(scale, 63)); });
      } else {
        each_group(o, row, [=](U a, U) { return scale < 64 ? a >> scale : 0; });
      }
      break;
    case Code::SquareRoot:
      each_group(o, row,
                 [=](U a, U) { return is_negative(a, a_signed) ? 0 : floored_root(static_cast<Wide>(a) << scale); });
      break;
    case Code::Wrap: each_group(o, row, [=](U a, U) { return wrapped(a, scale, d_signed); }); break;
    case Code::Saturate: each_group(o, row, [=](U a, U) { return saturated(a, a_signed, scale, d_signed); }); break;
    default: break;
  }
}

}  // namespace pixelflow::macro
