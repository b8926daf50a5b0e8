// Sums and comparisons at the macro level. They stay on rows of bytes: to transpose them into numbers would cost more.
#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/pixel_row_alu.h"

namespace pixelflow::macro {

using namespace vectors;

namespace {

/// Greatest number of bytes that a sum or a comparison goes through: one more than operands have, so that all are
/// signed.
constexpr int kMostBytes = 9;

/// An operand's rows byte by byte, lowest first, extended by its sign: 64 elements at row[0], the next at row[stride].
class ByteReader {
 public:
  ByteReader(const Operand& operand, const PixelRow& row) : own_(operand.uniform ? kMostBytes : operand.bytes) {
    const std::uint64_t constant = constant_of(operand);
    for (int byte = 0; byte < kMostBytes; ++byte) {
      if (operand.uniform) {
        const std::uint64_t sign = operand.is_signed && constant >> 63 ? 0xFF : 0;
        constants_[byte] = fill<Bytes>(byte < 8 ? constant >> (8 * byte) & 0xFF : sign);
      } else if (byte < own_) {
        rows_[byte] = row.memory(operand.address + byte);
      }
    }
    uniform_ = operand.uniform;
    signed_ = operand.is_signed;
  }

  PIXELFLOW_INLINE Bytes get(int byte, int first_lane) const {
    if (uniform_) return constants_[byte];
    if (byte < own_) return load(rows_[byte] + first_lane);
    return signed_ ? top_bit(load(rows_[own_ - 1] + first_lane)) : Bytes{};
  }

 private:
  int own_;
  bool uniform_, signed_;
  const std::uint8_t* rows_[kMostBytes] = {};
  Bytes constants_[kMostBytes];
};

}  // namespace

void add(const Operation& o, PixelRow& row) {
  const ByteReader a(o.a, row), b(o.b, row);
  const bool copies = o.code == Code::Copy;
  const Bytes invert = fill<Bytes>(o.code == Code::Sub ? 0xFF : 0);
  const std::uint8_t* const enable = row.enable();
  std::uint8_t* d[8];
  for (int byte = 0; byte < o.d.bytes; ++byte) d[byte] = row.memory(o.d.address + byte);
  each_enabled_group(row, [&](int at, bool) {
    const Bytes e = load(enable + at);
    // d may be a or b, and then its sign must be read before its last byte is written: all bytes first.
    Bytes sums[8], carry = invert;
    for (int byte = 0; byte < o.d.bytes; ++byte) {
      const Bytes p = a.get(byte, at);
      if (copies) {
        sums[byte] = p;
        continue;
      }
      const Bytes q = b.get(byte, at) ^ invert;
      sums[byte] = p + q - carry;
      carry = top_bit(carry_bit(p, q, sums[byte]));
    }
    for (int byte = 0; byte < o.d.bytes; ++byte) {
      std::uint8_t* const to = d[byte] + at;
      store(to, select(e, sums[byte], load(to)));
    }
  });
}

void compare(const Operation& o, PixelRow& row) {
  const ByteReader a(o.a, row), b(o.b, row);
  const int bytes = (o.a.bytes > o.b.bytes ? o.a.bytes : o.b.bytes) + 1;  // one more, so that all numbers are signed
  for (int at = 0; at < row.padded_lanes(); at += kGroup) {
    Bytes carry = load(kOnes), equal = load(kOnes), difference{};
    for (int byte = 0; byte < bytes; ++byte) {
      const Bytes p = a.get(byte, at), q = ~b.get(byte, at);
      difference = p + q - carry;
      equal &= is_zero(difference);
      carry = top_bit(carry_bit(p, q, difference));
    }
    const Bytes less = top_bit(difference);
    store(row.condition() + at, o.code == Code::Less ? less : o.code == Code::Equal ? equal : less | equal);
  }
}

}  // namespace pixelflow::macro
