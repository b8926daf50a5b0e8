// What a tile of pixel elements does with its accumulator: products, shifts, the division step.
#include <utility>

#include "cmodel/pixelflow/pixel_row_alu.h"
#include "cmodel/pixelflow/pixel_row_state.h"

namespace pixelflow {

using namespace vectors;

namespace {

/// Products of 64 pairs of bytes: low and high byte, and the byte that continues the sign.
struct Products {
  Bytes low, high, sign;
};

template <bool SignedA, bool SignedB>
PIXELFLOW_INLINE Products multiply_bytes(Bytes a, Bytes b) {
  // Bytes 0, 2, 4... and 1, 3, 5... of a vector, each extended to 16 bits; the product of two bytes fits in 16.
  const auto even = [](Bytes v, bool is_signed) {
    if (is_signed)
      return reinterpret_cast<Halves>(reinterpret_cast<SignedHalves>(reinterpret_cast<Halves>(v) << 8) >> 8);
    return reinterpret_cast<Halves>(v) & std::uint16_t{0xFF};
  };
  const auto odd = [](Bytes v, bool is_signed) {
    if (is_signed) return reinterpret_cast<Halves>(reinterpret_cast<SignedHalves>(v) >> 8);
    return reinterpret_cast<Halves>(v) >> 8;
  };
  const Halves e = even(a, SignedA) * even(b, SignedB), o = odd(a, SignedA) * odd(b, SignedB);
  const Bytes high = reinterpret_cast<Bytes>(e >> 8 | (o & std::uint16_t{0xFF00}));
  return {reinterpret_cast<Bytes>((e & std::uint16_t{0xFF}) | o << 8), high,
          SignedA || SignedB ? top_bit(high) : Bytes{}};
}

/// The four rows of the accumulator, lowest byte first.
using WideRows = std::uint8_t* const[4];

template <bool SignedA, bool SignedB>
void multiply_add(const WideRows& w, const std::uint8_t* a, std::ptrdiff_t a_stride, const std::uint8_t* b,
                  std::ptrdiff_t b_stride, int vectors) {
  for (int v = 0; v < vectors; ++v) {
    const Products product = multiply_bytes<SignedA, SignedB>(load(a + v * a_stride), load(b + v * b_stride));
    const Bytes addend[4] = {product.low, product.high, product.sign, product.sign};
    Bytes carry{};
    for (int byte = 0; byte < 4; ++byte) {
      const Bytes old = load(w[byte] + v * kWidth);
      const Bytes sum = old + addend[byte] - carry;
      store(w[byte] + v * kWidth, sum);
      carry = top_bit(carry_bit(old, addend[byte], sum));
    }
  }
}

}  // namespace

void PixelRow::multiply(const Instruction& i) {
  const bool immediate = i.p == static_cast<std::uint8_t>(P::Immediate);
  const std::uint8_t* const a = immediate ? state_->immediate : state_->x;
  const std::ptrdiff_t a_stride = immediate ? 0 : kWidth;
  const Source b = q_source(i);
  const WideRows w = {wide(0), wide(1), wide(2), wide(3)};
  const auto loop = i.set_c ? (i.set_s ? multiply_add<true, true> : multiply_add<true, false>)
                            : (i.set_s ? multiply_add<false, true> : multiply_add<false, false>);
  loop(w, a, a_stride, b.row, b.stride, vectors_);
}

void PixelRow::shift(const Instruction& i) {
  const When when = static_cast<When>(i.p);
  if (i.p > static_cast<std::uint8_t>(When::Normalize)) return;
  State& t = *state_;
  const bool left = i.fn == static_cast<std::uint8_t>(Wide::ShiftLeft);
  const Fill comes_in = static_cast<Fill>(i.cin);
  const int distance = 1 << i.at, rest = 8 - distance;
  const Bytes count = fill<Bytes>(distance), x_bit = fill<Bytes>(1 << (i.imm & 7));
  const Bytes top_bits = fill<Bytes>(0xFF << rest), low_bits = fill<Bytes>(0xFF >> rest);
  const WideRows rows = {wide(0), wide(1), wide(2), wide(3)};

  for (int v = 0; v < vectors_; ++v) {
    const int at = v * kWidth;
    Bytes w[4], shifted[4];
    for (int byte = 0; byte < 4; ++byte) w[byte] = load(rows[byte] + at);

    Bytes happens = load(kOnes);
    if (when == When::K) happens = load(t.k + at);
    if (when == When::XBit) happens = ~is_zero(load(t.x + at) & x_bit);
    if (when == When::Normalize) happens = is_zero(w[3] & top_bits) & reinterpret_cast<Bytes>(load(t.x + at) > count);

    if (left) {
      for (int byte = 0; byte < 4; ++byte) {
        const Bytes below = byte > 0 ? w[byte - 1] : Bytes{};
        shifted[byte] = distance == 8 ? below : shift_left(w[byte], distance) | shift_right(below, rest);
      }
      if (when == When::Normalize) store(t.x + at, load(t.x + at) - (happens & count));
    } else {
      Bytes above{};
      if (comes_in == Fill::Sign) above = top_bit(w[3]);
      if (comes_in == Fill::C) above = load(t.c + at);
      for (int byte = 3; byte >= 0; --byte) {
        shifted[byte] = distance == 8 ? above : shift_right(w[byte], distance) | shift_left(above, rest);
        above = w[byte];
      }
      if (comes_in == Fill::Jam) {
        const Bytes lost = w[0] & low_bits;
        shifted[0] |= ~is_zero(lost) & std::uint8_t{1};
      }
    }
    for (int byte = 0; byte < 4; ++byte) store(rows[byte] + at, select(happens, shifted[byte], w[byte]));
  }
}

void PixelRow::divide(const Instruction& i) {
  State& t = *state_;
  const WideRows rows = {wide(0), wide(1), wide(2), wide(3)};
  for (int v = 0; v < vectors_; ++v) {
    const int at = v * kWidth;
    const Bytes x = load(t.x + at);
    const Bytes quotient = ~(load(t.s + at) ^ load(t.k + at) ^ load(t.c + at));
    if (i.set_c || i.set_s) store(t.x + at, (x + x) | (i.set_c ? quotient & std::uint8_t{1} : Bytes{}));
    if (i.set_c) store(t.k + at, quotient);
    if (!i.set_s) continue;
    store(t.s + at, top_bit(load(rows[i.at] + at)));
    Bytes in = shift_right(x, 7);
    for (std::uint8_t* const row : rows) {
      const Bytes old = load(row + at);
      store(row + at, (old + old) | in);
      in = shift_right(old, 7);
    }
  }
}

void PixelRow::step_wide(const Instruction& i) {
  switch (static_cast<Wide>(i.fn)) {
    case Wide::Clear: std::memset(state_->w, 0, sizeof state_->w); break;
    case Wide::Multiply: multiply(i); break;
    case Wide::ShiftRight:
    case Wide::ShiftLeft: shift(i); break;
    case Wide::Divide: divide(i); break;
    default: break;
  }
}

}  // namespace pixelflow
