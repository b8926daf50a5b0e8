#include "scanline/patches.h"

#include "scanline/polygon.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

using Weights = std::array<double, 4>;

/// Bernstein polynomials at k / n. Turning the curve round (n - k for k) only swaps the weights, to the bit.
Weights weights(int k, int n) {
  const double t = static_cast<double>(k) / n, s = static_cast<double>(n - k) / n;
  return {s * s * s, 3 * (s * s * t), 3 * (t * t * s), t * t * t};
}

/// Derivatives and values at any place: good enough for normals.
Weights slopes(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Weights weights_at(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// The outer and the inner pair are added first: the sum is the same when the order of the points is turned round.
glm::dvec3 blend(const Weights& w, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c);
}

/// The weights of a point add up to one only nearly: a side that has shrunk to a point must stay one point.
glm::dvec3 blend_point(const Weights& w, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                       const glm::dvec3& d) {
  return a == b && a == c && a == d ? a : blend(w, a, b, c, d);
}

using ControlPoints = std::array<glm::dvec3, 16>;

template <auto Blend>
glm::dvec3 evaluate(const ControlPoints& p, const Weights& across, const Weights& up) {
  glm::dvec3 row[4];
  for (std::size_t r = 0; r < 4; ++r) row[r] = Blend(across, p[4 * r], p[4 * r + 1], p[4 * r + 2], p[4 * r + 3]);
  return Blend(up, row[0], row[1], row[2], row[3]);
}

glm::dvec3 normal_at(const ControlPoints& p, double u, double v) {
  // At a pole one derivative vanishes; the normal close by stands for the limit.
  for (const double inwards : {0.0, 1e-4, 1e-2}) {
    const double a = u + (0.5 - u) * inwards, b = v + (0.5 - v) * inwards;
    const glm::dvec3 du = evaluate<blend>(p, slopes(a), weights_at(b)),
                     dv = evaluate<blend>(p, weights_at(a), slopes(b));
    const glm::dvec3 normal = glm::cross(du, dv);
    const double length = glm::length(normal);
    if (length > 1e-9 * (glm::dot(du, du) + glm::dot(dv, dv))) return normal / length;
  }
  return glm::dvec3(0);
}

}  // namespace

PatchSet read_patches(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  if (!lines.next() || lines.words().size() != 2 || lines.words()[0] != "vsgpatches") {
    throw UserError({file, std::max(lines.line(), 1), 0, "a patch file begins with 'vsgpatches 1'"});
  }
  lines.whole(1, 1, 1);
  PatchSet set;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "v") {
      if (words.size() != 4) lines.fail("a control point has three coordinates");
      set.points.emplace_back(lines.number(1), lines.number(2), lines.number(3));
    } else if (words[0] == "b") {
      if (words.size() != 17) lines.fail("a patch has sixteen control points");
      auto& patch = set.patches.emplace_back();
      if (set.points.empty()) lines.fail("a patch stands before the first control point");
      const long last = static_cast<long>(set.points.size());
      for (std::size_t k = 0; k < 16; ++k) patch[k] = static_cast<std::uint32_t>(lines.whole(k + 1, 1, last) - 1);
    } else {
      lines.fail("unknown record '" + std::string(words[0]) + "' (known: v, b)");
    }
  }
  if (set.patches.empty()) throw UserError({file, 0, 0, "no patch in this file"});
  return set;
}

Mesh tessellate(const PatchSet& set, int level) {
  MeshBuilder mesh({{"normal", 3}, {"uv", 2}});
  const int side = level + 1;
  std::vector<Weights> grid;
  for (int k = 0; k <= level; ++k) grid.push_back(weights(k, level));
  for (const auto& patch : set.patches) {
    ControlPoints p;
    for (std::size_t k = 0; k < 16; ++k) p[k] = set.points[patch[k]];
    std::vector<std::uint32_t> vertices;
    std::vector<glm::dvec3> positions;
    std::vector<std::array<double, 5>> values;
    for (int j = 0; j <= level; ++j) {
      for (int i = 0; i <= level; ++i) {
        const double u = static_cast<double>(i) / level, v = static_cast<double>(j) / level;
        positions.push_back(evaluate<blend_point>(p, grid[i], grid[j]));
        vertices.push_back(mesh.vertex(positions.back()));
        const glm::dvec3 normal = normal_at(p, u, v);
        values.push_back({normal.x, normal.y, normal.z, u, v});
      }
    }
    const auto add = [&](std::initializer_list<int> corners) {
      std::vector<std::uint32_t> polygon;
      std::vector<double> attributes;
      for (const int c : corners) {
        polygon.push_back(vertices[c]);
        attributes.insert(attributes.end(), values[c].begin(), values[c].end());
      }
      mesh.polygon(polygon, attributes);
    };
    for (int j = 0; j < level; ++j) {
      for (int i = 0; i < level; ++i) {
        const int a = j * side + i, b = a + 1, c = b + side, d = a + side;
        const glm::dvec3 quad[4] = {positions[a], positions[b], positions[c], positions[d]};
        if (unevenness(quad) > kPlanarTolerance) {
          add({a, b, c});
          add({a, c, d});
        } else {
          add({a, b, c, d});
        }
      }
    }
  }
  return mesh.take();
}

}  // namespace scanline
