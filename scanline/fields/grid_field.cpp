#include "scanline/fields/grid_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scanline/fields/geometry.h"

namespace scanline::fields {
namespace {

class GridField final : public Field {
 public:
  GridField(const Field& field, int cells) {
    const Bounds box = field.bounds();
    const glm::dvec3 size = box.high - box.low;
    const double longest = std::max({size.x, size.y, size.z});
    step_ = (longest > 0 ? longest : 1) / cells;
    // One cube more on each side: the outermost samples are outside.
    for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(std::ceil(size[k] / step_ - 1e-9)) + 3;
    origin_ = (box.low + box.high) / 2.0 - step_ * glm::dvec3(count_ - 1) / 2.0;
    samples_.resize(std::size_t(count_.x) * std::size_t(count_.y) * std::size_t(count_.z));
    for (int z = 0; z < count_.z; ++z) {
      for (int y = 0; y < count_.y; ++y) {
        for (int x = 0; x < count_.x; ++x) {
          const glm::ivec3 place(x, y, z);
          samples_[index(place)] = static_cast<float>(field.distance(origin_ + step_ * glm::dvec3(place)));
        }
      }
    }
    find_slopes();
    // Beyond the samples only the way back to them is known: nothing of the solid may reach there.
    low_ = origin_ + step_ * 0.5;
    high_ = origin_ + step_ * (glm::dvec3(count_ - 1) - 0.5);
    solid_ = solid_bounds();
  }

  double distance(const glm::dvec3& point) const override {
    const glm::dvec3 p = reachable(point), q = glm::clamp(p, low_, high_);
    double inner = value(q);
    inner /= inner > 0 ? outer_slope_ : inner_slope_;
    if (p == q) return inner;
    // Everything of the solid is at an obtuse angle from the nearest point of the box.
    return glm::length(glm::dvec2(glm::length(p - q), std::max(inner, 0.0)));
  }

  glm::dvec3 normal(const glm::dvec3& point) const override {
    const glm::dvec3 p = glm::clamp(reachable(point), low_, high_);
    const auto [cell, t] = locate(p);
    glm::dvec3 sum{0};
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const glm::dvec3 weights = glm::mix(1.0 - t, t, glm::dvec3(offset));
      sum += gradient(cell + offset) * (weights.x * weights.y * weights.z);
    }
    return unit_or(sum, {0, 1, 0});
  }

  Bounds bounds() const override { return solid_; }

 private:
  std::size_t index(const glm::ivec3& p) const {
    return (std::size_t(p.z) * std::size_t(count_.y) + std::size_t(p.y)) * std::size_t(count_.x) + std::size_t(p.x);
  }
  double sample(const glm::ivec3& p) const { return samples_[index(p)]; }

  struct Place {
    glm::ivec3 cell;
    glm::dvec3 t;
  };
  /// The cube that holds a point of the grid, and where in it.
  Place locate(const glm::dvec3& p) const {
    const glm::dvec3 scaled = (p - origin_) / step_;
    const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(scaled)), glm::ivec3(0), count_ - 2);
    return {cell, glm::clamp(scaled - glm::dvec3(cell), 0.0, 1.0)};
  }

  double value(const glm::dvec3& p) const {
    const auto [cell, t] = locate(p);
    double planes[2];
    for (int z = 0; z < 2; ++z) {
      double rows[2];
      for (int y = 0; y < 2; ++y) {
        const std::size_t first = index(cell + glm::ivec3(0, y, z));
        rows[y] = glm::mix(double{samples_[first]}, double{samples_[first + 1]}, t.x);
      }
      planes[z] = glm::mix(rows[0], rows[1], t.y);
    }
    return glm::mix(planes[0], planes[1], t.z);
  }

  /// Central differences at a sample.
  glm::dvec3 gradient(const glm::ivec3& p) const {
    glm::dvec3 g;
    for (int k = 0; k < 3; ++k) {
      glm::ivec3 before = p, after = p;
      before[k] = std::max(p[k] - 1, 0);
      after[k] = std::min(p[k] + 1, count_[k] - 1);
      g[k] = (sample(after) - sample(before)) / (after[k] - before[k]);
    }
    return g;
  }

  /// Each component of the gradient is a mean of the differences along four edges of a cube. The way from a point
  /// outside to the nearest of the surface stays outside, so that only cubes that are outside somewhere count; inside
  /// likewise.
  void find_slopes() {
    for (int z = 0; z + 1 < count_.z; ++z) {
      for (int y = 0; y + 1 < count_.y; ++y) {
        for (int x = 0; x + 1 < count_.x; ++x) {
          glm::dvec3 greatest{0};
          bool is_outer = false, is_inner = false;
          for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 low(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1));
            const double at_low = sample(low);
            is_outer |= at_low > 0;
            is_inner |= at_low < 0;
            for (int k = 0; k < 3; ++k) {
              if (corner >> k & 1) continue;
              glm::ivec3 high = low;
              ++high[k];
              greatest[k] = std::max(greatest[k], std::abs(sample(high) - at_low));
            }
          }
          const double slope = glm::length(greatest) / step_;
          if (is_outer) outer_slope_ = std::max(outer_slope_, slope);
          if (is_inner) inner_slope_ = std::max(inner_slope_, slope);
        }
      }
    }
  }

  /// Around all cubes with a sample inside.
  Bounds solid_bounds() const {
    glm::ivec3 low = count_, high(-1);
    for (int z = 0; z < count_.z; ++z) {
      for (int y = 0; y < count_.y; ++y) {
        for (int x = 0; x < count_.x; ++x) {
          if (sample({x, y, z}) > 0) continue;
          low = glm::min(low, glm::ivec3(x, y, z));
          high = glm::max(high, glm::ivec3(x, y, z));
        }
      }
    }
    if (high.x < 0) return {(low_ + high_) / 2.0, (low_ + high_) / 2.0};
    return {glm::max(origin_ + step_ * glm::dvec3(low - 1), low_),
            glm::min(origin_ + step_ * glm::dvec3(high + 1), high_)};
  }

  glm::dvec3 origin_{0}, low_{0}, high_{0};
  double step_ = 1;
  double outer_slope_ = 1, inner_slope_ = 1;  ///< the steepest that the value may be outside, and inside
  glm::ivec3 count_{0};
  std::vector<float> samples_;
  Bounds solid_;
};

}  // namespace

FieldPointer grid_field(const Field& field, int cells) {
  return std::make_shared<GridField>(field, std::clamp(cells, 2, kMostGridCells));
}

}  // namespace scanline::fields
