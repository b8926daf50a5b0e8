// Distance fields in scene files.
#include "scanline/fields/field_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace fields_tests {
namespace {

using scanline::Geometry;

struct Read {
  Geometry geometry;
  std::string mistakes;
};

/// Reads an object's keys.
Read read(const std::string& text, const std::filesystem::path& folder = {}) {
  const toml::table table = toml::parse(text);
  scanline::TomlMistakes mistakes{"s", {}};
  scanline::TomlTable object(table, "object", mistakes);
  Read result{scanline::read_field_geometry(object, folder), {}};
  object.finish();
  for (const auto& m : mistakes.list) result.mistakes += scanline::format(m) + "\n";
  return result;
}

double at(const Read& r, const glm::dvec3& p) { return r.geometry.field->distance(p); }

TEST(FieldsReader, EveryKindHasItsDefaults) {
  const struct {
    const char* text;
    glm::dvec3 point;
    double distance;
  } cases[] = {{"kind = 'sphere'", {2, 0, 0}, 1.5},
               {"kind = 'box'", {2, 0, 0}, 1.5},
               {"kind = 'box', size = [2, 1, 1], round = 0.25", {2, 0, 0}, 1},
               {"kind = 'torus'", {2, 0, 0}, 1.5 - 0.5 / 3},
               {"kind = 'cylinder'", {0, 2, 0}, 1.5},
               {"kind = 'cone', top_radius = 0.5", {2, 0, 0}, 1.5},
               {"kind = 'ellipsoid', radii = [1, 0.5, 0.25]", {2, 0, 0}, 1},
               {"kind = 'triangle', a = [0, 0, 0], b = [1, 0, 0], c = [0, 1, 0]", {0.2, 0.2, 1}, 0.95},
               {"kind = 'union', of = [{kind = 'sphere'}, {kind = 'sphere', translate = [1, 0, 0]}]", {2, 0, 0}, 0.5},
               {"kind = 'intersection', of = [{kind = 'box'}, {kind = 'plane'}]", {0, 2, 0}, 2},
               {"kind = 'subtraction', of = [{kind = 'sphere'}, {kind = 'sphere', radius = 0.2}]", {0, 0, 0}, 0.2},
               {"kind = 'smooth_union', radius = 0.2, of = [{kind = 'sphere'}, {kind = 'sphere'}]", {2, 0, 0}, 1.45},
               {"kind = 'repeat', spacing = [2, 0, 0], count = [2, 0, 0], of = {kind = 'sphere'}", {1, 0, 0}, -0.5},
               {"kind = 'sphere', translate = [1, 0, 0], rotate = [0, 0, 90], scale = 2", {4, 0, 0}, 2}};
  for (const auto& c : cases) {
    const Read r = read(std::string("cells = 8\nfield = {") + c.text + "}");
    ASSERT_EQ(r.mistakes, "") << c.text;
    EXPECT_NEAR(at(r, c.point), c.distance, 1e-12) << c.text;
    EXPECT_FALSE(r.geometry.mesh.polygons.empty()) << c.text;
  }
  const Read grid = read("cells = 8\nfield = {kind = 'grid', cells = 16, of = {kind = 'sphere'}}");
  EXPECT_EQ(grid.mistakes, "");
  EXPECT_NEAR(at(grid, {2, 0, 0}), 1.5, 0.05);
}

TEST(FieldsReader, MeshFilesBecomeFields) {
  const auto path = std::filesystem::temp_directory_path() / "vsg_fields_reader_tetrahedron.off";
  std::ofstream(path) << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const Read r =
      read("cells = 8\nfield = {kind = 'mesh', file = '" + path.filename().string() + "'}", path.parent_path());
  std::filesystem::remove(path);
  ASSERT_EQ(r.mistakes, "");
  EXPECT_NEAR(at(r, {-1, 0.2, 0.2}), 1, 1e-12);
  EXPECT_NEAR(at(r, {0.1, 0.2, 0.2}), -0.1, 1e-12);
}

TEST(FieldsReader, BoundsCutTheField) {
  const Read r = read("cells = 8\nfield = {kind = 'plane'}\nbounds = [[-1, -1, -1], [1, 1, 1]]");
  ASSERT_EQ(r.mistakes, "");
  EXPECT_EQ(r.geometry.mesh.polygons.size(), 6u);
  EXPECT_NEAR(at(r, {3, -0.5, 0}), 2, 1e-12);
}

TEST(FieldsReader, AnErrorIsKept) {
  const Read r = read("error = 0.01\nfield = {kind = 'sphere'}");
  ASSERT_EQ(r.mistakes, "");
  for (const glm::dvec3& p : r.geometry.mesh.positions) EXPECT_LT(std::abs(at(r, p)), 0.01);
}

TEST(FieldsReaderSlow, AnErrorOutOfReachIsRefused) {
  const std::string refused = read("error = 1e-6\nfield = {kind = 'sphere'}").mistakes;
  EXPECT_NE(refused.find("s:1:9: error: the polygons come no nearer to the field than "), std::string::npos) << refused;
}

TEST(FieldsReader, MistakesHaveTheirPlaces) {
  const std::pair<const char*, const char*> cases[] = {
      {"cells = 8", "s:1:1: error: object needs the key 'field'\n"},
      {"field = 3", "s:1:9: error: 'field' of object must be a table\n"},
      {"field = {radius = 1}", "s:1:9: error: field needs the key 'kind'\n"},
      {"field = {kind = 'ball'}",
       "s:1:17: error: 'kind' of field must be one of sphere, box, plane, torus, cylinder, cone, ellipsoid, triangle, "
       "mesh, union, intersection, subtraction, smooth_union, repeat, grid, not 'ball'\n"},
      {"field = {kind = 'sphere', radius = -1, size = 3}",
       "s:1:36: error: 'radius' of field must be at least 1e-06\ns:1:40: error: unknown key 'size' in field\n"},
      {"field = {kind = 'box', size = 1, round = 0.6}",
       "s:1:42: error: 'round' of a box must be at most half its smallest side\n"},
      {"field = {kind = 'plane', normal = [0, 0, 0]}", "s:1:35: error: 'normal' of a plane has no length\n"},
      {"field = {kind = 'torus', radius = 1, thickness = 1}",
       "s:1:50: error: 'thickness' of a torus must be less than 'radius'\n"},
      {"field = {kind = 'ellipsoid'}", "s:1:9: error: field needs the key 'radii'\n"},
      {"field = {kind = 'triangle', a = [0, 0, 0], b = [0, 0]}",
       "s:1:48: error: 'b' of field must be an array of 3 numbers\ns:1:9: error: field needs the key 'c'\n"},
      {"field = {kind = 'union'}", "s:1:9: error: field needs the key 'of'\n"},
      {"field = {kind = 'union', of = []}", "s:1:31: error: 'of' holds no field\n"},
      {"field = {kind = 'subtraction', of = [{kind = 'sphere'}]}",
       "s:1:37: error: 'of' must hold two fields or more\n"},
      {"field = {kind = 'union', of = [{kind = 'sphere', radius = 0}, {kind = 'cube'}, {kind = 'box', size = 'x'}]}",
       "s:1:59: error: 'radius' of field must be at least 1e-06\n"
       "s:1:71: error: 'kind' of field must be one of sphere, box, plane, torus, cylinder, cone, ellipsoid, triangle, "
       "mesh, union, intersection, subtraction, smooth_union, repeat, grid, not 'cube'\n"
       "s:1:102: error: 'size' of field must be an array of 3 numbers\n"},
      {"field = {kind = 'smooth_union', of = [{kind = 'sphere'}]}", "s:1:9: error: field needs the key 'radius'\n"},
      {"field = {kind = 'repeat', spacing = [0, 0, 0], of = {kind = 'sphere'}}",
       "s:1:37: error: 'spacing' of a repeat is 0 along all axes\n"},
      {"field = {kind = 'repeat', spacing = [0.1, 0, 0], count = [1.5, 2, 0], of = {kind = 'sphere'}}",
       "s:1:58: error: 'count' of a repeat must be whole numbers\n"},
      {"field = {kind = 'repeat', spacing = [0.1, 0, 0], count = [1, 2, 0], of = {kind = 'sphere'}}",
       "s:1:37: error: 'spacing' of a repeat along x is less than a quarter of what is repeated\n"
       "s:1:58: error: 'count' of a repeat asks for copies along y, where 'spacing' is 0\n"},
      {"field = {kind = 'repeat', spacing = [1, 0, 0], of = {kind = 'plane'}}",
       "s:1:53: error: what is repeated along x is infinite there\n"},
      {"field = {kind = 'repeat', spacing = [1, 0, 0], of = {kind = 'sphere'}}",
       "s:1:9: error: this field is infinite: the object needs the key 'bounds'\n"},
      {"field = {kind = 'grid', of = {kind = 'plane'}}",
       "s:1:30: error: what a grid is made of is infinite: the grid needs the key 'bounds'\n"},
      {"field = {kind = 'mesh', file = 'none.off'}", "s:1:32: error: cannot read 'none.off'\n"},
      {"field = {kind = 'plane'}\nbounds = [[0, 0, 0], [1, 1]]",
       "s:2:10: error: 'bounds' of a field must be [[x, y, z], [x, y, z]], the lower corner first\n"},
      {"field = {kind = 'plane'}\nbounds = [[0, 0, 0], [1, -1, 1]]",
       "s:2:10: error: 'bounds' of a field must be [[x, y, z], [x, y, z]], the lower corner first\n"},
      {"field = {kind = 'sphere'}\nbounds = [[5, 5, 5], [6, 6, 6]]",
       "s:1:9: error: the field has no surface that its cells would show\n"},
      {"field = {kind = 'sphere'}\ncells = 1",
       "s:2:9: error: 'cells' of object must be a whole number from 2 to 512\n"},
      {"field = {kind = 'sphere'}\ncells = 8\nerror = 1", "s:3:9: error: a field has either 'cells' or 'error'\n"},
      {"field = {kind = 'sphere', scale = 0}", "s:1:35: error: 'scale' of field must be at least 1e-06\n"},
      {"field = {kind = 'sphere', translate = [inf, 0, nan]}",
       "s:1:40: error: 'translate' of field must be a finite number\n"}};
  for (const auto& [text, expected] : cases) {
    const std::string found = read(text).mistakes;
    EXPECT_EQ(found.substr(0, std::string(expected).size()), expected) << text;
  }
}

TEST(FieldsReader, DepthAndSizeAreBounded) {
  std::string deep = "{kind = 'sphere'}";
  for (int k = 0; k < 40; ++k) deep = "{kind = 'union', of = [" + deep + "]}";
  EXPECT_NE(read("field = " + deep).mistakes.find("nested more than 32 levels deep"), std::string::npos);
  std::string many = "field = {kind = 'union', of = [";
  for (int k = 0; k < 5000; ++k) many += "{kind = 'sphere'}, ";
  EXPECT_NE(read(many + "]}").mistakes.find("more than 4096 parts"), std::string::npos);
  std::string small = "{kind = 'sphere'}";
  for (int k = 0; k < 20; ++k) small = "{kind = 'union', scale = 1e-6, of = [" + small + "]}";
  EXPECT_NE(read("field = " + small).mistakes.find("smaller than 1e-9"), std::string::npos);
}

}  // namespace
}  // namespace fields_tests
