#include "tests/field_march/oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace field_march_tests {
namespace {

constexpr Real kEndless = std::numeric_limits<Real>::infinity();

using Polynomial = std::vector<Real>;  // lowest power first

Real value(const Polynomial& p, Real x) {
  Real sum = 0;
  for (std::size_t n = p.size(); n-- > 0;) sum = sum * x + p[n];
  return sum;
}

/// Real roots where the sign changes: between the extrema, which are roots of the derivative, there is one at most.
std::vector<Real> roots(Polynomial p) {
  while (p.size() > 1 && p.back() == 0) p.pop_back();
  if (p.size() < 2) return {};
  Polynomial slope;
  for (std::size_t n = 1; n < p.size(); ++n) slope.push_back(static_cast<Real>(n) * p[n]);
  Real bound = 0;
  for (const Real c : p) bound = std::max(bound, std::abs(c / p.back()));
  std::vector<Real> places = roots(slope);
  places.insert(places.begin(), -1 - bound);
  places.push_back(1 + bound);
  std::vector<Real> result;
  for (std::size_t n = 0; n + 1 < places.size(); ++n) {
    Real low = places[n], high = places[n + 1];
    const bool rises = value(p, high) > 0;
    if ((value(p, low) > 0) == rises) continue;
    for (int step = 0; step < 200; ++step) {
      const Real middle = (low + high) / 2;
      if (middle == low || middle == high) break;
      ((value(p, middle) > 0) == rises ? high : low) = middle;
    }
    result.push_back((low + high) / 2);
  }
  return result;
}

/// Where a polynomial is negative.
Intervals negative(const Polynomial& p) {
  std::vector<Real> places = roots(p);
  places.insert(places.begin(), -kEndless);
  places.push_back(kEndless);
  Intervals result;
  for (std::size_t n = 0; n + 1 < places.size(); ++n) {
    Real inside = (places[n] + places[n + 1]) / 2;
    if (std::isinf(places[n])) inside = std::isinf(places[n + 1]) ? 0 : places[n + 1] - 1;
    if (!std::isinf(places[n]) && std::isinf(places[n + 1])) inside = places[n] + 1;
    if (value(p, inside) < 0) result.emplace_back(places[n], places[n + 1]);
  }
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] += a[i] * b[k];
  }
  return result;
}

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Rows of the rotation about x, then y, then z.
std::array<Vector, 3> rotation(const glm::dvec3& degrees) {
  const auto turn = [](Real angle) { return angle * std::numbers::pi_v<Real> / 180; };
  const Real cx = std::cos(turn(degrees.x)), sx = std::sin(turn(degrees.x)), cy = std::cos(turn(degrees.y)),
             sy = std::sin(turn(degrees.y)), cz = std::cos(turn(degrees.z)), sz = std::sin(turn(degrees.z));
  return {Vector{cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx},
          Vector{sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx}, Vector{-sy, cy * sx, cy * cx}};
}

Vector to_solid(const Solid& solid, const glm::dvec3& v, bool is_point) {
  const auto rows = rotation(solid.key.rotate);
  Vector moved;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = static_cast<int>(k);
    moved[k] = static_cast<Real>(v[n]) - (is_point ? static_cast<Real>(solid.key.translate[n]) : 0);
  }
  Vector result{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) result[column] += rows[row][column] * moved[row];
    result[column] /= static_cast<Real>(solid.key.scale[static_cast<int>(column)]);
  }
  return result;
}

glm::dvec3 gradient(const Solid& solid, const glm::dvec3& p) {
  switch (solid.kind) {
    case Kind::Sphere: return p;
    case Kind::Torus: {
      const double around = std::hypot(p.x, p.z);
      return {p.x - p.x / around * solid.size[0], p.y, p.z - p.z / around * solid.size[0]};
    }
    case Kind::Plane: return {0, 1, 0};
    case Kind::Slab: return {0, p.y < 0 ? -1 : 1, 0};
    case Kind::Box: break;
  }
  glm::dvec3 result(0);
  int face = 0;
  for (int k = 1; k < 3; ++k) {
    const auto gap = [&](int n) { return std::abs(p[n]) - solid.size[static_cast<std::size_t>(n)]; };
    if (gap(k) > gap(face)) face = k;
  }
  result[face] = p[face] < 0 ? -1 : 1;
  return result;
}

class SolidField final : public scanline::Field {
 public:
  SolidField(const Solid& solid, double share, Asked* asked) : solid_(solid), share_(share), asked_(asked) {}

  double distance(const glm::dvec3& p) const override {
    if (asked_) ++asked_->distances;
    return share_ * exact(p);
  }
  glm::dvec3 normal(const glm::dvec3& p) const override {
    if (asked_) ++asked_->normals;
    return glm::normalize(gradient(solid_, p));
  }
  scanline::Bounds bounds() const override {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const auto& size = solid_.size;
    glm::dvec3 high(kInfinite);
    if (solid_.kind == Kind::Sphere) high = glm::dvec3(size[0]);
    if (solid_.kind == Kind::Box) high = {size[0], size[1], size[2]};
    if (solid_.kind == Kind::Torus) high = {size[0] + size[1], size[1], size[0] + size[1]};
    if (solid_.kind == Kind::Slab) high.y = size[0];
    if (solid_.kind == Kind::Plane) return {glm::dvec3(-kInfinite), {kInfinite, 0, kInfinite}};
    return {-high, high};
  }

 private:
  double exact(const glm::dvec3& p) const {
    const auto& size = solid_.size;
    switch (solid_.kind) {
      case Kind::Sphere: return glm::length(p) - size[0];
      case Kind::Torus: return std::hypot(std::hypot(p.x, p.z) - size[0], p.y) - size[1];
      case Kind::Plane: return p.y;
      case Kind::Slab: return std::abs(p.y) - size[0];
      case Kind::Box: break;
    }
    const glm::dvec3 q = glm::abs(p) - glm::dvec3(size[0], size[1], size[2]);
    return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0);
  }

  Solid solid_;
  double share_;
  Asked* asked_;
};

}  // namespace

Intervals meetings(const Solid& solid, const glm::dvec3& origin, const glm::dvec3& direction) {
  const Vector o = to_solid(solid, origin, true), d = to_solid(solid, direction, false);
  const auto& size = solid.size;
  const Real dd = dot(d, d), od = dot(o, d), oo = dot(o, o);
  switch (solid.kind) {
    case Kind::Sphere: return negative({oo - static_cast<Real>(size[0]) * size[0], 2 * od, dd});
    case Kind::Plane: return negative({o[1], d[1]});
    case Kind::Slab:
      return negative({o[1] * o[1] - static_cast<Real>(size[0]) * size[0], 2 * o[1] * d[1], d[1] * d[1]});
    case Kind::Torus: {
      // (p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2)
      const Real R2 = static_cast<Real>(size[0]) * size[0], r2 = static_cast<Real>(size[1]) * size[1];
      const Polynomial sum{oo + R2 - r2, 2 * od, dd};
      Polynomial result = product(sum, sum);
      const Polynomial flat{o[0] * o[0] + o[2] * o[2], 2 * (o[0] * d[0] + o[2] * d[2]), d[0] * d[0] + d[2] * d[2]};
      for (std::size_t n = 0; n < 3; ++n) result[n] -= 4 * R2 * flat[n];
      return negative(result);
    }
    case Kind::Box: break;
  }
  Real low = -kEndless, high = kEndless;
  for (std::size_t k = 0; k < 3; ++k) {
    const Intervals side = negative({o[k] * o[k] - static_cast<Real>(size[k]) * size[k], 2 * o[k] * d[k], d[k] * d[k]});
    if (side.empty()) return {};
    low = std::max(low, side[0].first);
    high = std::min(high, side[0].second);
  }
  return low < high ? Intervals{{low, high}} : Intervals{};
}

glm::dvec3 normal_at(const Solid& solid, const glm::dvec3& point) {
  const Vector p = to_solid(solid, point, true);
  const glm::dvec3 g =
      gradient(solid, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  const auto rows = rotation(solid.key.rotate);
  Vector result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<int>(k);
      result[row] += rows[row][k] * g[n] / solid.key.scale[n];
    }
  }
  const Real length = std::sqrt(dot(result, result));
  return {static_cast<double>(result[0] / length), static_cast<double>(result[1] / length),
          static_cast<double>(result[2] / length)};
}

bool grazes(const Solid& solid, const glm::dvec3& origin, const glm::dvec3& direction, Real t) {
  if (std::isinf(t)) return false;
  const glm::dvec3 normal = normal_at(solid, origin + static_cast<double>(t) * direction);
  return std::abs(glm::dot(normal, glm::normalize(direction))) < 0.01;
}

std::shared_ptr<const scanline::Field> field_of(const Solid& solid, double share, Asked* asked) {
  return std::make_shared<SolidField>(solid, share, asked);
}

scanline::Object object_of(const Solid& solid, double share, Asked* asked) {
  scanline::Object object;
  object.field = field_of(solid, share, asked);
  object.keys = {solid.key};
  return object;
}

scanline::Scene scene_of(const std::vector<Solid>& solids, double share, Asked* asked) {
  scanline::Scene scene;
  for (const Solid& solid : solids) scene.objects.push_back(object_of(solid, share, asked));
  return scene;
}

Random::Random(std::uint64_t own) : seed_(own) {
  if (const char* const text = std::getenv("FIELD_MARCH_SEED")) seed_ = std::stoull(text);
  numbers_.seed(seed_);
}

double Random::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(numbers_() >> 11) * 0x1p-53);
}

glm::dvec3 Random::vector(double size) {
  const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
  return {x, y, z};
}

glm::dvec3 Random::unit() {
  for (;;) {
    const glm::dvec3 v = vector(1);
    if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
  }
}

Solid Random::solid(Kind kind) {
  Solid solid{kind, {between(0.3, 2), between(0.3, 2), between(0.3, 2)}, {}};
  if (kind == Kind::Torus) solid.size[1] = solid.size[0] * between(0.1, 0.9);
  solid.key.translate = vector(3);
  solid.key.rotate = vector(180);
  // Stretching a field keeps what it answers a bound in its own space, where rays are marched.
  solid.key.scale = {between(0.5, 2), between(0.5, 2), between(0.5, 2)};
  return solid;
}

std::string Random::replay() const { return "seed " + std::to_string(seed_) + " (set FIELD_MARCH_SEED to it)"; }

}  // namespace field_march_tests
