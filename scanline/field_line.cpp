#include "scanline/field_line.h"

#include <algorithm>
#include <cmath>

namespace scanline {
namespace {

constexpr double kTolerance = 1e-10;
constexpr double kFinest = 1e-13;
constexpr int kMostRefinements = 100;
/// Of the search for the entry near a place.
constexpr int kMostNearSteps = 4000;
/// Of the tolerance, in the search for the sides of a surface.
constexpr int kMostDoublings = 10;
constexpr double kMargin = 1e-6;
/// For a line from the origin of a field without bounds: what is in proportion to nothing would not move.
constexpr double kLeast = 1e-100;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The largest finite coordinate of a box.
double extent(const Bounds& box) {
  double result = 0;
  for (int k = 0; k < 3; ++k) {
    for (const double x : {box.low[k], box.high[k]}) {
      if (std::isfinite(x)) result = std::max(result, std::abs(x));
    }
  }
  return result;
}

}  // namespace

FieldLine::FieldLine(const Field& field, const Bounds& bounds, const glm::dvec3& origin, const glm::dvec3& direction,
                     std::uint64_t& evaluations)
    : field_(field),
      box_(bounds),
      origin_(origin),
      direction_(direction),
      evaluations_(evaluations),
      length_(std::hypot(direction.x, direction.y, direction.z)),
      size_(std::max(largest(origin) + extent(bounds), kLeast)),
      is_line_(is_finite(origin) && std::isfinite(length_) && length_ > 0 && std::isfinite(1 / length_)) {
  const glm::dvec3 margin(kMargin * size_);
  box_.low -= margin;
  box_.high += margin;
}

FieldLine::Sample FieldLine::at(double t) {
  ++evaluations_;
  return {t, field_.distance(origin_ + t * direction_)};
}

double FieldLine::tolerance(double t) const { return kTolerance * (size_ + std::abs(t) * length_); }

FieldLine::Side FieldLine::side(const Sample& sample) const {
  const double tolerance = this->tolerance(sample.t);
  if (sample.distance > tolerance) return Side::kOutside;
  return sample.distance < -tolerance ? Side::kInside : Side::kSurface;
}

double FieldLine::step(const Sample& sample, double sign) const {
  const double next = sample.t + sign * std::max(std::abs(sample.distance), tolerance(sample.t)) / length_;
  return next != sample.t ? next : std::nextafter(next, sign * HUGE_VAL);
}

/// False when the line passes the box by.
bool FieldLine::clip(double& from, double& to) const {
  for (int k = 0; k < 3; ++k) {
    if (direction_[k] == 0) {
      if (origin_[k] < box_.low[k] || origin_[k] > box_.high[k]) return false;
      continue;
    }
    const double low = (box_.low[k] - origin_[k]) / direction_[k], high = (box_.high[k] - origin_[k]) / direction_[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return from <= to;
}

/// The false position method, kept from standing still by Illinois' rule.
double FieldLine::refine(Sample outside, Sample inside) {
  double outside_weight = outside.distance, inside_weight = inside.distance;
  const double finest = kFinest * (size_ + std::max(std::abs(outside.t), std::abs(inside.t)) * length_) / length_;
  for (int n = 0; n < kMostRefinements && std::abs(inside.t - outside.t) > finest; ++n) {
    const double width = inside.t - outside.t, share = outside_weight / (outside_weight - inside_weight);
    // Never at an end: where one has come close to the root, the other one is to come there too.
    const double least = finest / 2 / std::abs(width);
    const Sample middle = at(outside.t + std::clamp(share, least, 1 - least) * width);
    if (middle.distance == 0) return middle.t;
    if (middle.distance > 0) {
      outside = middle;
      outside_weight = middle.distance;
      inside_weight /= 2;
    } else {
      inside = middle;
      inside_weight = middle.distance;
      outside_weight /= 2;
    }
  }
  return outside.distance < -inside.distance ? outside.t : inside.t;
}

std::optional<double> FieldLine::first_entry(double from, double to, double reach, int most_steps) {
  if (!is_line_ || !std::isfinite(from) || !(from <= to)) return std::nullopt;
  double t = from, end = to;
  if (!clip(t, end)) return std::nullopt;
  if (!std::isfinite(end)) end = std::max(t, reach);
  std::optional<Sample> outside;
  std::optional<double> on_surface;  // of a line that has been nowhere else
  for (int n = 0; n < most_steps && std::isfinite(t); ++n) {
    const Sample sample = at(t);
    switch (side(sample)) {
      case Side::kOutside:
        outside = sample;
        on_surface.reset();
        break;
      case Side::kInside:
        if (outside) return refine(*outside, sample);
        if (on_surface) return on_surface;
        break;
      case Side::kSurface:
        if (n == 0 || on_surface) on_surface = t;
        break;
    }
    if (!(t < end)) return std::nullopt;
    t = std::min(step(sample, 1), end);
  }
  return std::nullopt;
}

std::optional<double> FieldLine::entry_near(double t) {
  if (!is_line_ || !std::isfinite(t) || t < 0) return std::nullopt;
  const Sample start = at(t);
  if (side(start) == Side::kSurface) return entry_at(start);
  if (side(start) == Side::kInside) return entry_before(start);
  // A chord of a sphere lies within its surface by no more than a certain part of its length.
  double diameter = glm::length(box_.high - box_.low);
  if (!std::isfinite(diameter)) diameter = size_ + t * length_;
  const double reach = 2 * std::sqrt(2 * diameter * start.distance) / length_;
  const Sample ahead = at(step(start, 1));
  const bool approaches = ahead.distance < start.distance;
  auto entry = approaches ? entry_ahead(start, ahead, reach) : entry_behind(start, reach);
  if (!entry) entry = approaches ? entry_behind(start, reach) : entry_ahead(start, ahead, reach);
  return entry;
}

/// Where a place on the surface has an outside and an inside close by, exactly there; otherwise at the place itself.
double FieldLine::entry_at(Sample start) {
  const auto look = [&](Side wanted, double sign) -> std::optional<Sample> {
    double step = sign * tolerance(start.t) / length_;
    for (int n = 0; n < kMostDoublings; ++n, step *= 2) {
      const Sample sample = at(start.t + step);
      if (side(sample) == wanted) return sample;
    }
    return std::nullopt;
  };
  const auto inside = look(Side::kInside, 1);
  if (!inside) return start.t;
  const auto outside = look(Side::kOutside, -1);
  return outside ? refine(*outside, *inside) : start.t;
}

std::optional<double> FieldLine::entry_before(Sample inside) {
  Sample sample = inside;
  for (int n = 0; n < kMostNearSteps && sample.t > 0; ++n) {
    sample = at(std::max(step(sample, -1), 0.0));
    if (side(sample) == Side::kOutside) return refine(sample, inside);
    if (side(sample) == Side::kInside) inside = sample;
  }
  return std::nullopt;
}

std::optional<double> FieldLine::entry_ahead(Sample start, Sample next, double reach) {
  Sample outside = start, sample = start;
  for (int n = 0; n < kMostNearSteps; ++n) {
    const bool recedes = next.distance > sample.distance;
    sample = next;
    if (side(sample) == Side::kInside) return refine(outside, sample);
    if (side(sample) == Side::kOutside) outside = sample;
    if (recedes && sample.t - start.t > reach) return std::nullopt;
    next = at(step(sample, 1));
  }
  return std::nullopt;
}

std::optional<double> FieldLine::entry_behind(Sample start, double reach) {
  Sample sample = start;
  for (int n = 0; n < kMostNearSteps && sample.t > 0 && start.t - sample.t <= reach; ++n) {
    sample = at(std::max(step(sample, -1), 0.0));
    if (side(sample) == Side::kInside) return entry_before(sample);
  }
  return std::nullopt;
}

}  // namespace scanline
