#include "tests/deferred/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace deferred {
namespace {

/// To a multiple of 1/16.
double rounded(double value) { return std::round(16 * value) / 16; }

glm::dmat3 turn(int axis, double degrees) {
  const double a = degrees * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  glm::dmat3 m(1);  // columns
  m[j][j] = c;
  m[j][k] = s;
  m[k][j] = -s;
  m[k][k] = c;
  return m;
}

/// Twice the area in the plane of the two axes, with its sign.
double area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal) {
  return glm::dot(glm::cross(b - a, c - a), normal);
}

}  // namespace

std::string Body::obj() const {
  std::ostringstream v, vt, vn, f;
  int count = 0;
  for (const std::vector<Corner>& polygon : polygons) {
    f << 'f';
    for (const Corner& c : polygon) {
      ++count;
      v << "v " << c.position.x << ' ' << c.position.y << ' ' << c.position.z << '\n';
      vt << "vt " << c.uv.x << ' ' << c.uv.y << '\n';
      vn << "vn " << c.normal.x << ' ' << c.normal.y << ' ' << c.normal.z << '\n';
      f << ' ' << count << '/' << count << '/' << count;
    }
    f << '\n';
  }
  return v.str() + vt.str() + vn.str() + f.str();
}

glm::dmat3 Body::matrix() const {
  glm::dmat3 size(1);
  for (int k = 0; k < 3; ++k) size[k][k] = scale[k];
  return turn(2, rotate.z) * turn(1, rotate.y) * turn(0, rotate.x) * size;
}

Surface::Surface(const Body& body, std::size_t polygon)
    : corners_(&body.polygons[polygon]),
      matrix_(body.matrix()),
      inverse_(glm::inverse(matrix_)),
      translate_(body.translate) {
  glm::dvec3 sum(0);
  const std::vector<Corner>& c = *corners_;
  for (const Corner& corner : c) world_.push_back(matrix_ * corner.position + translate_);
  for (std::size_t k = 1; k + 1 < c.size(); ++k) {
    sum += glm::cross(c[k].position - c[0].position, c[k + 1].position - c[0].position);
  }
  front_ = glm::normalize(glm::transpose(inverse_) * sum);
  double best = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const double size = std::abs(area(world_[i], world_[j], world_[k], front_));
        if (size <= best) continue;
        best = size;
        three_[0] = i;
        three_[1] = j;
        three_[2] = k;
      }
    }
  }
}

double Surface::meet(const Ray& ray) const {
  const double along = glm::dot(ray.direction, front_);
  if (along == 0) return std::numeric_limits<double>::infinity();
  return glm::dot(world_[0] - ray.origin, front_) / along;
}

bool Surface::holds(const glm::dvec3& point) const {
  // A half line within the plane, away from the point, crosses the outline an odd number of times.
  const glm::dvec3 first = std::abs(front_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 a = glm::normalize(glm::cross(front_, first)), b = glm::cross(front_, a);
  bool inside = false;
  for (std::size_t k = 0; k < world_.size(); ++k) {
    const glm::dvec3 p = world_[k] - point, q = world_[(k + 1) % world_.size()] - point;
    const double pa = glm::dot(p, a), pb = glm::dot(p, b), qa = glm::dot(q, a), qb = glm::dot(q, b);
    if ((pb > 0) == (qb > 0)) continue;
    if (pa + (qa - pa) * pb / (pb - qb) > 0) inside = !inside;
  }
  return inside;
}

double Surface::distance(const std::vector<glm::dvec3>& points) const {
  double largest = 0;
  for (const glm::dvec3& p : points) largest = std::max(largest, std::abs(glm::dot(p - world_[0], front_)));
  return largest;
}

bool Surface::faces(const View& view) const {
  const glm::dvec3 line = view.perspective ? world_[0] - view.position : view.target - view.position;
  return glm::dot(line, front_) < 0;
}

Shown Surface::at(const glm::dvec3& point) const {
  Shown shown;
  shown.world = point;
  shown.object = inverse_ * (point - translate_);
  shown.polygon_normal = front_;
  const glm::dvec3 &a = world_[three_[0]], &b = world_[three_[1]], &c = world_[three_[2]];
  const double all = area(a, b, c, front_);
  const double share[3] = {area(point, b, c, front_) / all, area(a, point, c, front_) / all,
                           area(a, b, point, front_) / all};
  glm::dvec3 normal(0);
  shown.uv = glm::dvec2(0);
  for (int k = 0; k < 3; ++k) {
    normal += share[k] * (*corners_)[three_[k]].normal;
    shown.uv += share[k] * (*corners_)[three_[k]].uv;
  }
  shown.normal = glm::normalize(glm::transpose(inverse_) * normal);
  return shown;
}

Body triangle_soup(std::mt19937_64& random, int count, int sixteenths) {
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random) / 16.0; };
  Body body;
  while (static_cast<int>(body.polygons.size()) < count) {
    std::vector<Corner> triangle;
    const int size = std::uniform_int_distribution<int>(4, sixteenths)(random);
    const glm::dvec3 middle(number(-sixteenths, sixteenths), number(-sixteenths, sixteenths),
                            number(-sixteenths, sixteenths));
    for (int k = 0; k < 3; ++k) {
      Corner c;
      c.position = middle + glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
      c.normal = {number(-16, 16), number(-16, 16), number(8, 32)};
      c.uv = {number(-48, 48), number(-48, 48)};
      triangle.push_back(c);
    }
    const glm::dvec3 across =
        glm::cross(triangle[1].position - triangle[0].position, triangle[2].position - triangle[0].position);
    if (glm::length(across) > 0.05) body.polygons.push_back(triangle);
  }
  return body;
}

Body star(int points) {
  Body body;
  const double step = std::acos(-1.0) / points;
  for (const bool back : {false, true}) {
    std::vector<Corner> corners;
    for (int k = 0; k < 2 * points; ++k) {
      const double radius = k % 2 == 0 ? 2 : 0.75;
      const double x = rounded(radius * std::cos(k * step)), y = rounded(radius * std::sin(k * step));
      // Both lie on planes that whole numbers of sixteenths meet: z is a sum of x and y, the back a sixteenth behind.
      corners.push_back({{x, y, x + y - (back ? 1 / 16.0 : 0)}, {x, 2, y + 4}, {x + y, 2 * y}});
    }
    if (back) std::reverse(corners.begin(), corners.end());
    body.polygons.push_back(corners);
  }
  return body;
}

Body box() {
  Body body;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      std::vector<Corner> corners;
      const int j = (axis + 1) % 3, k = (axis + 2) % 3;
      for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        Corner c;
        c.position[axis] = side;
        c.position[j] = a * side;
        c.position[k] = b;
        c.normal = glm::dvec3(0);
        c.normal[axis] = 2 * side;
        c.normal[j] = a * side / 2;
        c.normal[k] = b / 4.0;
        c.uv = {a * side * 3 + b, b * 0.5 + axis};
        corners.push_back(c);
      }
      body.polygons.push_back(corners);
    }
  }
  return body;
}

}  // namespace deferred
