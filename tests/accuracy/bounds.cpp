#include "tests/accuracy/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace accuracy {
namespace {

using std::numbers::ln2;
using std::numbers::pi;

constexpr double kNone = std::numeric_limits<double>::infinity();

// A function on its reduced range.
struct Range {
  double (*value)(double);
  double (*slope)(double);
  double low;
  double high;
};

constexpr Range kSine = {[](double t) { return std::sin(pi / 2 * t); },
                         [](double t) { return pi / 2 * std::cos(pi / 2 * t); }, 0, 1};
constexpr Range kTangent = {[](double w) { return std::tan(pi / 4 * w); },
                            [](double w) { return pi / 4 / (std::cos(pi / 4 * w) * std::cos(pi / 4 * w)); }, 0, 1};
constexpr Range kArcsine = {[](double s) { return std::asin(s); },  //
                            [](double s) { return 1 / std::sqrt(1 - s * s); }, 0, 0.5};
constexpr Range kArctangent = {[](double q) { return std::atan(q); },  //
                               [](double q) { return 1 / (1 + q * q); }, 0, 1};
constexpr Range kPower = {[](double f) { return std::exp2(f); },  //
                          [](double f) { return ln2 * std::exp2(f); }, 0, 1};
constexpr Range kLogarithm = {[](double m) { return std::log2(m); },  //
                              [](double m) { return 1 / (ln2 * m); }, 1, 2};

// Largest errors of the cubic on its range: absolute, relative to the function, and relative to what the function lacks
// of its value at the upper end.
struct CubicError {
  double absolute = 0;
  double relative = 0;
  double from_top = 0;
};

CubicError error_of(const Range& range) {
  const double width = range.high - range.low;
  const double low = range.value(range.low);
  const double high = range.value(range.high);
  const double low_slope = range.slope(range.low) * width;
  const double high_slope = range.slope(range.high) * width;
  CubicError worst;
  constexpr int kSteps = 1 << 14;  // the error is smooth: its top is missed by 2^-26 of itself or so
  for (int i = 1; i < kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const double r = 1 - t;
    const double cubic = r * r * ((1 + 2 * t) * low + t * low_slope) + t * t * ((1 + 2 * r) * high - r * high_slope);
    const double truth = range.value(range.low + t * width);
    const double error = std::fabs(cubic - truth);
    worst.absolute = std::max(worst.absolute, error);
    worst.relative = std::max(worst.relative, error / truth);
    worst.from_top = std::max(worst.from_top, error / (high - truth));
  }
  return worst;
}

struct Method {
  std::string_view function;
  const Range& range;
  double (*relative)(const CubicError&);
  double (*absolute)(const CubicError&);
  double largest;  // result: half its last place is added to the absolute error
};

double relative(const CubicError& e) { return e.relative; }
double absolute(const CubicError& e) { return e.absolute; }
double unbounded(const CubicError&) { return kNone; }
// An upper half that is the inverse: 1 / (1 - r) - 1.
double inverse_too(const CubicError& e) { return e.relative / (1 - e.relative); }
double twice(const CubicError& e) { return 2 * e.absolute; }
// asin: v below 1/2; above it pi/2 - 2v, which is at least pi/6.
double arcsine(const CubicError& e) { return std::max(e.relative, 2 * e.absolute / (pi / 6)); }
// acos: 2v above 1/2; pi/2 -+ v, at least pi/3, within; pi - 2v, at least 2 pi/3, below -1/2.
double arccosine(const CubicError& e) { return std::max(e.relative, e.absolute / (pi / 3)); }
// v up to the diagonal; pi/2 -+ v and pi - v, at least pi/4, beyond it.
double arctangent(const CubicError& e) { return std::max(e.relative, e.absolute / (pi / 4)); }
// E + f, 0 <= f < 1: at least f where E is not negative, and 1 - f from zero where it is.
double logarithm(const CubicError& e) { return std::max(e.relative, e.from_top); }

constexpr Method kMethods[] = {
    // The reduction is exact: the result is the cubic with a sign.
    {"fast_sin", kSine, relative, absolute, 1},
    {"fast_cos", kSine, relative, absolute, 1},
    {"fast_tan", kTangent, inverse_too, unbounded, kNone},  // poles
    {"fast_asin", kArcsine, arcsine, twice, pi / 2},
    {"fast_acos", kArcsine, arccosine, twice, pi},
    {"fast_atan", kArctangent, arctangent, absolute, pi / 2},
    {"fast_atan2", kArctangent, arctangent, absolute, pi},
    // 2^E 2^f: the factor leaves the relative error as it is.
    {"fast_exp", kPower, relative, unbounded, kNone},
    {"fast_exp2", kPower, relative, unbounded, kNone},
    {"fast_log", kLogarithm, logarithm, [](const CubicError& e) { return ln2 * e.absolute; }, 149 * ln2},
    {"fast_log2", kLogarithm, logarithm, absolute, 149},
};

// For the roundings of coefficients and of fixed point: below 2^-25 of the result, or of the largest addend, which is
// less than this part of the least error (that of the cubic of exp2, above 2^-11).
constexpr double kRoundings = 1 + 0x1p-10;
constexpr double kHalfPlace = 0x1p-24;  // of a number in [1, 2)

}  // namespace

Bound bound_of(std::string_view function) {
  for (const Method& method : kMethods) {
    if (method.function != function) continue;
    const CubicError error = error_of(method.range);
    const double half_place = std::isinf(method.largest) ? kNone : std::ldexp(kHalfPlace, std::ilogb(method.largest));
    return {method.relative(error) * kRoundings + kHalfPlace, method.absolute(error) * kRoundings + half_place};
  }
  throw std::invalid_argument("no bound of " + std::string(function));
}

bool is_within(const Tally& tally, const Bound& bound) {
  return tally.max_relative <= bound.relative && tally.max_absolute <= bound.absolute;
}

}  // namespace accuracy
