// Where a function of one number passes through zero.
#pragma once

#include <algorithm>
#include <cmath>

namespace scanline {

/// Where in [0, 1] a function passes from below 0 to above: by the ITP method (Oliveira, Takahashi 2020), never in more
/// steps than halving would take, and one.
template <typename Function>
double root(Function&& function) {
  constexpr double kEnough = 0x1p-44;
  double low = 0, high = 1, at_low = function(low), at_high = function(high);
  double halved = 1;  // what halving would have left of the interval by now, twice
  while (high - low > 2 * kEnough) {
    const double middle = (low + high) / 2, width = high - low;
    const double slack = halved - width / 2;
    halved /= 2;
    double secant = (at_high * low - at_low * high) / (at_high - at_low);
    if (!(secant >= low && secant <= high)) secant = middle;  // no change of sign, or no number
    const double towards = middle < secant ? -1 : 1, nudge = 0.2 * width * width;
    const double truncated = nudge <= std::abs(middle - secant) ? secant + towards * nudge : middle;
    const double t = std::abs(truncated - middle) <= slack ? truncated : middle - towards * slack;
    const double value = function(t);
    if (value == 0) return t;
    (value < 0 ? low : high) = t;
    (value < 0 ? at_low : at_high) = value;
  }
  return (low + high) / 2;
}

}  // namespace scanline
