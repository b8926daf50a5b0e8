// Conversions between fixed point and float at the macro level, by integer arithmetic: one rounding, or a floor.
#include <algorithm>
#include <bit>
#include <cstdlib>

#include "cmodel/pixelflow/macro_kernels.h"

namespace pixelflow::macro {
namespace {

constexpr int kBias = 127, kFractionBits = 23, kLeastExponent = -126, kGreatestExponent = 127;
constexpr std::uint32_t kInfinity = 0x7F800000;

/// magnitude 2^-scale with a sign, rounded to nearest even; a subnormal result becomes zero where `flush` asks for it.
std::uint32_t to_float(bool negative, std::uint64_t magnitude, int scale, bool flush) {
  const std::uint32_t sign = negative ? 0x80000000u : 0u;
  if (magnitude == 0) return 0;
  const int top = 63 - std::countl_zero(magnitude);
  const int exponent = top - scale;
  if (exponent > kGreatestExponent) return sign | kInfinity;
  const bool subnormal = exponent < kLeastExponent;
  const int dropped = top - kFractionBits + (subnormal ? kLeastExponent - exponent : 0);
  std::uint64_t fraction;
  if (dropped <= 0) {
    fraction = magnitude << -dropped;
  } else if (dropped > 64) {
    fraction = 0;
  } else {
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    fraction = dropped == 64 ? 0 : magnitude >> dropped;
    const std::uint64_t rest = magnitude & (half | (half - 1));
    if (rest > half || (rest == half && (fraction & 1))) ++fraction;
  }
  // The fraction's leading one adds itself to the exponent, and so does the carry of the rounding, up to infinity.
  const std::uint32_t biased = subnormal ? 0u : static_cast<std::uint32_t>(exponent + kBias - 1);
  const std::uint32_t bits = (biased << kFractionBits) + static_cast<std::uint32_t>(fraction);
  return sign | (flush && bits >> kFractionBits == 0 ? 0u : bits);
}

std::uint64_t limited(__int128 value, const Operand& d) {
  const int bits = 8 * d.bytes;
  const __int128 most = d.is_signed ? (__int128{1} << (bits - 1)) - 1 : (__int128{1} << bits) - 1;
  const __int128 least = d.is_signed ? -most - 1 : 0;
  return static_cast<std::uint64_t>(std::clamp(value, least, most));
}

/// floor(a 2^scale), saturated.
std::uint64_t to_fixed(std::uint32_t bits, const Operation& o) {
  const std::uint32_t magnitude = bits & 0x7FFFFFFFu;
  const bool negative = bits >> 31;
  if (magnitude > kInfinity) return 0;
  const __int128 beyond = __int128{1} << 100;
  if (magnitude == kInfinity) return limited(negative ? -beyond : beyond, o.d);
  const int exponent = std::max(static_cast<int>(magnitude >> kFractionBits), 1);
  std::uint32_t fraction = magnitude & 0x7FFFFFu;
  if (magnitude >> kFractionBits != 0) {
    fraction |= 0x800000u;
  } else if (o.flush) {
    fraction = 0;
  }
  const int shift = exponent - kBias - kFractionBits + o.scale;
  const __int128 value = negative ? -__int128{fraction} : __int128{fraction};
  return limited(shift >= 0 ? value << std::min(shift, 100) : value >> std::min(-shift, 127), o.d);
}

/// Results of up to seven bytes and moderate scales need no more than 64 bits; without branches the loop becomes
/// vectors.
constexpr int kModerateScale = 100, kShortBytes = 7;

void to_short_fixed(const std::uint64_t* a, std::uint64_t* d, const Operation& o) {
  const int bits = 8 * o.d.bytes, scale = o.scale - kBias - kFractionBits;
  const std::int64_t most = (std::int64_t{1} << (o.d.is_signed ? bits - 1 : bits)) - 1,
                     least = o.d.is_signed ? -most - 1 : 0;
  const std::int64_t flush = o.flush ? -1 : 0;
  for (int n = 0; n < kGroup; ++n) {
    const auto magnitude = static_cast<std::int64_t>(a[n] & 0x7FFFFFFFu);
    const std::int64_t exponent = magnitude >> kFractionBits;
    const std::int64_t normal = exponent != 0 ? -1 : 0;
    const std::int64_t fraction = (magnitude & 0x7FFFFF & (normal | ~flush)) | (normal & 0x800000);
    const std::int64_t value = a[n] >> 31 & 1 ? -fraction : fraction;
    const std::int64_t shift = std::max<std::int64_t>(exponent, 1) + scale;
    // 39 places left make every normal number too great for seven bytes, and fit in 64 bits. Subnormal ones never go
    // left.
    const std::int64_t left = std::clamp<std::int64_t>(exponent == 255 ? 39 : shift, 0, 39);
    const std::int64_t right = std::clamp<std::int64_t>(exponent == 255 ? 0 : -shift, 0, 63);
    const std::int64_t limited = std::clamp(value << left >> right, least, most);
    d[n] = static_cast<std::uint64_t>(magnitude > kInfinity ? 0 : limited);
  }
}

}  // namespace

void convert(const Operation& o, PixelRow& row) {
  alignas(64) std::uint64_t a[kGroup], d[kGroup];
  const bool is_short = o.d.bytes <= kShortBytes && std::abs(o.scale) <= kModerateScale;
  each_enabled_group(row, [&](int at, bool) {
    gather(o.a, row, at, a);
    if (o.code == Code::FloatToFixed && is_short) {
      to_short_fixed(a, d, o);
    } else if (o.code == Code::FloatToFixed) {
      for (int n = 0; n < kGroup; ++n) d[n] = to_fixed(static_cast<std::uint32_t>(a[n]), o);
    } else {
      for (int n = 0; n < kGroup; ++n) {
        const bool negative = o.a.is_signed && a[n] >> 63;
        d[n] = to_float(negative, negative ? std::uint64_t{0} - a[n] : a[n], o.scale, o.flush);
      }
    }
    scatter(o.d, row, at, d);
  });
}

}  // namespace pixelflow::macro
