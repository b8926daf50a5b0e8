#include "tests/microcode/float_oracle.h"

#include <bit>
#include <cmath>

namespace pixelflow_test {

using pixelflow::Code;

const std::vector<std::uint32_t>& hard_floats() {
  static const std::vector<std::uint32_t> values = [] {
    std::vector<std::uint32_t> v;
    const std::uint32_t fractions[] = {0, 1, 2, 0x3FFFFF, 0x400000, 0x400001, 0x7FFFFE, 0x7FFFFF};
    for (const std::uint32_t exponent :
         {0u, 1u, 2u, 23u, 24u, 63u, 102u, 103u, 126u, 127u, 128u, 150u, 151u, 190u, 253u, 254u, 255u}) {
      for (const std::uint32_t fraction : fractions) {
        v.push_back(exponent << 23 | fraction);
        if (fraction % 3 != 2) v.push_back(0x80000000u | exponent << 23 | fraction);
      }
    }
    return v;
  }();
  return values;
}

std::pair<std::uint32_t, std::uint32_t> random_floats(std::mt19937_64& random) {
  const auto any = [&] { return static_cast<std::uint32_t>(random()); };
  std::uint32_t a = any(), b = any();
  switch (random() % 6) {
    case 0: b = (b & 0x807FFFFF) | (a & 0x7F800000); break;                           // one exponent
    case 1: b = a ^ 0x80000000u ^ (any() & 0xFF); break;                              // cancel
    case 2: b = (b & 0x807FFFFF) | ((a + ((any() % 60) << 23)) & 0x7F800000); break;  // near exponents
    case 3:
      b = static_cast<std::uint32_t>((b & 0x807FFFFF) | ((254u << 23) - (a & 0x7F800000))) & 0xFFFFFFFFu;
      break;                         // product near 1
    case 4: a &= 0x80FFFFFF; break;  // tiny
    default: break;
  }
  return {a, b};
}

FloatOracle::FloatOracle() {
  mpfr_set_emin(-148);
  mpfr_set_emax(128);
  for (auto* number : {&x_, &y_, &r_}) mpfr_init2(*number, 24);
  mpfr_init2(wide_, 400);
}

FloatOracle::~FloatOracle() {
  for (auto* number : {&x_, &y_, &r_, &wide_}) mpfr_clear(*number);
}

std::uint32_t FloatOracle::bits(int inexact) {
  mpfr_subnormalize(r_, inexact, MPFR_RNDN);
  if (mpfr_nan_p(r_)) return 0x7FC00000;
  return std::bit_cast<std::uint32_t>(mpfr_get_flt(r_, MPFR_RNDN));
}

namespace {

std::uint32_t flushed(std::uint32_t a, bool flush) { return flush && (a & 0x7F800000) == 0 ? a & 0x80000000u : a; }

}  // namespace

std::uint32_t FloatOracle::rounded(Code code, std::uint32_t a, std::uint32_t b, bool flush) {
  mpfr_set_flt(x_, std::bit_cast<float>(flushed(a, flush)), MPFR_RNDN);
  mpfr_set_flt(y_, std::bit_cast<float>(flushed(b, flush)), MPFR_RNDN);
  int inexact = 0;
  switch (code) {
    case Code::FloatAdd: inexact = mpfr_add(r_, x_, y_, MPFR_RNDN); break;
    case Code::FloatSub: inexact = mpfr_sub(r_, x_, y_, MPFR_RNDN); break;
    case Code::FloatMultiply: inexact = mpfr_mul(r_, x_, y_, MPFR_RNDN); break;
    case Code::FloatDivide: inexact = mpfr_div(r_, x_, y_, MPFR_RNDN); break;
    case Code::FloatSquareRoot: inexact = mpfr_sqrt(r_, x_, MPFR_RNDN); break;
    default: break;
  }
  return flushed(bits(inexact), flush);
}

bool FloatOracle::compares(Code code, std::uint32_t a, std::uint32_t b, bool flush) {
  mpfr_set_flt(x_, std::bit_cast<float>(flushed(a, flush)), MPFR_RNDN);
  mpfr_set_flt(y_, std::bit_cast<float>(flushed(b, flush)), MPFR_RNDN);
  switch (code) {
    case Code::FloatLess: return mpfr_less_p(x_, y_);
    case Code::FloatLessEqual: return mpfr_lessequal_p(x_, y_);
    default: return mpfr_equal_p(x_, y_);
  }
}

std::uint32_t FloatOracle::from_fixed(std::uint64_t raw, const pixelflow::Operand& type, int scale) {
  const int width = 8 * type.bytes;
  const bool negative = type.is_signed && raw >> (width - 1) & 1;
  if (negative) {
    const std::uint64_t magnitude = (~raw + 1) & (width == 64 ? ~0ull : (1ull << width) - 1);
    mpfr_set_ui(wide_, magnitude, MPFR_RNDN);
    mpfr_neg(wide_, wide_, MPFR_RNDN);
  } else {
    mpfr_set_ui(wide_, raw, MPFR_RNDN);
  }
  // The exact value may lie below the exponents that single precision has.
  mpfr_set_emin(-400);
  mpfr_mul_2si(wide_, wide_, -scale, MPFR_RNDN);
  mpfr_set_emin(-148);
  const int inexact = mpfr_set(r_, wide_, MPFR_RNDN);
  return bits(inexact);
}

std::uint64_t FloatOracle::to_fixed(std::uint32_t a, const pixelflow::Operand& type, int scale) {
  const float value = std::bit_cast<float>(a);
  if (std::isnan(value)) return 0;
  const int width = 8 * type.bytes;
  const std::uint64_t mask = width == 64 ? ~0ull : (1ull << width) - 1;
  const std::uint64_t most = type.is_signed ? mask >> 1 : mask, least = type.is_signed ? ~(mask >> 1) & mask : 0;
  if (std::isinf(value)) return value > 0 ? most : least;
  mpfr_set_emin(-600);
  mpfr_set_emax(600);
  mpfr_set_flt(wide_, value, MPFR_RNDN);
  mpfr_mul_2si(wide_, wide_, scale, MPFR_RNDN);
  mpfr_floor(wide_, wide_);
  std::uint64_t result = 0;
  const double low = type.is_signed ? -std::ldexp(1.0, width - 1) : 0.0,
               high = std::ldexp(1.0, type.is_signed ? width - 1 : width);
  if (mpfr_cmp_d(wide_, low) < 0) {
    result = least;
  } else if (mpfr_cmp_d(wide_, high) >= 0) {
    result = most;
  } else if (mpfr_sgn(wide_) < 0) {
    mpfr_neg(wide_, wide_, MPFR_RNDN);
    result = (~static_cast<std::uint64_t>(mpfr_get_ui(wide_, MPFR_RNDN)) + 1) & mask;
  } else {
    result = mpfr_get_ui(wide_, MPFR_RNDN);
  }
  mpfr_set_emin(-148);
  mpfr_set_emax(128);
  return result;
}

}  // namespace pixelflow_test
