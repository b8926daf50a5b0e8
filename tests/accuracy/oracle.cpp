#include "tests/accuracy/oracle.h"

#include <mpfr.h>

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

namespace accuracy {
namespace {

using DoubleLoop = void (*)(const uint32_t*, const uint32_t*, double*, std::size_t);
using MpfrFunction = int (*)(mpfr_t, const mpfr_t, const mpfr_t);

double number(uint32_t bits) { return static_cast<double>(std::bit_cast<float>(bits)); }

template <double (*Function)(double)>
void unary_loop(const uint32_t* x, const uint32_t*, double* value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) value[i] = Function(number(x[i]));
}
template <double (*Function)(double, double)>
void binary_loop(const uint32_t* x, const uint32_t* y, double* value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) value[i] = Function(number(x[i]), number(y[i]));
}
template <int (*Function)(mpfr_t, const mpfr_t, mpfr_rnd_t)>
int unary_mpfr(mpfr_t result, const mpfr_t x, const mpfr_t) {
  return Function(result, x, MPFR_RNDN);
}
template <int (*Function)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t)>
int binary_mpfr(mpfr_t result, const mpfr_t x, const mpfr_t y) {
  return Function(result, x, y, MPFR_RNDN);
}

double reciprocal_root(double x) { return 1.0 / std::sqrt(x); }
int mpfr_reciprocal_root(mpfr_t result, const mpfr_t x, mpfr_rnd_t rounding) {
  return mpfr_rec_sqrt(result, x, rounding);
}

struct Entry {
  std::string_view name;
  DoubleLoop loop;
  MpfrFunction mpfr;
};

constexpr Entry kEntries[] = {
    {"sin", unary_loop<::sin>, unary_mpfr<mpfr_sin>},
    {"cos", unary_loop<::cos>, unary_mpfr<mpfr_cos>},
    {"tan", unary_loop<::tan>, unary_mpfr<mpfr_tan>},
    {"asin", unary_loop<::asin>, unary_mpfr<mpfr_asin>},
    {"acos", unary_loop<::acos>, unary_mpfr<mpfr_acos>},
    {"atan", unary_loop<::atan>, unary_mpfr<mpfr_atan>},
    {"exp", unary_loop<::exp>, unary_mpfr<mpfr_exp>},
    {"exp2", unary_loop<::exp2>, unary_mpfr<mpfr_exp2>},
    {"log", unary_loop<::log>, unary_mpfr<mpfr_log>},
    {"log2", unary_loop<::log2>, unary_mpfr<mpfr_log2>},
    {"inversesqrt", unary_loop<reciprocal_root>, unary_mpfr<mpfr_reciprocal_root>},
    {"atan2", binary_loop<::atan2>, binary_mpfr<mpfr_atan2>},
    {"pow", binary_loop<::pow>, binary_mpfr<mpfr_pow>},
};

const Entry& entry_of(std::string_view function) {
  const std::string_view name = function.starts_with("fast_") ? function.substr(5) : function;
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return entry;
  }
  throw std::invalid_argument("no such function: " + std::string(function));
}

constexpr uint32_t kNan = 0x7FC00000u;
constexpr double kBelow = 1.0 - 0x1p-50;
constexpr double kAbove = 1.0 + 0x1p-50;

uint32_t bits_of(double value) { return std::bit_cast<uint32_t>(static_cast<float>(value)); }

}  // namespace

struct Oracle::State {
  explicit State(const Entry& which) : entry(which) {
    mpfr_inits2(24, x, y, static_cast<mpfr_ptr>(nullptr));
    mpfr_init2(result, 200);
  }
  ~State() { mpfr_clears(x, y, result, static_cast<mpfr_ptr>(nullptr)); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  uint32_t decide(uint32_t x_bits, uint32_t y_bits) {
    mpfr_set_flt(x, std::bit_cast<float>(x_bits), MPFR_RNDN);
    mpfr_set_flt(y, std::bit_cast<float>(y_bits), MPFR_RNDN);
    entry.mpfr(result, x, y);
    return std::bit_cast<uint32_t>(mpfr_get_flt(result, MPFR_RNDN));
  }

  const Entry& entry;
  mpfr_t x, y, result;
};

Oracle::Oracle(std::string_view function) : state_(std::make_unique<State>(entry_of(function))) {}
Oracle::~Oracle() = default;

void Oracle::values(const uint32_t* x, const uint32_t* y, double* value, uint32_t* rounded, std::size_t count) {
  state_->entry.loop(x, y, value, count);
  bool unsure = false;
  for (std::size_t i = 0; i < count; ++i) {
    const uint32_t below = bits_of(value[i] * kBelow);
    const uint32_t above = bits_of(value[i] * kAbove);
    const bool nan = value[i] != value[i];
    rounded[i] = nan ? kNan : bits_of(value[i]);
    unsure |= !nan & (below != above);
  }
  if (!unsure) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (value[i] != value[i] || bits_of(value[i] * kBelow) == bits_of(value[i] * kAbove)) continue;
    rounded[i] = state_->decide(x[i], y != nullptr ? y[i] : 0u);
  }
}

}  // namespace accuracy
