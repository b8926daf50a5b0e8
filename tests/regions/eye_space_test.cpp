// Parameters with transform attributes on their way to eye space.
#include "pixelflow/shading/eye_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "tests/pfman_shading/region.h"
#include "tests/pixelflow_model/seed.h"

namespace region_tests {
namespace {

using pfman::Instance;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;
using Values = std::vector<double>;

constexpr char kShader[] = R"(
surface all(
    output varying fixed<8,8> px_shader_color[3],
    varying transform_as_vector float bound[3] = { 1, 0, 0 },
    varying transform_as_normal float ordinary[3] = { 0, 1, 0 },
    uniform transform_as_point float spot[3] = { 1, 2, 3 },
    uniform transform_as_point float spot4[4] = { 2, 4, 6, 2 },
    uniform transform_as_vector float arrow[3] = { 1, 2, 3 },
    uniform transform_as_vector float arrow4[4] = { 1, 2, 3, 0 },
    uniform transform_as_normal float across[3] = { 1, 2, 3 },
    uniform unit transform_as_normal signed fixed<16,14> unit_normal[3] = { 0.6, 0, 0.8 },
    uniform transform_as_texture float texcoord[2] = { 1, 2 },
    uniform float plain[3] = { 1, 2, 3 })
{
    px_shader_color = { bound[0] + ordinary[0] + spot[0], spot4[0] + arrow[0] + arrow4[0] + across[0],
                        unit_normal[0] + texcoord[0] + plain[0] };
}
)";

Values values(const Instance& instance, const std::string& name, const pfman::Scalar& type) {
  const auto& uniforms = instance.uniforms();
  const auto& raw = uniforms.contains(name) ? uniforms.at(name) : instance.bound().at(name);
  Values result;
  for (const std::uint64_t number : raw) result.push_back(pfman::to_double(number, type));
  return result;
}

const pfman::Scalar& type_of(const Instance& instance, const std::string& name) {
  for (const auto& parameter : instance.shader().shader->parameters) {
    if (parameter.variable->name == name) return parameter.variable->type.scalar;
  }
  throw std::invalid_argument(name);
}

void expect_near(const Instance& instance, const std::string& name, const Values& expected, const std::string& where) {
  const Values found = values(instance, name, type_of(instance, name));
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_NEAR(found[n], expected[n], 1e-4 * (1 + std::abs(expected[n]))) << where << ", " << name << ", number " << n;
  }
}

TEST(EyeSpace, IsReachedAsTheAttributesSay) {
  const auto unit = pfman_tests::compiled(kShader);
  const std::uint64_t seed = seed_or(92);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-3, 3);
  for (int round = 0; round < 20; ++round) {
    double m[3][4];
    glm::dmat4 matrix(1);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) matrix[column][row] = m[row][column] = number(random);
    }
    const auto times = [&](double x, double y, double z, double w) {
      Values result;
      for (const auto& row : m) result.push_back(row[0] * x + row[1] * y + row[2] * z + row[3] * w);
      return result;
    };
    Instance instance(unit->shaders[0], 1);
    instance.make_ordinary("ordinary");
    instance.set("arrow", {3, -1, 2});
    pfman::place(instance, matrix);
    const std::string where = replay(seed) + ", round " + std::to_string(round);
    expect_near(instance, "bound", times(1, 0, 0, 0), where);
    EXPECT_TRUE(instance.is_ordinary("ordinary"));
    EXPECT_FALSE(instance.bound().contains("ordinary"));
    expect_near(instance, "spot", times(1, 2, 3, 1), where);
    Values point4 = times(2, 4, 6, 2);
    point4.push_back(2);
    expect_near(instance, "spot4", point4, where);
    expect_near(instance, "arrow", times(3, -1, 2, 0), where);
    Values vector4 = times(1, 2, 3, 0);
    vector4.push_back(0);
    expect_near(instance, "arrow4", vector4, where);
    expect_near(instance, "texcoord", {1, 2}, where);
    expect_near(instance, "plain", {1, 2, 3}, where);

    // A normal stays perpendicular to what it was perpendicular to, and its product with any vector stays.
    const double determinant = glm::determinant(glm::dmat3(matrix));
    if (std::abs(determinant) < 0.5) continue;
    const Values normal = values(instance, "across", type_of(instance, "across"));
    const Values unit_normal = values(instance, "unit_normal", type_of(instance, "unit_normal"));
    double length = 0;
    for (const double component : unit_normal) length += component * component;
    EXPECT_NEAR(length, 1, 1e-3) << where;
    for (const Values& v : {Values{1, 0, 0}, {0, 1, 0}, {0.5, -1, 2}}) {
      const Values moved = times(v[0], v[1], v[2], 0);
      EXPECT_NEAR(normal[0] * moved[0] + normal[1] * moved[1] + normal[2] * moved[2], v[0] + 2 * v[1] + 3 * v[2], 1e-3)
          << where;
    }
    const Values along = times(0.8, 7, -0.6, 0);
    EXPECT_NEAR(unit_normal[0] * along[0] + unit_normal[1] * along[1] + unit_normal[2] * along[2], 0, 3e-3) << where;
  }
}

TEST(EyeSpace, KeepsValuesUnderTheIdentity) {
  const auto unit = pfman_tests::compiled(kShader);
  Instance instance(unit->shaders[0], 1);
  const Instance before = instance;
  pfman::place(instance, glm::dmat4(1));
  EXPECT_EQ(instance.uniforms(), before.uniforms());
  EXPECT_EQ(instance.bound(), before.bound());
}

TEST(EyeSpace, EndsWellForMatricesThatHaveNoInverse) {
  const auto unit = pfman_tests::compiled(kShader);
  for (const double size : {0.0, 1e-300, 1e300, double{INFINITY}, std::nan("")}) {
    Instance instance(unit->shaders[0], 1);
    EXPECT_NO_THROW(pfman::place(instance, glm::dmat4(size))) << size;
  }
  // Flattened: normals point along what was lost.
  Instance flat(unit->shaders[0], 1);
  pfman::place(flat, glm::scale(glm::dmat4(1), glm::dvec3(2, 2, 0)));
  const Values normal = values(flat, "unit_normal", type_of(flat, "unit_normal"));
  EXPECT_NEAR(normal[2], 1, 1e-3);
}

}  // namespace
}  // namespace region_tests
