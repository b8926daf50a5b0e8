// What the fast functions may be wrong by: the error of the method itself, a cubic that meets value and slope at both
// ends of the reduced range (Olano & Lastra 1998, section 6.1.4), carried through the function's reduction. Worked out
// from the true functions in double precision; no coefficient of the library is used.
#ifndef VSG_TESTS_ACCURACY_BOUNDS_H_
#define VSG_TESTS_ACCURACY_BOUNDS_H_

#include <string_view>

#include "tests/accuracy/comparison.h"

namespace accuracy {

// Infinity where the method bounds nothing.
struct Bound {
  double relative;
  double absolute;
};

// Of a fast function; another name throws std::invalid_argument.
Bound bound_of(std::string_view function);

// Whether all largest errors are within the bound.
bool is_within(const Tally& tally, const Bound& bound);

}  // namespace accuracy

#endif
