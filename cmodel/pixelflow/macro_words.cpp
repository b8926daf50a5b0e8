// Fixed-point operations whose numbers have up to four bytes, at the macro level: sixteen elements a vector of 32-bit
// numbers.
#include <algorithm>
#include <cmath>

#include "cmodel/pixelflow/macro_kernels.h"

namespace pixelflow::macro {

using namespace vectors;

namespace {

typedef std::int64_t SignedLongWords __attribute__((vector_size(kWidth), may_alias));

constexpr int kWordBytes = 4, kWordBits = 32;

/// The numbers of a group of elements, extended to 32 bits by the operand's sign.
class ShortReader {
 public:
  ShortReader(const Operand& operand, const PixelRow& row)
      : uniform_(operand.uniform),
        signed_(operand.is_signed),
        bytes_(operand.bytes),
        constant_(fill<Words>(static_cast<std::uint32_t>(constant_of(operand)))),
        rows_(operand.uniform ? nullptr : row.memory(operand.address)) {}

  PIXELFLOW_INLINE WordGroup get(int first_lane) const {
    if (uniform_) return {{constant_, constant_, constant_, constant_}};
    Bytes rows[kWordBytes];
    for (int byte = 0; byte < bytes_; ++byte) rows[byte] = load(rows_ + byte * PixelRow::kLanes + first_lane);
    const Bytes sign = signed_ ? top_bit(rows[bytes_ - 1]) : Bytes{};
    for (int byte = bytes_; byte < kWordBytes; ++byte) rows[byte] = sign;
    return words_of_rows(rows);
  }

 private:
  bool uniform_, signed_;
  int bytes_;
  Words constant_;
  const std::uint8_t* rows_;
};

void put(const Operand& d, PixelRow& row, int first_lane, const WordGroup& values) {
  Bytes rows[kWordBytes];
  rows_of_words(values, rows);
  const Bytes e = load(row.enable() + first_lane);
  std::uint8_t* to = row.memory(d.address) + first_lane;
  for (int byte = 0; byte < d.bytes; ++byte, to += PixelRow::kLanes) store(to, select(e, rows[byte], load(to)));
}

/// d := result(a, b), vector by vector.
template <typename F>
bool each_word(const Operation& o, PixelRow& row, F&& result) {
  const ShortReader a_reader(o.a, row), b_reader(o.code == Code::Multiply ? o.b : o.a, row);
  each_enabled_group(row, [&](int at, bool) {
    const WordGroup a = a_reader.get(at), b = b_reader.get(at);
    WordGroup d;
    for (int n = 0; n < 4; ++n) d.part[n] = result(a.part[n], b.part[n]);
    put(o.d, row, at, d);
  });
  return true;
}

PIXELFLOW_INLINE Words shifted_right(Words value, int distance, bool is_signed) {
  if (is_signed)
    return reinterpret_cast<Words>(reinterpret_cast<SignedWords>(value) >> std::min(distance, kWordBits - 1));
  return distance < kWordBits ? value >> distance : Words{};
}

/// The even (Half 0) or odd numbers of a vector, extended to 64 bits.
template <int Half>
PIXELFLOW_INLINE LongWords long_words(Words value, bool is_signed) {
  const LongWords both = reinterpret_cast<LongWords>(value),
                  top = Half ? both & ~std::uint64_t{0xFFFFFFFF} : both << kWordBits;
  return is_signed ? reinterpret_cast<LongWords>(reinterpret_cast<SignedLongWords>(top) >> kWordBits)
                   : top >> kWordBits;
}

PIXELFLOW_INLINE LongWords shifted_right(LongWords value, int distance, bool is_signed) {
  return is_signed ? reinterpret_cast<LongWords>(reinterpret_cast<SignedLongWords>(value) >> distance)
                   : value >> distance;
}

bool multiply(const Operation& o, PixelRow& row) {
  const int shift = 8 * o.scale;
  const bool a_signed = o.a.is_signed, b_signed = o.b.is_signed, is_signed = a_signed || b_signed;
  if (o.a.bytes + o.b.bytes <= kWordBytes) {
    return each_word(o, row, [=](Words a, Words b) { return shifted_right(a * b, shift, is_signed); });
  }
  // The bytes of d lie within the low 32 bits of the product, which are the same for signed and unsigned factors.
  if (o.scale + o.d.bytes <= kWordBytes) return each_word(o, row, [=](Words a, Words b) { return a * b >> shift; });
  if (shift >= 2 * kWordBits) return false;
  return each_word(o, row, [=](Words a, Words b) {
    const LongWords even = long_words<0>(a, a_signed) * long_words<0>(b, b_signed);
    const LongWords odd = long_words<1>(a, a_signed) * long_words<1>(b, b_signed);
    return reinterpret_cast<Words>((shifted_right(even, shift, is_signed) & std::uint64_t{0xFFFFFFFF}) |
                                   shifted_right(odd, shift, is_signed) << kWordBits);
  });
}

}  // namespace

bool words(const Operation& o, PixelRow& row) {
  constexpr int kExactScale = 60;  // no float of a 32-bit number becomes subnormal or infinite
  const bool is_signed = o.a.is_signed;
  if (o.d.bytes > kWordBytes || o.a.bytes > kWordBytes || (o.code == Code::Multiply && o.b.bytes > kWordBytes))
    return false;
  switch (o.code) {
    case Code::Multiply: return multiply(o, row);
    case Code::ShiftLeft:
      return each_word(o, row, [=](Words a, Words) { return o.scale < kWordBits ? a << o.scale : Words{}; });
    case Code::ShiftRight:
      return each_word(o, row, [=](Words a, Words) { return shifted_right(a, o.scale, is_signed); });
    case Code::Wrap: {
      const int unused = std::max(kWordBits - o.scale, 0);
      // Wider than 32 bits, a signed number keeps its sign, and an unsigned d of four bytes does not see what is above.
      return each_word(o, row, [=](Words a, Words) { return shifted_right(a << unused, unused, o.d.is_signed); });
    }
    case Code::FixedToFloat: {
      if (std::abs(o.scale) > kExactScale) return false;
      const float unit = std::ldexp(1.0f, -o.scale);
      if (is_signed) {
        return each_word(o, row, [=](Words a, Words) {
          return reinterpret_cast<Words>(__builtin_convertvector(reinterpret_cast<SignedWords>(a), Floats) * unit);
        });
      }
      return each_word(
          o, row, [=](Words a, Words) { return reinterpret_cast<Words>(__builtin_convertvector(a, Floats) * unit); });
    }
    default: return false;
  }
}

}  // namespace pixelflow::macro
