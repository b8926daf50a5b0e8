#include "scanline/fields/operations.h"

#include <algorithm>
#include <cmath>

#include "scanline/fields/geometry.h"

namespace scanline::fields {
namespace {

std::vector<BoundedField> bounded(std::vector<FieldPointer> parts) {
  std::vector<BoundedField> result;
  result.reserve(parts.size());
  for (FieldPointer& part : parts) result.emplace_back(std::move(part));
  return result;
}

Bounds around(const std::vector<BoundedField>& parts) {
  Bounds box = parts[0].box;
  for (const BoundedField& part : parts) {
    box.low = glm::min(box.low, part.box.low);
    box.high = glm::max(box.high, part.box.high);
  }
  return box;
}

class Union final : public Field {
 public:
  explicit Union(std::vector<FieldPointer> parts) : parts_(bounded(std::move(parts))), box_(around(parts_)) {}

  double distance(const glm::dvec3& p) const override { return nearest(reachable(p)).first; }
  glm::dvec3 normal(const glm::dvec3& p) const override {
    return parts_[nearest(reachable(p)).second].field->normal(p);
  }
  Bounds bounds() const override { return box_; }

 private:
  /// The least distance, and whose it is.
  std::pair<double, std::size_t> nearest(const glm::dvec3& p) const {
    std::pair<double, std::size_t> best{kInfinite, 0};
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      // A part whose box is no nearer than what is found need not be asked; inside the box any distance is possible.
      const glm::dvec3 outside = from_box(parts_[k].box, p);
      const double least = glm::length(outside);
      if (least > 0 && least >= best.first) continue;
      double distance = parts_[k].field->distance(p);
      if (outside != glm::dvec3(0)) distance = std::max(distance, least);
      if (distance < best.first) best = {distance, k};
    }
    return best;
  }

  std::vector<BoundedField> parts_;
  Bounds box_;
};

/// The maximum of distances, those of the parts from `first_out` on with their sign turned.
class Intersection final : public Field {
 public:
  Intersection(std::vector<FieldPointer> parts, std::size_t first_out)
      : parts_(bounded(std::move(parts))), first_out_(first_out), box_(parts_[0].box) {
    for (std::size_t k = 1; k < first_out_; ++k) {
      box_.low = glm::max(box_.low, parts_[k].box.low);
      box_.high = glm::min(box_.high, parts_[k].box.high);
    }
    // Parts that have nothing in common leave nothing: a point.
    box_.high = glm::max(box_.high, box_.low);
  }

  double distance(const glm::dvec3& p) const override { return greatest(reachable(p)).first; }

  glm::dvec3 normal(const glm::dvec3& p) const override {
    const std::size_t k = greatest(reachable(p)).second;
    return parts_[k].field->normal(p) * (k < first_out_ ? 1.0 : -1.0);
  }

  Bounds bounds() const override { return box_; }

 private:
  std::pair<double, std::size_t> greatest(const glm::dvec3& p) const {
    std::pair<double, std::size_t> best{-kInfinite, 0};
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const double distance = k < first_out_ ? parts_[k].distance(p) : -parts_[k].distance(p);
      if (distance > best.first) best = {distance, k};
    }
    return best;
  }

  std::vector<BoundedField> parts_;
  std::size_t first_out_;
  Bounds box_;
};

class SmoothUnion final : public Field {
 public:
  SmoothUnion(std::vector<FieldPointer> parts, double radius)
      : parts_(bounded(std::move(parts))), radius_(radius), box_(around(parts_)) {
    const double swelling = radius / 4 * static_cast<double>(parts_.size() - 1);
    box_.low -= swelling;
    box_.high += swelling;
  }

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    double sum = parts_[0].distance(p);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      // A part whose box is out of the blend's reach has no share.
      const double least = glm::length(from_box(parts_[k].box, p));
      if (least > 0 && least - sum >= radius_) continue;
      sum = blended(sum, parts_[k].distance(p)).distance;
    }
    return sum;
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point);
    double sum = parts_[0].distance(p);
    glm::dvec3 gradient = parts_[0].field->normal(p);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const Blend b = blended(sum, parts_[k].distance(p));
      sum = b.distance;
      // The blend's own slope with respect to the share is zero: only the parts' gradients remain.
      if (b.share < 1) gradient = b.share * gradient + (1 - b.share) * parts_[k].field->normal(p);
    }
    return unit_or(gradient, {0, 1, 0});
  }

  Bounds bounds() const override { return box_; }

 private:
  struct Blend {
    double distance, share;  ///< share of the first
  };
  Blend blended(double a, double b) const {
    const double share = std::clamp(0.5 + 0.5 * ((b - a) / radius_), 0.0, 1.0);
    if (share == 1) return {a, share};
    if (share == 0) return {b, share};
    return {share * a + (1 - share) * b - radius_ * share * (1 - share), share};
  }

  std::vector<BoundedField> parts_;
  double radius_;
  Bounds box_;
};

/// Copies whose boxes are within half a spacing along every axis are asked; any other is farther than that, and the
/// distance is taken to be no more: beyond, the field steps on by that much.
class Repetition final : public Field {
 public:
  Repetition(FieldPointer part, const glm::dvec3& spacing, const glm::ivec3& counts)
      : part_(std::move(part)), spacing_(spacing), counts_(counts), reach_(kInfinite), box_(part_.box) {
    for (int k = 0; k < 3; ++k) {
      if (spacing_[k] == 0) continue;
      reach_ = std::min(reach_, spacing_[k] / 2);
      const double half = counts_[k] == 0 ? kInfinite : spacing_[k] * (counts_[k] - 1) / 2;
      box_.low[k] -= half;
      box_.high[k] += half;
    }
  }

  double distance(const glm::dvec3& p) const override {
    const glm::dvec3 q = reachable(p);
    const double near = std::min(nearest(q).distance, reach_);
    const glm::dvec3 outside = from_box(box_, q);
    return outside == glm::dvec3(0) ? near : std::max(near, glm::length(outside));
  }

  glm::dvec3 normal(const glm::dvec3& p) const override {
    const glm::dvec3 q = reachable(p);
    const Nearest near = nearest(q);
    if (near.distance < kInfinite) return part_.field->normal(near.local);
    return unit_or(from_box(box_, q), {0, 1, 0});
  }

  Bounds bounds() const override { return box_; }

 private:
  struct Nearest {
    double distance = kInfinite;
    glm::dvec3 local{0};  ///< the point as that copy sees it
  };

  /// Offsets of copies along one axis, and how many.
  struct Row {
    double first = 0;
    int count = 1;
  };

  Row copies(int axis, double p) const {
    const double s = spacing_[axis], reach = s / 2;
    if (s == 0) return {};
    // In spacings, so that a copy's number is its place.
    double lowest = std::ceil((p - part_.box.high[axis] - reach) / s);
    double highest = std::floor((p - part_.box.low[axis] + reach) / s);
    double origin = 0;
    if (counts_[axis] > 0) {
      origin = -s * (counts_[axis] - 1) / 2;
      lowest = std::max(std::ceil((p - origin - part_.box.high[axis] - reach) / s), 0.0);
      highest = std::min(std::floor((p - origin - part_.box.low[axis] + reach) / s), counts_[axis] - 1.0);
    }
    return {origin + lowest * s, highest >= lowest ? static_cast<int>(highest - lowest) + 1 : 0};
  }

  Nearest nearest(glm::dvec3 p) const {
    Row rows[3];
    for (int k = 0; k < 3; ++k) {
      if (spacing_[k] > 0 && counts_[k] == 0) p[k] = std::remainder(p[k], spacing_[k]);
      rows[k] = copies(k, p[k]);
    }
    Nearest best;
    for (int x = 0; x < rows[0].count; ++x) {
      for (int y = 0; y < rows[1].count; ++y) {
        for (int z = 0; z < rows[2].count; ++z) {
          const glm::dvec3 offset(rows[0].first + x * spacing_.x, rows[1].first + y * spacing_.y,
                                  rows[2].first + z * spacing_.z);
          const glm::dvec3 local = p - offset, outside = from_box(part_.box, local);
          const double least = glm::length(outside);
          if (least > 0 && least >= best.distance) continue;
          double distance = part_.field->distance(local);
          if (outside != glm::dvec3(0)) distance = std::max(distance, least);
          if (distance < best.distance) best = {distance, local};
        }
      }
    }
    return best;
  }

  BoundedField part_;
  glm::dvec3 spacing_;
  glm::ivec3 counts_;
  double reach_;
  Bounds box_;
};

class Placed final : public Field {
 public:
  Placed(FieldPointer part, const Placement& placement)
      : part_(std::move(part)),
        turn_(rotation(placement.rotate)),
        back_(glm::transpose(turn_)),
        translate_(placement.translate),
        scale_(placement.scale) {
    const Bounds box = part_->bounds();
    for (int row = 0; row < 3; ++row) {
      box_.low[row] = box_.high[row] = translate_[row];
      for (int column = 0; column < 3; ++column) {
        const double factor = turn_[column][row] * scale_;
        if (factor == 0) continue;  // infinite sides would make it no number
        box_.low[row] += factor * (factor > 0 ? box.low : box.high)[column];
        box_.high[row] += factor * (factor > 0 ? box.high : box.low)[column];
      }
    }
  }

  double distance(const glm::dvec3& p) const override { return part_->distance(local(p)) * scale_; }
  glm::dvec3 normal(const glm::dvec3& p) const override { return unit_or(turn_ * part_->normal(local(p)), {0, 1, 0}); }
  Bounds bounds() const override { return box_; }

 private:
  glm::dvec3 local(const glm::dvec3& p) const { return reachable(back_ * (reachable(p) - translate_) / scale_); }

  FieldPointer part_;
  glm::dmat3 turn_, back_;
  glm::dvec3 translate_;
  double scale_;
  Bounds box_;
};

}  // namespace

FieldPointer join(std::vector<FieldPointer> parts) { return std::make_shared<Union>(std::move(parts)); }

FieldPointer intersect(std::vector<FieldPointer> parts) {
  const std::size_t count = parts.size();
  return std::make_shared<Intersection>(std::move(parts), count);
}

FieldPointer subtract(std::vector<FieldPointer> parts) { return std::make_shared<Intersection>(std::move(parts), 1); }

FieldPointer smooth_join(std::vector<FieldPointer> parts, double radius) {
  return std::make_shared<SmoothUnion>(std::move(parts), radius);
}

FieldPointer repeat(FieldPointer part, const glm::dvec3& spacing, const glm::ivec3& counts) {
  return std::make_shared<Repetition>(std::move(part), spacing, counts);
}

FieldPointer place(FieldPointer part, const Placement& placement) {
  if (placement == Placement{}) return part;
  return std::make_shared<Placed>(std::move(part), placement);
}

}  // namespace scanline::fields
