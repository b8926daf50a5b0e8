// A line of sight through one distance field, in the field's own space: where it enters the solid. Sphere tracing: what
// the field answers at a point is a length that can be walked without meeting the surface.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "scanline/field.h"

namespace scanline {

/// Places on the line are told in lengths of its direction, which need not be a unit vector. A place counts as inside
/// or outside where the distance is more than 1e-10 of the numbers at hand (the origin's, the way along the line, the
/// field's bounds); an entry is where outside turns into inside, and is found to about 1e-13 of them.
class FieldLine {
 public:
  /// `evaluations` counts those of the field. The field must outlive the line.
  FieldLine(const Field& field, const Bounds& bounds, const glm::dvec3& origin, const glm::dvec3& direction,
            std::uint64_t& evaluations);

  /// Where the line first enters the solid with from <= t <= to; a line that begins inside has to come out first, one
  /// that begins on the surface and leads inwards enters there. Nothing after `most_steps` steps, which a line that
  /// keeps close to a surface may need. Where neither `to` nor the field's bounds end the search, `reach` does.
  std::optional<double> first_entry(double from, double to, double reach, int most_steps);

  /// The entry that belongs to a place t >= 0 near the surface, in front of it or behind: back from t while that is
  /// inside; forward as long as the surface comes closer, or back through the solid where t is behind it. How far to
  /// look for it where the surface recedes follows from the distance at t: not farther than in a sphere of the field's
  /// size whose surface is so far away. Nothing where there is none.
  std::optional<double> entry_near(double t);

 private:
  struct Sample {
    double t = 0, distance = 0;
  };
  enum class Side { kOutside, kSurface, kInside };

  Sample at(double t);
  double tolerance(double t) const;
  Side side(const Sample& sample) const;
  /// The next place after a sample, no farther than the surface is; `sign` -1: backwards.
  double step(const Sample& sample, double sign) const;
  bool clip(double& from, double& to) const;
  double refine(Sample outside, Sample inside);
  double entry_at(Sample start);
  std::optional<double> entry_before(Sample inside);
  std::optional<double> entry_ahead(Sample start, Sample next, double reach);
  std::optional<double> entry_behind(Sample start, double reach);

  const Field& field_;
  Bounds box_;  // a little larger than the field's, so that a line comes into it outside of the solid
  glm::dvec3 origin_, direction_;
  std::uint64_t& evaluations_;
  double length_;  // of the direction
  double size_;    // of the origin's coordinates and the box
  bool is_line_;   // origin and direction are numbers, and the direction leads somewhere
};

}  // namespace scanline
