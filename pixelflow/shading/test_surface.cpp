#include "pixelflow/shading/test_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/eye_space.h"

namespace pfman {
namespace {

/// Half of what the eye sees at distance 1, upwards and downwards.
constexpr double kHalfHeight = 0.36;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Numbers of a varying parameter at a point; none for a parameter that no rendering node would know.
std::vector<double> value_at(const TestSurface::Point& point, const std::string& name, int count) {
  // A test shape is as smooth as if each pixel had a polygon of its own.
  if (name == "px_material_normal" || name == "polygon_normal") return {point.normal.begin(), point.normal.end()};
  if (name == "px_shader_texcoord") {
    if (count == 2) return {point.shape.texcoord[0], point.shape.texcoord[1]};
    const Vector& p = point.shape.position;
    std::vector<double> volume{p[0], p[1], p[2], 1};
    volume.resize(static_cast<std::size_t>(count));
    return volume;
  }
  if (name == "surface_height") return {point.shape.height};
  if (name == "surface_data") return {point.shape.data};
  if (name == "height") return {point.shape.height};
  if (name == "gradient") {
    const Vector& n = point.shape.normal;
    const double up = std::max(n[2], 1e-3);
    return {-n[0] / up, -n[1] / up};
  }
  const std::optional<double> material = opengl_material(name);
  return material ? std::vector<double>(static_cast<std::size_t>(count), *material) : std::vector<double>();
}

/// A region's memory, byte by byte of all elements.
class RegionImage {
 public:
  explicit RegionImage(int lanes)
      : bytes_(pixelflow::kMemoryBytes, std::vector<std::uint8_t>(static_cast<std::size_t>(lanes))) {}

  void put(int address, int lane, std::uint64_t raw, int bytes) {
    for (int n = 0; n < bytes; ++n) {
      bytes_[static_cast<std::size_t>(address + n)][static_cast<std::size_t>(lane)] =
          static_cast<std::uint8_t>(raw >> (8 * n));
    }
  }
  void write(pixelflow::PixelArray& array) const {
    for (int address = 0; address < pixelflow::kMemoryBytes; ++address)
      array.write(address, bytes_[static_cast<std::size_t>(address)]);
  }

 private:
  std::vector<std::vector<std::uint8_t>> bytes_;
};

}  // namespace

TestSurface::TestSurface(const TestView& view) : view_(view), depth_(view.distance / kHalfHeight) {
  const double ct = std::cos(radians(view.turn)), st = std::sin(radians(view.turn));
  const double cx = std::cos(radians(view.tilt)), sx = std::sin(radians(view.tilt));
  rotation_ = {{{ct, 0, st}, {-sx * st, cx, sx * ct}, {-cx * st, -sx, cx * ct}}};
}

Vector TestSurface::rotate(const Vector& v) const {
  Vector result{};
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = rotation_[row][0] * v[0] + rotation_[row][1] * v[1] + rotation_[row][2] * v[2];
  return result;
}

Vector TestSurface::rotate_back(const Vector& v) const {
  Vector result{};
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = rotation_[0][row] * v[0] + rotation_[1][row] * v[1] + rotation_[2][row] * v[2];
  return result;
}

std::optional<TestSurface::Point> TestSurface::at(int column, int row) const {
  const double height = view_.height;
  const Vector ray{(2 * column + 1 - view_.width) / height * kHalfHeight, (height - 2 * row - 1) / height * kHalfHeight,
                   -1};
  const auto hit = first_hit(view_.shape, view_.extent, rotate_back({0, 0, depth_}), rotate_back(ray));
  if (!hit) return std::nullopt;
  Point point{*hit, rotate(hit->position), rotate(hit->normal)};
  point.position[2] -= depth_;
  return point;
}

void TestSurface::place(Instance& instance) const {
  glm::dmat4 to_eye(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      to_eye[column][row] = rotation_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  to_eye[3][2] = -depth_;
  pfman::place(instance, to_eye);
}

void TestSurface::make_ordinary(Instance& instance) {
  const Point nowhere{};
  for (const TransferEntry& entry : transfer_map(instance.shader()).entries) {
    if (!value_at(nowhere, entry.name, entry.type.count()).empty()) instance.make_ordinary(entry.name);
  }
}

void TestSurface::fill(const Instance& instance, int first_column, int first_row, pixelflow::PixelArray& array) const {
  const TransferMap map = transfer_map(instance.shader());
  RegionImage image(array.lanes());
  for (int lane = 0; lane < array.lanes(); ++lane) {
    const int column = first_column + lane % pixelflow::kRegionWidth, row = first_row + lane / pixelflow::kRegionWidth;
    if (column < 0 || column >= view_.width || row < 0 || row >= view_.height) continue;
    const auto point = at(column, row);
    if (!point) continue;
    image.put(kShaderIdAt, lane, static_cast<std::uint64_t>(instance.id()), kShaderIdBytes);
    for (int n = 0; n < 3; ++n) {
      const auto coordinate = static_cast<float>(point->position[static_cast<std::size_t>(n)]);
      image.put(kPositionAt + 4 * n, lane, std::bit_cast<std::uint32_t>(coordinate), 4);
    }
    for (const TransferEntry& entry : map.entries) {
      const std::vector<double> values = value_at(*point, entry.name, entry.type.count());
      const int bytes = entry.type.scalar.bytes();
      for (std::size_t n = 0; n < values.size(); ++n) {
        image.put(entry.address + static_cast<int>(n) * bytes, lane, from_double(values[n], entry.type.scalar), bytes);
      }
    }
  }
  image.write(array);
}

}  // namespace pfman
