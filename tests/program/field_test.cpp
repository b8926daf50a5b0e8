// What pixels of a distance field show is its own surface, however coarse the polygons are by which it was found.
#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;

// Six cells: the polygons lie up to a tenth of the radius from the sphere, and their normals are far from its own.
constexpr char kSphere[] =
    "[[light]]\ndirection = [1, -1, -1]\nintensity = 0.75\n"
    "[[object]]\ngeometry = \"field\"\nfield = {kind = \"sphere\", radius = 0.8}\ncells = 6\n"
    "shader = {name = \"flat\", parameters = {color = [1, 1, 1]}}\n";

class FieldPixels : public ProgramTest {
 protected:
  Image render(const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",       "scene.toml", "-o",    name + ".exr", "--channels", "--stats",
                                       name + ".json", "--vsg",      "model", "--pe",        "macro"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return read_image(path(name + ".exr"));
  }
};

TEST_F(FieldPixels, ShowTheSurfaceItselfNotThePolygonsOverIt) {
  std::string scene = flat_scene(96, 96, kSphere);
  scene.replace(scene.find("intensity = 1"), 13, "intensity = 0.1");
  write("scene.toml", scene);
  const Image polygons = render("polygons", {}), traced = render("traced", {"--traced"});
  // R, G, B, Z, polygon, shader, normal.x, normal.y, normal.z
  constexpr int kZ = 3, kShader = 5;
  int both = 0, different = 0;
  for (int row = 0; row < 96; ++row) {
    for (int column = 0; column < 96; ++column) {
      if (polygons.at(column, row, kShader) == 0 || traced.at(column, row, kShader) == 0) continue;
      ++both;
      const auto apart = [&](int channel) {
        return std::abs(polygons.at(column, row, channel) - traced.at(column, row, channel));
      };
      // Z is a float of up to 2^15: its last place there is 2^-8. Colours are bytes: the same, as the normals are.
      const bool same = apart(kZ) <= 1.0f / 256 && apart(0) == 0 && apart(1) == 0 && apart(2) == 0 &&
                        apart(6) < 1e-5f && apart(7) < 1e-5f && apart(8) < 1e-5f;
      different += !same;
    }
  }
  const double circle = 3.14159265 * 0.8 * 0.8 * 48 * 48;
  EXPECT_GT(both, 0.8 * circle);
  const json stats = json::parse(read("polygons.json"));
  EXPECT_LE(different, stats["frames"][0]["fields"]["missed"].get<int>()) << "of " << both;
  EXPECT_LT(different, both / 50);
}

}  // namespace
}  // namespace vsg_tests
