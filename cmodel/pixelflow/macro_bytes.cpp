// Sums and comparisons at the macro level. They stay on rows of bytes: to transpose them into numbers would cost more.
#include "cmodel/pixelflow/macro_kernels.h"
#include "cmodel/pixelflow/pixel_row_alu.h"

namespace pixelflow::macro {

using namespace vectors;

namespace {

/// The bytes of an operand in a group of elements, lowest first, with as many bytes of its sign behind as one asks for.
class ByteReader {
 public:
  ByteReader(const Operand& operand, const PixelRow& row)
      : operand_(operand), row_(row), constant_(constant_of(operand)) {}

  PIXELFLOW_INLINE Bytes get(int byte, int first_lane) const {
    if (operand_.uniform) return fill<Bytes>(byte < 8 ? constant_ >> (8 * byte) & 0xFF : extension_of_constant());
    if (byte < operand_.bytes) return load(row_.memory(operand_.address + byte) + first_lane);
    if (!operand_.is_signed) return Bytes{};
    return top_bit(load(row_.memory(operand_.address + operand_.bytes - 1) + first_lane));
  }

 private:
  std::uint64_t extension_of_constant() const { return operand_.is_signed && constant_ >> 63 ? 0xFF : 0; }

  const Operand& operand_;
  const PixelRow& row_;
  std::uint64_t constant_;
};

}  // namespace

void add(const Operation& o, PixelRow& row) {
  const ByteReader a(o.a, row), b(o.b, row);
  const bool copies = o.code == Code::Copy;
  const Bytes invert = fill<Bytes>(o.code == Code::Sub ? 0xFF : 0);
  for (int at = 0; at < row.padded_lanes(); at += kGroup) {
    if (!any_enabled(row, at)) continue;
    const Bytes e = load(row.enable() + at);
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
      std::uint8_t* const to = row.memory(o.d.address + byte) + at;
      store(to, select(e, sums[byte], load(to)));
    }
  }
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
