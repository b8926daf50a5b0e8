#include "tests/random/random_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vsg_tests {
namespace {

constexpr std::size_t kMostPolygons = 40;
constexpr double kPi = std::numbers::pi;

class Maker {
 public:
  Maker(std::uint64_t seed, int lines) : random_(seed) {
    result_.frame.width = pick({16, 40, 64, 100, 128, 200, 256});
    result_.frame.height = std::min(lines, pick({8, 32, 64, 100, 128}));
    result_.keep_back_faces = chance(0.5);
  }

  RandomFrame make() {
    const int parts = 1 + below(4);
    for (int i = 0; i < parts && room() > 0; ++i) {
      using Part = void (Maker::*)();
      static constexpr std::pair<Part, const char*> kParts[] = {
          {&Maker::triangles, "triangles"}, {&Maker::slivers, "slivers"},       {&Maker::sheet, "sheet"},
          {&Maker::box, "box"},             {&Maker::nested, "nested"},         {&Maker::coincident, "coincident"},
          {&Maker::star, "star"},           {&Maker::borders, "borders"},       {&Maker::integers, "integers"},
          {&Maker::penetrating, "crossing"}, {&Maker::comb, "comb"}, {&Maker::crossed, "crossed"}};
      const auto& [part, name] = kParts[below(static_cast<int>(std::size(kParts)))];
      (this->*part)();
      result_.kinds += (i == 0 ? "" : "+") + std::string(name);
    }
    return std::move(result_);
  }

 private:
  // Distributions of the library may differ from machine to machine; these do not.
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53); }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  bool chance(double p) { return uniform(0, 1) < p; }
  int pick(std::initializer_list<int> values) { return values.begin()[below(static_cast<int>(values.size()))]; }

  std::size_t room() const { return kMostPolygons - std::min(kMostPolygons, result_.frame.polygons.size()); }
  double right() const { return std::nextafter(double(result_.frame.width), 0.0); }
  double top() const { return std::nextafter(double(result_.frame.height), 0.0); }
  double any_x() { return uniform(1, right()); }
  double any_y() { return uniform(0, top()); }
  /// Mostly moderate, sometimes at the ends of the number range.
  double any_z() { return chance(0.1) ? uniform(-65535.9, 65535.9) : uniform(50, 150); }

  std::uint32_t vertex(double x, double y, double z) {
    z = std::clamp(z, -65535.99, 65535.99);
    result_.frame.vertices.push_back({std::clamp(x, 1.0, right()), std::clamp(y, 0.0, top()), z});
    return static_cast<std::uint32_t>(result_.frame.vertices.size());
  }
  void polygon(std::vector<std::uint32_t> vertices) {
    if (room() > 0) result_.frame.polygons.push_back(std::move(vertices));
  }

  void triangles() {
    for (int n = 1 + below(10); n > 0; --n) {
      polygon({vertex(any_x(), any_y(), any_z()), vertex(any_x(), any_y(), any_z()), vertex(any_x(), any_y(), any_z())});
    }
  }
  void slivers() {
    for (int n = 1 + below(8); n > 0; --n) {
      const double x = any_x(), y = any_y(), z = any_z(), w = std::pow(10.0, uniform(-6, 0));
      const bool flat = chance(0.5);
      polygon({vertex(x, y, z), vertex(flat ? any_x() : x + w, flat ? y + w : any_y(), any_z()),
               vertex(flat ? any_x() : x - w, flat ? y - w : any_y(), any_z())});
    }
  }
  void sheet() {
    const int nx = 1 + below(3), ny = 1 + below(3);
    const double x0 = any_x(), x1 = any_x(), y0 = any_y(), y1 = any_y(), z = any_z(), a = uniform(0, 20);
    std::vector<std::uint32_t> grid;
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        grid.push_back(vertex(x0 + (x1 - x0) * i / nx + uniform(-2, 2), y0 + (y1 - y0) * j / ny + uniform(-2, 2),
                              z + uniform(-a, a)));
      }
    }
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const std::uint32_t p = grid[j * (nx + 1) + i], q = grid[j * (nx + 1) + i + 1];
        const std::uint32_t r = grid[(j + 1) * (nx + 1) + i + 1], s = grid[(j + 1) * (nx + 1) + i];
        if (chance(0.3)) {
          polygon({p, s, r, q});
        } else {
          polygon({p, s, r});
          polygon({p, r, q});
        }
      }
    }
  }
  void box() {
    const double cx = any_x(), cy = any_y(), cz = any_z(), h = uniform(1, 0.4 * result_.frame.height);
    const double a = uniform(0, 2 * kPi), b = uniform(0, 2 * kPi);
    std::uint32_t v[8];
    for (int i = 0; i < 8; ++i) {
      const double x = (i & 4 ? h : -h), y = (i & 2 ? h : -h), z = (i & 1 ? h : -h);
      const double x1 = x * std::cos(a) - y * std::sin(a), y1 = x * std::sin(a) + y * std::cos(a);
      v[i] = vertex(cx + x1, cy + y1 * std::cos(b) - z * std::sin(b), cz + y1 * std::sin(b) + z * std::cos(b));
    }
    constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (const auto& f : kFaces) {
      polygon({v[f[0]], v[f[1]], v[f[2]], v[f[3]]});
    }
  }
  void nested() {
    const double cx = any_x(), cy = any_y(), z = any_z();
    double h = uniform(3, 0.5 * result_.frame.height);
    for (int n = 2 + below(5); n > 0; --n, h *= uniform(0.5, 0.95)) {
      const double d = z + uniform(-3, 3);
      polygon({vertex(cx - h, cy - h, d), vertex(cx - h, cy + h, d), vertex(cx + h, cy + h, d + uniform(-1, 1)),
               vertex(cx + h, cy - h, d)});
    }
  }
  void coincident() {
    const bool flat = chance(0.4);  // the same depth everywhere: ties
    const double z = any_z();
    const auto depth = [&] { return flat ? z : any_z(); };
    const std::uint32_t a = vertex(any_x(), any_y(), depth()), b = vertex(any_x(), any_y(), depth()),
                        c = vertex(any_x(), any_y(), depth());
    for (int n = 2 + below(3); n > 0; --n) chance(0.5) ? polygon({a, b, c}) : polygon({c, b, a});
  }
  void star() {
    const int points = 3 + below(8);
    const double cx = any_x(), cy = any_y(), z = any_z(), gx = uniform(-0.5, 0.5), gy = uniform(-0.5, 0.5);
    const double a0 = uniform(0, 6), size = uniform(4, 0.6 * result_.frame.height);
    std::vector<std::uint32_t> v;
    for (int i = 0; i < 2 * points; ++i) {
      const double r = uniform(0.1, 1) * size, a = a0 - i * kPi / points;
      v.push_back(vertex(cx + r * std::cos(a), cy + r * std::sin(a), z + gx * r * std::cos(a) + gy * r * std::sin(a)));
    }
    polygon(std::move(v));
  }
  /// Corners on the borders of the frame and depths at the ends of the range.
  void borders() {
    const double x[] = {1, 1.0000001, 2, right(), right() - 0.5, double(result_.frame.width) - 1};
    const double y[] = {0, 0.0000001, 1, top(), top() - 1, double(result_.frame.height) - 1};
    const double z[] = {-65535.99, 65535.99, 0, 100};
    for (int n = 1 + below(5); n > 0; --n) {
      std::vector<std::uint32_t> v;
      for (int i = 3 + below(2); i > 0; --i) v.push_back(vertex(x[below(6)], y[below(6)], z[below(4)]));
      polygon(std::move(v));
    }
  }
  void integers() {
    for (int n = 1 + below(6); n > 0; --n) {
      std::vector<std::uint32_t> v;
      for (int i = 3 + below(3); i > 0; --i) v.push_back(vertex(1 + below(12) * 1.0, below(8), 95 + below(10)));
      polygon(std::move(v));
    }
  }
  void penetrating() {
    const double x0 = any_x(), x1 = any_x(), y0 = any_y(), y1 = any_y();
    for (int n = 2 + below(3); n > 0; --n) {
      const double za = any_z(), zb = any_z();
      polygon({vertex(x0, y0, za), vertex(x0 + uniform(-3, 3), y1, za + uniform(-9, 9)), vertex(x1, y1, zb),
               vertex(x1 + uniform(-3, 3), y0, zb)});
    }
  }
  void comb() {
    const int teeth = 2 + below(6);
    const double x0 = uniform(1, result_.frame.width * 0.3), w = uniform(4, result_.frame.width * 0.6), y0 = any_y(), y1 = any_y();
    const double z = any_z(), slope = uniform(-0.5, 0.5);
    std::vector<std::uint32_t> v;
    for (int i = 0; i <= 2 * teeth; ++i) {
      const double x = x0 + w * i / (2 * teeth);
      v.push_back(vertex(x, i % 2 ? y1 : y0 + uniform(-1, 1), z + slope * (x - x0)));
    }
    v.push_back(vertex(x0 + w, std::min(y0, y1) - 2, z + slope * w));
    v.push_back(vertex(x0, std::min(y0, y1) - 2, z));
    polygon(std::move(v));
  }
  /// A polygon that crosses itself (chapter V: a local error).
  void crossed() {
    const double x0 = any_x(), x1 = any_x(), y0 = any_y(), y1 = any_y(), z = any_z();
    polygon({vertex(x0, y0, z), vertex(x1, y1, z), vertex(x1, y0, z + 1), vertex(x0, y1, z + 2)});
  }

  std::mt19937_64 random_;
  RandomFrame result_;
};

}  // namespace

RandomFrame random_frame(std::uint64_t seed, int lines) { return Maker(seed, lines).make(); }

}  // namespace vsg_tests
