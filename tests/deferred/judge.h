// Renders scenes through the program with shaders that show one number of a pixel in 24 bits, and compares every
// covered sample with the number that a ray through it finds on the exact polygons.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/deferred/bodies.h"
#include "tests/deferred/view.h"
#include "tests/program/run_program.h"

namespace deferred {

/// What a shader shows: three or two numbers, a picture each.
enum class Quantity { kPosition, kNormal, kPolygonNormal, kTexture, kVolume };
constexpr Quantity kQuantities[] = {Quantity::kPosition, Quantity::kNormal, Quantity::kPolygonNormal,
                                    Quantity::kTexture, Quantity::kVolume};
int components(Quantity quantity);
const char* name(Quantity quantity);

struct Verdict {
  int covered = 0;  ///< samples that show a polygon
  int judged = 0;   ///< of these, with the sample within the polygon that is shown
  int wrong = 0;    ///< further from the truth than the formats' rounding
  std::string first;
};

/// The text of the shaders; surfaces are named as the quantities are.
std::string shader_text();

class Picture {
 public:
  Picture(const View& view, std::vector<Body> bodies);

  /// For `vsg render`; the meshes are files body0.obj, body1.obj... Numbers are multiplied by 2^-`halvings`, so that
  /// they fit the picture: positions and coordinates stay below 32 then, normals below 2.
  std::string scene(Quantity quantity, int component, int halvings) const;
  /// Learns from the frame file which polygon is whose.
  void read_frame(const std::string& frame);

  /// Compares a picture of a number, by the channel of polygons' numbers. `image`: channels R, G, B, Z, polygon.
  Verdict judge(const vsg_tests::Image& image, Quantity quantity, int component, int halvings) const;
  /// Compares the channels Z and normal, which are the host's.
  Verdict judge_channels(const vsg_tests::Image& image) const;
  /// Whether samples show the nearest polygon, or the background where none is: those apart whose neighbours should
  /// show another one, and those where two depths are closer than their slopes over a pixel (docs/accuracy.md).
  Verdict judge_visibility(const vsg_tests::Image& image) const;

  View view;

 private:
  struct Point {
    const Surface* surface;
    double distance;  ///< from the eye, perpendicular to the picture
    Shown shown;
  };
  /// Where the sample's ray meets the polygon that the frame numbers so; false when that is outside of it.
  bool find(std::uint32_t polygon, int column, int row, Point& point) const;
  int nearest(double column, double row) const;
  bool open(int column, int row) const;

  std::vector<Body> bodies_;
  std::vector<Surface> surfaces_;
  std::vector<int> surface_of_;  ///< by polygon number of the frame - 1
};

}  // namespace deferred
