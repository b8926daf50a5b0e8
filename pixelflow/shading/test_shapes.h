// Shapes that test pictures show: what a ray from the eye meets, in double precision.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pfman {

using Vector = std::array<double, 3>;

enum class TestShape {
  Plane,   ///< z = 0, from -extent to extent in x and y
  Relief,  ///< measured heights over the square from -1 to 1: particles and a fibre on a rough ground
  Sphere,  ///< of radius 1
  Pin      ///< a bowling pin, upright along y from -1 to 1
};

/// "plane", "relief", "sphere", "pin"; none for another word.
std::optional<TestShape> test_shape(const std::string& word);

/// A visible point, in the shape's own coordinates.
struct ShapePoint {
  Vector position;
  Vector normal;                   ///< unit
  std::array<double, 2> texcoord;  ///< within the shape from 0 to 1; a plane's from 0 to its extent
  double height = 0;               ///< relief: the first measurement, 0 and up
  double data = 0;                 ///< relief: the second, 0 to 1
};

/// The first point where the ray meets the shape. `direction` need not have unit length; `extent` counts for the plane.
std::optional<ShapePoint> first_hit(TestShape shape, double extent, const Vector& origin, const Vector& direction);

}  // namespace pfman
