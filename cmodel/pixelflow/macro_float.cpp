// Float arithmetic at the macro level, in the host's IEEE single precision: each operation alone and rounded to nearest
// even (the library is compiled without contraction), NaN in one form. Sixteen elements a vector.
#include <cmath>
#include <stdexcept>

#include "cmodel/pixelflow/macro.h"
#include "cmodel/pixelflow/macro_kernels.h"

namespace pixelflow {

void check_host_arithmetic() {
  const volatile float one = 1.0f, quarter_step = 0x1p-25f, most_of_half_step = 0x1.8p-24f, least_normal = 0x1p-126f,
                       half = 0.5f;
  const volatile float below_normal = 0x1p-149f, big = 0x1p120f;
  const bool nearest = one + quarter_step == one && one + most_of_half_step == 0x1.000002p0f &&
                       -one - most_of_half_step == -0x1.000002p0f;
  const bool results_subnormal = least_normal * half != 0.0f, operands_subnormal = below_normal * big != 0.0f;
  if (!nearest || !results_subnormal || !operands_subnormal) {
    throw std::runtime_error("the host's float arithmetic does not round to nearest even with subnormal numbers");
  }
}

namespace macro {

using namespace vectors;

namespace {

constexpr std::uint32_t kNan = 0x7FC00000, kSign = 0x80000000, kExponent = 0x7F800000;

/// Subnormal numbers to zeros of their sign.
PIXELFLOW_INLINE Words flushed(Words bits) {
  const Words is_small = reinterpret_cast<Words>((bits & kExponent) == 0);
  return bits & ~(is_small & ~kSign);
}

PIXELFLOW_INLINE Words one_nan(Floats value) {
  const Words is_number = reinterpret_cast<Words>(value == value);
  return select(is_number, reinterpret_cast<Words>(value), fill<Words>(kNan));
}

PIXELFLOW_INLINE Floats root(Floats value) {
  for (int n = 0; n < kWidth / 4; ++n) value[n] = std::sqrt(value[n]);
  return value;
}

template <Code C>
PIXELFLOW_INLINE Floats apply(Floats a, Floats b) {
  if constexpr (C == Code::FloatAdd) return a + b;
  if constexpr (C == Code::FloatSub) return a - b;
  if constexpr (C == Code::FloatMultiply) return a * b;
  if constexpr (C == Code::FloatDivide) return a / b;
  if constexpr (C == Code::FloatSquareRoot) return root(a);
}

template <Code C, bool Flush>
void arithmetic(const Operation& o, PixelRow& row) {
  const Operand& second = C == Code::FloatSquareRoot ? o.a : o.b;
  const WordWriter writer(o.d, row);
  with_readers(o.a, second, row, [&](const auto& a_reader, const auto& b_reader) {
    each_enabled_group(row, [&](int at, bool all) {
      const WordGroup a = a_reader.get(at), b = b_reader.get(at);
      WordGroup d;
      for (int n = 0; n < 4; ++n) {
        const Words p = Flush ? flushed(a.part[n]) : a.part[n], q = Flush ? flushed(b.part[n]) : b.part[n];
        d.part[n] = one_nan(apply<C>(reinterpret_cast<Floats>(p), reinterpret_cast<Floats>(q)));
        if (Flush) d.part[n] = flushed(d.part[n]);
      }
      writer.put(at, all, d);
    });
  });
}

template <Code C>
void arithmetic(const Operation& o, PixelRow& row) {
  o.flush ? arithmetic<C, true>(o, row) : arithmetic<C, false>(o, row);
}

}  // namespace

void float_arithmetic(const Operation& o, PixelRow& row) {
  switch (o.code) {
    case Code::FloatAdd: arithmetic<Code::FloatAdd>(o, row); break;
    case Code::FloatSub: arithmetic<Code::FloatSub>(o, row); break;
    case Code::FloatMultiply: arithmetic<Code::FloatMultiply>(o, row); break;
    case Code::FloatDivide: arithmetic<Code::FloatDivide>(o, row); break;
    case Code::FloatSquareRoot: arithmetic<Code::FloatSquareRoot>(o, row); break;
    default: break;
  }
}

void float_compare(const Operation& o, PixelRow& row) {
  std::uint8_t* const condition = row.condition();
  const int lanes = row.padded_lanes();
  with_readers(o.a, o.b, row, [&](const auto& a_reader, const auto& b_reader) {
    for (int at = 0; at < lanes; at += kGroup) {
      const WordGroup a = a_reader.get(at), b = b_reader.get(at);
      WordGroup holds;
      for (int n = 0; n < 4; ++n) {
        const Floats p = reinterpret_cast<Floats>(o.flush ? flushed(a.part[n]) : a.part[n]);
        const Floats q = reinterpret_cast<Floats>(o.flush ? flushed(b.part[n]) : b.part[n]);
        holds.part[n] = o.code == Code::FloatLess        ? reinterpret_cast<Words>(p < q)
                        : o.code == Code::FloatLessEqual ? reinterpret_cast<Words>(p <= q)
                                                         : reinterpret_cast<Words>(p == q);
      }
      Bytes rows[4];
      rows_of_words(holds, rows);
      store(condition + at, rows[0]);
    }
  });
}

}  // namespace macro
}  // namespace pixelflow
