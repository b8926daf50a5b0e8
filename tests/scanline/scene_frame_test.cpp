// Scenes to frames: projection by hand, ranges, sharing, keys, attributes.
#include "scanline/scene_frame.h"

#include <cmath>
#include <random>

#include "scanline/frame.h"
#include "scanline/polygon.h"
#include "scanline/shapes.h"
#include "tests/scanline/checks.h"

namespace scanline_tests {
namespace {

using scanline::Mesh;
using scanline::Scene;
using scanline::SceneFrame;

Scene scene_of(Mesh mesh, scanline::TransformKey key = {}) {
  Scene scene;
  scanline::Object object;
  object.name = "thing";
  object.mesh = std::move(mesh);
  object.keys = {key};
  object.file = "a.toml";
  object.line = 7;
  scene.objects.push_back(std::move(object));
  return scene;
}

Mesh mesh_of(const std::vector<std::vector<glm::dvec3>>& polygons) {
  scanline::MeshBuilder builder;
  for (const auto& points : polygons) {
    std::vector<std::uint32_t> polygon;
    for (const auto& p : points) polygon.push_back(builder.vertex(p));
    builder.polygon(polygon);
  }
  return builder.take();
}

/// Twice the area on the screen, positive when counter-clockwise (x right, y up).
double turn(const scanline::Frame& frame, std::size_t polygon) {
  double sum = 0;
  const auto& p = frame.polygons[polygon];
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto &a = frame.vertices[p[k] - 1], &b = frame.vertices[p[(k + 1) % p.size()] - 1];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

TEST(SceneFrame, OrthographicByHand) {
  Scene scene = scene_of(mesh_of({{{-1, -0.5, 0}, {1, -0.5, 1}, {0, 1, -1}}}));
  scene.camera.projection = scanline::Projection::kOrthographic;
  scene.camera.position = {0, 0, 5};
  scene.camera.height = 4;
  scene.camera.near = 1;
  scene.camera.far = 9;
  // Two pixels are as wide as one unit: 100 x 50 pixels show 8 x 4 units.
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 100, 50);
  EXPECT_EQ(f.frame.width, 102);
  EXPECT_EQ(f.frame.height, 51);
  ASSERT_EQ(f.frame.polygons.size(), 1u);
  ASSERT_EQ(f.frame.vertices.size(), 3u);
  // First vertex first, the others turned round: clockwise.
  const double expected[3][3] = {
      {1.5 + 37.5, 0.5 + 18.75, 0.5}, {1.5 + 50, 0.5 + 37.5, 0.625}, {1.5 + 62.5, 0.5 + 18.75, 0.375}};
  for (int k = 0; k < 3; ++k) {
    const auto& v = f.frame.vertices[f.frame.polygons[0][k] - 1];
    EXPECT_NEAR(v.x, expected[k][0], 1e-9);
    EXPECT_NEAR(v.y, expected[k][1], 1e-9);
    EXPECT_NEAR(v.z, expected[k][2] * scanline::kDepthRange, 1e-9);
  }
  EXPECT_LT(turn(f.frame, 0), 0);
}

TEST(SceneFrame, PerspectiveByHand) {
  Scene scene = scene_of(mesh_of({{{-1, -1, 3}, {2, -1, 3}, {0, 1.5, 1}}}));
  scene.camera.position = {0, 0, 5};
  scene.camera.field_of_view = 90;  // at distance d the picture is 2 d high
  scene.camera.near = 1;
  scene.camera.far = 5;
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 200, 100);
  ASSERT_EQ(f.frame.vertices.size(), 3u);
  // Depth: (far + near) / (far - near) - 2 far near / (far - near) / distance, from -1 to 1.
  const auto depth = [](double d) { return (1.5 - 2.5 / d + 1) / 2 * scanline::kDepthRange; };
  // Distances 2, 4, 2; x over (2 x distance), y over distance.
  const double expected[3][3] = {{1.5 + 200 * (1 - 0.25) / 2, 0.5 + 100 * (1 - 0.5) / 2, depth(2)},
                                 {1.5 + 200 * (1 + 0.0) / 2, 0.5 + 100 * (1 + 0.375) / 2, depth(4)},
                                 {1.5 + 200 * (1 + 0.5) / 2, 0.5 + 100 * (1 - 0.5) / 2, depth(2)}};
  const double w[3] = {2, 4, 2};
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t number = f.frame.polygons[0][k];
    const auto& v = f.frame.vertices[number - 1];
    EXPECT_NEAR(v.x, expected[k][0], 1e-9);
    EXPECT_NEAR(v.y, expected[k][1], 1e-9);
    EXPECT_NEAR(v.z, expected[k][2], 1e-8);
    EXPECT_NEAR(f.w[number - 1], w[k], 1e-12);
  }
  EXPECT_EQ(f.world[f.frame.polygons[0][2] - 1], glm::dvec3(2, -1, 3));
}

TEST(SceneFrame, DepthRunsFromNearToFar) {
  Scene scene = scene_of(mesh_of({{{-9, -9, 9}, {9, -9, 9}, {0, 0, -90}}}));
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 64, 64);
  double least = 1e9, most = 0;
  for (const auto& v : f.frame.vertices) {
    least = std::min(least, v.z);
    most = std::max(most, v.z);
  }
  EXPECT_GE(least, 0);
  EXPECT_LE(most, scanline::kDepthRange);
  EXPECT_GT(most, 0.99 * scanline::kDepthRange);
}

TEST(SceneFrame, KeysAreInterpolatedAndHeldAtTheEnds) {
  Scene scene = scene_of(mesh_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
  scene.objects[0].keys = {{2, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}}, {6, {-1, 0, 0}, {0, 0, 90}, {1, 3, 1}}};
  const auto corner = [&](double moment) {
    const SceneFrame f = scanline::make_scene_frame(scene, moment, 64, 64);
    return f.world[f.frame.polygons[0][2] - 1];  // where (1, 0, 0) has gone
  };
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
  EXPECT_TRUE(near(corner(1), {1, 0, 0}));
  EXPECT_TRUE(near(corner(2), {1, 0, 0}));
  EXPECT_TRUE(near(corner(4), {std::sqrt(0.5) - 0.5, std::sqrt(0.5), 0}));
  EXPECT_TRUE(near(corner(6), {-1, 1, 0}));
  EXPECT_TRUE(near(corner(99), {-1, 1, 0}));
}

TEST(SceneFrame, RotationIsAboutXThenYThenZ) {
  Scene scene = scene_of(mesh_of({{{0, 0.2, 0}, {1, 0.2, 0}, {0, 0.2, -1}}}), {0, {}, {90, 90, 90}, {1, 1, 1}});
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 64, 64);
  // (0, 0.2, 0): about x to (0, 0, 0.2), about y to (0.2, 0, 0), about z to (0, 0.2, 0).
  bool found = false;
  for (const glm::dvec3& p : f.world) found |= glm::length(p - glm::dvec3(0, 0.2, 0)) < 1e-12;
  EXPECT_TRUE(found);
}

TEST(SceneFrame, FrontFacesRunClockwiseAlsoWhenMirrored) {
  for (const double mirror : {1.0, -1.0}) {
    Scene scene = scene_of(scanline::make_sphere(1, 16, 8), {0, {}, {10, 20, 30}, {mirror, 1, 1}});
    const SceneFrame f = scanline::make_scene_frame(scene, 1, 256, 256);
    ASSERT_EQ(f.frame.polygons.size(), 16u * 8) << "back faces are kept";
    int front = 0;
    for (std::size_t p = 0; p < f.frame.polygons.size(); ++p) {
      const glm::dvec3& normal = f.polygons[p].normal;
      EXPECT_NEAR(glm::length(normal), 1, 1e-12);
      const glm::dvec3& at = f.world[f.frame.polygons[p][0] - 1];
      const bool faces_viewer = glm::dot(normal, scene.camera.position - at) > 0;
      EXPECT_GT(glm::dot(normal, at), 0) << "outwards";
      EXPECT_EQ(turn(f.frame, p) < 0, faces_viewer);
      front += faces_viewer;
    }
    EXPECT_GT(front, 20);
  }
}

/// Objects around, in front of and behind the camera, cut by every plane.
Scene random_scene(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](double size) { return glm::dvec3(unit(random), unit(random), unit(random)) * size; };
  Scene scene;
  scene.camera.position = point(2);
  scene.camera.target = scene.camera.position + point(1);
  scene.camera.up = point(1);
  scene.camera.near = 0.05 + 0.2 * (unit(random) + 1);
  scene.camera.far = 1 + 2 * (unit(random) + 1);
  scene.camera.field_of_view = 20 + 60 * (unit(random) + 1);
  if (unit(random) < 0) scene.camera.projection = scanline::Projection::kOrthographic;
  const std::vector<glm::dvec2> comb{{-1, -1}, {1, -1},   {1, 1},    {0.6, 1},  {0.6, 0},  {0.2, 0},
                                     {0.2, 1}, {-0.2, 1}, {-0.2, 0}, {-0.6, 0}, {-0.6, 1}, {-1, 1}};
  for (int k = 0; k < 4; ++k) {
    const Mesh meshes[] = {scanline::make_sphere(1, 9, 5), scanline::make_torus(1, 0.4, 11, 6),
                           scanline::make_prism(comb, 1), scanline::make_cone(1, 0.3, 2, 7)};
    Scene one = scene_of(meshes[k], {0, point(2), point(180), glm::dvec3(1.1) + point(1)});
    scene.objects.push_back(std::move(one.objects[0]));
  }
  return scene;
}

TEST(SceneFrame, CoordinatesStayInTheFrame) {
  std::size_t polygons = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int w = 1 + static_cast<int>(seed % 97), h = 1 + static_cast<int>(seed % 61);
    const SceneFrame f = scanline::make_scene_frame(random_scene(seed), 1, w, h);
    for (const auto& v : f.frame.vertices) {
      ASSERT_TRUE(v.x >= 1.5 && v.x <= w + 1.5) << v.x;
      ASSERT_TRUE(v.y >= 0.5 && v.y <= h + 0.5) << v.y;
      ASSERT_TRUE(v.z >= 0 && v.z <= scanline::kDepthRange) << v.z;
    }
    for (const auto& p : f.frame.polygons) {
      ASSERT_GE(p.size(), 3u);
      for (std::size_t k = 0; k < p.size(); ++k) {
        const auto &a = f.frame.vertices[p[k] - 1], &b = f.frame.vertices[p[(k + 1) % p.size()] - 1];
        ASSERT_FALSE(a.x == b.x && a.y == b.y && a.z == b.z) << "a vertex stands twice in a row";
      }
    }
    ASSERT_EQ(f.polygons.size(), f.frame.polygons.size());
    ASSERT_EQ(f.world.size(), f.frame.vertices.size());
    ASSERT_EQ(f.w.size(), f.frame.vertices.size());
    ASSERT_EQ(f.first_corner.size(), f.frame.polygons.size() + 1);
    for (const auto& a : f.attributes) {
      ASSERT_EQ(a.values.size(), std::size_t{f.first_corner.back()} * static_cast<std::size_t>(a.components));
    }
    polygons += f.frame.polygons.size();
  }
  EXPECT_GT(polygons, 5000u);
}

TEST(SceneFrame, EdgesInsideThePictureStayShared) {
  std::size_t shared = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int w = 300, h = 200;
    const SceneFrame f = scanline::make_scene_frame(random_scene(seed), 1, w, h);
    // All solids are closed: where an edge has no partner, a plane of the viewing box has cut.
    const auto open = open_edges(f.frame.polygons);
    for (const auto& [a, b] : open) {
      const auto &p = f.frame.vertices[a - 1], &q = f.frame.vertices[b - 1];
      const auto both = [](double u, double v, double value) {
        return std::abs(u - value) < 1e-6 && std::abs(v - value) < 1e-6;
      };
      ASSERT_TRUE(both(p.x, q.x, 1.5) || both(p.x, q.x, w + 1.5) || both(p.y, q.y, 0.5) || both(p.y, q.y, h + 0.5) ||
                  both(p.z, q.z, 0) || both(p.z, q.z, scanline::kDepthRange))
          << p.x << " " << p.y << " " << p.z << " to " << q.x << " " << q.y << " " << q.z;
    }
    for (const auto& p : f.frame.polygons) shared += p.size();
    shared -= open.size();
  }
  EXPECT_GT(shared, 10000u);
}

TEST(SceneFrame, AttributesFollowTheirCorners) {
  // "color" holds the object-space position; after clipping it must still be the world position.
  Scene scene;
  for (int k = 0; k < 2; ++k) {
    Scene one = scene_of(scanline::make_plane({3, 3}, {4, 4}), {0, {0, -0.5 - k, 0}, {}, {1, 1, 1}});
    Mesh& mesh = one.objects[0].mesh;
    if (k == 0) {
      scanline::MeshAttribute position{"color", 3, {}};
      for (const auto& p : mesh.polygons) {
        for (const std::uint32_t v : p) {
          const glm::dvec3& at = mesh.positions[v];
          position.values.insert(position.values.end(), {at.x, at.y - 0.5, at.z});
        }
      }
      mesh.attributes.push_back(position);
    }
    scene.objects.push_back(std::move(one.objects[0]));
  }
  scene.camera.position = {0.3, 0.2, 2};
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 100, 100);
  ASSERT_EQ(f.attributes.size(), 3u);
  const auto& color = f.attributes[2];
  ASSERT_EQ(color.name, "color");
  std::size_t clipped = 0;
  for (std::size_t p = 0; p < f.frame.polygons.size(); ++p) {
    for (std::size_t k = 0; k < f.frame.polygons[p].size(); ++k) {
      const double* value = &color.values[3 * (f.first_corner[p] + k)];
      const glm::dvec3 wanted = f.polygons[p].object == 0 ? f.world[f.frame.polygons[p][k] - 1] : glm::dvec3(0);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], wanted[c], 1e-12);
      clipped += f.polygons[p].object == 0 && std::abs(std::remainder(wanted.x, 0.75)) > 1e-9;
    }
  }
  EXPECT_GT(clipped, 0u);
}

TEST(SceneFrame, NormalsTurnAndScaleWithTheObject) {
  Scene scene = scene_of(scanline::make_sphere(0.5, 12, 6), {0, {}, {40, 30, 20}, {2, 1, -0.5}});
  const SceneFrame f = scanline::make_scene_frame(scene, 1, 100, 100);
  ASSERT_EQ(f.attributes[0].name, "normal");
  for (std::size_t p = 0; p < f.frame.polygons.size(); ++p) {
    for (std::size_t k = 0; k < f.frame.polygons[p].size(); ++k) {
      const double* n = &f.attributes[0].values[3 * (f.first_corner[p] + k)];
      EXPECT_GT(glm::dot(glm::normalize(glm::dvec3(n[0], n[1], n[2])), f.polygons[p].normal), 0.5);
    }
  }
}

TEST(SceneFrame, WarnsOnceAnObjectOfCrossingAndUnevenPolygons) {
  const std::vector<glm::dvec3> good{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<glm::dvec3> crossed{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {2, 1, 0}};
  const std::vector<glm::dvec3> bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  const SceneFrame f =
      scanline::make_scene_frame(scene_of(mesh_of({good, crossed, bent, bent, crossed, bent})), 1, 64, 64);
  ASSERT_EQ(f.warnings.size(), 2u);
  EXPECT_EQ(format(f.warnings[0], "warning"),
            "a.toml:7: warning: object 'thing': polygon 2 and 1 more cross themselves");
  EXPECT_EQ(format(f.warnings[1], "warning"), "a.toml:7: warning: object 'thing': polygon 3 and 2 more are not planar");
  EXPECT_TRUE(scanline::make_scene_frame(scene_of(mesh_of({good})), 1, 64, 64).warnings.empty());
}

TEST(SceneFrame, WarnsOfBowTiesWhoseHalvesCancel) {
  const std::vector<glm::dvec3> flat{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}};
  const std::vector<glm::dvec3> bent{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0.3}};
  const SceneFrame f = scanline::make_scene_frame(scene_of(mesh_of({flat})), 1, 64, 64);
  ASSERT_EQ(f.warnings.size(), 1u);
  EXPECT_EQ(format(f.warnings[0], "warning"), "a.toml:7: warning: object 'thing': polygon 1 crosses itself");
  const SceneFrame g = scanline::make_scene_frame(scene_of(mesh_of({bent})), 1, 64, 64);
  ASSERT_EQ(g.warnings.size(), 2u);
  EXPECT_EQ(g.warnings[0].message, "object 'thing': polygon 1 crosses itself");
  EXPECT_EQ(g.warnings[1].message, "object 'thing': polygon 1 is not planar");
}

TEST(SceneFrame, RefusesWhatCannotBe) {
  const Scene good = scene_of(scanline::make_sphere(1, 4, 4));
  EXPECT_NE(mistake([&] { scanline::make_scene_frame(good, 1, 0, 5); }), "");
  EXPECT_NE(mistake([&] { scanline::make_scene_frame(good, 1, 5, 8191); }), "");
  EXPECT_NE(mistake([&] { scanline::make_scene_frame(good, 1, 8190, 5); }), "");
  EXPECT_EQ(mistake([&] { scanline::make_scene_frame(good, 1, 8189, 8190); }), "");
  const Scene far = scene_of(scanline::make_sphere(1, 4, 4), {0, {1e12, 1e12, 1e12}, {}, {1e6, 1e6, 1e6}});
  EXPECT_EQ(mistake([&] { scanline::make_scene_frame(far, 1, 64, 64); }),
            "a.toml:7: error: object 'thing': a vertex lies outside the range of numbers (1e12)");
}

TEST(SceneFrame, ObjectScaledToNothingIsLeftOut) {
  Scene scene = scene_of(scanline::make_sphere(1, 4, 4));
  scene.objects[0].keys = {{1, {}, {}, {1, 1, 1}}, {3, {}, {}, {-1, 1, 1}}};
  EXPECT_TRUE(scanline::make_scene_frame(scene, 2, 64, 64).frame.polygons.empty());
  EXPECT_FALSE(scanline::make_scene_frame(scene, 1, 64, 64).frame.polygons.empty());
}

}  // namespace
}  // namespace scanline_tests
