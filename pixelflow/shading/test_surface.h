// A plain scene for one surface shader: a camera and a shape, whose visible points give every pixel what a rendering
// node would send: shader ID, the parameters of the transfer map, the position.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/shading/instance.h"
#include "pixelflow/shading/test_shapes.h"

namespace pfman {

/// The eye stands at the origin and looks along -z; a plane at `distance` 1 that is not turned fills the picture's
/// height exactly, whatever the size. Angles in degrees.
struct TestView {
  TestShape shape = TestShape::Plane;
  int width = 512, height = 512;  ///< pixels
  double distance = 1;            ///< of the shape's middle, in the distance at which a height of 2 fills the picture
  double turn = 0;                ///< about the vertical axis, to the right
  double tilt = 0;                ///< then about the horizontal axis: the upper side away from the eye
  double extent = 1;              ///< of a plane: half of its side
};

class TestSurface {
 public:
  explicit TestSurface(const TestView& view);

  const TestView& view() const { return view_; }

  struct Point {
    ShapePoint shape;
    Vector position, normal;  ///< in eye space
  };
  /// What the middle of a pixel shows; rows count from the top.
  std::optional<Point> at(int column, int row) const;

  /// Takes the parameters of `instance` that have a transform attribute from the shape's coordinates to eye space.
  void place(Instance& instance) const;

  /// Declares as ordinary the varying parameters that fill() knows: px_material_* and px_shader_texcoord,
  /// surface_height and surface_data, and as terrains have it (z being up) height and gradient. One that is set
  /// afterwards is bound.
  static void make_ordinary(Instance& instance);

  /// Writes a region of 128 x 64 pixels into memory, or as many rows of it as the array has elements for. Pixels
  /// outside of the picture and those that show nothing have shader ID 0. All other memory becomes zero.
  void fill(const Instance& instance, int first_column, int first_row, pixelflow::PixelArray& array) const;

 private:
  Vector rotate(const Vector& v) const;
  Vector rotate_back(const Vector& v) const;

  TestView view_;
  double depth_;  ///< of the shape's middle
  std::array<Vector, 3> rotation_;
};

}  // namespace pfman
