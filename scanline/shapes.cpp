#include "scanline/shapes.h"

#include <cmath>
#include <numbers>

namespace scanline {
namespace {

/// A point of a profile that is turned about y: radius and height, its normal in the same plane, and v of "uv".
struct ProfilePoint {
  double radius, y;
  glm::dvec2 normal;  ///< away from the axis, up
  double v;
};

MeshBuilder round_builder() { return MeshBuilder({{"normal", 3}, {"uv", 2}}); }

/// Cosine and sine of a part of a turn, exact at the quarters and mirrored exactly, so that round shapes are closed.
glm::dvec2 on_circle(int part, int parts) {
  const int eighth = (8 * part) / parts;  // 0 to 7
  const auto angle = [&](int numerator) { return 2 * std::numbers::pi * numerator / (4.0 * parts); };
  // Numerators count in quarters of a part, so that the distance to the nearest axis is a whole number.
  const int n = 4 * part;
  switch (eighth) {
    case 0: return {std::cos(angle(n)), std::sin(angle(n))};
    case 1:
    case 2: return {-std::sin(angle(n - parts)), std::cos(angle(n - parts))};
    case 3:
    case 4: return {-std::cos(angle(n - 2 * parts)), -std::sin(angle(n - 2 * parts))};
    case 5:
    case 6: return {std::sin(angle(n - 3 * parts)), -std::cos(angle(n - 3 * parts))};
    default: return {std::cos(angle(n - 4 * parts)), std::sin(angle(n - 4 * parts))};
  }
}

/// Turns the line from `low` to `high` about y: a band of quads, triangles where it meets the axis.
void add_band(MeshBuilder& mesh, const ProfilePoint& low, const ProfilePoint& high, int segments) {
  const auto point = [&](const ProfilePoint& p, int k) {
    const glm::dvec2 c = on_circle(k % segments, segments);
    return mesh.vertex({p.radius * c.x, p.y, p.radius * -c.y});
  };
  for (int k = 0; k < segments; ++k) {
    std::vector<std::uint32_t> vertices;
    std::vector<double> values;
    const auto add = [&](const ProfilePoint& p, int part) {
      const glm::dvec2 c = on_circle(part % segments, segments);
      vertices.push_back(point(p, part));
      values.insert(values.end(),
                    {p.normal.x * c.x, p.normal.y, p.normal.x * -c.y, static_cast<double>(part) / segments, p.v});
    };
    add(low, k);
    if (low.radius > 0) add(low, k + 1);
    add(high, k + 1);
    if (high.radius > 0) add(high, k);
    mesh.polygon(vertices, values);
  }
}

/// A flat disc as one polygon, facing up or down.
void add_cap(MeshBuilder& mesh, double radius, double y, int segments, bool up) {
  std::vector<std::uint32_t> vertices;
  std::vector<double> values;
  for (int k = 0; k < segments; ++k) {
    const glm::dvec2 c = on_circle(up ? k : segments - 1 - k, segments);
    vertices.push_back(mesh.vertex({radius * c.x, y, radius * -c.y}));
    values.insert(values.end(), {0, up ? 1.0 : -1.0, 0, 0.5 + c.x / 2, 0.5 + c.y / 2});
  }
  mesh.polygon(vertices, values);
}

}  // namespace

Mesh make_boxes(std::span<const Box> boxes) {
  MeshBuilder mesh;
  // Corner k: bit 0 right, bit 1 top, bit 2 front.
  constexpr std::uint32_t faces[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                         {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
  for (const Box& box : boxes) {
    mesh.begin_part();
    std::uint32_t corners[8];
    for (unsigned k = 0; k < 8; ++k) {
      const glm::dvec2 width = k & 2 ? box.top : glm::dvec2(1);
      const glm::dvec3 side((k & 1 ? 0.5 : -0.5) * width.x, k & 2 ? 0.5 : -0.5, (k & 4 ? 0.5 : -0.5) * width.y);
      corners[k] = mesh.vertex(box.center + side * box.size);
    }
    for (const auto& face : faces) {
      const std::uint32_t polygon[4] = {corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
      mesh.polygon(polygon);
    }
  }
  return mesh.take();
}

Mesh make_plane(const glm::dvec2& size, const glm::ivec2& divisions) {
  MeshBuilder mesh = round_builder();
  const auto place = [](int k, int n) { return static_cast<double>(k) / n; };
  for (int j = 0; j < divisions.y; ++j) {
    for (int i = 0; i < divisions.x; ++i) {
      std::vector<std::uint32_t> vertices;
      std::vector<double> values;
      for (const auto& [di, dj] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, 0)}) {
        const double u = place(i + di, divisions.x), v = place(j + dj, divisions.y);
        vertices.push_back(mesh.vertex({(u - 0.5) * size.x, 0, (v - 0.5) * size.y}));
        values.insert(values.end(), {0, 1, 0, u, 1 - v});
      }
      mesh.polygon(vertices, values);
    }
  }
  return mesh.take();
}

Mesh make_sphere(double radius, int segments, int rings) {
  MeshBuilder mesh = round_builder();
  const auto point = [&](int ring) {
    const glm::dvec2 c = on_circle(ring, 2 * rings);  // cosine from the south pole
    const double r = ring == 0 || ring == rings ? 0 : c.y;
    return ProfilePoint{radius * r, -radius * c.x, {r, -c.x}, static_cast<double>(ring) / rings};
  };
  for (int ring = 0; ring < rings; ++ring) add_band(mesh, point(ring), point(ring + 1), segments);
  return mesh.take();
}

Mesh make_cone(double radius, double top_radius, double height, int segments) {
  MeshBuilder mesh = round_builder();
  const glm::dvec2 normal = glm::normalize(glm::dvec2(height, radius - top_radius));
  add_band(mesh, {radius, -height / 2, normal, 0}, {top_radius, height / 2, normal, 1}, segments);
  if (top_radius > 0) add_cap(mesh, top_radius, height / 2, segments, true);
  if (radius > 0) add_cap(mesh, radius, -height / 2, segments, false);
  return mesh.take();
}

Mesh make_tube(double radius, double inner_radius, double height, int segments) {
  MeshBuilder mesh = round_builder();
  const double y = height / 2;
  const ProfilePoint corners[4] = {
      {radius, -y, {}, 0}, {radius, y, {}, 1}, {inner_radius, y, {}, 1}, {inner_radius, -y, {}, 0}};
  const glm::dvec2 normals[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int k = 0; k < 4; ++k) {
    ProfilePoint from = corners[k], to = corners[(k + 1) % 4];
    from.normal = to.normal = normals[k];
    add_band(mesh, from, to, segments);
  }
  return mesh.take();
}

Mesh make_torus(double radius, double thickness, int segments, int sides) {
  MeshBuilder mesh = round_builder();
  const auto point = [&](int side) {
    const glm::dvec2 c = on_circle(side % sides, sides);
    return ProfilePoint{radius + thickness * c.x, thickness * c.y, c, static_cast<double>(side) / sides};
  };
  for (int side = 0; side < sides; ++side) add_band(mesh, point(side), point(side + 1), segments);
  return mesh.take();
}

Mesh make_prism(std::span<const glm::dvec2> outline, double depth) {
  MeshBuilder mesh;
  double area = 0;
  const std::size_t n = outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % n];
    area += a.x * b.y - b.x * a.y;
  }
  std::vector<std::uint32_t> front, back;
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2& p = outline[area >= 0 ? k : n - 1 - k];
    front.push_back(mesh.vertex({p.x, p.y, depth / 2}));
    back.push_back(mesh.vertex({p.x, p.y, -depth / 2}));
  }
  mesh.polygon(front);
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t side[4] = {front[k], back[k], back[(k + 1) % n], front[(k + 1) % n]};
    mesh.polygon(side);
  }
  mesh.polygon(std::vector<std::uint32_t>(back.rbegin(), back.rend()));
  return mesh.take();
}

}  // namespace scanline
