#include "scanline/field.h"

#include <algorithm>
#include <cmath>

#include "scanline/fields/geometry.h"

namespace scanline {

glm::dvec3 Field::normal(const glm::dvec3& point) const {
  const glm::dvec3 p = reachable(point);
  const Bounds box = bounds();
  // In proportion to the numbers at hand: the cube root of the doubles' precision balances rounding and curvature.
  double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  for (int k = 0; k < 3; ++k) {
    if (std::isfinite(box.high[k] - box.low[k])) size = std::max(size, box.high[k] - box.low[k]);
  }
  const double step = 6e-6 * std::max(size, 1e-100);
  glm::dvec3 gradient;
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 before = p, after = p;
    before[k] -= step;
    after[k] += step;
    gradient[k] = distance(after) - distance(before);
  }
  return unit_or(gradient / step, {0, 1, 0});
}

}  // namespace scanline
