// Shadows and reflections against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/field_march/oracle.h"

namespace field_march_tests {
namespace {

using scanline::FieldCost;
using scanline::FieldScene;
using scanline::Light;

Light point_light(const glm::dvec3& position) {
  Light light;
  light.kind = Light::Kind::kPoint;
  light.position = position;
  return light;
}
Light sun(const glm::dvec3& direction) {
  Light light;
  light.direction = direction;
  return light;
}
Light ambient(const glm::dvec3& color) {
  Light light;
  light.kind = Light::Kind::kAmbient;
  light.color = color;
  return light;
}
Light shader_light(std::map<std::string, scanline::ParameterValue> parameters) {
  scanline::ShaderCall call;
  call.name = "lamp";
  call.parameters = std::move(parameters);
  Light light;
  light.shader = call;
  return light;
}

/// Whether the way from a point on a solid to 1 (or without end) passes through one of the solids; the solid's own
/// meeting at the point itself does not count. Close: the way passes an outline within 1e-5.
struct Shadow {
  bool is_shadow = false, is_close = false;
};
Shadow shadow(const std::vector<Solid>& solids, const glm::dvec3& point, const glm::dvec3& way, bool ends) {
  constexpr Real kClose = 1e-5;
  Shadow result;
  for (const Solid& solid : solids) {
    for (const auto& [entry, exit] : meetings(solid, point, way)) {
      if (exit < kClose) continue;  // behind, or left at the point
      result.is_close |= exit - entry < kClose || std::abs(entry) < kClose || std::abs(entry - 1) < kClose;
      if (entry > 0) result.is_close |= grazes(solid, point, way, entry);
      result.is_shadow |= entry > 0 && (!ends || entry < 1);
    }
  }
  return result;
}

TEST(field_march_visibility, is_what_stands_in_the_way) {
  Random random(31);
  SCOPED_TRACE(random.replay());
  const Solid floor{Kind::Plane, {}, {.translate = {0, -4, 0}}};
  int lit = 0, dark = 0, turned = 0, close = 0;
  for (int k = 0; k < 20; ++k) {
    const std::vector<Solid> solids{random.solid(Kind::Sphere), random.solid(Kind::Torus), random.solid(Kind::Box),
                                    floor};
    const scanline::Scene scene = scene_of(solids);
    const FieldScene fields(scene, 1);
    for (int n = 0; n < 300; ++n) {
      const Solid& solid = solids[static_cast<std::size_t>(n) % solids.size()];
      const glm::dvec3 from = random.vector(10), way = random.vector(4) - from;
      const Intervals seen = meetings(solid, from, way);
      if (seen.empty() || !(std::abs(seen[0].first) < 100)) continue;
      const glm::dvec3 point = from + static_cast<double>(seen[0].first) * way, normal = normal_at(solid, point);
      const bool is_sun = n % 2 == 0;
      const glm::dvec3 place = is_sun ? random.unit() : random.vector(12);
      const Light light = is_sun ? sun(-place) : point_light(place);
      const glm::dvec3 towards = is_sun ? place : place - point;
      FieldCost cost;
      const double visible = fields.visibility(point, normal, light, cost);
      const double facing = glm::dot(normal, glm::normalize(towards));
      if (facing <= 0) {
        EXPECT_EQ(visible, 0);
        EXPECT_EQ(cost, FieldCost{});
        ++turned;
        continue;
      }
      EXPECT_EQ(cost.rays, 1u);
      const Shadow expected = shadow(solids, point, towards, !is_sun);
      if (expected.is_close || facing < 0.01) {
        ++close;
        continue;
      }
      EXPECT_EQ(visible, expected.is_shadow ? 0 : 1) << n;
      ++(expected.is_shadow ? dark : lit);
    }
  }
  EXPECT_GT(lit, 300);
  EXPECT_GT(dark, 100);
  EXPECT_GT(turned, 300);
  EXPECT_LT(close, (lit + dark) / 10);
}

TEST(field_march_visibility, of_a_ball_is_the_side_that_is_turned_to_the_light) {
  Random random(32);
  SCOPED_TRACE(random.replay());
  const scanline::Scene scene = scene_of({Solid{}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 normal = random.unit();
    // Down to the very edge.
    glm::dvec3 towards = random.unit();
    towards -= glm::dot(towards, normal) * normal;
    const double height = std::pow(10.0, random.between(-9, 0));
    towards = glm::normalize(glm::normalize(towards) + height * normal);
    EXPECT_EQ(fields.visibility(normal, normal, sun(-towards), cost), 1) << height;
    EXPECT_EQ(fields.visibility(normal, normal, sun(towards), cost), 0) << height;
    // Points as recovered, a little inside and outside.
    EXPECT_EQ(fields.visibility(normal * (1 - 1e-9), normal, sun(-towards), cost), 1) << height;
    EXPECT_EQ(fields.visibility(normal * (1 + 1e-9), normal, sun(-towards), cost), 1) << height;
  }
  // Over all directions, few are so level that they take long.
  FieldCost all;
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 normal = random.unit();
    fields.visibility(normal, normal, sun(random.unit()), all);
  }
  EXPECT_LT(all.evaluations, all.rays * 100);
}

TEST(field_march_visibility, of_lights_of_the_shading_language) {
  const scanline::Scene scene = scene_of({Solid{Kind::Sphere, {1, 0, 0}, {.translate = {0, 3, 0}}}});
  const FieldScene fields(scene, 1);
  FieldCost cost;
  const auto seen = [&](const Light& light) { return fields.visibility({0, 0, 0}, {0, 1, 0}, light, cost); };
  using Numbers = std::vector<double>;
  EXPECT_EQ(seen(shader_light({{"position", Numbers{0, 5, 0}}})), 0);
  EXPECT_EQ(seen(shader_light({{"position", Numbers{0, 1.5, 0}}})), 1);
  EXPECT_EQ(seen(shader_light({{"position", Numbers{5, 5, 0}}})), 1);
  EXPECT_EQ(seen(shader_light({{"direction", Numbers{0, -1, 0}}})), 0);
  EXPECT_EQ(seen(shader_light({{"direction", Numbers{-1, -1, 0}}})), 1);
  // Four numbers are homogeneous coordinates.
  EXPECT_EQ(seen(shader_light({{"position", Numbers{0, 1, 0, 0}}})), 0);
  EXPECT_EQ(seen(shader_light({{"position", Numbers{0, 10, 0, 2}}})), 0);
  EXPECT_EQ(seen(shader_light({{"position", Numbers{0, 3, 0, 2}}})), 1);
  const std::uint64_t rays = cost.rays;
  EXPECT_EQ(rays, 8u);
  EXPECT_EQ(seen(shader_light({{"lamp", Numbers{0, 5, 0}}})), 1);
  EXPECT_EQ(seen(shader_light({{"position", std::string("above")}})), 1);
  EXPECT_EQ(seen(shader_light({{"position", Numbers{1, 2}}})), 1);
  EXPECT_EQ(seen(ambient(glm::dvec3(1))), 1);
  EXPECT_EQ(seen(sun({0, 0, 0})), 1);
  EXPECT_EQ(seen(point_light({0, 0, 0})), 1);
  EXPECT_EQ(cost.rays, rays);
}

class field_march_reflection : public testing::Test {
 protected:
  /// A ball over a mirror at y = 0.
  field_march_reflection() {
    scene.background = {0.1, 0.2, 0.3};
    scene.objects.push_back(object_of(ball));
    scene.objects[0].shader.parameters["color"] = std::vector<double>{0.9, 0.5, 0.25};
    scene.lights.push_back(sun({0.3, 1, 0.2}));  // from below: the mirrored side is lit
    scene.lights.back().color = {1, 0.5, 0.25};
    scene.lights.back().intensity = 1.5;
    scene.lights.push_back(ambient(glm::dvec3(0.2)));
    scene.lights.push_back(point_light({5, -1, 0}));
  }
  /// By the closed form, without shadows.
  glm::dvec3 expected(const glm::dvec3& point, const glm::dvec3& mirrored, glm::dvec3* where = nullptr) const {
    const glm::dvec3 from = point - ball.key.translate, d = glm::normalize(mirrored);
    const double b = glm::dot(from, d), under = b * b - glm::dot(from, from) + 1;
    if (under < 0 || -b - std::sqrt(under) < 0) return scene.background;
    const glm::dvec3 normal = from + (-b - std::sqrt(under)) * d, at = ball.key.translate + normal;
    if (where) *where = at;
    const double by_sun = std::max(0.0, glm::dot(normal, -glm::normalize(glm::dvec3(0.3, 1, 0.2))));
    const double by_lamp = std::max(0.0, glm::dot(normal, glm::normalize(glm::dvec3(5, -1, 0) - at)));
    const glm::dvec3 light = by_sun * 1.5 * glm::dvec3(1, 0.5, 0.25) + glm::dvec3(0.2) + glm::dvec3(by_lamp);
    return glm::dvec3(0.9, 0.5, 0.25) * light;
  }

  Solid ball{Kind::Sphere, {1, 0, 0}, {.translate = {0, 2, 0}}};
  scanline::Scene scene;
};

TEST_F(field_march_reflection, shows_the_ball_and_the_background) {
  Random random(33);
  SCOPED_TRACE(random.replay());
  const FieldScene fields(scene, 1);
  int balls = 0, background = 0;
  FieldCost cost;
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 point(random.between(-2, 2), 0, random.between(-2, 2));
    const glm::dvec3 view =
        random.between(0.1, 20) * glm::normalize(glm::dvec3(random.between(-1, 1), -1, random.between(-1, 1)));
    const glm::dvec3 color = fields.reflection(point, {0, 1, 0}, view, cost);
    const glm::dvec3 truth = expected(point, {view.x, -view.y, view.z});
    ++(truth == scene.background ? background : balls);
    // The ray starts a little off the mirror, which counts most at the ball's outline.
    if ((truth == scene.background) == (color == scene.background)) {
      EXPECT_LT(glm::distance(color, truth), 1e-4);
    } else {
      const glm::dvec3 from = point - ball.key.translate, d = glm::normalize(glm::dvec3(view.x, -view.y, view.z));
      EXPECT_NEAR(glm::length(from - glm::dot(from, d) * d), 1, 1e-5);
    }
  }
  EXPECT_GT(balls, 300);
  EXPECT_GT(background, 300);
  EXPECT_EQ(cost.rays, 2000u);
}

TEST_F(field_march_reflection, shows_shadows_where_the_scene_asks_for_them) {
  // A wall keeps the lamp's light from the ball.
  Solid wall{Kind::Box, {0.1, 1, 1}, {.translate = {3, 0, 0}}};
  scene.objects.push_back(object_of(wall));
  scene.lights = {point_light({5, -1, 0})};
  FieldCost cost;
  const glm::dvec3 point(0.4, 0, 0), view(0, -1, 0);
  const glm::dvec3 open = FieldScene(scene, 1).reflection(point, {0, 1, 0}, view, cost);
  EXPECT_GT(open.r, 0.05);
  EXPECT_EQ(cost.rays, 1u);
  scene.fields.shadows = true;
  const glm::dvec3 shaded = FieldScene(scene, 1).reflection(point, {0, 1, 0}, view, cost);
  EXPECT_EQ(shaded, glm::dvec3(0));
  EXPECT_EQ(cost.rays, 3u);
}

TEST_F(field_march_reflection, takes_colours_from_parameters) {
  FieldCost cost;
  const auto color = [&](const char* name, scanline::ParameterValue value) {
    scene.objects[0].shader.parameters = {{name, std::move(value)}};
    scene.lights = {ambient(glm::dvec3(1))};
    return FieldScene(scene, 1).reflection({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, cost);
  };
  using Numbers = std::vector<double>;
  EXPECT_EQ(color("color", Numbers{0.1, 0.2, 0.3}), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(color("rgb", Numbers{0.1, 0.2, 0.3}), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(color("color", 0.5), glm::dvec3(0.5));
  EXPECT_EQ(color("tint", 0.5), glm::dvec3(0.8));
  EXPECT_EQ(color("color", std::string("red")), glm::dvec3(0.8));
  for (const char* name : {"rgb", "color"}) {
    scene.lights = {shader_light({{"direction", Numbers{0, 1, 0}}, {name, Numbers{1, 0.5, 0}}, {"intensity", 2.0}})};
    EXPECT_LT(
        glm::distance(FieldScene(scene, 1).reflection({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, cost), glm::dvec3(1.6, 0.8, 0)),
        1e-6)
        << name;
  }
}

TEST_F(field_march_reflection, of_a_surface_seen_from_behind_is_what_lies_straight_on) {
  const FieldScene fields(scene, 1);
  FieldCost cost;
  EXPECT_NE(fields.reflection({0, 0, 0}, {0, 1, 0}, {0, 1, 0}, cost), scene.background);
  EXPECT_EQ(fields.reflection({0, 0, 0}, {0, -1, 0}, {0, -1, 0}, cost), scene.background);
}

}  // namespace
}  // namespace field_march_tests
